// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/arm/arm_jog.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/arm/jog_target.h"
#include "backend/arm_model/limit_texts.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"

#include <QCoreApplication>
#include <QStringList>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <poll.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct ArmJogText {
    Q_DECLARE_TR_FUNCTIONS(ArmJogText)
};

constexpr std::int64_t kCommandPeriod_ns = 20'000'000;
/// The arm, and other programs that move it, are looked for so long.
constexpr std::int64_t kReadyWait_ns = 7'500'000'000;
constexpr std::int64_t kRestWait_ns = 3'000'000'000;
/// Without motion for so long the arm is at rest.
constexpr std::int64_t kRestTime_ns = 300'000'000;
constexpr double kRestTolerance = 1e-3; ///< rad or m

/// One joint of the arm and the operator's hand on it.
class Jog {
public:
    Jog(JogTarget& target, std::size_t joint)
        : m_target(target)
        , m_joint(joint) {}

    /// Gives a command when it is due, with the rate of the joint, and takes what the arm tells.
    void turn(double rate) {
        const std::int64_t now_ns = core::steadyNow_ns();
        if (now_ns >= m_nextCommand_ns) {
            core::ArmCommand command;
            command.rate_radPerS = core::JointVector::zeros(m_target.arm().description().joints());
            command.rate_radPerS[m_joint] = rate;
            command.time_ns = now_ns;
            m_target.arm().post(command);
            m_nextCommand_ns = now_ns + kCommandPeriod_ns;
        }
        (void)m_wakeup.waitFor(std::chrono::nanoseconds(m_nextCommand_ns - core::steadyNow_ns()));
        for (core::JointSample sample; m_target.arm().joints().pop(sample);)
            m_track.emplace_back(sample.time_ns, sample.angle_rad[m_joint]);
        m_flags |= m_target.flags();
    }
    void hurry() { m_nextCommand_ns = 0; }

    void start() { m_target.arm().start(m_wakeup); }
    /// All but the newest sample. seen() first.
    void forget() {
        m_track.erase(m_track.begin(), m_track.end() - 1);
        m_flags = 0;
    }

    [[nodiscard]] bool seen() const { return !m_track.empty(); }
    [[nodiscard]] double position() const { return m_track.back().second; }
    [[nodiscard]] std::uint32_t flags() const { return m_flags; }
    /// When the joint was last away from where it is now; nothing: not since the track began.
    [[nodiscard]] std::optional<std::int64_t> lastAway_ns() const {
        for (auto at = m_track.rbegin(); at != m_track.rend(); ++at) {
            if (std::abs(at->second - position()) > kRestTolerance)
                return at->first;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool atRest() const {
        return m_track.back().first - lastAway_ns().value_or(m_track.front().first) > kRestTime_ns;
    }

private:
    JogTarget& m_target;
    std::size_t m_joint;
    core::Wakeup m_wakeup;
    std::vector<std::pair<std::int64_t, double>> m_track; ///< times and positions
    std::int64_t m_nextCommand_ns = 0;
    std::uint32_t m_flags = 0;
};

struct JogResult {
    double way = 0.0;
    double held_s = 0.0; ///< how long the switch was held
    std::optional<double> toRest_s;
    std::uint32_t flags = 0;
    std::string problem; ///< what held the arm before the time was over
};

/// Waits for a line from the terminal; false: not agreed, or interrupted.
bool agreed(const QString& question) {
    std::cerr << question.toStdString() << std::flush;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    constexpr int kLook_ms = 100;
    while (!interrupted()) {
        if (poll(&input, 1, kLook_ms) <= 0)
            continue;
        std::string answer;
        std::getline(std::cin, answer);
        return answer == "yes";
    }
    return false;
}

core::Expected<void> waitUntilReady(Jog& jog, const JogTarget& target) {
    const std::int64_t end_ns = core::steadyNow_ns() + kReadyWait_ns;
    for (;;) {
        // The switch is seen let go.
        jog.turn(0.0);
        const std::string problem = target.problem();
        if (interrupted())
            return core::Unexpected(interruption());
        if (jog.seen() && target.ready() && problem.empty())
            return {};
        if (core::steadyNow_ns() > end_ns)
            return core::failed(core::ErrorKind::unavailable,
                                ArmJogText::tr("the arm cannot be moved: %1")
                                    .arg(problem.empty() ? ArmJogText::tr("no joint states were received")
                                                         : QString::fromStdString(problem)));
    }
}

/// After waitUntilReady(), which has seen the joint.
JogResult move(Jog& jog, const JogTarget& target, double rate, double time_s) {
    JogResult result;
    jog.forget();
    const double from = jog.position();
    const std::int64_t start_ns = core::steadyNow_ns();
    const std::int64_t end_ns = start_ns + std::llround(time_s * 1e9);
    jog.hurry();
    while (!interrupted() && core::steadyNow_ns() < end_ns) {
        jog.turn(rate);
        result.problem = target.problem();
        if (!result.problem.empty())
            break;
    }
    const std::int64_t letGo_ns = core::steadyNow_ns();
    result.held_s = static_cast<double>(letGo_ns - start_ns) * 1e-9;
    jog.hurry();
    while (!jog.atRest() && core::steadyNow_ns() < letGo_ns + kRestWait_ns)
        jog.turn(0.0);
    result.way = jog.position() - from;
    if (jog.atRest())
        result.toRest_s =
            std::max(0.0, static_cast<double>(jog.lastAway_ns().value_or(letGo_ns) - letGo_ns) * 1e-9);
    result.flags = jog.flags();
    return result;
}

core::Expected<void> print(const JogResult& result, const ArmJogOptions& options, const QString& unit) {
    if (options.json) {
        nlohmann::ordered_json limits = nlohmann::ordered_json::array();
        for (const arm_model::NamedLimit& limit : arm_model::namedLimits()) {
            if ((result.flags & static_cast<std::uint32_t>(limit.flag)) != 0)
                limits.push_back(limit.name);
        }
        return printDocument({{"joint", options.joint},
                              {"unit", unit.toStdString()},
                              {"way", result.way},
                              {"held_s", result.held_s},
                              {"time_to_rest_s", orNull(result.toRest_s)},
                              {"limits", limits}});
    }
    QString text = ArmJogText::tr("%1 moved %2 %3 in %4 s.")
                       .arg(QString::fromStdString(options.joint), forPeople(result.way), unit,
                            forPeople(result.held_s)) +
                   QLatin1Char(' ');
    text += result.toRest_s ? ArmJogText::tr("It was at rest %1 s after the command ended.")
                                  .arg(forPeople(*result.toRest_s, 3))
                            : ArmJogText::tr("It was not seen to come to rest.");
    text += QLatin1Char('\n');
    const QStringList limits = arm_model::limitTexts(result.flags);
    if (!limits.isEmpty())
        text +=
            ArmJogText::tr("Active limits: %1.").arg(limits.join(QStringLiteral(", "))) + QLatin1Char('\n');
    return printText(text.toStdString());
}

} // namespace

core::Expected<void> jogArm(const ArmJogOptions& options) {
    TELETA_CHECK(checkJogFile(options.path));
    if (!options.yes && isatty(STDIN_FILENO) == 0)
        refuse("--yes", ArmJogText::tr("there is no terminal to ask on; add --yes to move the arm"));
    const core::StopSwitch stop;
    core::Expected<std::unique_ptr<JogTarget>> opened = openJogTarget(options.path, options.arm, stop);
    if (!opened)
        return core::Unexpected(interrupted() ? interruption() : opened.error());
    JogTarget& target = **opened;
    const std::vector<JogTarget::Joint> joints = target.joints();
    const std::size_t joint = jointOf(joints, options.joint);
    const QString unit = QLatin1String(joints[joint].unit);
    Jog jog(target, joint);
    jog.start();
    TELETA_CHECK(waitUntilReady(jog, target));
    if (!options.yes) {
        if (!agreed(ArmJogText::tr("This moves %1 of %2 at %3 %4/s for %5 s. Type \"yes\" to move it: ")
                        .arg(QString::fromStdString(options.joint), target.name(), forPeople(options.rate),
                             unit, forPeople(options.time_s))))
            return core::failed(core::ErrorKind::cancelled, ArmJogText::tr("nothing was moved"));
        TELETA_CHECK(waitUntilReady(jog, target));
    }
    const JogResult result = move(jog, target, options.rate, options.time_s);
    target.arm().stop();
    TELETA_CHECK(unlessCut(print(result, options, unit)));
    if (!result.problem.empty())
        return core::failed(
            core::ErrorKind::unavailable,
            ArmJogText::tr("the motion was cut short: %1").arg(QString::fromStdString(result.problem)));
    return {};
}

} // namespace teleta::cli
