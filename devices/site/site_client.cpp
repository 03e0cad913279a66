// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/site_client.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "devices/site/boot_name.h"
#include "devices/site/decline_message.h"
#include "devices/site/lent_texts.h"
#include "devices/site/stream_descriptions.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

namespace teleta::site_link {

namespace {

struct SiteClientText {
    Q_DECLARE_TR_FUNCTIONS(SiteClientText)
};

using site::Mode;
using site::RequestKind;

constexpr std::int64_t kCycle_ns = 10'000'000;
constexpr std::int64_t kPresence_ns = 100'000'000;
constexpr std::int64_t kProbe_ns = 250'000'000;
/// At first, so that the clock is soon known.
constexpr std::int64_t kFirstProbe_ns = 125'000'000;
constexpr std::int64_t kFirstTime_ns = 4'000'000'000;
constexpr std::int64_t kAskAgain_ns = 200'000'000;
/// Longer than any offer waits.
constexpr std::int64_t kLongestAsk_ns = 15'000'000'000;
constexpr std::int64_t kOpenLook_ns = 50'000'000;
constexpr std::int64_t kConsolesLook_ns = 500'000'000;
/// Times of messages are in ms.
constexpr double kPerMs = 1e-3;

std::vector<std::string> textsOf(const dds_sequence_string& sequence) {
    std::vector<std::string> texts;
    for (const char* text : ros::view(sequence))
        texts.push_back(textOf(text));
    return texts;
}

template <typename Enumeration>
Enumeration atMost(std::uint8_t value, Enumeration highest) {
    return static_cast<Enumeration>(std::min(value, static_cast<std::uint8_t>(highest)));
}

bool moves(const core::JointVector& rate) {
    return std::ranges::any_of(rate, [](double value) { return value != 0.0; });
}

std::uint64_t firstRequestOf(const site::BootName& boot) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < 6; ++i)
        number = number << 8U | boot[i];
    return number;
}

/// A console that asks for it becomes the controller once it is done.
bool mayGrant(RequestKind kind) {
    constexpr std::array kWays{RequestKind::request, RequestKind::takeOver, RequestKind::accept};
    return std::ranges::find(kWays, kind) != kWays.end();
}

QString joined(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names)
        list << QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

} // namespace

/// Waits for what the site says of itself.
core::Expected<SiteClient::Told>
SiteClient::findSite(const std::shared_ptr<const dds::Participant>& participant, const SiteTopics& topics,
                     const RemoteSiteFile& file, const std::function<bool()>& cancelled) {
    TELETA_TRY(auto info, dds::Reader<ros::SiteInfo>::open(participant, topics.info(), kLatched));
    TELETA_TRY(auto descriptions, dds::Reader<ros::String>::open(participant, topics.streams(), kLatched));
    dds::WaitSet waitSet(participant);
    waitSet.attach(info);
    waitSet.attach(descriptions);
    std::optional<std::uint32_t> protocol;
    std::optional<std::string> text;
    std::size_t expected = 0;
    double lease_s = 0.0;
    double loopLimit_s = 0.0;
    for (const std::int64_t end_ns = core::steadyNow_ns() + SiteClient::kLongestOpen_ns;
         core::steadyNow_ns() < end_ns;) {
        if (cancelled && cancelled())
            return core::failed(core::ErrorKind::cancelled, SiteClientText::tr("interrupted"));
        (void)info.take([&](const ros::SiteInfo& message, const dds::SampleInfo&) {
            protocol = message.protocol;
            expected = ros::view(message.streams).size();
            lease_s = message.control_lease_ms * kPerMs;
            loopLimit_s = message.loop_limit_ms * kPerMs;
        });
        (void)descriptions.take(
            [&text](const ros::String& message, const dds::SampleInfo&) { text = textOf(message.data); });
        if (protocol && *protocol != kProtocol)
            return core::refused(
                SiteClientText::tr("%1 speaks version %2 of the protocol of sites, this program version %3")
                    .arg(QString::fromStdString(file.name))
                    .arg(*protocol)
                    .arg(kProtocol));
        if (protocol && text) {
            TELETA_TRY(auto streams, readStreams(*text, file.name));
            // The descriptions of the program before may come first.
            if (streams.size() == expected)
                return Told{std::move(streams), lease_s, loopLimit_s};
        }
        waitSet.wait(kOpenLook_ns);
    }
    // With keys that do not accept each other, this end may be the only one that knows.
    if (const dds::Refusals refusals = participant->refusals(); refusals.count > 0)
        return core::refused(QString::fromStdString(refusals.reason));
    return core::failed(core::ErrorKind::unavailable,
                        SiteClientText::tr("the site %1 was not found in domain %2 within %3 s")
                            .arg(QString::fromStdString(file.name))
                            .arg(file.meeting.domain.domain)
                            .arg(SiteClient::kLongestOpen_ns / 1'000'000'000),
                        SiteClientText::tr("teleta-site running there, and its address under peers"));
}

std::string hindranceOf(const SiteView& view, const std::string& console, const std::string& arm) {
    const auto text = [](const QString& sentence) { return sentence.toStdString(); };
    if (!view.reached)
        return text(SiteClientText::tr("the site does not answer"));
    if (view.mode == Mode::stopped)
        return text(SiteClientText::tr("STOP is held by %1").arg(joined(view.stopHolders)));
    if (view.controller.empty())
        return text(SiteClientText::tr("nobody controls the site; request control first"));
    if (view.controller != console)
        return text(SiteClientText::tr("%1 controls the site").arg(QString::fromStdString(view.controller)));
    if (!view.granted)
        return text(SiteClientText::tr("an earlier program of this console still controls the site"));
    if (view.mode == Mode::offered)
        return text(
            SiteClientText::tr("control is being handed to %1").arg(QString::fromStdString(view.offeredTo)));
    const auto found = std::ranges::find(view.arms, arm, &RemoteArmState::name);
    if (found == view.arms.end())
        return text(SiteClientText::tr("the site has no such arm any more"));
    if (view.mode == Mode::fault && found->message.empty())
        return text(SiteClientText::tr("an arm had a fault; clear it first"));
    if (found->message.empty() && view.pressAnew)
        return text(SiteClientText::tr("let go of the switch and press it again"));
    return found->message;
}

core::Expected<std::shared_ptr<SiteClient>> SiteClient::open(const RemoteSiteFile& file,
                                                             const std::string& version,
                                                             const core::StopSwitch& stop,
                                                             const std::function<bool()>& cancelled) {
    TELETA_TRY(const auto participant, file.meeting.join());
    const SiteTopics topics(file.name);
    TELETA_TRY(Told told, findSite(participant, topics, file, cancelled));
    TELETA_TRY(auto state, dds::Reader<ros::SiteState>::open(participant, topics.state(), kState));
    TELETA_TRY(auto event, dds::Reader<ros::SiteEvent>::open(participant, topics.event(), kEvents));
    TELETA_TRY(auto answer,
               dds::Reader<ros::ClockAnswer>::open(participant, topics.clockAnswer(file.console), kNewest));
    TELETA_TRY(auto presence, dds::Writer<ros::ConsolePresence>::open(
                                  participant, topics.presence(file.console), kPresenceProfile));
    std::optional<dds::Writer<ros::ControlRequest>> request;
    std::optional<dds::Writer<ros::SiteArmCommand>> command;
    if (!file.viewer) {
        TELETA_TRY(auto asks, dds::Writer<ros::ControlRequest>::open(
                                  participant, topics.request(file.console), kRequests));
        TELETA_TRY(auto moves, dds::Writer<ros::SiteArmCommand>::open(participant,
                                                                      topics.command(file.console), kNewest));
        request.emplace(std::move(asks));
        command.emplace(std::move(moves));
    }
    TELETA_TRY(auto probe,
               dds::Writer<ros::ClockProbe>::open(participant, topics.clockProbe(file.console), kNewest));
    TELETA_TRY(auto discovery, dds::Discovery::open(participant));
    std::shared_ptr<SiteClient> client(
        new SiteClient(file, version, participant, std::move(told),
                       {std::move(state), std::move(event), std::move(answer), std::move(presence),
                        std::move(request), std::move(command), std::move(probe), std::move(discovery)},
                       stop));
    client->m_thread = std::jthread([raw = client.get()](const std::stop_token& end) { raw->run(end); });
    return client;
}

SiteClient::SiteClient(RemoteSiteFile file, std::string version,
                       std::shared_ptr<const dds::Participant> participant, Told told, Ends ends,
                       const core::StopSwitch& stop)
    : m_file(std::move(file))
    , m_version(std::move(version))
    , m_participant(std::move(participant))
    , m_topics(m_file.name)
    , m_streams(std::move(told.streams))
    , m_controlLease_s(told.controlLease_s)
    , m_loopLimit_s(told.loopLimit_s)
    , m_keyWarnings(m_file.meeting.keyWarnings())
    , m_ends(std::move(ends))
    , m_stop(stop)
    , m_waitSet(m_participant)
    , m_boot(newBootName())
    , m_lastRequest(firstRequestOf(m_boot)) {
    m_waitSet.attach(m_ends.state);
    m_waitSet.attach(m_ends.event);
    m_waitSet.attach(m_ends.answer);
}

SiteClient::~SiteClient() {
    m_thread.request_stop();
    m_waitSet.wake();
    if (m_thread.joinable())
        m_thread.join();
}

std::vector<RemoteEvent> SiteClient::takeEvents() {
    const std::scoped_lock lock(m_mutex);
    std::vector<RemoteEvent> events(std::make_move_iterator(m_events.begin()),
                                    std::make_move_iterator(m_events.end()));
    m_events.clear();
    return events;
}

std::uint64_t SiteClient::request(RequestKind kind, const std::string& target) {
    std::uint64_t number = 0;
    {
        const std::scoped_lock lock(m_mutex);
        Pending pending;
        number = pending.outcome.id = ++m_lastRequest;
        pending.outcome.kind = kind;
        pending.target = target;
        pending.until_ns = core::steadyNow_ns() + kLongestAsk_ns;
        m_pending = std::move(pending);
        if (mayGrant(kind)) {
            constexpr std::size_t kMostAsked = 16;
            if (m_askedControl.size() == kMostAsked)
                m_askedControl.pop_front();
            m_askedControl.push_back(number);
        }
    }
    m_waitSet.wake();
    return number;
}

void SiteClient::post(const std::string& arm, const core::ArmCommand& command) {
    {
        // Each is kept until the thread has seen it: a press that follows at once must not hide a release.
        constexpr std::size_t kMostPosted = 64;
        const std::scoped_lock lock(m_mutex);
        if (m_posted.size() == kMostPosted)
            m_posted.pop_front();
        m_posted.push_back({arm, command});
    }
    m_waitSet.wake();
}

recording::StreamInfo SiteClient::clockStream() const {
    return {.name = m_file.name + "-clock",
            .kind = recording::StreamKind::numbers,
            .type = recording::ValueType::float64,
            .source = m_file.name,
            .shape = {4},
            .columns = {{"t1_console_ns", "ns"},
                        {"t2_site_ns", "ns"},
                        {"t3_site_ns", "ns"},
                        {"t4_console_ns", "ns"}},
            .nominalRate_Hz = 1e9 / static_cast<double>(kProbe_ns)};
}

void SiteClient::recordClock(std::shared_ptr<core::StreamTap> tap) {
    const std::scoped_lock lock(m_mutex);
    m_clockTap = std::move(tap);
}

std::int64_t SiteClient::readTime_ns(std::int64_t read_site_ns, std::int64_t arrived_ns) const {
    const std::optional<std::int64_t> offset_ns = m_offset_ns.get();
    return offset_ns ? std::min(read_site_ns - *offset_ns, arrived_ns) : arrived_ns;
}

void SiteClient::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    m_started_ns = core::steadyNow_ns();
    std::int64_t next_ns = m_started_ns;
    while (!stop.stop_requested()) {
        m_waitSet.wait(std::max<std::int64_t>(0, next_ns - core::steadyNow_ns()));
        const std::int64_t now_ns = core::steadyNow_ns();
        next_ns = now_ns + kCycle_ns;
        listen();
        if (leaves())
            giveUp();
        tellPresence(now_ns);
        probeClock(now_ns);
        ask(now_ns);
        findConsoles(now_ns);
        command(now_ns);
        publish(now_ns);
    }
    giveUp();
}

/// Once: a reliable message that the site gets even if the program ends meanwhile.
void SiteClient::giveUp() {
    if (std::exchange(m_released, true) || !m_now.controls(m_file.console))
        return;
    const std::scoped_lock lock(m_mutex);
    writeRequest(++m_lastRequest, RequestKind::release, {});
}

void SiteClient::listen() {
    (void)m_ends.state.take(
        [this](const ros::SiteState& state, const dds::SampleInfo&) { take(state, core::steadyNow_ns()); });
    (void)m_ends.answer.take([this](const ros::ClockAnswer& answer, const dds::SampleInfo&) {
        take(answer, core::steadyNow_ns());
    });
    (void)m_ends.event.take([this](const ros::SiteEvent& event, const dds::SampleInfo&) {
        const std::scoped_lock lock(m_mutex);
        if (m_events.size() == kMostEvents)
            m_events.pop_front();
        m_events.push_back(
            {event.site_ns, event.severity, textOf(event.source), textOf(event.code), textOf(event.message)});
    });
}

void SiteClient::take(const ros::SiteState& state, std::int64_t now_ns) {
    const site::BootName boot = bootNameOf(state.site_boot);
    if (m_siteBoot != boot) {
        // Everything that was known of the other program is dropped, control included.
        m_clock.reset();
        m_shownOffset.reset();
        m_refused.reset();
        m_loops_s.clear();
        m_now.boots += m_siteBoot ? 1 : 0;
        m_now.granted = false;
        m_siteBoot = boot;
        m_stateNumber = state.number - 1;
    }
    if (state.number <= m_stateNumber)
        return; // it was overtaken
    m_now.statesLost += state.number - m_stateNumber - 1;
    m_stateNumber = state.number;
    m_echoSite_ns = state.site_ns;
    m_now.lastState_ns = now_ns;
    m_now.mode = atMost(state.mode, Mode::fault);
    m_now.controller = textOf(state.controller);
    m_now.offeredTo = textOf(state.offered_to);
    m_now.epoch = state.epoch;
    m_now.controlLeft_s = state.control_left_ms * kPerMs;
    m_now.offerLeft_s = state.offer_left_ms * kPerMs;
    m_now.stopHolders = textsOf(state.stop_holders);
    m_now.viewers = textsOf(state.viewers);
    m_now.accepted = state.commands_accepted;
    m_now.refused = state.commands_refused;
    m_now.lastRefusal = atMost(state.last_refusal, site::CommandRefusal::otherBoot);
    countRefusals();
    judgePress(now_ns);
    m_now.arms.clear();
    for (const ros::ArmState& arm : ros::view(state.arms))
        m_now.arms.push_back(
            {textOf(arm.name), atMost(arm.drive, core::ArmDrive::jog), arm.flags, textOf(arm.message)});
    const std::scoped_lock lock(m_mutex);
    for (const ros::RequestResult& result : ros::view(state.results)) {
        if (textOf(result.console) != m_file.console)
            continue;
        const auto answer = atMost(result.result, site::RequestAnswer::expired);
        m_now.granted =
            m_now.granted || (answer == site::RequestAnswer::done &&
                              std::ranges::find(m_askedControl, result.request) != m_askedControl.end());
        if (!m_pending || result.request != m_pending->outcome.id)
            continue;
        m_pending->outcome.answer = answer;
        if (answer == site::RequestAnswer::expired)
            m_pending->outcome.declined = declineReason(textOf(result.message));
        m_now.request = m_pending->outcome;
        if (m_pending->outcome.answer != site::RequestAnswer::waits)
            m_pending.reset();
    }
}

void SiteClient::take(const ros::ClockAnswer& answer, std::int64_t now_ns) {
    if (bootNameOf(answer.console_boot) != m_boot)
        return; // to another program of this console's name
    if (m_siteBoot && bootNameOf(answer.site_boot) != *m_siteBoot)
        return;
    if (!m_clock.add({answer.t1_console_ns, answer.t2_site_ns, answer.t3_site_ns, now_ns}))
        return;
    {
        const std::scoped_lock lock(m_mutex);
        const std::array<double, 4> times_ns{
            static_cast<double>(answer.t1_console_ns), static_cast<double>(answer.t2_site_ns),
            static_cast<double>(answer.t3_site_ns), static_cast<double>(now_ns)};
        if (m_clockTap)
            m_clockTap->append(now_ns, 1e-9 * times_ns[1], std::span<const double>(times_ns));
    }
    m_now.loop_s = core::elapsed_s(answer.t1_console_ns, now_ns);
    if (m_loops_s.size() == kLoops)
        m_loops_s.pop_front();
    m_loops_s.push_back(*m_now.loop_s);
    std::vector<double> sorted(m_loops_s.begin(), m_loops_s.end());
    std::ranges::sort(sorted);
    m_now.loops = LoopTimes{core::quantileOf(sorted, 0.5), core::quantileOf(sorted, 0.99)};
}

void SiteClient::countRefusals() {
    if (m_refused && m_now.refused > *m_refused)
        m_now.refusedBy[static_cast<std::size_t>(m_now.lastRefusal)] += m_now.refused - *m_refused;
    m_refused = m_now.refused;
}

/// A state tells how many commands were refused, not which: those of the press before may be among them until
/// the loop is over once.
void SiteClient::judgePress(std::int64_t now_ns) {
    if (!m_hand.isHeld() || core::elapsed_s(m_pressed_ns, now_ns) < (m_now.loops ? m_now.loops->slow_s : 0.0))
        return;
    const Counted counted{m_now.accepted,
                          m_now.refusedBy[static_cast<std::size_t>(site::CommandRefusal::pressAnew)]};
    if (m_sincePress && counted.accepted != m_sincePress->accepted)
        m_now.pressAnew = false;
    else if (m_sincePress && counted.pressAnew != m_sincePress->pressAnew)
        m_now.pressAnew = true;
    m_sincePress = counted;
}

void SiteClient::tellPresence(std::int64_t now_ns) {
    const bool stopped = leaves() ? m_toldStop : m_stop.engaged();
    if (now_ns < m_nextPresence_ns && stopped == m_toldStop)
        return;
    m_nextPresence_ns = now_ns + kPresence_ns;
    m_toldStop = stopped;
    LentTexts texts;
    ros::ConsolePresence presence{};
    std::ranges::copy(m_boot, std::begin(presence.console_boot));
    presence.number = ++m_presenceNumber;
    presence.console_ns = now_ns;
    presence.console = texts(m_file.console);
    presence.person = texts(m_file.person);
    presence.version = texts(m_version);
    presence.viewer = m_file.viewer;
    presence.stop_engaged = stopped;
    presence.epoch = m_now.epoch;
    presence.echo_site_ns = m_echoSite_ns;
    (void)m_ends.presence.write(presence);
}

void SiteClient::probeClock(std::int64_t now_ns) {
    if (now_ns < m_nextProbe_ns)
        return;
    m_nextProbe_ns = now_ns + (now_ns - m_started_ns < kFirstTime_ns ? kFirstProbe_ns : kProbe_ns);
    ros::ClockProbe probe{};
    std::ranges::copy(m_boot, std::begin(probe.console_boot));
    probe.number = ++m_probeNumber;
    probe.t1_console_ns = core::steadyNow_ns();
    (void)m_ends.probe.write(probe);
}

void SiteClient::ask(std::int64_t now_ns) {
    const std::scoped_lock lock(m_mutex);
    if (!m_pending || now_ns < m_pending->next_ns)
        return;
    m_now.request = m_pending->outcome;
    if (!m_ends.request) {
        m_now.request->answer = site::RequestAnswer::notPermitted;
        m_pending.reset();
        return;
    }
    if (now_ns > m_pending->until_ns) {
        m_now.request->answer = site::RequestAnswer::expired;
        m_pending.reset();
        return;
    }
    m_pending->next_ns = now_ns + kAskAgain_ns;
    writeRequest(m_pending->outcome.id, m_pending->outcome.kind, m_pending->target);
}

void SiteClient::writeRequest(std::uint64_t number, RequestKind kind, const std::string& target) {
    if (!m_ends.request)
        return;
    LentTexts texts;
    ros::ControlRequest request{};
    std::ranges::copy(m_boot, std::begin(request.console_boot));
    request.request = number;
    request.kind = static_cast<std::uint8_t>(kind);
    request.target = texts(target);
    request.epoch = m_now.epoch;
    (void)m_ends.request->write(request);
}

void SiteClient::findConsoles(std::int64_t now_ns) {
    if (now_ns < m_nextLook_ns)
        return;
    m_nextLook_ns = now_ns + kConsolesLook_ns;
    m_now.consoles.clear();
    for (const dds::FoundEnd& end : m_ends.discovery.ends()) {
        const std::optional<std::string> name = m_topics.consoleOf(end.ddsTopic);
        if (name && end.writes && std::ranges::find(m_now.consoles, *name) == m_now.consoles.end())
            m_now.consoles.push_back(*name);
    }
    listenToOthers();
}

/// Who sits at the other consoles.
void SiteClient::listenToOthers() {
    std::erase_if(m_others, [this](const auto& other) {
        return std::ranges::find(m_now.consoles, other.first) == m_now.consoles.end();
    });
    std::erase_if(m_now.persons, [this](const auto& person) { return !m_others.contains(person.first); });
    if (!m_file.person.empty())
        m_now.persons[m_file.console] = m_file.person;
    for (const std::string& name : m_now.consoles) {
        constexpr std::size_t kMostOthers = 64;
        if (name == m_file.console || m_others.contains(name) || m_others.size() >= kMostOthers)
            continue;
        auto reader =
            dds::Reader<ros::ConsolePresence>::open(m_participant, m_topics.presence(name), kNewest);
        m_others.emplace(name, reader ? std::optional(std::move(*reader)) : std::nullopt);
    }
    for (auto& [name, reader] : m_others) {
        if (!reader)
            continue;
        (void)reader->take(
            [this, &name = name](const ros::ConsolePresence& presence, const dds::SampleInfo&) {
                std::string person = textOf(presence.person);
                if (person.empty() || person.size() > kLongestPerson_bytes)
                    m_now.persons.erase(name);
                else
                    m_now.persons[name] = std::move(person);
            });
    }
}

void SiteClient::command(std::int64_t now_ns) {
    {
        const std::scoped_lock lock(m_mutex);
        for (Posted& posted : m_posted) {
            m_hand.post(moves(posted.command.rate_radPerS), posted.command.time_ns);
            m_newest = std::move(posted);
        }
        m_posted.clear();
    }
    // The site stops by the presence. A STOP that was released before a busy view looked counts, too.
    const std::uint64_t engagements = m_stop.engagements();
    const bool wasEngaged = std::exchange(m_engagements, engagements) != engagements;
    if (m_stop.engaged() || wasEngaged || leaves())
        m_hand.stop();
    if (std::exchange(m_press, m_hand.press()) != m_hand.press() || !m_hand.isHeld()) {
        m_pressed_ns = now_ns;
        m_sincePress.reset();
        m_now.pressAnew = m_hand.isBlocked();
    }
    if (now_ns < m_nextCommand_ns)
        return;
    const site::OperatorHand::Send send = m_hand.step(now_ns);
    if (m_newest.arm.empty() || send == site::OperatorHand::Send::nothing || !m_ends.command)
        return;
    m_nextCommand_ns = now_ns + site::OperatorHand::kPeriod_ns;
    LentTexts texts;
    const bool hold = send == site::OperatorHand::Send::hold;
    core::JointVector rate = m_newest.command.rate_radPerS;
    ros::SiteArmCommand message{};
    std::ranges::copy(m_boot, std::begin(message.console_boot));
    message.number = ++m_commandNumber;
    message.epoch = m_now.epoch;
    message.press = m_hand.press();
    message.kind = hold ? kHoldCommand : kRatesCommand;
    message.arm = texts(m_newest.arm);
    message.frame_id = texts({});
    message.console_ns = now_ns;
    message.echo_site_ns = m_echoSite_ns;
    if (!hold)
        ros::lend(message.values, std::span(rate.data(), rate.size()));
    (void)m_ends.command->write(message);
}

void SiteClient::publish(std::int64_t now_ns) {
    m_now.reached = m_now.lastState_ns != 0 && now_ns - m_now.lastState_ns <= kSilence_ns;
    m_now.clock = m_clock.offset(now_ns);
    m_now.clockJumps = m_clock.jumps();
    m_now.shownOffset_ns =
        m_now.clock ? std::optional(m_shownOffset.follow(m_now.clock->offset_ns, now_ns)) : std::nullopt;
    m_offset_ns.set(m_now.clock ? std::optional(m_now.clock->offset_ns) : std::nullopt);
    m_view.set(m_now);
}

} // namespace teleta::site_link
