// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/site_control.h"

#include "backend/arm_model/arm_model.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "devices/site/boot_name.h"
#include "devices/site/decline_message.h"
#include "devices/site/lent_texts.h"
#include "devices/site/site_streams.h"
#include "devices/site/stream_descriptions.h"

#include <QByteArray>
#include <QCryptographicHash>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace teleta::site_link {

namespace {

using site::CommandRefusal;
using site::Mode;
using site::RequestAnswer;
using site::RequestKind;
using Severity = SiteNews::Severity;

/// Between looks for new consoles.
constexpr std::int64_t kConsoleLook_ns = 100'000'000;
/// Results of requests are told for so long, and so many of them.
constexpr std::int64_t kResult_ns = 5'000'000'000;
constexpr std::size_t kMostResults = 8;

std::uint32_t toMs(std::int64_t time_ns) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(time_ns / 1'000'000, 0, 0xFFFFFFFF));
}

std::uint64_t firstEpochOf(const site::BootName& boot) {
    std::uint64_t epoch = 0;
    for (std::size_t i = 0; i < 4; ++i)
        epoch = epoch << 8U | boot[i];
    return epoch;
}

std::string messageOf(RequestAnswer answer) {
    switch (answer) {
    case RequestAnswer::waits:
        return "waiting for the other console";
    case RequestAnswer::done:
        return "done";
    case RequestAnswer::busy:
        return "another console is in control";
    case RequestAnswer::notPermitted:
        return "this console may not do that";
    case RequestAnswer::noSuchConsole:
        return "there is no such console";
    case RequestAnswer::notController:
        return "this console is not in control";
    case RequestAnswer::stopped:
        return "STOP is engaged";
    case RequestAnswer::expired:
        return "nobody answered in time";
    }
    return {};
}

/// What a site tells of an arm once.
struct ToldArm {
    LentTexts texts;
    std::vector<char*> names;
    std::vector<std::uint8_t> prismatic;
    core::JointVector lowest;
    core::JointVector highest;
    core::JointVector fastest;

    ros::ArmInfo fill(const SiteArm& arm) {
        const core::ArmDescription& description = arm.source->description();
        lowest = description.lowest_rad;
        highest = description.highest_rad;
        fastest = description.fastest_radPerS;
        for (std::size_t i = 0; i < description.joints(); ++i) {
            names.push_back(texts(arm.chain ? arm.chain->joint(i).name : "joint_" + std::to_string(i + 1)));
            prismatic.push_back(arm.chain && arm.chain->joint(i).type == arm_model::JointType::prismatic ? 1
                                                                                                         : 0);
        }
        ros::ArmInfo info{};
        info.name = texts(arm.name);
        info.adapter = texts(arm.adapter);
        ros::lend(info.joint_names, std::span(names));
        ros::lend(info.prismatic, std::span(prismatic));
        ros::lend(info.lower, std::span(lowest.data(), lowest.size()));
        ros::lend(info.upper, std::span(highest.data(), highest.size()));
        ros::lend(info.velocity, std::span(fastest.data(), fastest.size()));
        info.tip_frame = texts(arm.chain ? arm.chain->tipLink() : std::string());
        info.tip_linear_m_per_s = arm.tipSpeed_mPerS;
        info.tip_angular_rad_per_s = arm.tipTurn_radPerS;
        if (arm.chain) {
            const QByteArray sum = QCryptographicHash::hash(
                QByteArray::fromStdString(arm.chain->model().urdf), QCryptographicHash::Sha256);
            std::ranges::copy(sum, std::begin(info.description_sha256));
        }
        info.effort_unit = texts(arm.effortUnit);
        info.guarded = arm.guarded;
        return info;
    }
};

} // namespace

core::Expected<std::unique_ptr<SiteControl>>
SiteControl::open(std::shared_ptr<const dds::Participant> participant, SiteSettings settings,
                  std::vector<SiteArm> arms, const std::vector<recording::StreamInfo>& streams,
                  const site::BootName& boot, core::StopSwitch& stop,
                  std::function<void(const SiteNews&)> told) {
    const SiteTopics topics(settings.name);
    TELETA_TRY(auto info, dds::Writer<ros::SiteInfo>::open(participant, topics.info(), kLatched));
    TELETA_TRY(auto state, dds::Writer<ros::SiteState>::open(participant, topics.state(), kState));
    TELETA_TRY(auto event, dds::Writer<ros::SiteEvent>::open(participant, topics.event(), kEvents));
    TELETA_TRY(auto discovery, dds::Discovery::open(participant));
    Writers writers{std::move(info), std::move(state), std::move(event), {}};
    for (const SiteArm& arm : arms) {
        if (!arm.chain)
            continue;
        TELETA_TRY(auto description,
                   dds::Writer<ros::String>::open(participant, topics.description(arm.name), kLatched));
        std::string urdf = arm.chain->model().urdf;
        ros::String message{};
        message.data = urdf.data();
        (void)description.write(message);
        writers.descriptions.push_back(std::move(description));
    }
    std::unique_ptr<SiteControl> control(new SiteControl(std::move(participant), std::move(settings),
                                                         std::move(arms), boot, stop, std::move(told),
                                                         std::move(writers), std::move(discovery)));
    control->tellInfo(streams);
    control->m_thread = std::jthread([raw = control.get()](const std::stop_token& end) { raw->run(end); });
    return control;
}

SiteControl::SiteControl(std::shared_ptr<const dds::Participant> participant, SiteSettings settings,
                         std::vector<SiteArm> arms, const site::BootName& boot, core::StopSwitch& stop,
                         std::function<void(const SiteNews&)> told, Writers writers, dds::Discovery discovery)
    : m_participant(std::move(participant))
    , m_settings(std::move(settings))
    , m_topics(m_settings.name)
    , m_arms(std::move(arms))
    , m_boot(boot)
    , m_stop(stop)
    , m_told(std::move(told))
    , m_writers(std::move(writers))
    , m_discovery(std::move(discovery))
    , m_waitSet(m_participant)
    , m_siteStop(m_settings.stops.site)
    , m_arbiter(m_settings.supervisors, m_settings.times, m_settings.stops, firstEpochOf(m_boot))
    , m_health(m_arms.size())
    , m_keptStops(m_settings.stops) {
    m_known.epoch = m_arbiter.epoch();
}

SiteControl::~SiteControl() {
    m_thread.request_stop();
    m_waitSet.wake();
    if (m_thread.joinable())
        m_thread.join();
}

void SiteControl::tellInfo(const std::vector<recording::StreamInfo>& streams) {
    LentTexts texts;
    std::deque<ToldArm> told(m_arms.size());
    std::vector<ros::ArmInfo> arms;
    for (std::size_t i = 0; i < m_arms.size(); ++i)
        arms.push_back(told[i].fill(m_arms[i]));
    std::deque<std::vector<std::uint32_t>> shapes;
    std::vector<ros::SiteStreamInfo> infos;
    for (const recording::StreamInfo& stream : streams) {
        const std::string device = deviceOf(stream);
        const StreamTopic topic = topicOf(stream, m_topics);
        ros::SiteStreamInfo info{};
        info.name = texts(device);
        info.kind = texts(topic.kind);
        info.topic = texts(topic.name);
        info.unit = texts(stream.unit);
        info.frame_id = texts(frameOf(stream, streams));
        info.rate_hz = stream.nominalRate_Hz;
        const auto details = nlohmann::json::parse(stream.details, nullptr, false);
        info.simulated = details.is_object() && details.value("simulated", nlohmann::json()) == true;
        shapes.emplace_back(stream.shape.begin(), stream.shape.end());
        ros::lend(info.shape, std::span(shapes.back()));
        infos.push_back(info);
    }
    ros::SiteInfo info{};
    info.protocol = kProtocol;
    info.site = texts(m_settings.name);
    info.version = texts(m_settings.version);
    std::ranges::copy(m_boot, std::begin(info.site_boot));
    info.motion_lease_ms = toMs(m_settings.times.motion_ns);
    info.control_lease_ms = toMs(m_settings.times.control_ns);
    info.loop_limit_ms = toMs(m_settings.times.loopLimit_ns);
    ros::lend(info.arms, std::span(arms));
    ros::lend(info.streams, std::span(infos));
    (void)m_writers.info.write(info);
}

void SiteControl::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    std::int64_t next_ns = core::steadyNow_ns() + kCycle_ns;
    while (!stop.stop_requested()) {
        m_waitSet.wait(std::max<std::int64_t>(0, next_ns - core::steadyNow_ns()));
        const std::int64_t now_ns = core::steadyNow_ns();
        if (now_ns >= next_ns) {
            if (now_ns - next_ns > kLate_ns) {
                m_late_ns.push_back(now_ns);
                ++m_lateCycles;
            }
            next_ns = now_ns + kCycle_ns;
            findConsoles();
        }
        listen(now_ns);
        m_arbiter.setSiteStop(m_siteStop);
        if (m_withdraws.exchange(false))
            m_arbiter.withdrawStopsOfGone(now_ns);
        m_arbiter.advance(now_ns);
        checkArms(now_ns);
        moveArms(now_ns);
        noteChanges(now_ns);
        tellNews();
        if (now_ns >= m_nextState_ns)
            tellState(now_ns);
    }
    for (const SiteArm& arm : m_arms)
        arm.source->post(
            {core::JointVector::zeros(arm.source->description().joints()), core::steadyNow_ns()});
}

void SiteControl::findConsoles() {
    const std::int64_t now_ns = core::steadyNow_ns();
    if (now_ns < m_nextLook_ns)
        return;
    m_nextLook_ns = now_ns + kConsoleLook_ns;
    if (std::string reason = m_participant->refusals().reason; reason != m_keptOut) {
        m_keptOut = std::move(reason);
        if (!m_keptOut.empty())
            tell(Severity::warning, {}, "kept_out", m_keptOut);
    }
    for (const dds::FoundEnd& end : m_discovery.ends()) {
        const std::optional<std::string> name = m_topics.consoleOf(end.ddsTopic);
        if (!name || !end.writes || end.own || m_consoles.contains(*name))
            continue;
        if (m_consoles.size() >= kMostConsoles) {
            if (!m_isFull)
                tell(Severity::error, *name, "console_refused",
                     *name + " is ignored: " + std::to_string(kMostConsoles) +
                         " consoles have come since teleta-site was started; restart it to let others in");
            m_isFull = true;
            continue;
        }
        auto opened = ConsoleEnds::open(m_participant, m_topics, *name);
        if (!opened) {
            tell(Severity::error, *name, "console_refused", core::describe(opened.error()));
            continue;
        }
        m_waitSet.attach((*opened)->presence);
        m_waitSet.attach((*opened)->request);
        m_waitSet.attach((*opened)->command);
        m_waitSet.attach((*opened)->probe);
        m_consoles.emplace(*name, std::move(*opened));
        tell(Severity::note, *name, "console", *name + " is there");
    }
}

void SiteControl::listen(std::int64_t now_ns) {
    for (auto& [name, console] : m_consoles) {
        (void)console->probe.take([&](const ros::ClockProbe& probe, const dds::SampleInfo&) {
            ros::ClockAnswer answer{};
            std::ranges::copy(probe.console_boot, std::begin(answer.console_boot));
            std::ranges::copy(m_boot, std::begin(answer.site_boot));
            answer.number = probe.number;
            answer.t1_console_ns = probe.t1_console_ns;
            // Not before it came, however long this cycle takes: the bound of the offset rests on that.
            answer.t2_site_ns = core::steadyNow_ns();
            answer.t3_site_ns = core::steadyNow_ns();
            (void)console->answer.write(answer);
        });
        // STOP first: a command that came with it must not move.
        (void)console->presence.take([&](const ros::ConsolePresence& message, const dds::SampleInfo&) {
            take(*console, message, now_ns);
        });
        (void)console->request.take([&](const ros::ControlRequest& message, const dds::SampleInfo&) {
            take(*console, message, now_ns);
        });
        (void)console->command.take([&](const ros::SiteArmCommand& message, const dds::SampleInfo&) {
            take(*console, message, now_ns);
        });
    }
}

void SiteControl::take(ConsoleEnds& console, const ros::ConsolePresence& presence, std::int64_t now_ns) {
    const bool known = m_arbiter.presence(
        console.name, {bootNameOf(presence.console_boot), presence.viewer, presence.stop_engaged}, now_ns);
    if (!known && !console.nameTaken)
        tell(Severity::warning, console.name, "name_in_use",
             "another console named " + console.name + " is connected; this one is ignored");
    console.nameTaken = !known;
}

void SiteControl::take(ConsoleEnds& console, const ros::ControlRequest& request, std::int64_t now_ns) {
    m_nextState_ns = now_ns;
    auto known = std::ranges::find(console.requests, request.request, &ConsoleEnds::Request::id);
    if (known == console.requests.end()) {
        if (console.requests.size() == kMostResults)
            console.requests.pop_front();
        console.requests.push_back({.id = request.request, .first_ns = now_ns});
        known = std::prev(console.requests.end());
    }
    known->seen_ns = now_ns;
    if (known->answer)
        return;
    const std::string target = textOf(request.target);
    if (request.kind >= static_cast<std::uint8_t>(RequestKind::request) &&
        request.kind <= static_cast<std::uint8_t>(RequestKind::clearFault)) {
        const site::BootName boot = bootNameOf(request.console_boot);
        const RequestAnswer answer = m_arbiter.request(
            console.name, boot, request.request, static_cast<RequestKind>(request.kind), target, now_ns);
        // The arbiter keeps no answers for a second program of that name.
        if (m_arbiter.isNameTaken(console.name, boot, known->first_ns))
            known->answer = answer;
        return;
    }
    const SiteArm* arm = armOf(target);
    known->answer = request.kind != kRestartRequest || arm == nullptr ? RequestAnswer::notPermitted
                    : m_arbiter.controller() != console.name          ? RequestAnswer::notController
                                                                      : RequestAnswer::done;
    if (known->answer == RequestAnswer::done)
        arm->source->restartProgram();
}

void SiteControl::take(ConsoleEnds& console, const ros::SiteArmCommand& command, std::int64_t now_ns) {
    const SiteArm* arm = armOf(textOf(command.arm));
    const auto values = ros::view(command.values);
    site::CommandHead head;
    head.boot = bootNameOf(command.console_boot);
    head.number = command.number;
    head.epoch = command.epoch;
    head.press = command.press;
    head.hold = command.kind == kHoldCommand;
    head.echoSite_ns = command.echo_site_ns;
    const std::optional<AskedMotion> asked =
        arm == nullptr || head.hold
            ? std::nullopt
            : AskedMotion::of(command.kind, textOf(command.frame_id), {values.data(), values.size()}, *arm);
    head.armKnown = arm != nullptr && (head.hold || asked);
    head.finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    head.armLive = arm == nullptr || (arm->source->status().state == core::DeviceState::live &&
                                      (!asked || asked->isLed(*arm, now_ns)) &&
                                      m_health[static_cast<std::size_t>(arm - m_arms.data())].fault.empty());
    const CommandRefusal why = m_arbiter.command(console.name, head, now_ns);
    if (why != CommandRefusal::none) {
        m_lastRefusal = why;
        return;
    }
    m_commandNumber = command.number;
    m_command.reset();
    if (head.hold)
        return;
    m_commanded = arm;
    m_command = asked;
}

void SiteControl::checkArms(std::int64_t now_ns) {
    while (!m_late_ns.empty() && now_ns - m_late_ns.front() > kLateWindow_ns)
        m_late_ns.pop_front();
    bool fault = m_late_ns.size() >= kMostLate;
    for (std::size_t i = 0; i < m_arms.size(); ++i) {
        ArmHealth health = m_arms[i].health ? m_arms[i].health() : ArmHealth();
        if (!health.fault.empty() && m_health[i].fault.empty())
            tell(Severity::error, m_arms[i].name, "fault", health.fault);
        fault = fault || !health.fault.empty();
        // The zeros of a pause would be the release that the arm waits for.
        if (health.wantsNewPress)
            m_arbiter.demandNewPress();
        m_health[i] = std::move(health);
    }
    m_arbiter.setFaultCause(fault);
}

void SiteControl::moveArms(std::int64_t now_ns) {
    if (m_arbiter.mode(now_ns) == Mode::stopped)
        m_stop.engage();
    else
        m_stop.release();
    if (!m_arbiter.mayMove(now_ns))
        m_command.reset();
    for (const SiteArm& arm : m_arms) {
        // The latest command counts until the motion lease is over, however often the console sends.
        core::ArmCommand command{core::JointVector::zeros(arm.source->description().joints()), now_ns};
        if (m_command && m_commanded == &arm)
            command.rate_radPerS = m_command->rates(arm, now_ns);
        arm.source->post(command);
    }
}

void SiteControl::noteChanges(std::int64_t now_ns) {
    SiteStatus now;
    now.mode = m_arbiter.mode(now_ns);
    now.controller = m_arbiter.controller();
    now.epoch = m_arbiter.epoch();
    now.consoles = m_consoles.size();
    now.accepted = m_arbiter.accepted();
    now.refused = refused();
    now.cycles = m_known.cycles + 1;
    now.lateCycles = m_lateCycles;
    if (now.epoch != m_known.epoch)
        tell(Severity::note, now.controller, "granted", now.controller + " is in control");
    else if (now.controller != m_known.controller)
        tell(Severity::note, m_known.controller, "free", m_known.controller + " is no longer in control");
    if (m_arbiter.stops() != m_keptStops) {
        m_keptStops = m_arbiter.stops();
        if (m_settings.keepStops)
            m_settings.keepStops(m_keptStops);
    }
    std::set<std::string> holders = m_arbiter.stopHolders();
    for (const std::string& holder : holders) {
        if (!m_stopHolders.contains(holder))
            tell(Severity::warning, holder, "stop", "STOP is held by " + holder);
    }
    for (const std::string& holder : m_stopHolders) {
        if (!holders.contains(holder))
            tell(Severity::note, holder, "stop_withdrawn", holder + " withdrew STOP");
    }
    if (now.mode != m_known.mode || now.epoch != m_known.epoch || now.controller != m_known.controller ||
        holders != m_stopHolders)
        m_nextState_ns = now_ns;
    m_stopHolders = std::move(holders);
    m_known = now;
    m_status.set(std::move(now));
}

void SiteControl::tellState(std::int64_t now_ns) {
    m_nextState_ns = now_ns + kState_ns;
    LentTexts texts;
    std::vector<char*> holders;
    for (const std::string& holder : m_stopHolders)
        holders.push_back(texts(holder));
    std::vector<char*> viewers;
    for (const std::string& viewer : m_arbiter.viewers(now_ns))
        viewers.push_back(texts(viewer));
    std::vector<ros::ArmState> arms;
    for (std::size_t i = 0; i < m_arms.size(); ++i) {
        ros::ArmState arm{};
        arm.name = texts(m_arms[i].name);
        arm.drive = static_cast<std::uint8_t>(m_arms[i].source->drive());
        arm.flags = m_health[i].flags;
        arm.message = texts(m_arms[i].source->hindrance());
        arms.push_back(arm);
    }
    std::vector<ros::RequestResult> results;
    for (const auto& [name, console] : m_consoles) {
        std::erase_if(console->requests, [now_ns](const ConsoleEnds::Request& request) {
            return now_ns - request.seen_ns > kResult_ns;
        });
        for (const ConsoleEnds::Request& request : console->requests) {
            const RequestAnswer answer = request.answer.value_or(m_arbiter.answerTo(name, request.id));
            ros::RequestResult result{};
            result.console = texts(name);
            result.request = request.id;
            result.result = static_cast<std::uint8_t>(answer);
            const std::optional<std::string> declined = m_arbiter.declinedFor(name, request.id);
            result.message = texts(declined ? declineMessage(*declined) : messageOf(answer));
            results.push_back(result);
        }
    }
    ros::SiteState state{};
    std::ranges::copy(m_boot, std::begin(state.site_boot));
    state.number = ++m_stateNumber;
    state.site_ns = core::steadyNow_ns();
    state.epoch = m_arbiter.epoch();
    state.mode = static_cast<std::uint8_t>(m_arbiter.mode(now_ns));
    state.controller = texts(m_arbiter.controller());
    state.offered_to = texts(m_arbiter.offeredTo());
    state.control_left_ms = toMs(m_arbiter.controlLeft_ns(now_ns));
    state.offer_left_ms = toMs(m_arbiter.offerLeft_ns(now_ns));
    ros::lend(state.stop_holders, std::span(holders));
    state.command_sequence = m_commandNumber;
    state.commands_accepted = m_arbiter.accepted();
    state.commands_refused = refused();
    state.last_refusal = static_cast<std::uint8_t>(m_lastRefusal);
    ros::lend(state.viewers, std::span(viewers));
    ros::lend(state.arms, std::span(arms));
    ros::lend(state.results, std::span(results));
    (void)m_writers.state.write(state);
}

void SiteControl::tell(Severity severity, const std::string& source, const std::string& code,
                       const std::string& message) {
    const SiteNews news{severity, source, code, message};
    publish(news);
    if (m_told)
        m_told(news);
}

void SiteControl::publish(const SiteNews& news) {
    LentTexts texts;
    ros::SiteEvent event{};
    std::ranges::copy(m_boot, std::begin(event.site_boot));
    event.number = ++m_eventNumber;
    event.site_ns = core::steadyNow_ns();
    event.severity = static_cast<std::uint8_t>(news.severity);
    event.source = texts(news.source);
    event.code = texts(news.code);
    event.message = texts(news.message);
    (void)m_writers.event.write(event);
}

void SiteControl::post(SiteNews news) {
    const std::scoped_lock lock(m_newsMutex);
    m_news.push_back(std::move(news));
}

void SiteControl::tellNews() {
    std::vector<SiteNews> news;
    {
        const std::scoped_lock lock(m_newsMutex);
        news.swap(m_news);
    }
    for (const SiteNews& one : news)
        publish(one);
}

const SiteArm* SiteControl::armOf(const std::string& name) const {
    const auto found = std::ranges::find(m_arms, name, &SiteArm::name);
    return found == m_arms.end() ? nullptr : &*found;
}

std::uint64_t SiteControl::refused() const {
    std::uint64_t all = 0;
    for (auto why = static_cast<int>(CommandRefusal::notController);
         why <= static_cast<int>(CommandRefusal::otherBoot); ++why)
        all += m_arbiter.refused(static_cast<CommandRefusal>(why));
    return all;
}

} // namespace teleta::site_link
