// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/arm_drive_control.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulated {

using core::ArmDemand;
using core::ArmDrive;

void ArmDriveControl::post(core::ArmCommand command, std::int64_t now_ns) {
    command.time_ns = std::min(command.time_ns, now_ns);
    m_commands.post(command);
}

void ArmDriveControl::begin(bool programRuns) {
    forgetWishes();
    m_programRuns = programRuns && m_arm.hasProgram;
    m_drive.store(ArmDrive::held, std::memory_order_release);
}

void ArmDriveControl::forgetWishes() {
    (void)m_commands.take();
    (void)m_programWishes.take();
    m_restartWish.store(false, std::memory_order_relaxed);
    m_jog.reset();
    m_programRuns = false;
}

bool ArmDriveControl::takeRestart(bool stopped) {
    if (!m_restartWish.exchange(false, std::memory_order_acq_rel) || stopped)
        return false;
    m_jog.reset();
    m_programRuns = m_arm.hasProgram;
    return true;
}

ArmDemand ArmDriveControl::decide(bool stopped, bool programDone, std::int64_t now_ns,
                                  const std::optional<core::JointVector>& reference_rad) {
    ArmDemand demand;
    if (stopped) {
        forgetWishes();
        m_jogsCountFrom_ns = now_ns;
        demand.drive = ArmDrive::stopped;
    } else {
        takeWishes();
        if (jogs(now_ns)) {
            m_programRuns = false;
            if (reference_rad) {
                demand.drive = ArmDrive::jog;
                demand.rate_radPerS = limited(m_jog->rate_radPerS, *reference_rad);
            }
        } else if (m_programRuns && !programDone) {
            demand.drive = ArmDrive::program;
        }
    }
    m_drive.store(demand.drive, std::memory_order_release);
    return demand;
}

void ArmDriveControl::takeWishes() {
    if (const auto wish = m_programWishes.take()) {
        m_programRuns = wish->running && m_arm.hasProgram;
        m_jogsCountFrom_ns = wish->time_ns;
        m_jog.reset();
    }
    if (const auto command = m_commands.take(); command && command->time_ns >= m_jogsCountFrom_ns) {
        m_jog = command;
        for (double& rate_radPerS : m_jog->rate_radPerS)
            rate_radPerS = std::isnan(rate_radPerS) ? 0.0 : rate_radPerS;
    }
}

bool ArmDriveControl::jogs(std::int64_t now_ns) const {
    // An old time must not overflow the difference.
    return m_jog && m_jog->time_ns >= now_ns - core::ArmCommand::kJogLifetime_ns &&
           std::any_of(m_jog->rate_radPerS.begin(), m_jog->rate_radPerS.end(),
                       [](double rate_radPerS) { return rate_radPerS != 0.0; });
}

core::JointVector ArmDriveControl::limited(const core::JointVector& rate_radPerS,
                                           const core::JointVector& reference_rad) const {
    core::JointVector limits = core::JointVector::zeros(m_arm.joints());
    for (std::size_t joint = 0; joint < limits.size(); ++joint) {
        const double fastest = std::max(0.0, m_arm.fastest_radPerS[joint]);
        // As far as one step may go without leaving the range; from outside of it, back only.
        const double up =
            std::max(0.0, (m_arm.highest_rad[joint] - reference_rad[joint]) * m_arm.nominalRate_Hz);
        const double down =
            std::max(0.0, (reference_rad[joint] - m_arm.lowest_rad[joint]) * m_arm.nominalRate_Hz);
        limits[joint] = std::clamp(rate_radPerS[joint], -std::min(fastest, down), std::min(fastest, up));
    }
    return limits;
}

} // namespace teleta::simulated
