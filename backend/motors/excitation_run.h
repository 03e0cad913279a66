// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/error.h"
#include "backend/motors/excitation.h"
#include "backend/motors/motor_recording.h"
#include "backend/playback/player.h"

#include <atomic>
#include <cstddef>
#include <stop_token>

namespace teleta::motors {

/// Plays drives on one tactor, not mapped by a motor's range; below the player's limits and watchdogs as
/// everything else. excitation is copied. Thread: any.
[[nodiscard]] playback::Program programOf(const Excitation& excitation, std::size_t tactor);

/// Plays an excitation on one tactor and records what the bracelet's own sensor tells of the motor, a
/// thousand times a second, with the drive that was really written. Waits until it is done; its program ends
/// when a stop is requested, and nothing is played when that was before. progress: 0 .. 1. Error:
/// unavailable: the bracelet has no sensor; refused: the playing ended early (STOP, unplugged, a command of
/// somebody else); cancelled. Thread: any but the GUI's; clock is the player's.
[[nodiscard]] core::Expected<MotorRecording>
recordExcitation(playback::Player& player, const core::BraceletSource& bracelet, std::size_t tactor,
                 const Excitation& excitation, const std::stop_token& stop, std::atomic<double>& progress,
                 core::PacingClock& clock);

} // namespace teleta::motors
