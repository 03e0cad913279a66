// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device_state.h"

namespace teleta::recording {

/// The words in RecordingEvent::kind for what happened during a recording. The text of an event is the name
/// of its source, if it has one.

inline constexpr char kSourceJoined[] = "source_joined";
inline constexpr char kSourceLeft[] = "source_left";
inline constexpr char kSettings[] = "settings";
inline constexpr char kStopEngaged[] = "stop_engaged";
inline constexpr char kStopReleased[] = "stop_released";

/// Of a camera; value: number of the contact.
inline constexpr char kContactBegins[] = "contact_begins";
inline constexpr char kContactEnds[] = "contact_ends";
inline constexpr char kBump[] = "bump";
inline constexpr char kFollows[] = "follows";
inline constexpr char kReference[] = "reference";
inline constexpr char kRestart[] = "restart";

/// Of a flat gel; value: number of the contact, or 0.
inline constexpr char kIncipientSlip[] = "incipient_slip";
inline constexpr char kSlip[] = "slip";
inline constexpr char kPictureDark[] = "picture_dark";
inline constexpr char kLightJump[] = "light_jump";
inline constexpr char kGelTorn[] = "gel_torn";

/// For the new state of a source; empty: no event.
[[nodiscard]] constexpr const char* stateWord(core::DeviceState state) {
    switch (state) {
    case core::DeviceState::live:
        return "source_live";
    case core::DeviceState::lost:
        return "source_lost";
    case core::DeviceState::paused:
        return "source_paused";
    case core::DeviceState::finished:
        return "source_finished";
    default:
        return "";
    }
}

} // namespace teleta::recording
