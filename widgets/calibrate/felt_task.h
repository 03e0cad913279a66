// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/felt_threshold.h"
#include "backend/motors/felt_trials.h"
#include "backend/motors/motor_file.h"
#include "backend/playback/player_types.h"

#include <cstddef>
#include <vector>

namespace teleta::calibrate {

/// The presentations and questions of a calibration by feel, and what the answers say about the motors.
///   start    one motor: was it felt?
///   balance  motors 2 to 6 in turn: was the second burst (that motor) stronger than the first (motor 1)?
/// Thread: one.
class FeltTask {
public:
    enum class Kind { start, balance };

    /// motor: the one asked about; in a balance the reference is motor 0.
    [[nodiscard]] static FeltTask start(const motors::MotorCalibration& calibration, std::size_t motor);
    [[nodiscard]] static FeltTask balance(const motors::MotorCalibration& calibration);

    [[nodiscard]] Kind kind() const { return m_kind; }
    /// The motor asked about now.
    [[nodiscard]] std::size_t motor() const;
    [[nodiscard]] int answers() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] bool done() const;

    /// Bursts of raw drives; for a catch trial, silence of the same length.
    [[nodiscard]] playback::Program presentation() const;
    void answer(bool yes);
    /// Undoes the last answer, also that of a previous motor. Returns false if there is none.
    bool undo();

    /// Updates the motors: the answers will change only what they determine.
    void setCalibration(const motors::MotorCalibration& calibration) { m_calibration = calibration; }
    /// The calibration updated by the answers. Error: the problem with the answers, naming the motor.
    [[nodiscard]] core::Expected<motors::MotorCalibration> result() const;
    /// Result of a finished start.
    [[nodiscard]] core::Expected<motors::FeltThreshold> threshold() const;

private:
    FeltTask(Kind kind, const motors::MotorCalibration& calibration, std::size_t first);
    [[nodiscard]] std::size_t current() const;

    Kind m_kind;
    motors::MotorCalibration m_calibration;
    std::size_t m_first;                      ///< motor of the first trials
    std::vector<motors::FeltTrials> m_trials; ///< one per motor asked about
    double m_reference = 0.0;                 ///< drive of motor 0 in a balance
};

} // namespace teleta::calibrate
