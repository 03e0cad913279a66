// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace teleta::test {

/// What ros_robot writes about one joint, read while it grows. Times are those of the steady clock.
class RobotLog {
public:
    struct State {
        std::int64_t time_ns = 0;
        double position_rad = 0.0;
        double velocity_radPerS = 0.0;
        double setpoint_rad = 0.0; ///< of the controller
    };

    RobotLog(const std::string& path, std::size_t joint)
        : m_file(path)
        , m_joint(joint) {}

    /// Reads what has come.
    void read() {
        m_file.clear();
        for (char c = 0; m_file.get(c);) {
            if (c != '\n') {
                m_line.push_back(c);
                continue;
            }
            take(nlohmann::json::parse(std::exchange(m_line, {}), nullptr, false));
        }
    }
    [[nodiscard]] const std::vector<State>& states() const { return m_states; }
    /// When the newest trajectory was accepted; 0: none.
    [[nodiscard]] std::int64_t commanded_ns() const { return m_commanded_ns; }

    /// When the joint, or its setpoint, was last farther than this from where it is now.
    [[nodiscard]] std::int64_t lastAway_ns(double State::*what, double tolerance_rad) const {
        std::int64_t last_ns = 0;
        for (const State& state : m_states) {
            if (std::abs(state.*what - m_states.back().*what) > tolerance_rad)
                last_ns = state.time_ns;
        }
        return last_ns;
    }
    /// Farthest way from where it was then.
    [[nodiscard]] double movedSince_rad(std::int64_t from_ns) const {
        const State* first = nullptr;
        double farthest_rad = 0.0;
        for (const State& state : m_states) {
            if (state.time_ns < from_ns)
                continue;
            first = first == nullptr ? &state : first;
            farthest_rad = std::max(farthest_rad, std::abs(state.position_rad - first->position_rad));
        }
        return farthest_rad;
    }

private:
    void take(const nlohmann::json& event) {
        if (event.is_discarded())
            return;
        if (event["event"] == "state")
            m_states.push_back({event["steady_ns"], event["position"][m_joint], event["velocity"][m_joint],
                                event["desired"][m_joint]});
        else if (event["event"] == "trajectory" && event["accepted"] == true)
            m_commanded_ns = event["steady_ns"];
    }

    std::ifstream m_file;
    std::size_t m_joint;
    std::string m_line;
    std::vector<State> m_states;
    std::int64_t m_commanded_ns = 0;
};

} // namespace teleta::test
