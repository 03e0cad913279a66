// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/site/control_arbiter.h"
#include "devices/dds/endpoint.h"
#include "devices/site/image/picture_budget.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace teleta::site_link {

/// What the pictures of a stream are.
enum class SentPicture {
    colour, ///< core::bytesOf() of them
    grey,   ///< of a gel with markers
    rest,   ///< of a gel at rest, grey: each is sent, finely, and whoever comes later gets the newest
};

/// Sends the pictures of a site's cameras as JPEG, from a thread of its own: coding one takes longer than
/// joints may wait. The newest picture wins. Without a console that looks, nothing is coded.
/// Thread: any; no call waits but the destructor, for the thread to end.
class PictureSender {
public:
    static constexpr std::int64_t kPoll_ns = 4'000'000;

    explicit PictureSender(const site::BootName& boot);
    ~PictureSender();
    PictureSender(const PictureSender&) = delete;
    PictureSender& operator=(const PictureSender&) = delete;

    /// A camera whose pictures the tap takes. writer: of ros::ImageFrame, which keeps one that shows the
    /// rest.
    [[nodiscard]] std::shared_ptr<core::StreamTap> add(dds::AnyWriter writer, const PictureSettings& settings,
                                                       SentPicture kind = SentPicture::colour);
    /// Why the last picture of any camera could not be coded; nothing: it could, or none was.
    [[nodiscard]] std::optional<core::Error> problem() const;

private:
    struct Camera {
        std::shared_ptr<core::StreamTap> tap;
        dds::AnyWriter writer;
        PictureBudget budget;
        SentPicture kind;
        core::TappedFrames newest{}; ///< not sent yet; without frames: none
        std::uint64_t next = 0;      ///< number of the next picture
    };

    void run();
    void send(Camera& camera);
    /// Codes the newest picture; empty: it cannot be.
    [[nodiscard]] std::vector<std::uint8_t> coded(const Camera& camera, const core::GreyImage& picture);

    site::BootName m_boot;
    mutable std::mutex m_mutex;
    std::vector<std::unique_ptr<Camera>> m_cameras; ///< grows only; guarded by m_mutex
    std::optional<core::Error> m_problem;           ///< guarded by m_mutex
    std::atomic<bool> m_stopping{false};
    std::thread m_thread; ///< from the first camera on
};

} // namespace teleta::site_link
