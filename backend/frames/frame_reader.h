// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/data/frame_file.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/core/error.h"
#include "backend/frames/frame_request.h"
#include "backend/frames/frame_series.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::frames {

/// Reads recorded frames of an array, whatever program wrote them; what the file is, its content says. Own
/// CSV files (time_s,t0,t1,...) are read row by row with constant memory, also from a pipe. All other files
/// are read as a whole when they are opened, so that a damaged one gives no frame. Thread: one.
class FrameReader {
public:
    /// Error: notFound, ioFailed; badInput with place and reason, also when memory does not suffice;
    /// cancelled by goOn.
    [[nodiscard]] static core::Expected<FrameReader> open(const FrameRequest& request, const GoOn& goOn = {});

    /// The next frame into values, taxels().values() entries; a time in s. False after the last frame; a file
    /// without frames is an error.
    [[nodiscard]] core::Expected<bool> next(double& time_s, std::span<float> values);

    /// Of a known array: one row of all its values.
    [[nodiscard]] const core::ArrayLayout& layout() const { return m_layout; }
    /// What a frame looks like.
    [[nodiscard]] const core::TaxelLayout& taxels() const { return m_taxels; }
    /// Whether the file or the request tells the pitches of layout().
    [[nodiscard]] bool hasPitch() const { return m_hasPitch; }
    /// Of the values, as the file tells it; empty: it does not.
    [[nodiscard]] const std::string& unit() const { return m_unit; }
    /// What the file says besides and nothing here heeds, by the names that it has there.
    [[nodiscard]] const std::vector<std::string>& unused() const { return m_unused; }
    /// How far reading has come, and what there is; in bytes.
    [[nodiscard]] std::uint64_t bytesRead() const;
    [[nodiscard]] std::uint64_t bytesTotal() const;

private:
    friend core::Expected<FrameSeries> readFrames(const FrameRequest& request, const GoOn& goOn);

    struct Loaded {
        FrameSeries series{};
        std::size_t next = 0;
    };
    using Source = std::variant<Loaded, core::FrameFile>;

    explicit FrameReader(Source source)
        : m_source(std::move(source)) {}

    core::ArrayLayout m_layout{};
    core::TaxelLayout m_taxels{};
    bool m_hasPitch = false;
    std::string m_unit{};
    std::vector<std::string> m_unused{};
    Source m_source;
};

/// Arrays of a file that can be its frames, by their names for FrameRequest::array; empty: it has none, such
/// as a table, or cannot be read. Reads no values. Thread: any.
[[nodiscard]] std::vector<std::string> arraysIn(const std::string& path);

/// All frames of a file. Error: as FrameReader::open() and next().
[[nodiscard]] core::Expected<FrameSeries> readFrames(const FrameRequest& request, const GoOn& goOn = {});

} // namespace teleta::frames
