// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/felt_task.h"

#include "backend/motors/strength_balance.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::calibrate {

namespace {

struct FeltText {
    Q_DECLARE_TR_FUNCTIONS(FeltTask)
};

constexpr double kBurst_s = 0.6;
constexpr double kPause_s = 0.4;
/// Strength of the reference in a balance, low enough that weaker motors can match it.
constexpr double kReferenceShare = 0.6;

} // namespace

FeltTask::FeltTask(Kind kind, const motors::MotorCalibration& calibration, std::size_t first)
    : m_kind(kind)
    , m_calibration(calibration)
    , m_first(first) {
}

FeltTask FeltTask::start(const motors::MotorCalibration& calibration, std::size_t motor) {
    FeltTask task(Kind::start, calibration, motor);
    task.m_trials.emplace_back();
    return task;
}

FeltTask FeltTask::balance(const motors::MotorCalibration& calibration) {
    FeltTask task(Kind::balance, calibration, 1);
    const double start = calibration.motors[0].profile.startDrive;
    task.m_reference = start + kReferenceShare * (1.0 - start);
    for (std::size_t i = 1; i < core::kTactors; ++i)
        task.m_trials.emplace_back(motors::StaircaseRules{.lowest = 0.05,
                                                          .first = task.m_reference,
                                                          .smallestStep = 0.02,
                                                          .reversals = 10,
                                                          .mostTrials = 40,
                                                          .catchEvery = 0});
    return task;
}

std::size_t FeltTask::current() const {
    const auto open = std::ranges::find_if(m_trials, [](const auto& trials) { return !trials.done(); });
    return std::min(static_cast<std::size_t>(open - m_trials.begin()), m_trials.size() - 1);
}

std::size_t FeltTask::motor() const {
    return m_first + current();
}

int FeltTask::answers() const {
    std::size_t sum = 0;
    for (const motors::FeltTrials& trials : m_trials)
        sum += trials.trials().size();
    return static_cast<int>(sum);
}

double FeltTask::progress() const {
    double sum = 0.0;
    for (const motors::FeltTrials& trials : m_trials)
        sum += trials.progress();
    return sum / static_cast<double>(m_trials.size());
}

bool FeltTask::done() const {
    return std::ranges::all_of(m_trials, &motors::FeltTrials::done);
}

playback::Program FeltTask::presentation() const {
    const double drive = m_trials[current()].drive();
    const bool pair = m_kind == Kind::balance;
    const double second_s = pair ? kBurst_s + kPause_s : 0.0;
    playback::Program program;
    program.raw = true;
    program.duration_s = second_s + kBurst_s;
    program.evaluate = [=, motor = motor(), reference = m_reference](double time_s) {
        core::Intensities drives{};
        if (pair && time_s < kBurst_s)
            drives[0] = reference;
        if (time_s >= second_s)
            drives[motor] = drive;
        return drives;
    };
    return program;
}

void FeltTask::answer(bool yes) {
    m_trials[current()].answer(yes);
}

bool FeltTask::undo() {
    const auto last = std::find_if(m_trials.rbegin(), m_trials.rend(),
                                   [](const auto& trials) { return !trials.trials().empty(); });
    return last != m_trials.rend() && last->undo();
}

core::Expected<motors::FeltThreshold> FeltTask::threshold() const {
    return motors::estimateThreshold(m_trials.front().trials());
}

core::Expected<motors::MotorCalibration> FeltTask::result() const {
    motors::MotorCalibration calibration = m_calibration;
    core::Intensities equal{};
    equal[0] = m_reference;
    for (std::size_t i = 0; i < m_trials.size(); ++i) {
        auto threshold = motors::estimateThreshold(m_trials[i].trials());
        if (!threshold) {
            core::Error error = threshold.error();
            error.message = FeltText::tr("Motor %1: %2", "a motor, and what is wrong with the answers")
                                .arg(m_first + i + 1)
                                .arg(QString::fromStdString(error.message))
                                .toStdString();
            return core::Unexpected(std::move(error));
        }
        if (m_kind == Kind::balance) {
            equal[i + 1] = threshold->drive;
            continue;
        }
        motors::CalibratedMotor& motor = calibration.motors[m_first];
        const double start = std::clamp(threshold->drive, 0.001, motor.profile.fullDrive - 0.001);
        motor.profile = motors::withStart(motor.profile, start);
        motor.startFrom = motors::CalibratedMotor::Origin::answers;
        motor.startError = threshold->standardError();
    }
    if (m_kind == Kind::balance) {
        const pattern::MotorProfiles balanced = motors::balancedByFeel(calibration.profiles(), equal);
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            motors::CalibratedMotor& motor = calibration.motors[i];
            motor.profile = balanced[i];
            // The start from which it was measured does not change.
            if (motor.startFrom == motors::CalibratedMotor::Origin::assumed)
                motor.startFrom = motors::CalibratedMotor::Origin::answers;
        }
    }
    return calibration;
}

} // namespace teleta::calibrate
