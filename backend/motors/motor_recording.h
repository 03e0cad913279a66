// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::motors {

/// How fast one motor turned while it was told what. The vectors have the same length, but `unknown` may be
/// empty; times rise.
struct MotorRecording {
    std::vector<double> time_s;
    std::vector<double> drive; ///< what the device was told, 0 .. 1 of its full drive
    std::vector<double> speed_Hz;
    std::vector<bool> unknown; ///< samples whose speed the sensor does not tell; empty: it tells all

    [[nodiscard]] bool isKnown(std::size_t sample) const { return unknown.empty() || !unknown[sample]; }
    [[nodiscard]] std::size_t size() const { return time_s.size(); }
};

/// Reads a recording of one motor: time_s, commanded (0 .. 1) and speed_hz of a tachometer, or instead of it
/// signal, the samples of an accelerometer or a microphone (speedFromSignal). Other columns are ignored.
/// Error: notFound, ioFailed; badInput with the place: a column is missing, a number is not finite, times do
/// not rise, a drive is out of range; refused: what the signal does not show. Thread: any.
[[nodiscard]] core::Expected<MotorRecording> readMotorRecording(const std::string& path);

/// The same columns, as the reader takes them. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeMotorRecording(const MotorRecording& recording,
                                                       const std::string& path);

/// Checks what the reader checks, for a recording that was made here; where.line is the sample, from 1.
[[nodiscard]] core::Expected<void> checkMotorRecording(const MotorRecording& recording);

} // namespace teleta::motors
