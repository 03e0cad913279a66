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
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::site_link {

/// A camera at a site: one that is looked at, whose frames are colour pictures, see core::colourOf(), or one
/// in front of a gel with markers, whose frames are grey; the first one after the site has taken the gel at
/// rest brings those pictures. Times are those of the reads at the site, by the clock here.
///   connecting -> live <-> stale; stop(): closed
/// A message that is no whole JPEG picture is a lost frame; the status names the first of them, until a
/// picture comes. Thread: as core::CameraSource.
class RemoteCamera : public core::CameraSource {
public:
    enum class Sees { surroundings, gel };
    /// name: of the camera at the site. description: as the site describes it. Error: unavailable, its topics
    /// cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<RemoteCamera>>
    open(std::shared_ptr<SiteClient> site, const std::string& name, core::CameraDescription description,
         Sees sees = Sees::surroundings);

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return m_outlet.frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

private:
    friend core::DeviceThread<RemoteCamera>;
    RemoteCamera(std::shared_ptr<SiteClient> site, core::CameraDescription description,
                 dds::Reader<ros::ImageFrame> reader, std::optional<dds::Reader<ros::ImageFrame>> restReader);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_waitSet.wake(); }
    void take(const ros::ImageFrame& message);
    void takeRest(const ros::ImageFrame& message);
    /// Empty: it is none, which is counted and told.
    [[nodiscard]] core::ColourImage decoded(const ros::ImageFrame& message);
    [[nodiscard]] static core::Expected<core::ColourImage> pictureOf(const ros::ImageFrame& message);

    std::shared_ptr<SiteClient> m_site;
    core::CameraDescription m_description;
    dds::Reader<ros::ImageFrame> m_reader;
    std::optional<dds::Reader<ros::ImageFrame>> m_restReader; ///< of a gel
    dds::WaitSet m_waitSet;
    core::CameraOutlet m_outlet;
    RemoteStream m_stream;

    // The worker's own.
    std::string m_misfit; ///< why messages are no pictures, since the last one that was; empty: they are
    std::uint64_t m_number = 0;
    bool m_discontinuity = false;
    core::GreyImage m_rest; ///< to go with the next picture; empty: none

    core::DeviceThread<RemoteCamera> m_thread{*this};
};

} // namespace teleta::site_link
