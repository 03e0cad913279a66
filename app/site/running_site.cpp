// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/running_site.h"

#include "app/common/version.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "devices/ros/arm_fault.h"
#include "devices/ros/ros_arm.h"
#include "devices/site/boot_name.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>
#include <utility>

namespace teleta::site_program {

namespace {

struct RunningSiteText {
    Q_DECLARE_TR_FUNCTIONS(RunningSiteText)
};

using Severity = site_link::SiteNews::Severity;

constexpr std::chrono::milliseconds kOpenLook{20};
/// A day.
constexpr std::int64_t kKeysLook_ns = 86'400'000'000'000;

site_link::SiteArm armOf(const std::string& id, pipeline::JointChannel& channel) {
    site_link::SiteArm arm;
    arm.name = id;
    arm.source = &channel.device();
    arm.guarded = channel.description().guarded;
    arm.chain = channel.chain();
    arm.angles = [&channel] {
        const pipeline::JointReading reading = channel.newestReading();
        return site_link::ArmReading{reading.angle_rad, reading.time_ns};
    };
    arm.oldestAngles_ns = core::staleAfter_ns(channel.description().nominalRate_Hz);
    if (!channel.description().simulated)
        arm.adapter = "none";
    if (const auto* ros = dynamic_cast<const ros_arm::RosArm*>(&channel.device())) {
        arm.adapter = ros_arm::nameOf(ros->file().adapter);
        arm.effortUnit = ros->file().effortUnit == ros_arm::EffortUnit::newtonMetre ? "Nm"
                         : ros->file().effortUnit == ros_arm::EffortUnit::ampere    ? "A"
                                                                                    : "none";
        arm.oldestAngles_ns = std::llround(1e9 * ros->file().jointTimeout_s);
        arm.tipSpeed_mPerS = ros->file().limits.tipSpeed_mPerS;
        arm.tipTurn_radPerS = ros->file().limits.tipTurn_radPerS;
        arm.health = [ros] {
            const ros_arm::MoverState mover = ros->state().mover;
            return site_link::ArmHealth{mover.fault ? ros_arm::describe(*mover.fault).toStdString()
                                                    : std::string(),
                                        mover.flags, mover.ignoresPress};
        };
    }
    return arm;
}

bool isMovable(const core::ArmDescription& arm) {
    return std::ranges::any_of(arm.fastest_radPerS, [](double rate) { return rate > 0.0; });
}

/// The state of a device as an arm that requires it sees it.
core::DeviceState stateOf(pipeline::Channel& channel) {
    const core::DeviceStatus status = channel.status();
    return core::observedState(status.state, status.lastData_ns, core::steadyNow_ns(),
                               core::staleAfter_ns(channel.summary().nominalRate_Hz));
}

/// Why nothing comes of it; empty: it is live.
std::string troubleOf(const core::DeviceStatus& status) {
    if (status.state == core::DeviceState::live)
        return {};
    if (!status.message.empty())
        return status.message;
    switch (status.state) {
    case core::DeviceState::connecting:
        return RunningSiteText::tr("nothing was read yet").toStdString();
    case core::DeviceState::stale:
        return RunningSiteText::tr("it sends nothing any more").toStdString();
    default:
        break;
    }
    return RunningSiteText::tr("it is not connected").toStdString();
}

/// The same of a source: an arm is its joints, too.
std::string troubleOf(pipeline::Channel& channel) {
    const std::string trouble = troubleOf(channel.status());
    const auto* joints = dynamic_cast<pipeline::JointChannel*>(&channel);
    return trouble.empty() && joints != nullptr ? troubleOf(joints->jointStatus()) : trouble;
}

} // namespace

core::Expected<std::unique_ptr<RunningSite>> RunningSite::open(const SiteFile& file,
                                                               const SiteFolders& folders, SiteLog& log,
                                                               const std::function<bool()>& cancelled) {
    std::unique_ptr<RunningSite> site(new RunningSite(log));
    TELETA_CHECK(file.meeting.checkInterface());
    TELETA_TRY(const auto participant, file.meeting.join());
    const site_link::SiteTopics topics(file.name);
    const site::BootName boot = site_link::newBootName();
    site->m_meeting = file.meeting;
    site->lookAtKeys();
    site->m_stopMemory = std::make_unique<StopMemory>(folders.state, file.name);
    const site::StopHolders stops = site->m_stopMemory->atStart();
    // Devices may move by themselves before the control has begun.
    if (stops.any())
        site->m_stop.engage();
    TELETA_CHECK(site->openDevices(file, cancelled));
    for (const Device& device : site->m_devices) {
        if (!device.channel)
            return core::Unexpected(device.error);
    }
    TELETA_CHECK(site->checkRequired());
    TELETA_CHECK(site->placePads(file));
    site_link::SiteStreams::Pictures pictures;
    for (const SiteDevice& device : file.devices)
        pictures.emplace(device.id, device.pictures);
    TELETA_TRY(site->m_streams, site_link::SiteStreams::open(participant, topics, boot, std::move(pictures)));
    std::vector<site_link::SiteArm> arms;
    for (const Device& device : site->m_devices) {
        device.channel->watch(pipeline::Watcher::liveView, site->m_streams, device.id);
        if (auto* joints = dynamic_cast<pipeline::JointChannel*>(device.channel.get()))
            arms.push_back(armOf(device.id, *joints));
    }
    TELETA_CHECK(site->startPublishing(file));
    if (file.record)
        TELETA_CHECK(site->startRecording(file, folders.recordings));
    site_link::SiteSettings settings{.name = file.name,
                                     .version = app::version().text().toStdString(),
                                     .supervisors = file.supervisors,
                                     .times = file.times,
                                     .stops = stops,
                                     .keepStops = [raw = site.get()](const site::StopHolders& holders) {
                                         raw->m_stopMemory->keep(holders);
                                     }};
    TELETA_TRY(const auto streams, site->m_streams->streams());
    TELETA_TRY(site->m_control,
               site_link::SiteControl::open(
                   participant, std::move(settings), std::move(arms), streams, boot, site->m_stop,
                   [raw = site.get()](const site_link::SiteNews& news) { raw->tell(news); }));
    if (const std::string& problem = site->m_stopMemory->problem(); !problem.empty())
        site->tellAll({Severity::error,
                       {},
                       "stop_unknown",
                       "it is not known who engaged STOP before: " + problem +
                           "; the site is stopped until STOP is withdrawn there"});
    return site;
}

core::Expected<std::unique_ptr<RunningSite>>
RunningSite::openForCheck(const SiteFile& file, SiteLog& log, const std::function<bool()>& cancelled) {
    std::unique_ptr<RunningSite> site(new RunningSite(log));
    TELETA_CHECK(file.meeting.checkInterface());
    TELETA_TRY(const auto participant, file.meeting.join());
    site->m_meeting = file.meeting;
    site->lookAtKeys();
    TELETA_CHECK(site->openDevices(file, cancelled));
    const bool allOpened =
        std::ranges::all_of(site->m_devices, [](const Device& device) { return device.channel != nullptr; });
    // The links of an arm that cannot be opened are not known.
    if (const auto placed = site->placePads(file); !placed && allOpened)
        site->m_misplaced = core::describe(placed.error());
    return site;
}

RunningSite::~RunningSite() {
    m_control.reset();
    m_required->clear();
    for (const Device& device : m_devices) {
        if (!device.channel)
            continue;
        device.channel->watch(pipeline::Watcher::liveView, nullptr, device.id);
        device.channel->watch(pipeline::Watcher::plot, nullptr, device.id);
        if (m_recorder)
            device.channel->record(nullptr, device.id);
    }
    if (m_recorder)
        (void)m_recorder->stop();
}

core::Expected<void> RunningSite::openDevices(const SiteFile& file, const std::function<bool()>& cancelled) {
    std::vector<pipeline::ChannelKey> keys;
    for (const SiteDevice& device : file.devices) {
        app::SourceRequest request = device.request;
        if (auto* arm = std::get_if<app::ArmRequest>(&request))
            arm->required = m_required;
        keys.push_back(m_pipeline.open(app::makeSourceFactory(std::move(request), m_stop, cancelled)));
        m_devices.push_back({device.id, nullptr, {}, {}});
    }
    for (std::size_t known = 0; known < keys.size();) {
        if (cancelled())
            return core::failed(core::ErrorKind::cancelled, RunningSiteText::tr("interrupted"));
        for (const pipeline::ChannelEvent& event : m_pipeline.takeEvents()) {
            for (std::size_t i = 0; i < keys.size(); ++i) {
                if (keys[i] != event.key)
                    continue;
                m_devices[i].channel = event.channel;
                if (event.channel)
                    m_required->add(m_devices[i].id, [known = std::weak_ptr(event.channel)] {
                        const auto channel = known.lock();
                        return channel ? stateOf(*channel) : core::DeviceState::closed;
                    });
                m_devices[i].error = event.error;
                ++known;
            }
        }
        std::this_thread::sleep_for(kOpenLook);
    }
    return {};
}

core::Expected<void> RunningSite::placePads(const SiteFile& file) {
    for (const SiteDevice& device : file.devices) {
        if (!device.pad)
            continue;
        const auto misplaced = [&](const QString& message) {
            return core::failed(
                core::ErrorKind::badInput,
                RunningSiteText::tr("the frame of %1: %2").arg(QString::fromStdString(device.id), message),
                RunningSiteText::tr("a link of one arm of the site"));
        };
        pipeline::JointChannel* wearer = nullptr;
        for (const Device& other : m_devices) {
            auto* joints = dynamic_cast<pipeline::JointChannel*>(other.channel.get());
            if (joints == nullptr || !joints->chain() || !joints->chain()->model().findLink(device.pad->link))
                continue;
            if (wearer != nullptr)
                return misplaced(RunningSiteText::tr("several arms have the link %1")
                                     .arg(QString::fromStdString(device.pad->link)));
            wearer = joints;
        }
        if (wearer == nullptr)
            return misplaced(
                RunningSiteText::tr("no arm has the link %1").arg(QString::fromStdString(device.pad->link)));
        if (wearer->pad())
            return misplaced(RunningSiteText::tr("the arm wears another array already"));
        core::PadPlacement pad = *device.pad;
        const auto* arm = dynamic_cast<const ros_arm::RosArm*>(&wearer->device());
        if (arm != nullptr && arm->file().touch) {
            pad = arm->file().touch->pad;
            pad.link = device.pad->link;
            pad.position_m = device.pad->position_m;
            pad.rollPitchYaw_rad = device.pad->rollPitchYaw_rad;
        }
        if (const auto usable = pipeline::padOnLink(wearer->chain(), pad); !usable)
            return misplaced(QString::fromStdString(core::describe(usable.error())));
        wearer->wearPad(pad, pipeline::framesStreamName(device.id));
    }
    return {};
}

core::Expected<void> RunningSite::checkRequired() const {
    for (const Device& device : m_devices) {
        auto* joints = dynamic_cast<pipeline::JointChannel*>(device.channel.get());
        const auto* arm =
            joints == nullptr ? nullptr : dynamic_cast<const ros_arm::RosArm*>(&joints->device());
        if (arm == nullptr)
            continue;
        for (const std::string& required : arm->file().required) {
            if (std::ranges::find(m_devices, required, &Device::id) == m_devices.end())
                return core::failed(
                    core::ErrorKind::badInput,
                    RunningSiteText::tr("%1 requires the device %2, which the site does not have")
                        .arg(QString::fromStdString(device.id), QString::fromStdString(required)),
                    RunningSiteText::tr("ids of the site's devices"));
        }
    }
    return {};
}

core::Expected<void> RunningSite::startPublishing(const SiteFile& file) {
    if (!file.publishing)
        return {};
    TELETA_TRY(auto participant, dds::Participant::open(file.publishing->domain));
    std::map<std::string, std::string> frames;
    for (const SiteDevice& device : file.devices) {
        if (device.pad)
            frames.emplace(device.id, device.pad->link);
    }
    m_publisher = std::make_shared<ros_arm::TactilePublisher>(std::move(participant), std::move(frames),
                                                              file.publishing->reliable);
    // Nobody plots here.
    for (const Device& device : m_devices)
        device.channel->watch(pipeline::Watcher::plot, m_publisher, device.id);
    if (const auto failure = m_publisher->failure())
        return core::Unexpected(*failure);
    return {};
}

core::Expected<void> RunningSite::startRecording(const SiteFile& file, const std::string& folder) {
    const QString name = QString::fromStdString(file.name) +
                         QDateTime::currentDateTimeUtc().toString(QStringLiteral("'-'yyyyMMdd'T'HHmmss'Z'"));
    const std::string path =
        QDir(QString::fromStdString(folder)).filePath(name + QLatin1String(".teleta")).toStdString();
    TELETA_TRY(auto recorder,
               recording::Recorder::start(path, {.appVersion = app::version().text().toStdString(),
                                                 .scene = {},
                                                 .sceneText = {},
                                                 .configuration = {},
                                                 .start_ns = core::steadyNow_ns()}));
    m_recorder = std::move(recorder);
    for (const Device& device : m_devices)
        device.channel->record(m_recorder, device.id);
    tell({Severity::note, {}, "recording", "recording to " + path});
    return {};
}

void RunningSite::tell(const site_link::SiteNews& news) {
    if (m_recorder)
        m_recorder->add({core::steadyNow_ns(), "site", news.message, 0.0});
    m_log.write(news);
}

void RunningSite::tellAll(const site_link::SiteNews& news) {
    tell(news);
    if (m_control)
        m_control->post(news);
}

void RunningSite::lookAtKeys() {
    m_nextKeys_ns = core::steadyNow_ns() + kKeysLook_ns;
    std::vector<std::string> warnings = m_meeting.keyWarnings();
    for (const std::string& warning : warnings) {
        if (std::ranges::find(m_keyWarnings, warning) == m_keyWarnings.end())
            tellAll({Severity::warning, {}, "keys", warning});
    }
    m_keyWarnings = std::move(warnings);
}

void RunningSite::lookAtStopMemory() {
    std::string trouble = m_stopMemory ? m_stopMemory->trouble() : std::string();
    if (trouble == m_stopTrouble)
        return;
    m_stopTrouble = std::move(trouble);
    tellAll({m_stopTrouble.empty() ? Severity::note : Severity::error,
             {},
             "stop_kept",
             m_stopTrouble.empty() ? "STOP is kept for the next start again"
                                   : "STOP is not kept for the next start: " + m_stopTrouble});
}

void RunningSite::setStop(bool engaged) {
    m_control->setStop(engaged);
    if (!engaged)
        m_control->withdrawStopsOfGone();
}

void RunningSite::poll() {
    for (Device& device : m_devices) {
        if (!device.channel)
            continue;
        // Nobody looks at what a console would show.
        device.channel->drain();
        std::string trouble = troubleOf(*device.channel);
        if (trouble != device.trouble) {
            device.trouble = std::move(trouble);
            tellAll({device.trouble.empty() ? Severity::note : Severity::warning, device.id, "device",
                     device.trouble.empty() ? "live" : device.trouble});
        }
        if (m_recorder) {
            if (const auto changed = device.channel->takeSettingsEvent())
                m_recorder->add(*changed);
        }
    }
    (void)m_pipeline.takeEvents();
    if (m_recorder && !m_recorderFailed &&
        m_recorder->status().state == recording::RecorderStatus::State::failed) {
        m_recorderFailed = true;
        tellAll({Severity::error, {}, "recording_failed", core::describe(m_recorder->status().error)});
    }
    if (core::steadyNow_ns() >= m_nextKeys_ns)
        lookAtKeys();
    lookAtStopMemory();
}

std::vector<std::string> RunningSite::problems() const {
    std::vector<std::string> found;
    for (const Device& device : m_devices) {
        std::string reason = device.channel ? troubleOf(*device.channel) : core::describe(device.error);
        // A read-only arm is no problem.
        if (auto* joints = dynamic_cast<pipeline::JointChannel*>(device.channel.get());
            joints != nullptr && reason.empty() && isMovable(joints->description()))
            reason = joints->device().hindrance();
        if (!reason.empty())
            found.push_back(device.id + ": " + reason);
    }
    if (!m_misplaced.empty())
        found.push_back(m_misplaced);
    if (const std::optional<core::Error> error = m_streams ? m_streams->pictureProblem() : std::nullopt)
        found.push_back(core::describe(*error));
    return found;
}

} // namespace teleta::site_program
