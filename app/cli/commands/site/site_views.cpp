// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/site/site_views.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/commands/site/site_words.h"
#include "app/common/version.h"
#include "app/sources/site_request.h"
#include "app/sources/source_request.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/touch_pipeline.h"
#include "backend/recording/recorder.h"
#include "devices/dds/discovery.h"
#include "devices/dds/endpoint.h"
#include "devices/site/lent_texts.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_client.h"
#include "devices/site/site_topics.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using site_link::SiteView;

struct CliSiteText {
    Q_DECLARE_TR_FUNCTIONS(CliSiteText)
};

constexpr std::chrono::milliseconds kLookAtSite{20};
/// Other programs repeat what they are within 2 s; a site tells its state at once.
constexpr std::int64_t kDiscovery_ns = 3'000'000'000;
constexpr double kPerNs = 1e-9;

/// Counts the time of a command, and sees when it is over.
class Watch {
public:
    explicit Watch(const std::optional<double>& time_s)
        : m_time_s(time_s) {}

    [[nodiscard]] double now_s() const { return core::elapsed_s(m_start_ns, core::steadyNow_ns()); }
    /// Waits a little; false once the command is over.
    [[nodiscard]] bool goesOn() const {
        std::this_thread::sleep_for(kLookAtSite);
        return !interrupted() && !(m_time_s && now_s() >= *m_time_s);
    }

private:
    std::optional<double> m_time_s;
    std::int64_t m_start_ns = core::steadyNow_ns();
};

/// A console that only looks. stop: never engaged.
core::Expected<std::shared_ptr<site_link::SiteClient>> look(const SiteOptions& options,
                                                            const core::StopSwitch& stop) {
    TELETA_TRY(site_link::RemoteSiteFile file, site_link::readRemoteSite(options.path));
    file.viewer = true;
    auto client = site_link::SiteClient::open(file, app::version().text().toStdString(), stop, interrupted);
    if (!client)
        return core::Unexpected(interruptedInstead(client.error()));
    return client;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : " ") + name;
    return text;
}

/// A site of the domain, as it tells itself.
struct FoundSite {
    dds::Reader<ros::SiteInfo> info;
    dds::Reader<ros::SiteState> state;
    std::string version{};
    std::size_t arms = 0;
    std::size_t streams = 0;
    bool toldState = false;
    site::Mode mode = site::Mode::free;
    std::string controller{};

    void take() {
        (void)info.take([this](const ros::SiteInfo& message, const dds::SampleInfo&) {
            version = site_link::textOf(message.version);
            arms = ros::view(message.arms).size();
            streams = ros::view(message.streams).size();
        });
        (void)state.take([this](const ros::SiteState& message, const dds::SampleInfo&) {
            toldState = true;
            mode =
                static_cast<site::Mode>(std::min(message.mode, static_cast<std::uint8_t>(site::Mode::fault)));
            controller = site_link::textOf(message.controller);
        });
    }
};

} // namespace

core::Expected<void> listSites(const SiteOptions& options) {
    TELETA_TRY(const site_link::RemoteSiteFile file, site_link::readRemoteSite(options.path));
    TELETA_TRY(const auto participant, file.meeting.join());
    TELETA_TRY(const auto discovery, dds::Discovery::open(participant));
    std::map<std::string, FoundSite> sites;
    for (const std::int64_t end_ns = core::steadyNow_ns() + kDiscovery_ns;
         core::steadyNow_ns() < end_ns && !interrupted(); std::this_thread::sleep_for(kLookAtSite)) {
        for (const dds::FoundEnd& end : discovery.ends()) {
            const std::optional<std::string> name = site_link::siteOfInfo(end.ddsTopic);
            if (!name || !end.writes || sites.contains(*name))
                continue;
            const site_link::SiteTopics topics(*name);
            TELETA_TRY(auto info,
                       dds::Reader<ros::SiteInfo>::open(participant, topics.info(), site_link::kLatched));
            TELETA_TRY(auto state,
                       dds::Reader<ros::SiteState>::open(participant, topics.state(), site_link::kState));
            sites.emplace(*name, FoundSite{std::move(info), std::move(state)});
        }
        for (auto& [name, site] : sites)
            site.take();
    }
    if (interrupted())
        return core::Unexpected(interruption());
    constexpr std::array<std::string_view, 6> kColumns{"site",       "version", "state",
                                                       "controller", "arms",    "streams"};
    TELETA_TRY(auto rows, RowOutput::open(kColumns, {.json = options.json, .outPath = {}}));
    for (const auto& [name, site] : sites) {
        rows.text(name);
        rows.text(site.version);
        rows.text(site.toldState ? toString(site.mode) : "silent");
        rows.text(site.controller);
        rows.integer(static_cast<long long>(site.arms));
        rows.integer(static_cast<long long>(site.streams));
        rows.endRow();
    }
    TELETA_CHECK(rows.finish());
    if (sites.empty())
        return core::failed(
            core::ErrorKind::unavailable,
            CliSiteText::tr("no site was found in domain %1").arg(file.meeting.domain.domain));
    return {};
}

core::Expected<void> watchSite(const SiteOptions& options) {
    const core::StopSwitch stop;
    TELETA_TRY(const auto client, look(options, stop));
    constexpr std::array<std::string_view, 10> kColumns{"time_s",       "state",   "controller", "epoch",
                                                        "stop_holders", "viewers", "accepted",   "refused",
                                                        "last_refusal", "loop_s"};
    TELETA_TRY(auto rows, RowOutput::open(kColumns, {.json = options.json, .outPath = {}}));
    const Watch watch(options.time_s);
    const auto changing = [](const SiteView& view) {
        return std::tuple(view.reached, view.mode, view.controller, view.epoch, view.stopHolders,
                          view.viewers, view.refused);
    };
    std::optional<SiteView> told;
    while (watch.goesOn() && !rows.failed()) {
        const SiteView view = client->view();
        if (view.lastState_ns == 0 || (told && changing(*told) == changing(view)))
            continue;
        told = view;
        rows.number(watch.now_s());
        rows.text(view.reached ? toString(view.mode) : "silent");
        rows.text(view.controller);
        rows.integer(static_cast<long long>(view.epoch));
        rows.text(joined(view.stopHolders));
        rows.text(joined(view.viewers));
        rows.integer(static_cast<long long>(view.accepted));
        rows.integer(static_cast<long long>(view.refused));
        rows.text(toString(view.lastRefusal));
        rows.number(view.loop_s);
        rows.endRow();
        rows.flush();
    }
    return rows.finish();
}

core::Expected<void> watchClock(const SiteOptions& options) {
    const core::StopSwitch stop;
    TELETA_TRY(const auto client, look(options, stop));
    constexpr std::array<std::string_view, 6> kColumns{"time_s",  "offset_s", "bound_s",
                                                       "delay_s", "jumps",    "shown_offset_s"};
    TELETA_TRY(auto rows, RowOutput::open(kColumns, {.json = options.json, .outPath = {}}));
    const Watch watch(options.time_s);
    double next_s = 1.0;
    while (watch.goesOn() && !rows.failed()) {
        if (watch.now_s() < next_s)
            continue;
        next_s += 1.0;
        const SiteView view = client->view();
        const auto seconds = [&view](std::int64_t site::ClockOffset::*member) {
            return view.clock ? std::optional(static_cast<double>((*view.clock).*member) * kPerNs)
                              : std::nullopt;
        };
        rows.number(watch.now_s());
        rows.number(seconds(&site::ClockOffset::offset_ns));
        rows.number(seconds(&site::ClockOffset::bound_ns));
        rows.number(seconds(&site::ClockOffset::delay_ns));
        rows.integer(static_cast<long long>(view.clockJumps));
        rows.number(view.shownOffset_ns ? std::optional(static_cast<double>(*view.shownOffset_ns) * kPerNs)
                                        : std::nullopt);
        rows.endRow();
        rows.flush();
    }
    return rows.finish();
}

core::Expected<void> recordSite(const SiteOptions& options) {
    const core::StopSwitch stop;
    const auto found = app::siteDevicesOf(options.path, stop, interrupted);
    if (!found)
        return core::Unexpected(interruptedInstead(found.error()));
    std::vector<std::pair<std::string, std::shared_ptr<pipeline::Channel>>> channels;
    pipeline::TouchPipeline running;
    std::map<pipeline::ChannelKey, std::string> names;
    for (const app::SiteRequest& request : found->devices)
        names.emplace(running.open(app::makeSourceFactory(request, stop)), request.device);
    while (channels.size() < names.size() && !interrupted()) {
        for (const pipeline::ChannelEvent& event : running.takeEvents()) {
            if (event.kind == pipeline::ChannelEvent::Kind::failed)
                return core::Unexpected(event.error);
            if (event.channel)
                channels.emplace_back(names.at(event.key), event.channel);
        }
        std::this_thread::sleep_for(kLookAtSite);
    }
    if (interrupted())
        return core::Unexpected(interruption());
    TELETA_TRY(auto started,
               recording::Recorder::start(options.out, {.appVersion = app::version().text().toStdString(),
                                                        .scene = {},
                                                        .sceneText = {},
                                                        .configuration = {},
                                                        .start_ns = core::steadyNow_ns()}));
    const std::shared_ptr<recording::Recorder> recorder = std::move(started);
    for (const auto& [name, channel] : channels)
        channel->record(recorder, name);
    found->site->recordClock(recorder->addStream(found->site->clockStream()));
    using State = recording::RecorderStatus::State;
    for (const Watch watch(options.time_s); watch.goesOn() && recorder->status().state == State::recording;) {
        for (const auto& [name, channel] : channels)
            channel->drain();
        for (const site_link::RemoteEvent& event : found->site->takeEvents())
            recorder->add({core::steadyNow_ns(), "site", event.message, 0.0});
    }
    found->site->recordClock(nullptr);
    for (const auto& [name, channel] : channels)
        channel->record(nullptr, name);
    TELETA_CHECK(recorder->stop());
    const recording::RecorderStatus status = recorder->status();
    return printFields(
        {{CliSiteText::tr("Recording"), QString::fromStdString(recorder->path())},
         {CliSiteText::tr("Duration"), CliSiteText::tr("%1 s").arg(forPeople(status.duration_s))},
         {CliSiteText::tr("Frames"), QString::number(status.frames)},
         {CliSiteText::tr("Dropped here"), QString::number(status.dropped)}});
}

} // namespace teleta::cli
