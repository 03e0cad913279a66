// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/site_request.h"

#include "app/common/version.h"
#include "backend/core/failure.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/pipeline/scene_camera_channel.h"
#include "backend/pipeline/touch_channel.h"
#include "devices/site/remote/remote_arm.h"
#include "devices/site/remote/remote_array.h"
#include "devices/site/remote/remote_camera.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_streams.h"
#include "devices/site/stream_descriptions.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace teleta::app {

namespace {

struct SiteRequestText {
    Q_DECLARE_TR_FUNCTIONS(SiteRequestText)
};

using recording::StreamInfo;
using recording::StreamKind;

const StreamInfo* findStream(const site_link::SiteClient& site, const std::string& device, StreamKind kind) {
    const auto found = std::ranges::find_if(site.streams(), [&](const StreamInfo& stream) {
        return stream.kind == kind && site_link::deviceOf(stream) == device &&
               !site_link::isGelAtRest(stream);
    });
    return found == site.streams().end() ? nullptr : &*found;
}

core::Expected<std::shared_ptr<pipeline::TouchChannel>>
openSkin(const std::shared_ptr<site_link::SiteClient>& site, const std::string& device,
         const StreamInfo& stream) {
    const StreamInfo* temperatures = findStream(*site, device, StreamKind::numbers);
    const std::size_t chips = temperatures != nullptr ? temperatures->channels() : 0;
    TELETA_TRY(pipeline::RecordedArray array, pipeline::recordedArray(stream, site->file().name, chips));
    array.description.recorded = false;
    TELETA_TRY(auto source,
               site_link::RemoteArray::open(site, device, array.description, chips, array.countsLosses));
    auto skin = std::make_shared<pipeline::TouchChannel>(std::move(source), std::move(array.settings));
    skin->setLoads(std::move(array.loads));
    return skin;
}

/// The device whose frames are the skin of this arm; nothing: it has none, or the site does not send it.
core::Expected<std::optional<std::string>> skinOf(const site_link::SiteClient& site,
                                                  const StreamInfo& joints) {
    TELETA_TRY(const pipeline::RecordedArm arm, pipeline::recordedArm(joints, site.file().name));
    for (const StreamInfo& stream : site.streams()) {
        if (stream.kind == StreamKind::array && stream.name == arm.skinStream)
            return site_link::deviceOf(stream);
    }
    return std::nullopt;
}

core::Expected<std::shared_ptr<pipeline::Channel>>
openCamera(const std::shared_ptr<site_link::SiteClient>& site, const std::string& device,
           const StreamInfo& stream) {
    using site_link::RemoteCamera;
    if (site_link::isGel(stream)) {
        TELETA_TRY(auto gel, pipeline::gelOf(stream, site->file().name));
        TELETA_TRY(auto feed, RemoteCamera::open(site, device, gel.description, RemoteCamera::Sees::gel));
        auto channel = std::make_shared<pipeline::GelChannel>(std::move(feed), std::move(gel.file));
        channel->setLoads(std::move(gel.loads));
        return channel;
    }
    TELETA_TRY(auto description, pipeline::sceneCameraOf(stream, site->file().name));
    TELETA_TRY(auto source, RemoteCamera::open(site, device, std::move(description)));
    return std::make_shared<pipeline::SceneCameraChannel>(std::move(source));
}

} // namespace

core::Expected<SiteDevices> siteDevicesOf(const std::string& path, const core::StopSwitch& stop,
                                          const std::function<bool()>& cancelled) {
    TELETA_TRY(const auto file, site_link::readRemoteSite(path));
    SiteDevices found;
    TELETA_TRY(found.site,
               site_link::SiteClient::open(file, app::version().text().toStdString(), stop, cancelled));
    // What an arm wears is opened with the arm.
    std::set<std::string> worn;
    for (const StreamInfo& stream : found.site->streams()) {
        if (stream.kind != StreamKind::joints)
            continue;
        TELETA_TRY(const auto skin, skinOf(*found.site, stream));
        if (skin && *skin != site_link::deviceOf(stream))
            worn.insert(*skin);
    }
    for (const StreamInfo& stream : found.site->streams()) {
        const std::string device = site_link::deviceOf(stream);
        if (!device.empty() && !worn.contains(device) &&
            std::ranges::find(found.devices, device, &SiteRequest::device) == found.devices.end())
            found.devices.push_back({path, file.name, device, found.site});
    }
    if (found.devices.empty())
        return core::refused(
            SiteRequestText::tr("the site %1 has no device to show").arg(QString::fromStdString(file.name)));
    return found;
}

core::Expected<std::shared_ptr<pipeline::Channel>>
openRemote(const std::shared_ptr<site_link::SiteClient>& site, const SiteRequest& request) {
    if (site == nullptr)
        return core::failed(
            core::ErrorKind::unavailable,
            SiteRequestText::tr("the connection to %1 has ended").arg(QString::fromStdString(request.name)),
            SiteRequestText::tr("the site to be connected again"));
    const std::string& device = request.device;
    const StreamInfo* joints = findStream(*site, device, StreamKind::joints);
    if (const StreamInfo* pictures = findStream(*site, device, StreamKind::camera))
        return openCamera(site, device, *pictures);
    std::string skinDevice = device;
    if (joints != nullptr) {
        TELETA_TRY(const auto worn, skinOf(*site, *joints));
        skinDevice = worn.value_or(device);
    }
    std::shared_ptr<pipeline::TouchChannel> skin;
    if (const StreamInfo* frames = findStream(*site, skinDevice, StreamKind::array)) {
        TELETA_TRY(skin, openSkin(site, skinDevice, *frames));
    }
    if (joints == nullptr)
        return skin;
    TELETA_TRY(pipeline::RecordedArm arm, pipeline::recordedArm(*joints, site->file().name));
    arm.description.recorded = false;
    const std::optional<core::PadPlacement> pad = arm.description.pad;
    const bool hasWrench = findStream(*site, device, StreamKind::wrench) != nullptr;
    TELETA_TRY(auto source, site_link::RemoteArm::open(site, device, arm.description, hasWrench));
    if (skin != nullptr && pad) {
        TELETA_TRY(auto channel,
                   pipeline::ArmChannel::withPad(std::move(source), std::move(skin), std::move(arm.chain),
                                                 *pad, site->file().meshPath));
        return channel;
    }
    if (skin != nullptr)
        return std::make_shared<pipeline::ArmChannel>(std::move(source), std::move(skin));
    return std::make_shared<pipeline::JointChannel>(std::move(source), std::move(arm.chain),
                                                    site->file().meshPath);
}

} // namespace teleta::app
