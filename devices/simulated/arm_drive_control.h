// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/threads/mailbox.h"

#include <atomic>
#include <cstdint>
#include <optional>

namespace teleta::simulated {

/// Decides what may move an arm in each step, and how fast.
///   STOP      nothing moves; commands that were given before its release are dropped, and the program does
///             not go on by itself after it
///   jog       a command counts for ArmCommand::kJogLifetime_ns; a rate other than zero ends the program
///   program   until it is held, ends, or the operator takes over
/// Rates: NaN is 0, at most fastest_radPerS, and no further than the end of the joint's range.
/// Thread: post, setProgramRunning, restartProgram from one commanding thread; drive from any; the rest is
/// for the worker.
class ArmDriveControl {
public:
    explicit ArmDriveControl(const core::ArmDescription& arm)
        : m_arm(arm) {}

    /// A command of the future counts as given now.
    void post(core::ArmCommand command, std::int64_t now_ns);
    void setProgramRunning(bool running, std::int64_t now_ns) { m_programWishes.post({running, now_ns}); }
    void restartProgram() { m_restartWish.store(true, std::memory_order_release); }
    [[nodiscard]] core::ArmDrive drive() const { return m_drive.load(std::memory_order_acquire); }

    /// Forgets all wishes; the program runs or is held. By the worker, or before it runs.
    void begin(bool programRuns);
    /// Whether the world is to begin anew before this step. Never while stopped.
    [[nodiscard]] bool takeRestart(bool stopped);
    /// The demand of one step. reference_rad: where the controller was told to go; empty before the first
    /// step, when there is nothing that a jog could be limited by.
    [[nodiscard]] core::ArmDemand decide(bool stopped, bool programDone, std::int64_t now_ns,
                                         const std::optional<core::JointVector>& reference_rad);

private:
    struct ProgramWish {
        bool running = false;
        std::int64_t time_ns = 0;
    };

    void forgetWishes();
    void takeWishes();
    [[nodiscard]] bool jogs(std::int64_t now_ns) const;
    [[nodiscard]] core::JointVector limited(const core::JointVector& rate_radPerS,
                                            const core::JointVector& reference_rad) const;

    core::ArmDescription m_arm;
    core::Mailbox<core::ArmCommand> m_commands;
    core::Mailbox<ProgramWish> m_programWishes;
    std::atomic<bool> m_restartWish{false};
    std::atomic<core::ArmDrive> m_drive{core::ArmDrive::held};

    std::optional<core::ArmCommand> m_jog;
    std::int64_t m_jogsCountFrom_ns = 0;
    bool m_programRuns = false;
};

} // namespace teleta::simulated
