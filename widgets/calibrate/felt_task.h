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

/// What a person is asked, presentation by presentation, and what follows for the motors.
///   start    one motor: was it felt?
///   balance  motors 2 to 6 one after another: was the second burst (that motor) stronger than the first
///   (motor 1)?
/// Thread: one.
class FeltTask {
public:
    enum class Kind { start, balance };

    /// motor: the one that is asked about; of a balance, the reference is motor 0.
    [[nodiscard]] static FeltTask start(const motors::MotorCalibration& calibration, std::size_t motor);
    [[nodiscard]] static FeltTask balance(const motors::MotorCalibration& calibration);

    [[nodiscard]] Kind kind() const { return m_kind; }
    /// The motor that is asked about now.
    [[nodiscard]] std::size_t motor() const;
    [[nodiscard]] int answers() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] bool done() const;

    /// Bursts of raw drives; of a catch trial silence of the same length.
    [[nodiscard]] playback::Program presentation() const;
    void answer(bool yes);
    /// Takes the last answer back, over motors too. False: there is none.
    bool undo();

    /// What was learnt of the motors meanwhile: the answers change only what they tell.
    void setCalibration(const motors::MotorCalibration& calibration) { m_calibration = calibration; }
    /// The calibration with what the answers tell. Error: what is wrong with the answers; the motor is named.
    [[nodiscard]] core::Expected<motors::MotorCalibration> result() const;
    /// Of a start that is done.
    [[nodiscard]] core::Expected<motors::FeltThreshold> threshold() const;

private:
    FeltTask(Kind kind, const motors::MotorCalibration& calibration, std::size_t first);
    [[nodiscard]] std::size_t current() const;

    Kind m_kind;
    motors::MotorCalibration m_calibration;
    std::size_t m_first;                      ///< motor of the first trials
    std::vector<motors::FeltTrials> m_trials; ///< one a motor that is asked about
    double m_reference = 0.0;                 ///< drive of motor 0 in a balance
};

} // namespace teleta::calibrate
