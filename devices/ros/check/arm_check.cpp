// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/check/arm_check.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/ros/stamps.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/qos_text.h"
#include "devices/dds/wait_set.h"
#include "devices/ros/arm_chain.h"
#include "devices/ros/arm_commander.h"
#include "devices/ros/frame_readers.h"
#include "devices/ros/joint_watch.h"
#include "devices/ros/wall_clock.h"
#include "devices/ros/wrench_readers.h"
#include "devices/ros/wrench_watch.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::ros_arm {

namespace {

struct ArmCheckText {
    Q_DECLARE_TR_FUNCTIONS(RosArmCheck)
};

constexpr int kDepth = 64;
constexpr std::int64_t kCheckLook_ns = 50'000'000;
/// Clocks that differ by more are told apart from delays of the network.
constexpr double kNoticedClock_s = 0.1;

QString asText(const std::string& text) {
    return QString::fromStdString(text);
}

QString listOf(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names)
        list << asText(name);
    return list.join(QStringLiteral(", "));
}

QString shortNumber(double value) {
    return QString::number(value, 'g', 3);
}

class Findings {
public:
    void add(const char* check, FindingLevel level, const QString& text) {
        m_all.push_back({check, level, text});
    }
    void good(const char* check, const QString& text) { add(check, FindingLevel::good, text); }
    void note(const char* check, const QString& text) { add(check, FindingLevel::note, text); }
    void problem(const char* check, const QString& text) { add(check, FindingLevel::problem, text); }
    [[nodiscard]] std::vector<ArmFinding> take() { return std::move(m_all); }

private:
    std::vector<ArmFinding> m_all;
};

void findJoints(Findings& findings, const RosArmFile& file, std::size_t joints, const ArmObservation& seen) {
    const QString topic = asText(file.jointStates);
    const std::string ddsTopic = ros::ddsTopicOf(file.jointStates);
    const auto writers = std::ranges::count_if(
        seen.ends, [&](const dds::FoundEnd& end) { return end.writes && end.ddsTopic == ddsTopic; });
    if (seen.counters.messages == 0)
        findings.problem("joints", writers == 0
                                       ? ArmCheckText::tr("nobody publishes %1").arg(topic)
                                       : ArmCheckText::tr("nothing was sent on %1").arg(topic) +
                                             (seen.jointMismatch
                                                  ? QStringLiteral(": ") + dds::describe(*seen.jointMismatch)
                                                  : QString()));
    else if (!seen.missing.empty())
        findings.problem("joints",
                         ArmCheckText::tr("%1 does not report: %2").arg(topic, listOf(seen.missing)));
    else
        findings.good("joints", ArmCheckText::tr("%1 reports all %2 joints").arg(topic).arg(joints));
    if (writers > 1)
        findings.note("joints", ArmCheckText::tr("%1 publishers of %2").arg(writers).arg(topic));
    if (!seen.unknown.empty())
        findings.note(
            "joints",
            ArmCheckText::tr("%1 reports %2, which the arm does not have").arg(topic, listOf(seen.unknown)));
    if (seen.counters.malformed > 0)
        findings.note(
            "joints",
            ArmCheckText::tr("%1 messages were inconsistent and were ignored").arg(seen.counters.malformed));
    if (seen.fault)
        findings.problem("joints", describe(*seen.fault));
}

void findRate(Findings& findings, const RosArmFile& file, const ArmObservation& seen) {
    if (seen.samples == 0)
        return;
    const QString text = ArmCheckText::tr("%1 samples a second, longest gap %2 s")
                             .arg(shortNumber(static_cast<double>(seen.samples) / seen.time_s),
                                  shortNumber(seen.longestGap_s));
    if (seen.longestGap_s > file.jointTimeout_s)
        findings.problem(
            "rate", text + ArmCheckText::tr("; joint_timeout_s is %1").arg(shortNumber(file.jointTimeout_s)));
    else
        findings.good("rate", text);
}

void findEffort(Findings& findings, const RosArmFile& file, const ArmObservation& seen) {
    if (file.effortUnit == EffortUnit::none || seen.samples == 0)
        return;
    const QString unit = QLatin1String(file.effortUnit == EffortUnit::ampere ? "A" : "Nm");
    if (seen.effortTold)
        findings.good("effort", ArmCheckText::tr("reported, in %1 according to the file").arg(unit));
    else if (!file.limits.effortStop_Nm.empty())
        findings.problem("effort", ArmCheckText::tr("not reported, so effort_stop cannot work"));
    else
        findings.note("effort", ArmCheckText::tr("not reported"));
}

void findForce(Findings& findings, const RosArmFile& file, const ArmObservation& seen) {
    if (!file.wrench || !seen.wrench)
        return;
    const QString topic = asText(file.wrench->topic);
    const FindingLevel bad = file.limits.forceStop_N ? FindingLevel::problem : FindingLevel::note;
    if (seen.wrench->messages == 0)
        return findings.add("force", bad, ArmCheckText::tr("%1 reports no force").arg(topic));
    if (!seen.wrench->unknownFrame.empty())
        return findings.add(
            "force", bad,
            ArmCheckText::tr("%1 reports a force in the frame %2, which neither the description nor "
                             "/tf_static nor /tf (within the last second) has")
                .arg(topic, asText(seen.wrench->unknownFrame)));
    const QString text =
        ArmCheckText::tr("%1 messages a second, longest gap %2 s, at most %3 N")
            .arg(shortNumber(static_cast<double>(seen.wrench->messages) / seen.time_s),
                 shortNumber(seen.wrench->longestGap_s), shortNumber(seen.wrench->strongest_N));
    if (seen.wrench->longestGap_s > file.wrench->timeout_s)
        findings.add("force", bad,
                     text + ArmCheckText::tr("; timeout_s is %1").arg(shortNumber(file.wrench->timeout_s)));
    else if (file.limits.forceStop_N && !(seen.wrench->strongest_N <= *file.limits.forceStop_N))
        findings.problem(
            "force",
            text + ArmCheckText::tr("; force_stop_N is %1").arg(shortNumber(*file.limits.forceStop_N)));
    else
        findings.good("force", text);
}

/// Up to here the tip is where the robot has it.
constexpr double kSamePlace_m = 0.001;
constexpr double kSameTurn_rad = 0.005;
/// A description of this kind of robot, without the calibration of this one, is hardly farther off.
constexpr double kSameRobot_m = 0.02;
constexpr double kSameRobot_rad = 0.05;

void findFrames(Findings& findings, const arm_model::SerialChain& chain, const FrameObservation& seen) {
    if (seen.messages == 0)
        return; // not every robot has them
    if (!seen.connected)
        return findings.note("frames", ArmCheckText::tr("/tf does not lead from %1 to %2")
                                           .arg(asText(chain.baseLink()), asText(chain.tipLink())));
    if (seen.compared == 0)
        return findings.note("frames", ArmCheckText::tr("/tf has no pose of the time of a joint sample"));
    const QString apart = ArmCheckText::tr("%1 mm and %2° off at most")
                              .arg(QString::number(1e3 * seen.farthest_m, 'f', 2),
                                   QString::number(seen.largestTurn_rad * 180.0 / std::numbers::pi, 'f', 2));
    if (seen.farthest_m <= kSamePlace_m && seen.largestTurn_rad <= kSameTurn_rad)
        return findings.good("frames", ArmCheckText::tr("the tip is where /tf has it: %1").arg(apart));
    const QString off = ArmCheckText::tr("the tip is not where /tf has it: %1").arg(apart);
    if (seen.farthest_m <= kSameRobot_m && seen.largestTurn_rad <= kSameRobot_rad)
        findings.note("frames", off);
    else
        findings.problem("frames", off + ArmCheckText::tr("; the description is another robot's, or a joint "
                                                          "has another zero"));
}

void findClock(Findings& findings, const ArmObservation& seen) {
    if (seen.zeroStamps > 0)
        findings.note("clock", ArmCheckText::tr("%1 stamps are zero").arg(seen.zeroStamps));
    if (!seen.clockDifference_s)
        return;
    const QString text =
        ArmCheckText::tr("stamps are %1 s behind this computer").arg(shortNumber(*seen.clockDifference_s));
    findings.add(
        "clock",
        std::abs(*seen.clockDifference_s) > kNoticedClock_s ? FindingLevel::note : FindingLevel::good, text);
}

/// A force sensor that is looked at for some time.
struct WatchedWrench {
    [[nodiscard]] static core::Expected<WatchedWrench>
    open(const std::shared_ptr<const dds::Participant>& participant, const RosWrenchFile& file,
         const std::shared_ptr<const arm_model::SerialChain>& chain) {
        TELETA_TRY(auto readers, WrenchReaders::open(participant, file, kDepth));
        return WatchedWrench{std::move(readers), WrenchWatch(file, chain), {}, {}};
    }

    void look() {
        readers.take(watch, [this](std::int64_t read_ns) {
            const double force_N = watch.newest_N();
            if (!(force_N <= observed.strongest_N) && !std::isnan(observed.strongest_N))
                observed.strongest_N = force_N;
            if (last_ns)
                observed.longestGap_s =
                    std::max(observed.longestGap_s, static_cast<double>(read_ns - *last_ns) * 1e-9);
            last_ns = read_ns;
        });
    }

    [[nodiscard]] WrenchObservation seen(std::int64_t now_ns, double time_s) const {
        WrenchObservation told = observed;
        told.messages = watch.messages();
        told.unknownFrame = watch.unknownFrame();
        told.longestGap_s =
            last_ns ? std::max(told.longestGap_s, static_cast<double>(now_ns - *last_ns) * 1e-9) : time_s;
        return told;
    }

    WrenchReaders readers;
    WrenchWatch watch;
    WrenchObservation observed;
    std::optional<std::int64_t> last_ns;
};

/// Topics of other controllers that take commands of this type.
std::vector<std::string> controllersOf(const std::vector<dds::FoundEnd>& ends, std::string_view type) {
    std::vector<std::string> topics;
    for (const dds::FoundEnd& end : ends) {
        const std::optional<std::string> topic = ros::rosTopicOf(end.ddsTopic);
        if (!end.writes && topic && ros::rosTypeOf(end.ddsType) == type)
            topics.push_back(*topic);
    }
    return topics;
}

void findGuard(Findings& findings, const RosArmFile& file) {
    if (!isGuarded(file.adapter))
        findings.note("guard", ArmCheckText::tr("UNGUARDED: %1 keeps its last command when this program ends "
                                                "or the network fails")
                                   .arg(asText(file.controller)));
}

void findController(Findings& findings, const RosArmFile& file, const std::vector<dds::FoundEnd>& ends) {
    const QString topic = asText(file.commandTopic());
    const std::string ddsTopic = ros::ddsTopicOf(file.commandTopic());
    const std::string_view type = commandTypeOf(file.adapter);
    bool reads = false;
    std::optional<QString> why;
    for (const dds::FoundEnd& end : ends) {
        if (end.ddsTopic != ddsTopic)
            continue;
        if (end.writes) {
            findings.problem("writers", ArmCheckText::tr("someone else commands %1").arg(topic));
            continue;
        }
        const std::optional<ros::QosMismatch> mismatch = ros::mismatch(end.profile, ros::kCommandWriter);
        if (ros::rosTypeOf(end.ddsType) != type)
            why = ArmCheckText::tr("%1 has the type %2").arg(topic, asText(ros::rosTypeOf(end.ddsType)));
        else if (mismatch)
            why = dds::describe(*mismatch);
        else
            reads = true;
    }
    if (reads) {
        findings.good("controller", ArmCheckText::tr("reads %1").arg(topic));
        return;
    }
    const std::vector<std::string> others = controllersOf(ends, type);
    QString text = why ? ArmCheckText::tr("cannot be reached: %1").arg(*why)
                       : ArmCheckText::tr("nobody reads %1").arg(topic);
    if (!why && !others.empty())
        text += ArmCheckText::tr("; found: %1").arg(listOf(others));
    findings.problem("controller", text);
}

} // namespace

core::Expected<WatchedArm> watchArm(const RosArmFile& file, double time_s,
                                    const std::function<bool()>& cancelled) {
    TELETA_TRY(const std::shared_ptr<const dds::Participant> participant,
               dds::Participant::open(file.domain));
    TELETA_TRY(const dds::Discovery discovery, dds::Discovery::open(participant));
    TELETA_TRY(std::shared_ptr<const arm_model::SerialChain> chain, findChain(participant, file, cancelled));
    TELETA_TRY(std::vector<std::string> names, wireNames(file, *chain));
    TELETA_TRY(auto reader, dds::Reader<ros::JointState>::open(participant, ros::ddsTopicOf(file.jointStates),
                                                               ros::kSensorReader.withDepth(kDepth)));
    dds::WaitSet waitSet(participant);
    waitSet.attach(reader);
    JointWatch watch(std::move(names), file.jointStates, file.jointTimeout_s);
    std::optional<WatchedWrench> wrench;
    if (file.wrench) {
        TELETA_TRY(auto opened, WatchedWrench::open(participant, *file.wrench, chain));
        waitSet.attach(opened.readers.wrench);
        wrench.emplace(std::move(opened));
    }
    TELETA_TRY(FrameReaders frameReaders, FrameReaders::open(participant));
    FrameCheck frames(chain);
    ArmObservation seen;
    std::vector<double> differences_s;
    const std::int64_t start_ns = core::steadyNow_ns();
    const std::int64_t end_ns = start_ns + std::llround(time_s * 1e9);
    // The first sample comes when the publisher has found us.
    std::optional<std::int64_t> last_ns;
    std::int64_t now_ns = start_ns;
    for (; now_ns < end_ns; now_ns = core::steadyNow_ns()) {
        if (cancelled && cancelled())
            return core::failed(core::ErrorKind::cancelled, ArmCheckText::tr("the check was interrupted"));
        (void)reader.take([&](const ros::JointState& message, const dds::SampleInfo&) {
            const std::int64_t read_ns = core::steadyNow_ns();
            const std::optional<ros::JoinedJoints> joints = watch.take(message, read_ns);
            seen.missing = watch.missing(read_ns);
            if (!joints)
                return;
            ++seen.samples;
            seen.effortTold = !joints->effort.empty();
            frames.takeJoints(joints->position, joints->stamp_s);
            if (joints->stamp_s != 0.0)
                differences_s.push_back(wallClock_s() - joints->stamp_s);
            if (last_ns)
                seen.longestGap_s =
                    std::max(seen.longestGap_s, static_cast<double>(read_ns - *last_ns) * 1e-9);
            last_ns = read_ns;
        });
        frameReaders.take(frames);
        if (wrench)
            wrench->look();
        if (std::optional<ArmFault> fault = watch.takeFault(); fault && !seen.fault)
            seen.fault = std::move(fault);
        waitSet.wait(kCheckLook_ns);
    }
    seen.time_s = static_cast<double>(now_ns - start_ns) * 1e-9;
    seen.longestGap_s =
        last_ns ? std::max(seen.longestGap_s, static_cast<double>(now_ns - *last_ns) * 1e-9) : seen.time_s;
    if (wrench)
        seen.wrench = wrench->seen(now_ns, seen.time_s);
    seen.frames = frames.seen();
    seen.counters = watch.joiner().counters();
    seen.zeroStamps = watch.joiner().stamps().zero();
    if (!differences_s.empty())
        seen.clockDifference_s = core::medianOf(differences_s);
    seen.unknown = watch.joiner().takeUnknownNames();
    seen.jointMismatch = reader.incompatible();
    seen.ends = discovery.ends();
    std::erase_if(seen.ends, [](const dds::FoundEnd& end) { return end.own; });
    return WatchedArm{std::move(chain), std::move(seen)};
}

std::vector<ArmFinding> findingsOf(const RosArmFile& file, const arm_model::SerialChain& chain,
                                   const ArmObservation& seen) {
    Findings findings;
    findJoints(findings, file, chain.joints(), seen);
    findRate(findings, file, seen);
    findEffort(findings, file, seen);
    findForce(findings, file, seen);
    findFrames(findings, chain, seen.frames);
    findClock(findings, seen);
    findController(findings, file, seen.ends);
    findGuard(findings, file);
    for (const QString& obstacle : obstacles(file, chain))
        findings.problem("file", obstacle);
    return findings.take();
}

} // namespace teleta::ros_arm
