// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote/remote_arm.h"

#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "devices/site/boot_name.h"
#include "devices/site/remote/remote_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::site_link {

namespace {

constexpr std::size_t kQueueSamples = 4096;
/// A batch ends with what one look at the topic brings.
constexpr std::size_t kBatchSamples = 64;

} // namespace

core::Expected<std::unique_ptr<RemoteArm>> RemoteArm::open(std::shared_ptr<SiteClient> site,
                                                           const std::string& name,
                                                           core::ArmDescription description, bool hasWrench) {
    TELETA_TRY(auto reader,
               dds::Reader<ros::JointBlock>::open(site->participant(), site->topics().joints(name),
                                                  kStreamed.withDepth(kReaderDepth)));
    std::optional<dds::Reader<ros::TactileBlock>> wrench;
    if (hasWrench) {
        TELETA_TRY(auto opened,
                   dds::Reader<ros::TactileBlock>::open(site->participant(), site->topics().wrench(name),
                                                        kStreamed.withDepth(kReaderDepth)));
        wrench.emplace(std::move(opened));
    }
    return std::unique_ptr<RemoteArm>(
        new RemoteArm(std::move(site), name, std::move(description), std::move(reader), std::move(wrench)));
}

RemoteArm::RemoteArm(std::shared_ptr<SiteClient> site, std::string name, core::ArmDescription description,
                     dds::Reader<ros::JointBlock> reader,
                     std::optional<dds::Reader<ros::TactileBlock>> wrenchReader)
    : m_site(std::move(site))
    , m_name(std::move(name))
    , m_description(std::move(description))
    , m_reader(std::move(reader))
    , m_wrenchReader(std::move(wrenchReader))
    , m_waitSet(m_site->participant())
    , m_outlet(kQueueSamples, kBatchSamples)
    , m_wrenches(kQueueSamples) {
    m_waitSet.attach(m_reader);
    if (m_wrenchReader)
        m_waitSet.attach(*m_wrenchReader);
}

core::ArmDrive RemoteArm::drive() const {
    const SiteView view = m_site->view();
    const auto found = std::ranges::find(view.arms, m_name, &RemoteArmState::name);
    return found == view.arms.end() ? core::ArmDrive::held : found->drive;
}

std::string RemoteArm::hindrance() const {
    return hindranceOf(m_site->view(), m_site->file().console, m_name);
}

core::ArmReport RemoteArm::report() const {
    const SiteView view = m_site->view();
    const auto found = std::ranges::find(view.arms, m_name, &RemoteArmState::name);
    core::ArmReport report;
    if (view.reached && found != view.arms.end())
        report.activeLimits = found->flags;
    return report;
}

void RemoteArm::open(core::Wakeup& consumer) {
    m_outlet.open(consumer, core::steadyNow_ns());
}

void RemoteArm::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_description.nominalRate_Hz);
    while (!stop.stop_requested()) {
        m_waitSet.wait(RemoteStream::kLook_ns);
        (void)m_reader.take([this](const ros::JointBlock& block, const dds::SampleInfo&) { take(block); });
        if (m_wrenchReader)
            (void)m_wrenchReader->take(
                [this](const ros::TactileBlock& block, const dds::SampleInfo&) { takeWrench(block); });
        m_outlet.flush();
        RemoteStream::watchSilence(m_outlet, m_outlet.lastData_ns(), staleAfter_ns,
                                   [this] { return silenceText(*m_site); });
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
}

void RemoteArm::take(const ros::JointBlock& block) {
    const std::int64_t arrived_ns = core::steadyNow_ns();
    const std::size_t joints = m_description.joints();
    const auto times = ros::view(block.read_site_ns);
    const auto source = ros::view(block.source_s);
    const auto position = ros::view(block.position);
    const auto effort = ros::view(block.effort);
    const auto offset = ros::view(block.reference_offset);
    const std::size_t count = times.size();
    // A block whose lengths contradict each other says nothing.
    if (source.size() != count || position.size() != count * joints || effort.size() != count * joints ||
        offset.size() != count * joints)
        return;
    const RemoteStream::Step step = m_stream.take(bootNameOf(block.site_boot), block.first, count);
    if (!step.use)
        return;
    if (step.lost > 0)
        m_outlet.lose(step.lost);
    for (std::size_t i = 0; i < count; ++i) {
        core::JointSample sample;
        sample.time_ns = m_stream.inOrder(m_site->readTime_ns(times[i], arrived_ns));
        sample.sourceTime_s = source[i];
        sample.arrived_ns = arrived_ns;
        sample.discontinuity = i == 0 && (step.discontinuity || block.discontinuity != 0);
        sample.angle_rad = core::JointVector::zeros(joints);
        sample.reference_rad = sample.angle_rad;
        sample.torque_Nm = sample.angle_rad;
        bool told = true;
        for (std::size_t joint = 0; joint < joints; ++joint) {
            const std::size_t at = i * joints + joint;
            sample.angle_rad[joint] = position[at];
            sample.reference_rad[joint] = position[at] + static_cast<double>(offset[at]);
            sample.torque_Nm[joint] = static_cast<double>(effort[at]);
            told = told && std::isfinite(effort[at]);
        }
        if (!told)
            sample.torque_Nm = {};
        m_outlet.deliver(std::move(sample), arrived_ns);
    }
}

void RemoteArm::takeWrench(const ros::TactileBlock& block) {
    constexpr std::size_t kNumbers = 6;
    const std::int64_t arrived_ns = core::steadyNow_ns();
    const auto times = ros::view(block.read_site_ns);
    const auto source = ros::view(block.source_s);
    const auto values = ros::view(block.values);
    if (source.size() != times.size() || values.size() != times.size() * kNumbers ||
        !m_wrenchStream.take(bootNameOf(block.site_boot), block.first, times.size()).use)
        return;
    for (std::size_t i = 0; i < times.size(); ++i) {
        core::WrenchSample sample;
        sample.time_ns = m_wrenchStream.inOrder(m_site->readTime_ns(times[i], arrived_ns));
        sample.sourceTime_s = source[i];
        const auto numbers = values.subspan(i * kNumbers, kNumbers);
        std::ranges::copy(numbers.first(3), sample.force_N.begin());
        std::ranges::copy(numbers.last(3), sample.torque_Nm.begin());
        m_wrenches.push(std::move(sample));
    }
}

} // namespace teleta::site_link
