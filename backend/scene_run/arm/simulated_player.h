// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"
#include "backend/playback/player_types.h"
#include "backend/playback/safety_limiter.h"

#include <cstdint>
#include <optional>
#include <string>

namespace teleta::scene_run {

/// The bracelet of a scene in simulated time: frames at the player's rate, below its safety limits, off when
/// what they rest on stays away. Thread: one.
class SimulatedPlayer {
public:
    static constexpr double kRate_Hz = 200.0;
    /// As the live setpoints of playback::PlayerConfig.
    static constexpr double kTimeout_s = 0.1;

    /// outFolder: gets bracelet.csv, time_s,t1..t6, a row when the frame changes; empty: none.
    [[nodiscard]] static core::Expected<SimulatedPlayer> open(const std::string& outFolder);

    /// Played from the next frame on, in place of what is played.
    void play(playback::Program program);
    /// Writes the frames that are due by now. heardAt_s: when the arm told something last; older than
    /// kTimeout_s ends the playing.
    void advance(double now_s, double heardAt_s);

    /// When the first frame other than zero of the newest program was written; empty: not yet, or never.
    [[nodiscard]] std::optional<double> onset_s() const { return m_onset_s; }
    [[nodiscard]] core::Expected<void> finish() { return m_csv ? m_csv->finish() : core::Expected<void>(); }

private:
    SimulatedPlayer();
    void writeFrame(double now_s, bool heard);

    playback::SafetyLimiter m_limiter;
    std::optional<core::CsvWriter> m_csv;
    std::optional<playback::Program> m_program;
    std::optional<double> m_begun_s; ///< of the program: its first frame
    std::optional<double> m_onset_s;
    std::uint64_t m_frames = 0;
    core::Intensities m_written{};
};

} // namespace teleta::scene_run
