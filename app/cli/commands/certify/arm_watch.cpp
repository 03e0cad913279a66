// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/arm_watch.h"

#include "app/cli/base/interruption.h"
#include "app/cli/commands/arm/jog_target.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/ros/messages.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"
#include "devices/ros/files/ros_arm_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::cli {

namespace {

struct ArmWatchText {
    Q_DECLARE_TR_FUNCTIONS(ArmWatch)
};

constexpr std::int64_t kLook_ns = 20'000'000;
constexpr std::int64_t kFirst_ns = 5'000'000'000;
constexpr std::int64_t kSilent_ns = 2'000'000'000;
/// What is older says nothing of now.
constexpr std::int64_t kRecent_ns = 200'000'000;
constexpr std::size_t kSamplesKept = 65'536; ///< more than a minute at 1 kHz

class RosJointView : public JointView {
public:
    RosJointView(const std::shared_ptr<const dds::Participant>& participant,
                 dds::Reader<ros::JointState> reader, std::string arm, std::string joint)
        : m_reader(std::move(reader))
        , m_waitSet(participant)
        , m_arm(std::move(arm))
        , m_joint(std::move(joint)) {
        m_waitSet.attach(m_reader);
    }

    std::vector<double> wait(std::int64_t longest_ns) override {
        m_waitSet.wait(longest_ns);
        std::vector<double> positions;
        (void)m_reader.take([this, &positions](const ros::JointState& message, const dds::SampleInfo&) {
            const auto names = ros::view(message.name);
            const auto values = ros::view(message.position);
            for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i)
                if (names[i] == m_joint && std::isfinite(values[i]))
                    positions.push_back(values[i]);
        });
        return positions;
    }
    std::string name() const override { return m_arm; }
    bool simulated() const override { return false; }

private:
    dds::Reader<ros::JointState> m_reader;
    dds::WaitSet m_waitSet;
    std::string m_arm;
    std::string m_joint; ///< on the wire
};

class SiteJointView : public JointView {
public:
    /// stop: that of the client.
    SiteJointView(std::unique_ptr<core::StopSwitch> stop, SiteArm arm, std::size_t joint)
        : m_stop(std::move(stop))
        , m_at(std::move(arm))
        , m_joint(joint) {
        m_at.arm->start(m_wakeup);
    }
    ~SiteJointView() override { m_at.arm->stop(); }

    std::vector<double> wait(std::int64_t longest_ns) override {
        (void)m_wakeup.waitFor(std::chrono::nanoseconds(longest_ns));
        std::vector<double> positions;
        for (core::JointSample sample; m_at.arm->joints().pop(sample);)
            positions.push_back(sample.angle_rad[m_joint]);
        return positions;
    }
    std::string name() const override { return m_at.device + " (" + m_at.site->file().name + ")"; }
    bool simulated() const override { return m_at.arm->description().simulated; }

private:
    std::unique_ptr<core::StopSwitch> m_stop;
    SiteArm m_at;
    std::size_t m_joint;
    core::Wakeup m_wakeup;
};

} // namespace

core::Expected<std::unique_ptr<JointView>> viewRosJoint(const std::string& path, const std::string& joint) {
    TELETA_TRY(const ros_arm::RosArmFile file, ros_arm::readRosArm(path));
    TELETA_TRY(const auto participant, dds::Participant::open(file.domain, ""));
    constexpr std::size_t kDepth = 100;
    TELETA_TRY(auto reader, dds::Reader<ros::JointState>::open(participant, ros::ddsTopicOf(file.jointStates),
                                                               ros::kSensorReader.withDepth(kDepth)));
    return std::make_unique<RosJointView>(participant, std::move(reader), file.name, file.wireName(joint));
}

core::Expected<std::unique_ptr<JointView>> viewSiteJoint(const std::string& path, const std::string& device,
                                                         const std::string& joint) {
    TELETA_TRY(auto file, site_link::readRemoteSite(path));
    if (!file.viewer) {
        if (file.meeting.security)
            return core::failed(
                core::ErrorKind::badInput,
                ArmWatchText::tr(
                    "this site has certificates, so a viewer with keys of its own has to watch the arm"),
                ArmWatchText::tr("--viewer with the file of a viewer"), {path});
        file.viewer = true;
        file.console += "_certify";
    }
    auto stop = std::make_unique<core::StopSwitch>();
    TELETA_TRY(SiteArm arm, openSiteArm(file, device, "--device", *stop));
    const std::size_t place = jointOf(arm.joints, joint);
    return std::make_unique<SiteJointView>(std::move(stop), std::move(arm), place);
}

core::Expected<std::unique_ptr<ArmWatch>> ArmWatch::start(std::unique_ptr<JointView> view, double rate) {
    auto watch = std::make_unique<ArmWatch>(std::move(view), rate);
    for (const std::int64_t end_ns = core::steadyNow_ns() + kFirst_ns; !watch->position();) {
        if (interrupted())
            return core::Unexpected(interruption());
        if (core::steadyNow_ns() > end_ns)
            return core::failed(core::ErrorKind::unavailable,
                                ArmWatchText::tr("no position of this joint was received within 5 s"),
                                ArmWatchText::tr("--joint with a joint that the arm reports"));
        std::this_thread::sleep_for(std::chrono::nanoseconds(kLook_ns));
    }
    return watch;
}

ArmWatch::ArmWatch(std::unique_ptr<JointView> view, double rate)
    : m_tolerance(rate * kTolerance_s)
    , m_view(std::move(view))
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

std::optional<double> ArmWatch::position() const {
    const std::lock_guard lock(m_mutex);
    return m_samples.empty() ? std::nullopt : std::optional(m_samples.back().position);
}

ActuatorWatch::Look ArmWatch::newest() const {
    const std::lock_guard lock(m_mutex);
    if (m_samples.empty())
        return {};
    const Sample& last = m_samples.back();
    bool moved = false;
    for (auto at = m_samples.rbegin(); at != m_samples.rend() && last.time_ns - at->time_ns < kStill_ns; ++at)
        moved = moved || std::abs(at->position - last.position) > m_tolerance;
    return {last.time_ns, last.time_ns, moved};
}

std::optional<ActuatorWatch::Look> ArmWatch::offSince(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    std::optional<Look> first;
    for (auto at = m_samples.rbegin(); at != m_samples.rend() && at->time_ns > from_ns; ++at) {
        if (std::abs(at->position - m_samples.back().position) > m_tolerance)
            break;
        first = Look{at->time_ns, at->time_ns, false};
    }
    if (first && core::steadyNow_ns() - m_samples.back().time_ns < kRecent_ns &&
        m_samples.back().time_ns - first->answered_ns >= kStill_ns)
        return first;
    return std::nullopt;
}

bool ArmWatch::wasOnAfter(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    const auto begin =
        std::ranges::find_if(m_samples, [from_ns](const Sample& sample) { return sample.time_ns > from_ns; });
    return std::any_of(begin, m_samples.end(), [&](const Sample& sample) {
        return std::abs(sample.position - begin->position) > m_tolerance;
    });
}

std::int64_t ArmWatch::longestGap_ns(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    std::int64_t longest_ns = 0;
    for (std::size_t k = 1; k < m_samples.size(); ++k)
        if (m_samples[k].time_ns > from_ns)
            longest_ns = std::max(longest_ns, m_samples[k].time_ns - m_samples[k - 1].time_ns);
    return longest_ns;
}

bool ArmWatch::failed() const {
    const std::lock_guard lock(m_mutex);
    return !m_samples.empty() && core::steadyNow_ns() - m_samples.back().time_ns > kSilent_ns;
}

void ArmWatch::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const std::vector<double> positions = m_view->wait(kLook_ns);
        const std::int64_t now_ns = core::steadyNow_ns();
        const std::lock_guard lock(m_mutex);
        if (m_samples.size() + positions.size() > kSamplesKept)
            m_samples.erase(m_samples.begin(),
                            m_samples.begin() + static_cast<std::ptrdiff_t>(m_samples.size() / 2));
        for (const double position : positions)
            m_samples.push_back({now_ns, position});
    }
}

} // namespace teleta::cli
