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

/// A program that plays an excitation on one tactor without mapping it to the range of the motor. The
/// player's limits and watchdogs apply as to every program. excitation is copied. Thread: any.
[[nodiscard]] playback::Program programOf(const Excitation& excitation, std::size_t tactor);

/// Plays an excitation on one tactor and records the motor's speed from the bracelet's own sensor at 1 kHz,
/// together with the drive that was actually written. Blocks until done. When a stop is requested the program
/// ends; when it was requested before the call, nothing is played. progress: 0 .. 1. clock: that of the
/// player. Error: unavailable: the bracelet has no sensor; refused: playing ended early (STOP, unplugged,
/// another command); cancelled. Thread: any but the GUI's.
[[nodiscard]] core::Expected<MotorRecording>
recordExcitation(playback::Player& player, const core::BraceletSource& bracelet, std::size_t tactor,
                 const Excitation& excitation, const std::stop_token& stop, std::atomic<double>& progress,
                 core::PacingClock& clock);

} // namespace teleta::motors
