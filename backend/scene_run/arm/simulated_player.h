// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/playback/player_types.h"
#include "backend/playback/safety_limiter.h"
#include "backend/scene_run/base/run_csv.h"

#include <cstdint>
#include <optional>
#include <string>

namespace teleta::scene_run {

/// The bracelet of a scene in simulated time: frames at the player's rate, within its safety limits, off when
/// its input stalls. Thread: one.
class SimulatedPlayer {
public:
    static constexpr double kRate_Hz = 200.0;
    /// As the live setpoints of playback::PlayerConfig.
    static constexpr double kTimeout_s = 0.1;

    /// outFolder: gets bracelet.csv, time_s,t1..t6, a row for each change; empty: none.
    [[nodiscard]] static core::Expected<SimulatedPlayer> open(const std::string& outFolder);

    /// Plays the program from the next frame on, in place of the current one.
    void play(playback::Program program);
    /// Writes the frames that are due by now. heardAt_s: time of the arm's last data; playing ends when it is
    /// older than kTimeout_s.
    void advance(double now_s, double heardAt_s);

    /// When the first nonzero frame of the current program was written; empty: not yet.
    [[nodiscard]] std::optional<double> onset_s() const { return m_onset_s; }
    [[nodiscard]] core::Expected<void> finish() { return m_csv.finish(); }

private:
    SimulatedPlayer();
    void writeFrame(double now_s, bool heard);

    playback::SafetyLimiter m_limiter;
    RunCsv m_csv;
    std::optional<playback::Program> m_program;
    std::optional<double> m_begun_s; ///< first frame of the program
    std::optional<double> m_onset_s;
    std::uint64_t m_frames = 0;
    core::Intensities m_written{};
};

} // namespace teleta::scene_run
