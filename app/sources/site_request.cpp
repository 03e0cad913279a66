// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/site_request.h"

#include "app/common/version.h"
#include "backend/core/failure.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/pipeline/touch_channel.h"
#include "devices/site/remote_arm.h"
#include "devices/site/remote_array.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_streams.h"

#include <QCoreApplication>

#include <algorithm>
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
        return stream.kind == kind && site_link::deviceOf(stream) == device;
    });
    return found == site.streams().end() ? nullptr : &*found;
}

core::Expected<std::shared_ptr<pipeline::TouchChannel>> openSkin(const SiteRequest& request,
                                                                 const StreamInfo& stream) {
    TELETA_TRY(pipeline::RecordedArray array, pipeline::recordedArray(stream, request.site->file().name));
    array.description.recorded = false;
    TELETA_TRY(auto source, site_link::RemoteArray::open(request.site, request.device, array.description));
    return std::make_shared<pipeline::TouchChannel>(std::move(source), std::move(array.settings));
}

} // namespace

core::Expected<std::vector<SiteRequest>> siteRequestsOf(const std::string& path, const core::StopSwitch& stop,
                                                        const std::function<bool()>& cancelled) {
    TELETA_TRY(const auto file, site_link::readRemoteSite(path));
    TELETA_TRY(const auto site,
               site_link::SiteClient::open(file, app::version().text().toStdString(), stop, cancelled));
    std::vector<SiteRequest> requests;
    for (const StreamInfo& stream : site->streams()) {
        const std::string device = site_link::deviceOf(stream);
        if (!device.empty() && std::ranges::find(requests, device, &SiteRequest::device) == requests.end())
            requests.push_back({path, device, site});
    }
    if (requests.empty())
        return core::refused(
            SiteRequestText::tr("the site %1 has no device to show").arg(QString::fromStdString(file.name)));
    return requests;
}

core::Expected<std::shared_ptr<pipeline::Channel>> openRemote(const SiteRequest& request) {
    const StreamInfo* joints = findStream(*request.site, request.device, StreamKind::joints);
    const StreamInfo* frames = findStream(*request.site, request.device, StreamKind::array);
    std::shared_ptr<pipeline::TouchChannel> skin;
    if (frames != nullptr) {
        TELETA_TRY(skin, openSkin(request, *frames));
    }
    if (joints == nullptr)
        return skin;
    TELETA_TRY(pipeline::RecordedArm arm, pipeline::recordedArm(*joints, request.site->file().name));
    arm.description.recorded = false;
    TELETA_TRY(auto source, site_link::RemoteArm::open(request.site, request.device, arm.description));
    if (skin != nullptr)
        return std::make_shared<pipeline::ArmChannel>(std::move(source), std::move(skin));
    return std::make_shared<pipeline::JointChannel>(std::move(source), std::move(arm.chain));
}

} // namespace teleta::app
