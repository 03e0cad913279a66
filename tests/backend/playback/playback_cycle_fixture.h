// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/playback/playback_cycle.h"
#include "tests/backend/playback/scripted_bracelet.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace teleta::test {

using core::Intensities;
using core::isOff;
using core::kFullDrive;
using core::PacingClock;
using playback::LiveRequest;
using playback::PlaybackCycle;
using playback::PlayerCommands;
using playback::PlayerConfig;
using playback::PlayerEnding;
using playback::PlayerMode;
using playback::Program;
using playback::ProgramRequest;
using playback::SafetyLimits;

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr std::int64_t kPeriod_ns = 5 * kMs_ns;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class PlaybackCycleTest : public testing::Test {
protected:
    /// limits: have tests of their own.
    void make(PlayerConfig config = {},
              const SafetyLimits& limits = {.rise_perS = kInfinity, .heatBudget = 1.0}) {
        config.clock = m_clock;
        config.limits = limits;
        m_cycle = std::make_unique<PlaybackCycle>(m_bracelet, m_stop, std::move(config));
    }

    std::int64_t run(PlayerCommands commands = {}) { return m_cycle->run(std::move(commands)); }

    std::int64_t play(Program program, bool loop = false, double from_s = 0.0) {
        PlayerCommands commands;
        commands.start = ProgramRequest{std::move(program), loop, from_s};
        return run(std::move(commands));
    }

    std::int64_t startLive() {
        PlayerCommands commands;
        commands.start = LiveRequest{};
        return run(std::move(commands));
    }

    /// Runs every cycle at its deadline for so long.
    void runOnTime(std::int64_t duration_ns) {
        const std::int64_t end_ns = m_clock->now_ns() + duration_ns;
        for (std::int64_t next_ns = run(); next_ns <= end_ns; next_ns = run())
            m_clock->add(next_ns - m_clock->now_ns());
        m_clock->add(end_ns - m_clock->now_ns());
    }

    [[nodiscard]] std::vector<ScriptedBracelet::Written> written() const { return m_bracelet.written(); }
    [[nodiscard]] bool lastIsOff() const { return isOff(written().back().frame.drive); }

    std::shared_ptr<SetClock> m_clock = std::make_shared<SetClock>();
    core::StopSwitch m_stop;
    ScriptedBracelet m_bracelet{m_clock};
    std::unique_ptr<PlaybackCycle> m_cycle;
};

inline Program steady(double intensity, double duration_s = kInfinity) {
    return {[intensity](double) { return all(intensity); }, duration_s};
}

/// The first tactor tells the time: 1 is 1 s.
inline Program clockOf1s() {
    return {[](double t_s) { return Intensities{t_s}; }, 1.0};
}

} // namespace teleta::test
