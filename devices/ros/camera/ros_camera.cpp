// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/ros_camera.h"

#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/qos_text.h"
#include "devices/ros/camera/camera_message.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::ros_camera {

namespace {

struct RosCameraText {
    Q_DECLARE_TR_FUNCTIONS(RosCamera)
};

constexpr std::size_t kQueueFrames = 8;
/// The newest message alone is decoded.
constexpr int kReaderDepth = 1;
constexpr std::int64_t kLook_ns = 50'000'000;

const dds_topic_descriptor_t& typeOf(PictureFormat format) {
    return format == PictureFormat::image ? ros::descriptorOf<ros::Image>()
                                          : ros::descriptorOf<ros::CompressedImage>();
}

} // namespace

core::Expected<std::unique_ptr<RosCamera>> RosCamera::open(RosCameraFile file) {
    TELETA_TRY(std::shared_ptr<const dds::Participant> participant, dds::Participant::open(file.domain));
    TELETA_TRY(auto reader,
               dds::AnyReader::open(participant, ros::ddsTopicOf(file.topic), typeOf(file.format),
                                    ros::kSensorReader.withDepth(kReaderDepth)));
    return std::unique_ptr<RosCamera>(
        new RosCamera(std::move(file), std::move(participant), std::move(reader)));
}

RosCamera::RosCamera(RosCameraFile file, std::shared_ptr<const dds::Participant> participant,
                     dds::AnyReader reader)
    : m_file(std::move(file))
    , m_description{.name = m_file.name, .nominalRate_Hz = m_file.rate_Hz}
    , m_participant(std::move(participant))
    , m_reader(std::move(reader))
    , m_waitSet(m_participant)
    , m_outlet(kQueueFrames) {
    m_waitSet.attach(m_reader);
}

void RosCamera::open(core::Wakeup& consumer) {
    m_counters = {};
    m_published.set(m_counters);
    m_misfit.clear();
    m_stamps = {};
    m_lastStamp_s.reset();
    m_time_s = 0.0;
    m_last_ns = core::steadyNow_ns();
    m_outlet.open(consumer, m_last_ns);
}

void RosCamera::run(const std::stop_token& stop) {
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_file.rate_Hz);
    const std::int64_t start_ns = core::steadyNow_ns();
    while (!stop.stop_requested()) {
        m_waitSet.wait(kLook_ns);
        takeAll();
        const std::int64_t now_ns = core::steadyNow_ns();
        const core::DeviceState state = m_outlet.state();
        const std::int64_t since_ns = state == core::DeviceState::connecting ? start_ns : m_last_ns;
        if (now_ns - since_ns <= staleAfter_ns)
            continue;
        m_outlet.setState(state == core::DeviceState::connecting ? state : core::DeviceState::stale, now_ns,
                          silence());
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

void RosCamera::takeAll() {
    const std::uint64_t misfits = m_counters.misfits;
    (void)m_reader.takeAny([this](const void* message, const dds::SampleInfo&) {
        if (m_file.format == PictureFormat::image)
            take(*static_cast<const ros::Image*>(message));
        else
            take(*static_cast<const ros::CompressedImage*>(message));
    });
    if (m_counters.misfits > misfits)
        m_outlet.lose(m_counters.misfits - misfits);
    m_counters.oddStamps = m_stamps.zero() + m_stamps.equal() + m_stamps.backward();
    if (m_published.get() != m_counters)
        m_published.set(m_counters);
}

template <typename Message>
void RosCamera::take(const Message& message) {
    const std::int64_t read_ns = core::steadyNow_ns();
    ++m_counters.messages;
    auto picture = pictureOf(message);
    if (!picture) {
        ++m_counters.misfits;
        m_misfit = picture.error().message;
        return;
    }
    m_misfit.clear();
    core::CameraFrame frame;
    frame.image = core::bytesOf(std::move(*picture));
    frame.time_ns = read_ns;
    frame.capture_s = captureTime_s(message.header.stamp, read_ns);
    frame.number = m_counters.pictures++;
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(frame));
}

double RosCamera::captureTime_s(const ros::Time& stamp, std::int64_t read_ns) {
    double step_s = static_cast<double>(read_ns - std::exchange(m_last_ns, read_ns)) * 1e-9;
    if (m_counters.pictures == 0)
        step_s = 0.0;
    m_stamps.see(stamp);
    const double told_s = ros::seconds(stamp);
    if (m_lastStamp_s && told_s > *m_lastStamp_s)
        step_s = told_s - *m_lastStamp_s;
    m_lastStamp_s = told_s == 0.0 ? std::nullopt : std::optional(told_s);
    m_time_s += step_s;
    return m_time_s;
}

std::string RosCamera::silence() const {
    const QString topic = QString::fromStdString(m_file.topic);
    if (!m_misfit.empty())
        return RosCameraText::tr("%1: %2").arg(topic, QString::fromStdString(m_misfit)).toStdString();
    if (m_reader.matched() == 0) {
        if (const auto mismatch = m_reader.incompatible())
            return dds::describe(*mismatch).toStdString();
        return RosCameraText::tr("nobody publishes %1").arg(topic).toStdString();
    }
    return RosCameraText::tr("%1 is silent").arg(topic).toStdString();
}

} // namespace teleta::ros_camera
