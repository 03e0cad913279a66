// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/colour_image.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/wait_set.h"
#include "devices/site/remote/remote_stream.h"
#include "devices/site/site_client.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

namespace teleta::site_link {

/// A camera at a site that is looked at. Its frames are colour pictures, see core::colourOf(). Times are
/// those of the reads at the site, by the clock here.
///   connecting -> live <-> stale; stop(): closed
/// A message that is no whole JPEG picture is a lost frame; the status names the first of them, until a
/// picture comes. Thread: as core::CameraSource.
class RemoteCamera : public core::CameraSource {
public:
    /// name: of the camera at the site. description: as the site describes it. Error: unavailable, its topic
    /// cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<RemoteCamera>>
    open(std::shared_ptr<SiteClient> site, const std::string& name, core::CameraDescription description);

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return m_outlet.frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

private:
    friend core::DeviceThread<RemoteCamera>;
    RemoteCamera(std::shared_ptr<SiteClient> site, core::CameraDescription description,
                 dds::Reader<ros::ImageFrame> reader);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_waitSet.wake(); }
    void take(const ros::ImageFrame& message);
    [[nodiscard]] static core::Expected<core::ColourImage> pictureOf(const ros::ImageFrame& message);

    std::shared_ptr<SiteClient> m_site;
    core::CameraDescription m_description;
    dds::Reader<ros::ImageFrame> m_reader;
    dds::WaitSet m_waitSet;
    core::CameraOutlet m_outlet;
    RemoteStream m_stream;

    // The worker's own.
    std::string m_misfit; ///< why messages are no pictures, since the last one that was; empty: they are
    std::uint64_t m_number = 0;
    bool m_discontinuity = false;

    core::DeviceThread<RemoteCamera> m_thread{*this};
};

} // namespace teleta::site_link
