// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/messages.h"

#include <span>
#include <string>
#include <vector>

namespace teleta::ros {

/// A message of joint states, and what its C struct borrows.
struct JointMessage {
    std::vector<std::string> names;
    std::vector<double> position;
    std::vector<double> velocity{};
    std::vector<double> effort{};
    Time stamp{};
    std::string frame{};
    std::vector<char*> pointers{};
    JointState state{};

    [[nodiscard]] const JointState& message() {
        pointers.clear();
        for (std::string& name : names)
            pointers.push_back(name.data());
        state.header = {stamp, frame.data()};
        lend(state.name, std::span(pointers));
        lend(state.position, std::span(position));
        lend(state.velocity, std::span(velocity));
        lend(state.effort, std::span(effort));
        return state;
    }
};

} // namespace teleta::ros
