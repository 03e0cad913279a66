// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote/remote_camera.h"

#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/ros/camera/camera_message.h"
#include "devices/site/boot_name.h"
#include "devices/site/image/jpeg_picture.h"
#include "devices/site/remote/remote_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace teleta::site_link {

namespace {

struct RemoteCameraText {
    Q_DECLARE_TR_FUNCTIONS(RemoteCameraText)
};

constexpr std::size_t kQueueFrames = 8;
constexpr std::int64_t kLeastSilence_ns = 3'000'000'000;

/// Of a grey picture that was decoded in colour: all three are alike.
core::GreyImage greyOf(const core::ColourImage& picture) {
    const std::size_t size = static_cast<std::size_t>(picture.width_px) * picture.height_px;
    auto pixels = std::make_shared<std::vector<std::uint8_t>>(size);
    for (std::size_t i = 0; i < size; ++i)
        (*pixels)[i] = picture.pixels.get()[3 * i];
    return {{pixels, pixels->data()}, picture.width_px, picture.height_px};
}

} // namespace

core::Expected<std::unique_ptr<RemoteCamera>> RemoteCamera::open(std::shared_ptr<SiteClient> site,
                                                                 const std::string& name,
                                                                 core::CameraDescription description,
                                                                 Sees sees) {
    TELETA_TRY(auto reader,
               dds::Reader<ros::ImageFrame>::open(site->participant(), site->topics().image(name),
                                                  sees == Sees::gel ? kStreamed : kNewest));
    std::optional<dds::Reader<ros::ImageFrame>> restReader;
    if (sees == Sees::gel) {
        TELETA_TRY(auto opened, dds::Reader<ros::ImageFrame>::open(site->participant(),
                                                                   site->topics().rest(name), kLatched));
        restReader.emplace(std::move(opened));
    }
    return std::unique_ptr<RemoteCamera>(
        new RemoteCamera(std::move(site), std::move(description), std::move(reader), std::move(restReader)));
}

RemoteCamera::RemoteCamera(std::shared_ptr<SiteClient> site, core::CameraDescription description,
                           dds::Reader<ros::ImageFrame> reader,
                           std::optional<dds::Reader<ros::ImageFrame>> restReader)
    : m_site(std::move(site))
    , m_description(std::move(description))
    , m_reader(std::move(reader))
    , m_restReader(std::move(restReader))
    , m_waitSet(m_site->participant())
    , m_outlet(kQueueFrames) {
    m_waitSet.attach(m_reader);
    if (m_restReader)
        m_waitSet.attach(*m_restReader);
}

void RemoteCamera::open(core::Wakeup& consumer) {
    m_misfit.clear();
    m_outlet.open(consumer, core::steadyNow_ns());
}

void RemoteCamera::run(const std::stop_token& stop) {
    // A site with little room on the way sends fewer pictures than its camera takes.
    const std::int64_t staleAfter_ns =
        std::max(core::staleAfter_ns(m_description.nominalRate_Hz), kLeastSilence_ns);
    std::int64_t last_ns = core::steadyNow_ns();
    while (!stop.stop_requested()) {
        m_waitSet.wait(RemoteStream::kLook_ns);
        const std::uint64_t before = m_number;
        // Before the pictures that are compared with it.
        if (m_restReader)
            (void)m_restReader->take(
                [this](const ros::ImageFrame& message, const dds::SampleInfo&) { takeRest(message); });
        (void)m_reader.take(
            [this](const ros::ImageFrame& message, const dds::SampleInfo&) { take(message); });
        if (m_number != before)
            last_ns = core::steadyNow_ns();
        // The time of arrival counts: how old a picture is, its own time says.
        RemoteStream::watchSilence(m_outlet, last_ns, staleAfter_ns,
                                   [this] { return m_misfit.empty() ? silenceText(*m_site) : m_misfit; });
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

core::Expected<core::ColourImage> RemoteCamera::pictureOf(const ros::ImageFrame& message) {
    if (const auto bytes = ros::view(message.image.data); !isWholeJpeg(bytes))
        return core::failed(
            core::ErrorKind::badInput,
            RemoteCameraText::tr("the received data are not a complete JPEG picture (%1 bytes)")
                .arg(bytes.size()));
    return ros_camera::pictureOf(message.image);
}

core::ColourImage RemoteCamera::decoded(const ros::ImageFrame& message) {
    auto picture = pictureOf(message);
    if (picture)
        return std::move(*picture);
    m_outlet.lose(1);
    if (std::exchange(m_misfit, picture.error().message).empty())
        m_outlet.setState(m_outlet.state(), core::steadyNow_ns(), m_misfit);
    return {};
}

void RemoteCamera::takeRest(const ros::ImageFrame& message) {
    if (const core::ColourImage rest = decoded(message); !rest.isEmpty())
        m_rest = greyOf(rest);
}

void RemoteCamera::take(const ros::ImageFrame& message) {
    const std::int64_t arrived_ns = core::steadyNow_ns();
    const RemoteStream::Step step = m_stream.take(bootNameOf(message.site_boot), message.number, 1);
    if (!step.use)
        return;
    if (step.lost > 0)
        m_outlet.lose(step.lost);
    m_discontinuity = m_discontinuity || step.discontinuity || message.discontinuity != 0;
    core::ColourImage picture = decoded(message);
    if (picture.isEmpty())
        return;
    m_misfit.clear();
    core::CameraFrame frame;
    frame.image = m_restReader ? greyOf(picture) : core::bytesOf(std::move(picture));
    frame.reference = std::exchange(m_rest, {});
    frame.time_ns = m_stream.inOrder(m_site->readTime_ns(message.read_site_ns, arrived_ns));
    frame.capture_s = message.capture_s;
    frame.number = m_number++;
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(frame));
}

} // namespace teleta::site_link
