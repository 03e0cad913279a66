// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/ros_arm.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/qos_text.h"
#include "devices/ros/arm_chain.h"
#include "devices/ros/wall_clock.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace teleta::ros_arm {

namespace {

struct RosArmText {
    Q_DECLARE_TR_FUNCTIONS(RosArm)
};

constexpr const char* kNodeName = "teleta";
constexpr std::size_t kQueueSamples = 4096;
/// A batch ends with what one look at the topic brings.
constexpr std::size_t kBatchSamples = 64;
/// At 1 kHz a thread that sleeps for some ms must not lose samples.
constexpr int kReaderDepth = 64;
/// Of an arm that is closed; then it is told to stand at once.
constexpr std::int64_t kLongestBraking_ns = 1'000'000'000;
/// Between looks for other programs.
constexpr std::int64_t kLook_ns = 100'000'000;

/// Our wall clock less the stamps of joint states, between which MoveIt Servo takes our commands for as old
/// as they are.
constexpr double kEarliestStamp_s = -0.02;
constexpr double kLatestStamp_s = 0.08;

core::ArmDescription describeArm(const RosArmFile& file, const arm_model::SerialChain& chain) {
    core::ArmDescription arm;
    arm.name = file.name;
    arm.nominalRate_Hz = 0.0; // nobody tells it
    arm.lowest_rad = chain.lowest();
    arm.highest_rad = chain.highest();
    arm.fastest_radPerS = chain.fastest();
    arm.guarded = isGuarded(file.adapter);
    for (double& fastest : arm.fastest_radPerS)
        fastest *= file.limits.speedScale;
    return arm;
}

/// Why two ends of a topic did not find each other, behind what is missing.
QString withReason(const QString& text, const std::optional<ros::QosMismatch>& mismatch) {
    return mismatch ? text + QStringLiteral(" (") + dds::describe(*mismatch) + QLatin1Char(')') : text;
}

} // namespace

core::Expected<std::unique_ptr<RosArm>> RosArm::open(const RosArmFile& file, const core::StopSwitch& stop,
                                                     const std::function<bool()>& cancelled,
                                                     std::shared_ptr<const core::RequiredDevices> required) {
    TELETA_TRY(const std::shared_ptr<const dds::Participant> participant,
               dds::Participant::open(file.domain, file.announce ? kEnclave : ""));
    TELETA_TRY(std::shared_ptr<const arm_model::SerialChain> chain, findChain(participant, file, cancelled));
    TELETA_TRY(std::vector<std::string> names, wireNames(file, *chain));
    if (const QStringList found = obstacles(file, *chain, required.get()); !found.isEmpty())
        return core::refused(
            RosArmText::tr("the arm cannot be moved: %1").arg(found.join(QStringLiteral("; "))));
    TELETA_TRY(dds::Discovery discovery, dds::Discovery::open(participant));
    TELETA_TRY(auto reader, dds::Reader<ros::JointState>::open(participant, ros::ddsTopicOf(file.jointStates),
                                                               ros::kSensorReader.withDepth(kReaderDepth)));
    TELETA_TRY(auto commander, ArmCommander::open(participant, file, names));
    std::vector<dds::Guid> readers{reader.guid()};
    std::optional<WrenchReaders> wrench;
    if (file.wrench) {
        TELETA_TRY(auto opened, WrenchReaders::open(participant, *file.wrench, kReaderDepth));
        readers.insert(readers.end(),
                       {opened.wrench.guid(), opened.frames.fixed.guid(), opened.frames.moving.guid()});
        wrench.emplace(std::move(opened));
    }
    std::optional<NodeAnnouncement> announcement;
    if (file.announce) {
        TELETA_TRY(NodeAnnouncement told, NodeAnnouncement::open(participant, file.distribution, kNodeName,
                                                                 readers, {commander->writer().guid()}));
        announcement.emplace(std::move(told));
    }
    return std::unique_ptr<RosArm>(
        new RosArm(file, std::move(chain), std::move(names),
                   {participant, std::move(discovery), std::move(reader), std::move(commander),
                    std::move(wrench), std::move(announcement)},
                   stop, std::move(required)));
}

RosArm::RosArm(RosArmFile file, std::shared_ptr<const arm_model::SerialChain> chain,
               std::vector<std::string> names, Ends ends, const core::StopSwitch& stop,
               std::shared_ptr<const core::RequiredDevices> required)
    : m_file(std::move(file))
    , m_chain(std::move(chain))
    , m_description(describeArm(m_file, *m_chain))
    , m_ends(std::move(ends))
    , m_stop(stop)
    , m_required(std::move(required))
    , m_outlet(kQueueSamples, kBatchSamples)
    , m_wrenches(kQueueSamples)
    , m_timing(timingOf(m_file.adapter))
    , m_mover(m_chain, m_file.limits, m_timing.period_ns, m_timing.reaction_s)
    , m_watch(std::move(names), m_file.jointStates, m_file.jointTimeout_s)
    , m_waitSet(m_ends.participant) {
    m_waitSet.attach(m_ends.reader);
    if (m_file.wrench) {
        m_wrench.emplace(*m_file.wrench, m_chain);
        m_waitSet.attach(m_ends.wrench->wrench);
        m_waitSet.attach(m_ends.wrench->frames.fixed);
    }
}

void RosArm::post(const core::ArmCommand& command) {
    m_mover.post(command, core::steadyNow_ns());
}

core::ArmReport RosArm::report() const {
    RosArmState state = m_state.get();
    const bool tellsEffort = m_file.effortUnit != EffortUnit::none;
    return {state.mover.flags, state.rate, tellsEffort ? state.effort : core::JointVector(),
            m_file.effortUnit == EffortUnit::ampere, std::move(state.unknownJoints)};
}

void RosArm::open(core::Wakeup& consumer) {
    m_opened_ns = core::steadyNow_ns();
    m_nextLook_ns = m_opened_ns;
    m_outlet.open(consumer, m_opened_ns);
}

void RosArm::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    std::int64_t next_ns = m_opened_ns + m_timing.period_ns;
    while (!stop.stop_requested()) {
        m_waitSet.wait(next_ns - core::steadyNow_ns());
        takeJoints();
        takeWrench();
        const std::int64_t now_ns = core::steadyNow_ns();
        if (now_ns < next_ns)
            continue;
        step(now_ns);
        next_ns = std::max(next_ns + m_timing.period_ns, now_ns + m_timing.period_ns / 2);
    }
    comeToRest();
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

/// Trajectory controllers stop by themselves.
void RosArm::comeToRest() {
    ArmCommander& commander = *m_ends.commander;
    const std::int64_t begin_ns = core::steadyNow_ns();
    while (!commander.isDone()) {
        if (core::steadyNow_ns() - begin_ns > kLongestBraking_ns)
            commander.halt();
        (void)commander.pause({.dt_s = 1e-9 * static_cast<double>(m_timing.period_ns),
                               .stamp_ns = stampAt_ns(core::steadyNow_ns()),
                               .alone = !m_otherWriter});
        std::this_thread::sleep_for(std::chrono::nanoseconds(m_timing.period_ns));
    }
    commander.forget();
}

void RosArm::takeJoints() {
    (void)m_ends.reader.take([this](const ros::JointState& message, const dds::SampleInfo&) {
        const std::int64_t read_ns = core::steadyNow_ns();
        if (const std::optional<ros::JoinedJoints> joints = m_watch.take(message, read_ns))
            deliver(*joints, read_ns);
    });
    m_outlet.flush();
}

void RosArm::deliver(const ros::JoinedJoints& joints, std::int64_t read_ns) {
    core::JointSample sample;
    sample.time_ns = read_ns;
    sample.sourceTime_s = joints.stamp_s;
    m_wallAtRead_ns = wallClock_ns();
    m_read_ns = read_ns;
    m_clockDifference_s = 1e-9 * static_cast<double>(m_wallAtRead_ns) - joints.stamp_s;
    sample.angle_rad = joints.position;
    sample.torque_Nm = torqueOf(joints);
    const core::JointVector& commanded = m_mover.state().commanded;
    sample.reference_rad = commanded.empty() ? joints.position : commanded;
    sample.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(sample));
}

/// The wall clock then, unless it was set since the newest joints were read: they were found to agree with
/// it.
std::int64_t RosArm::stampAt_ns(std::int64_t now_ns) const {
    return m_wallAtRead_ns + (now_ns - m_read_ns);
}

void RosArm::takeWrench() {
    if (!m_wrench)
        return;
    m_ends.wrench->take(*m_wrench, [this](std::int64_t read_ns) {
        const std::optional<ros::JoinedJoints> joints = m_watch.sampleAt(read_ns);
        if (std::optional<core::WrenchSample> sample =
                joints ? m_wrench->atTip(joints->position) : std::nullopt)
            m_wrenches.push(std::move(*sample));
    });
}

core::JointVector RosArm::torqueOf(const ros::JoinedJoints& joints) const {
    if (m_file.effortUnit != EffortUnit::newtonMetre || joints.effort.empty())
        return {};
    core::JointVector torque = joints.effort;
    if (m_file.effortContainsGravity) {
        const std::optional<core::JointVector> gravity = m_chain->gravityTorque(joints.position);
        if (!gravity)
            return {};
        for (std::size_t i = 0; i < torque.size(); ++i)
            torque[i] -= (*gravity)[i];
    }
    return torque;
}

void RosArm::lookAround(std::int64_t now_ns) {
    if (now_ns < m_nextLook_ns)
        return;
    m_nextLook_ns = now_ns + kLook_ns;
    m_controllers = m_ends.commander->writer().matched();
    m_controllerMismatch = m_ends.commander->writer().incompatible();
    m_jointMismatch = m_ends.reader.incompatible();
    const dds::Guid own = m_ends.commander->writer().guid();
    m_otherWriter =
        std::ranges::any_of(m_ends.discovery.endsOf(ros::ddsTopicOf(m_file.commandTopic())),
                            [&own](const dds::FoundEnd& end) { return end.writes && end.guid != own; });
}

void RosArm::step(std::int64_t now_ns) {
    lookAround(now_ns);
    MoverInput input;
    input.now_ns = now_ns;
    input.stopped = m_stop.engaged();
    input.engagements = m_stop.engagements();
    const bool clockOff = m_file.adapter == Adapter::moveitServo &&
                          !(m_clockDifference_s >= kEarliestStamp_s && m_clockDifference_s <= kLatestStamp_s);
    const bool ready = m_controllers > 0 && now_ns - m_opened_ns >= kSettling_ns && !clockOff;
    // What brakes blindly ends that before it takes another command.
    input.ready = ready && !m_ends.commander->isBraking();
    input.trouble = m_watch.takeFault();
    if (!input.trouble && m_otherWriter)
        input.trouble = ArmFault{ArmFaultKind::otherWriter, m_file.commandTopic()};
    const std::optional<ros::JoinedJoints> joints = m_watch.sampleAt(now_ns);
    if (joints)
        m_known_ns = now_ns;
    else if (m_known_ns && now_ns - *m_known_ns > kSilence_ns && !input.trouble)
        input.trouble = ArmFault{ArmFaultKind::silent, m_file.jointStates};
    // An arm whose effort is to hold it is not known without it.
    const core::JointVector torque = joints ? torqueOf(*joints) : core::JointVector();
    const bool effortMissing = joints && torque.empty() && !m_file.limits.effortStop_Nm.empty();
    std::optional<Eigen::Vector3d> force_Base_N;
    if (joints && m_wrench)
        force_Base_N = m_wrench->takeForce_Base_N(joints->position, now_ns);
    const bool forceMissing = joints && !force_Base_N && m_file.limits.forceStop_N;
    if (joints && !effortMissing && !forceMissing)
        input.reading = arm_model::MotionReading{joints->position, torque, force_Base_N};
    std::string lacking = m_required ? m_required->firstMissing(m_file.required) : std::string();
    input.lacking = !lacking.empty();
    const auto points = m_mover.step(input);
    const MoverState& mover = m_mover.state();
    bool sent = true;
    if (points) {
        sent = m_ends.commander->send({*points, mover.commanded, mover.rate, stampAt_ns(now_ns)});
    } else {
        MotionPause pause{.dt_s = 1e-9 * static_cast<double>(m_timing.period_ns),
                          .stamp_ns = stampAt_ns(now_ns),
                          .alone = !m_otherWriter};
        if (joints && mover.fault && mover.fault->kind == ArmFaultKind::notFollowing)
            pause.blocked = joints->position;
        sent = m_ends.commander->pause(pause);
    }
    m_unsent += sent ? 0 : 1;

    RosArmState state;
    state.mover = mover;
    state.missing = m_watch.missing(now_ns);
    state.controllers = m_controllers;
    state.ready = ready;
    state.unsent = m_unsent;
    state.counters = m_watch.joiner().counters();
    if (joints) {
        state.rate = joints->velocity;
        state.effort = joints->effort;
    }
    for (std::string& name : m_watch.joiner().takeUnknownNames())
        m_unknownJoints.push_back(std::move(name));
    state.unknownJoints = m_unknownJoints;
    state.effortMissing = effortMissing;
    state.forceMissing = forceMissing;
    state.lacking = std::move(lacking);
    if (clockOff)
        state.clockOff_s = m_clockDifference_s;
    state.problem = problemOf(state).toStdString();
    using core::DeviceState;
    // A sample makes it live again.
    if (const DeviceState device = m_outlet.state(); !state.missing.empty())
        m_outlet.setState(device == DeviceState::live ? DeviceState::stale : device, now_ns, state.problem);
    m_state.set(std::move(state));
}

QString RosArm::problemOf(const RosArmState& state) const {
    if (state.mover.fault)
        return describe(*state.mover.fault);
    if (!state.missing.empty()) {
        QStringList names;
        for (const std::string& name : state.missing)
            names << QString::fromStdString(name);
        return withReason(
            RosArmText::tr("%1 does not report: %2")
                .arg(QString::fromStdString(m_file.jointStates), names.join(QStringLiteral(", "))),
            m_jointMismatch);
    }
    if (state.effortMissing)
        return RosArmText::tr("%1 reports no effort, so effort_stop cannot work")
            .arg(QString::fromStdString(m_file.jointStates));
    if (state.forceMissing)
        return m_wrench->unknownFrame().empty()
                   ? RosArmText::tr("%1 reports no force, so force_stop_N cannot work")
                         .arg(QString::fromStdString(m_file.wrench->topic))
                   : RosArmText::tr("%1 reports a force in the frame %2, which neither the description nor "
                                    "/tf_static nor /tf (within the last second) has")
                         .arg(QString::fromStdString(m_file.wrench->topic),
                              QString::fromStdString(m_wrench->unknownFrame()));
    if (!state.lacking.empty())
        return RosArmText::tr("%1, which the arm requires, is not live")
            .arg(QString::fromStdString(state.lacking));
    if (state.clockOff_s)
        return RosArmText::tr("the stamps of %1 are %2 s behind this computer, MoveIt Servo takes %3 to %4")
            .arg(QString::fromStdString(m_file.jointStates))
            .arg(*state.clockOff_s, 0, 'g', 3)
            .arg(kEarliestStamp_s)
            .arg(kLatestStamp_s);
    if (state.controllers == 0)
        return withReason(
            RosArmText::tr("no controller reads %1").arg(QString::fromStdString(m_file.commandTopic())),
            m_controllerMismatch);
    if (!state.ready)
        return RosArmText::tr("looking for other programs");
    if (state.mover.ignoresPress)
        return RosArmText::tr("it was held; let go of the switch and press it again");
    return {};
}

} // namespace teleta::ros_arm
