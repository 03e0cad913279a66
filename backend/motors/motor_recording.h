// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::motors {

/// Drive and speed of one motor over time. The vectors have the same length, except that `unknown` may be
/// empty; times rise.
struct MotorRecording {
    std::vector<double> time_s;
    std::vector<double> drive; ///< commanded drive, 0 .. 1 of the full drive
    std::vector<double> speed_Hz;
    std::vector<bool> unknown; ///< samples without a known speed; empty: all speeds are known

    [[nodiscard]] bool isKnown(std::size_t sample) const { return unknown.empty() || !unknown[sample]; }
    [[nodiscard]] std::size_t size() const { return time_s.size(); }
};

/// Reads the recording of one motor from CSV: time_s, commanded (0 .. 1) and either speed_hz of a tachometer
/// or signal, the samples of an accelerometer or a microphone (speedFromSignal()). Other columns are ignored.
/// Error: notFound, ioFailed; badInput with line and column: a column is missing, a number is not finite,
/// times do not rise, a drive is out of range; refused: as for speedFromSignal(). Thread: any.
[[nodiscard]] core::Expected<MotorRecording> readMotorRecording(const std::string& path);

/// Makes the same checks as the reader for a recording that was not read from a file. Error: as for the
/// reader, with where.line the number of the sample, from 1.
[[nodiscard]] core::Expected<void> checkMotorRecording(const MotorRecording& recording);

} // namespace teleta::motors
