// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/trigger_port.h"

#include <algorithm>

namespace teleta::core {

namespace {

constexpr std::size_t kFirstStimulus = 100;
constexpr std::size_t kFirstAnswer = 200;
constexpr std::size_t kLastStimulus = 99;
constexpr std::size_t kLastAnswer = 55;

} // namespace

std::uint8_t TriggerEvent::byte() const {
    switch (kind) {
    case Kind::session:
        return 1;
    case Kind::sessionEnd:
        return 2;
    case Kind::pause:
        return 3;
    case Kind::goOn:
        return 4;
    case Kind::fault:
        return 5;
    case Kind::stimulus:
        return static_cast<std::uint8_t>(kFirstStimulus + std::min(index, kLastStimulus));
    case Kind::answer:
        return static_cast<std::uint8_t>(kFirstAnswer + std::min(index, kLastAnswer));
    case Kind::noAnswer:
        break;
    }
    return static_cast<std::uint8_t>(kFirstAnswer);
}

std::string TriggerEvent::word() const {
    switch (kind) {
    case Kind::session:
        return "session";
    case Kind::sessionEnd:
        return "end";
    case Kind::pause:
        return "pause";
    case Kind::goOn:
        return "go_on";
    case Kind::fault:
        return "fault";
    case Kind::stimulus:
        return "stimulus_" + std::to_string(index);
    case Kind::answer:
        return "answer_" + std::to_string(index);
    case Kind::noAnswer:
        break;
    }
    return "no_answer";
}

} // namespace teleta::core
