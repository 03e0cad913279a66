// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/ros_probes.h"

#include "app/cli/commands/devices/measured_rate.h"
#include "devices/ros/array/ros_array.h"
#include "devices/ros/camera/ros_camera.h"

#include <QCoreApplication>

namespace teleta::cli {

namespace {

struct RosProbeText {
    Q_DECLARE_TR_FUNCTIONS(RosProbeText)
};

/// What keeps frames from coming, as the source's last status says.
core::Error silence(const core::DeviceStatus& status, const std::string& topic) {
    return {core::ErrorKind::unavailable,
            status.message.empty() ? RosProbeText::tr("nothing came on the topic").toStdString()
                                   : status.message,
            {},
            {topic, 0, 0}};
}

} // namespace

core::Expected<FoundDevice> probeRosArray(const std::string& path) {
    TELETA_TRY(const auto file, ros_array::readRosArray(path));
    FoundDevice found{.kind = "ros_tactile", .name = file.name, .where = file.topic};
    const auto opened = ros_array::RosArray::open(file);
    found.error = errorOf(opened);
    if (!opened)
        return found;
    ros_array::RosArray& array = **opened;
    const SeenFrames seen = lookAt(array);
    found.frameRate_Hz = seen.rate_Hz;
    const ros_array::RosArrayCounters counters = array.counters();
    if (!found.frameRate_Hz)
        found.error = silence(seen.status, file.topic);
    const core::ArrayLayout& layout = array.description().layout.grid();
    found.values = {{"rows", static_cast<double>(layout.rows), "1"},
                    {"columns", static_cast<double>(layout.columns), "1"},
                    {"pitch", layout.largerPitch_m(), "m"},
                    {"messages", static_cast<double>(counters.messages), "1"},
                    {"misfits", static_cast<double>(counters.misfits), "1"},
                    {"odd_stamps", static_cast<double>(counters.oddStamps), "1"}};
    return found;
}

core::Expected<FoundDevice> probeRosCamera(const std::string& path) {
    TELETA_TRY(const auto file, ros_camera::readRosCamera(path));
    FoundDevice found{.kind = "ros_camera", .name = file.name, .where = file.topic};
    const auto opened = ros_camera::RosCamera::open(file);
    found.error = errorOf(opened);
    if (!opened)
        return found;
    ros_camera::RosCamera& camera = **opened;
    const SeenFrames seen = lookAt(camera);
    const ros_camera::RosCameraCounters counters = camera.counters();
    found.frameRate_Hz = seen.rate_Hz;
    if (!seen.rate_Hz)
        found.error = silence(seen.status, file.topic);
    if (seen.width_px > 0)
        found.values = {{"width", static_cast<double>(seen.width_px), "px"},
                        {"height", static_cast<double>(seen.height_px), "px"}};
    found.values.push_back({"messages", static_cast<double>(counters.messages), "1"});
    found.values.push_back({"misfits", static_cast<double>(counters.misfits), "1"});
    found.values.push_back({"odd_stamps", static_cast<double>(counters.oddStamps), "1"});
    return found;
}

} // namespace teleta::cli
