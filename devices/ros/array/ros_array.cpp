// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/ros_array.h"

#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
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
    TELETA_TRY(auto feed,
               ros_topic::TopicFeed::open(file.domain, file.topic, typeOf(file.format), kReaderDepth));
    return std::unique_ptr<RosArray>(new RosArray(std::move(file), std::move(feed)));
}

RosArray::RosArray(RosArrayFile file, std::unique_ptr<ros_topic::TopicFeed> feed)
    : m_file(std::move(file))
    , m_description{.name = m_file.name,
                    .layout = m_file.layout,
                    .unit = m_file.unit,
                    .nominalRate_Hz = m_file.rate_Hz}
    , m_feed(std::move(feed))
    , m_outlet(kQueueBlocks)
    , m_loads(m_file.layout.taxels()) {
}

void RosArray::open(core::Wakeup& consumer) {
    m_counters = {};
    m_published.set(m_counters);
    m_misfit.clear();
    m_clock = {};
    m_outlet.open(consumer, core::steadyNow_ns());
}

void RosArray::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_file.rate_Hz);
    const std::int64_t start_ns = core::steadyNow_ns();
    while (!stop.stop_requested()) {
        m_feed->wait();
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
    m_feed->take([this](const void* message) {
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
    m_counters.oddStamps = m_clock.oddStamps();
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
    m_block.sourceTime_s.push_back(m_clock.at(stamp, read_ns));
    m_block.values.insert(m_block.values.end(), m_loads.begin(), m_loads.end());
}

std::string RosArray::silence() const {
    if (m_misfit.empty() && m_counters.messages > 0 && m_counters.frames == 0)
        return RosArrayText::tr("%1 has no sensor named \"%2\"")
            .arg(QString::fromStdString(m_file.topic), QString::fromStdString(m_file.sensor))
            .toStdString();
    return m_feed->silence(m_misfit);
}

} // namespace teleta::ros_array
