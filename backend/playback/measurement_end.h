// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/playback/player_types.h"

namespace teleta::playback {

/// Why a measurement that plays something has to end: refused, as the player's playing ended. A status
/// without an ending: something else was played. Thread: any (pure).
[[nodiscard]] core::Unexpected measurementEnd(const PlayerStatus& status);

} // namespace teleta::playback
