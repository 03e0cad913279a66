// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/image/picture_sender.h"

#include "backend/core/device/colour_image.h"
#include "backend/core/steady_time.h"
#include "backend/ros/messages.h"
#include "devices/site/image/jpeg_picture.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <span>
#include <string>
#include <utility>

namespace teleta::site_link {

namespace {

/// While one is coded, others come; they are replaced by the newest.
constexpr std::size_t kTapPictures = 8;
/// Of a gel at rest, which is sent seldom.
constexpr int kRestQuality = 95;

} // namespace

PictureSender::PictureSender(const site::BootName& boot)
    : m_boot(boot) {
}

PictureSender::~PictureSender() {
    m_stopping = true;
    if (m_thread.joinable())
        m_thread.join();
    for (const auto& camera : m_cameras)
        camera->tap->close();
}

std::shared_ptr<core::StreamTap> PictureSender::add(dds::AnyWriter writer, const PictureSettings& settings,
                                                    SentPicture kind) {
    auto tap = std::make_shared<core::StreamTap>(kTapPictures);
    const std::scoped_lock lock(m_mutex);
    m_cameras.push_back(
        std::make_unique<Camera>(Camera{tap, std::move(writer), PictureBudget(settings), kind}));
    if (!m_thread.joinable())
        m_thread = std::thread([this] { run(); });
    return tap;
}

std::optional<core::Error> PictureSender::problem() const {
    const std::scoped_lock lock(m_mutex);
    return m_problem;
}

void PictureSender::run() {
    std::vector<Camera*> known;
    while (!m_stopping) {
        {
            const std::scoped_lock lock(m_mutex);
            for (std::size_t i = known.size(); i < m_cameras.size(); ++i)
                known.push_back(m_cameras[i].get());
        }
        for (Camera* camera : known)
            send(*camera);
        std::this_thread::sleep_for(std::chrono::nanoseconds(kPoll_ns));
    }
}

std::vector<std::uint8_t> PictureSender::coded(const Camera& camera, const core::GreyImage& picture) {
    const int quality = camera.kind == SentPicture::rest ? kRestQuality : camera.budget.quality();
    auto bytes = camera.kind == SentPicture::colour ? toJpeg(core::colourOf(picture), quality)
                                                    : toJpeg(picture, quality);
    const std::scoped_lock lock(m_mutex);
    m_problem = bytes ? std::nullopt : std::optional(bytes.error());
    return bytes ? std::move(*bytes) : std::vector<std::uint8_t>();
}

void PictureSender::send(Camera& camera) {
    core::TappedFrames one;
    for (std::size_t left = camera.tap->capacity(); left > 0 && camera.tap->pop(one); --left) {
        camera.budget.arrived(one.time_ns.front());
        one.discontinuity = one.discontinuity || camera.newest.discontinuity;
        camera.newest = std::exchange(one, {});
    }
    const bool isKept = camera.kind == SentPicture::rest;
    if (camera.newest.frames() == 0 || (!isKept && !camera.budget.mayWrite(core::steadyNow_ns())))
        return;
    const core::TappedFrames picture = std::exchange(camera.newest, {});
    if (!isKept && camera.writer.matched() == 0)
        return;
    std::vector<std::uint8_t> bytes = coded(camera, picture.image);
    if (bytes.empty())
        return;
    camera.budget.written(bytes.size(), core::steadyNow_ns());
    std::string frame;
    std::string format = "jpeg";
    ros::ImageFrame message{};
    std::ranges::copy(m_boot, std::begin(message.site_boot));
    message.number = camera.next++;
    message.read_site_ns = picture.time_ns.front();
    message.capture_s = picture.sourceTime_s.front();
    message.discontinuity = picture.discontinuity ? 1 : 0;
    message.image.header.frame_id = frame.data();
    message.image.format = format.data();
    ros::lend(message.image.data, std::span(bytes));
    (void)camera.writer.writeAny(&message);
}

} // namespace teleta::site_link
