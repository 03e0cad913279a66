// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "backend/scene_run/base/labelled_frame.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::sweep {

/// Frames after which a file of frames is written.
inline constexpr std::size_t kFramesOfPart = 50'000;

/// Labelled tactile frames of runs, as an npz file. n frames of t taxels with m contacts in all:
///   frames (n, t) float32        values in N, row by row
///   run, cell, seed (n) int64    run_time_s (n) float64
///   contact_begin (n + 1) int64  the contacts of frame i are contact_begin[i] to contact_begin[i + 1] - 1
///   contact_place_m (m, 2) float64, contact_force_N (m) float64, contact_normal (m, 3) float64 in {array}
///   contact_object, contact_identity (m) int64
///   layout (2) int64: rows and columns; pitch_m () float64
/// Frames of a run that fails are left out. Thread: one.
class FrameParts {
public:
    /// Frames of another array do not fit into the same file.
    [[nodiscard]] bool takes(const core::ArrayLayout& layout) const {
        return m_time_s.empty() || (layout.rows == m_layout.rows && layout.columns == m_layout.columns &&
                                    layout.pitchX_m == m_layout.pitchX_m);
    }
    void beginRun(std::uint64_t run, std::uint64_t cell, std::uint64_t seed, const core::ArrayLayout& layout);
    void add(const scene_run::LabelledFrame& frame);
    /// keep: false takes the frames of the run out again.
    void endRun(bool keep);
    [[nodiscard]] std::size_t frames() const { return m_time_s.size(); }

    /// Writes what is there, and is empty then. Error: ioFailed.
    [[nodiscard]] core::Expected<void> write(const std::string& path);

private:
    struct Sizes {
        std::size_t frames = 0, values = 0, contacts = 0;
    };
    void cutTo(const Sizes& sizes);

    std::int64_t m_run = 0, m_cell = 0, m_seed = 0;
    Sizes m_before;
    core::ArrayLayout m_layout;
    std::vector<float> m_values;
    std::vector<std::int64_t> m_runs, m_cells, m_seeds, m_begin, m_object, m_identity;
    std::vector<double> m_time_s, m_place_m, m_force_N, m_normal;
};

} // namespace teleta::sweep
