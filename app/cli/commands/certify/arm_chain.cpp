// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/arm_chain.h"

#include "app/cli/base/interruption.h"
#include "app/cli/commands/arm/jog_target.h"
#include "app/cli/commands/certify/chain_lines.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::cli {

namespace {

constexpr std::int64_t kChainPeriod_ns = 20'000'000;

/// The operator's hand.
class Hand {
public:
    Hand(JogTarget& target, const ArmChainOptions& options)
        : m_target(target)
        , m_joint(jointOf(target.joints(), options.joint))
        , m_rate(options.rate)
        , m_centre(options.centre) {}

    /// Presses the switch, where nothing is in the way; else says what is.
    void press() {
        if (m_held)
            return;
        const std::string problem = m_target.problem();
        if (!problem.empty())
            say("problem " + problem);
        if (!m_seen || !m_target.ready() || !problem.empty())
            return;
        m_held = true;
        say("driving");
    }
    void letGo() {
        if (m_held)
            say("idle");
        m_held = false;
    }

    /// Takes what the arm tells, and gives a command when it is due.
    void turn(std::int64_t now_ns) {
        for (core::JointSample sample; m_target.arm().joints().pop(sample);)
            see(sample.angle_rad[m_joint]);
        if (!m_target.problem().empty())
            letGo();
        if (now_ns < m_nextCommand_ns)
            return;
        m_nextCommand_ns = now_ns + kChainPeriod_ns;
        core::ArmCommand command;
        command.rate_radPerS = core::JointVector::zeros(m_target.arm().description().joints());
        command.rate_radPerS[m_joint] = m_held ? m_direction * m_rate : 0.0;
        command.time_ns = now_ns;
        m_target.arm().post(command);
    }
    [[nodiscard]] std::int64_t nextCommand_ns() const { return m_nextCommand_ns; }

private:
    void see(double position) {
        m_seen = true;
        if (position > m_centre + kReach_s * m_rate)
            m_direction = -1.0;
        else if (position < m_centre - kReach_s * m_rate)
            m_direction = 1.0;
    }

    JogTarget& m_target;
    std::size_t m_joint;
    double m_rate;
    double m_centre;
    double m_direction = 1.0;
    bool m_held = false;
    bool m_seen = false; ///< a position came
    std::int64_t m_nextCommand_ns = 0;
};

} // namespace

core::Expected<void> runArmChain(const ArmChainOptions& options) {
    core::StopSwitch stop;
    TELETA_TRY(const std::unique_ptr<JogTarget> target, openJogTarget(options.path, options.device, stop));
    Hand hand(*target, options);
    core::Wakeup wakeup;
    target->arm().start(wakeup);
    CommandReader commands;
    while (!interrupted() && !commands.closed()) {
        (void)wakeup.waitFor(std::chrono::nanoseconds(hand.nextCommand_ns() - core::steadyNow_ns()));
        while (const std::optional<std::string> command = commands.next()) {
            if (*command == "go")
                hand.press();
            else if (*command == "pause")
                hand.letGo();
            else if (*command == "stop")
                stop.engage();
            else if (*command == "release")
                stop.release();
        }
        hand.turn(core::steadyNow_ns());
    }
    hand.letGo();
    target->arm().stop();
    return {};
}

} // namespace teleta::cli
