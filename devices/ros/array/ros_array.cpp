// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/ros_array.h"

#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/qos_text.h"
#include "devices/ros/array/array_message.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::ros_array {

namespace {

struct RosArrayText {
    Q_DECLARE_TR_FUNCTIONS(RosArray)
};

constexpr std::size_t kQueueBlocks = 256;
constexpr int kReaderDepth = 64;
constexpr std::int64_t kLook_ns = 50'000'000;

const dds_topic_descriptor_t& typeOf(ArrayFormat format) {
    switch (format) {
    case ArrayFormat::tactileState:
        return ros::descriptorOf<ros::TactileState>();
    case ArrayFormat::image:
        return ros::descriptorOf<ros::Image>();
    case ArrayFormat::float64MultiArray:
        break;
    }
    return ros::descriptorOf<ros::Float64MultiArray>();
}

const ros::Time* stampOf(const ros::TactileState& message) {
    return &message.header.stamp;
}
const ros::Time* stampOf(const ros::Image& message) {
    return &message.header.stamp;
}
const ros::Time* stampOf(const ros::Float64MultiArray& /*message*/) {
    return nullptr;
}

} // namespace

core::Expected<std::unique_ptr<RosArray>> RosArray::open(RosArrayFile file) {
    TELETA_TRY(std::shared_ptr<const dds::Participant> participant, dds::Participant::open(file.domain));
    TELETA_TRY(auto reader,
               dds::AnyReader::open(participant, ros::ddsTopicOf(file.topic), typeOf(file.format),
                                    ros::kSensorReader.withDepth(kReaderDepth)));
    return std::unique_ptr<RosArray>(
        new RosArray(std::move(file), std::move(participant), std::move(reader)));
}

RosArray::RosArray(RosArrayFile file, std::shared_ptr<const dds::Participant> participant,
                   dds::AnyReader reader)
    : m_file(std::move(file))
    , m_description{.name = m_file.name,
                    .layout = m_file.layout,
                    .unit = m_file.unit,
                    .nominalRate_Hz = m_file.rate_Hz}
    , m_participant(std::move(participant))
    , m_reader(std::move(reader))
    , m_waitSet(m_participant)
    , m_outlet(kQueueBlocks)
    , m_loads(m_file.layout.taxels()) {
    m_waitSet.attach(m_reader);
}

void RosArray::open(core::Wakeup& consumer) {
    m_counters = {};
    m_published.set(m_counters);
    m_misfit.clear();
    m_stamps = {};
    m_lastStamp_s.reset();
    m_time_s = 0.0;
    m_last_ns = core::steadyNow_ns();
    m_outlet.open(consumer, m_last_ns);
}

void RosArray::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_file.rate_Hz);
    const std::int64_t start_ns = core::steadyNow_ns();
    while (!stop.stop_requested()) {
        m_waitSet.wait(kLook_ns);
        takeAll();
        const std::int64_t now_ns = core::steadyNow_ns();
        const core::DeviceState state = m_outlet.state();
        if (state == core::DeviceState::live && now_ns - m_outlet.lastData_ns() > staleAfter_ns)
            m_outlet.setState(core::DeviceState::stale, now_ns, silence());
        else if (state == core::DeviceState::connecting && now_ns - start_ns > staleAfter_ns)
            m_outlet.setState(state, now_ns, silence());
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

void RosArray::takeAll() {
    m_block = {};
    m_block.channels = m_loads.size();
    (void)m_reader.takeAny([this](const void* message, const dds::SampleInfo&) {
        switch (m_file.format) {
        case ArrayFormat::tactileState:
            return take(*static_cast<const ros::TactileState*>(message));
        case ArrayFormat::float64MultiArray:
            return take(*static_cast<const ros::Float64MultiArray*>(message));
        case ArrayFormat::image:
            return take(*static_cast<const ros::Image*>(message));
        }
    });
    if (!m_block.time_ns.empty()) {
        m_block.discontinuity = std::exchange(m_discontinuity, false);
        m_outlet.deliver(std::move(m_block), core::DeviceState::live);
    }
    m_counters.oddStamps = m_stamps.zero() + m_stamps.equal() + m_stamps.backward();
    if (m_published.get() != m_counters)
        m_published.set(m_counters);
}

template <typename Message>
void RosArray::take(const Message& message) {
    const std::int64_t read_ns = core::steadyNow_ns();
    ++m_counters.messages;
    const core::Expected<bool> isFrame = loadsOf(message, m_file, m_loads);
    if (!isFrame) {
        ++m_counters.misfits;
        m_misfit = isFrame.error().message;
        return;
    }
    if (!*isFrame)
        return;
    m_misfit.clear();
    ++m_counters.frames;
    deliver(stampOf(message), read_ns);
}

void RosArray::deliver(const ros::Time* stamp, std::int64_t read_ns) {
    m_block.time_ns.push_back(read_ns);
    m_block.sourceTime_s.push_back(sourceTime_s(stamp, read_ns));
    m_block.values.insert(m_block.values.end(), m_loads.begin(), m_loads.end());
}

double RosArray::sourceTime_s(const ros::Time* stamp, std::int64_t read_ns) {
    double step_s = static_cast<double>(read_ns - std::exchange(m_last_ns, read_ns)) * 1e-9;
    if (m_counters.frames == 1)
        step_s = 0.0;
    if (stamp != nullptr) {
        m_stamps.see(*stamp);
        const double told_s = ros::seconds(*stamp);
        if (m_lastStamp_s && told_s > *m_lastStamp_s)
            step_s = told_s - *m_lastStamp_s;
        m_lastStamp_s = told_s == 0.0 ? std::nullopt : std::optional(told_s);
    }
    m_time_s += step_s;
    return m_time_s;
}

std::string RosArray::silence() const {
    const QString topic = QString::fromStdString(m_file.topic);
    if (!m_misfit.empty())
        return RosArrayText::tr("%1: %2").arg(topic, QString::fromStdString(m_misfit)).toStdString();
    if (m_counters.messages > 0 && m_counters.frames == 0)
        return RosArrayText::tr("%1 has no sensor named \"%2\"")
            .arg(topic, QString::fromStdString(m_file.sensor))
            .toStdString();
    if (m_reader.matched() == 0) {
        if (const auto mismatch = m_reader.incompatible())
            return dds::describe(*mismatch).toStdString();
        return RosArrayText::tr("nobody publishes %1").arg(topic).toStdString();
    }
    return RosArrayText::tr("%1 is silent").arg(topic).toStdString();
}

} // namespace teleta::ros_array
