// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/site/site_file.h"
#include "app/site/site_log.h"
#include "app/site/stop_memory.h"
#include "backend/core/device/required_devices.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/channel.h"
#include "backend/pipeline/touch_pipeline.h"
#include "backend/recording/recorder.h"
#include "devices/ros/publish/tactile_publisher.h"
#include "devices/site/site_control.h"
#include "devices/site/site_streams.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::site_program {

/// Where a site leaves what it writes.
struct SiteFolders {
    std::string recordings; ///< its own, where its file asks for them
    std::string state;      ///< of StopMemory
};

/// The robot's end of a link while it runs: its devices, what is sent of them, and who moves the arms.
/// Thread: one; the work is done by threads of its own.
class RunningSite {
public:
    /// Opens all devices and waits for them. They are stopped from the start if STOP was engaged when the
    /// program last ended.
    /// cancelled: looked at meanwhile. Error: that of the first device that cannot be opened; cancelled.
    [[nodiscard]] static core::Expected<std::unique_ptr<RunningSite>>
    open(const SiteFile& file, const SiteFolders& folders, SiteLog& log,
         const std::function<bool()>& cancelled);
    /// The same for a check: a device that cannot be opened is one of problems(), nothing is recorded, and
    /// no console is let in.
    [[nodiscard]] static core::Expected<std::unique_ptr<RunningSite>>
    openForCheck(const SiteFile& file, SiteLog& log, const std::function<bool()>& cancelled);
    /// Holds the arms, completes the recording, closes the devices.
    ~RunningSite();
    RunningSite(const RunningSite&) = delete;
    RunningSite& operator=(const RunningSite&) = delete;

    /// What has to be done a few times a second: follows settings, frees what nobody shows.
    void poll();

    /// Somebody at the site engages its STOP, or withdraws it with those of consoles that have vanished. Not
    /// of a check.
    void setStop(bool engaged);
    /// Not of a check.
    [[nodiscard]] site_link::SiteStatus status() const { return m_control->status(); }
    /// What keeps a device from being used now, "NAME: reason" each; empty: all of them are live.
    [[nodiscard]] std::vector<std::string> problems() const;
    [[nodiscard]] std::size_t devices() const { return m_devices.size(); }

private:
    struct Device {
        std::string id;
        std::shared_ptr<pipeline::Channel> channel; ///< null: it could not be opened
        core::Error error;                          ///< of such a one
        std::string trouble;                        ///< as the log has it
    };

    explicit RunningSite(SiteLog& log)
        : m_log(log) {}
    /// Error: cancelled.
    [[nodiscard]] core::Expected<void> openDevices(const SiteFile& file,
                                                   const std::function<bool()>& cancelled);
    /// Tells the arms which arrays they wear. Error: badInput, no arm has the link, or several have it, or
    /// it cannot bear a pad.
    [[nodiscard]] core::Expected<void> placePads(const SiteFile& file);
    /// Error: badInput, an arm requires a device that the site does not have.
    [[nodiscard]] core::Expected<void> checkRequired() const;
    [[nodiscard]] core::Expected<void> startPublishing(const SiteFile& file);
    [[nodiscard]] core::Expected<void> startRecording(const SiteFile& file, const std::string& folder);
    void tell(const site_link::SiteNews& news);
    /// Also to the consoles.
    void tellAll(const site_link::SiteNews& news);
    void lookAtKeys();
    void lookAtStopMemory();

    SiteLog& m_log;
    core::StopSwitch m_stop;                  ///< of all devices
    std::unique_ptr<StopMemory> m_stopMemory; ///< null: a check
    std::string m_stopTrouble;                ///< as it was told last
    std::shared_ptr<core::RequiredDevices> m_required = std::make_shared<core::RequiredDevices>();
    pipeline::TouchPipeline m_pipeline;
    std::vector<Device> m_devices;
    std::string m_misplaced; ///< of a check: why an array cannot be where its frame says
    std::shared_ptr<recording::Recorder> m_recorder;
    bool m_recorderFailed = false;
    site_link::OperatorDomain m_meeting;
    std::int64_t m_nextKeys_ns = 0;
    std::vector<std::string> m_keyWarnings; ///< as they were told last
    std::shared_ptr<site_link::SiteStreams> m_streams;
    std::shared_ptr<ros_arm::TactilePublisher> m_publisher; ///< null: nothing is sent to ROS 2
    std::unique_ptr<site_link::SiteControl> m_control;      ///< the first to go
};

} // namespace teleta::site_program
