// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/control_arbiter.h"

#include <algorithm>
#include <utility>

namespace teleta::site {

namespace {

/// Answers that are kept a console: more than it can have open.
constexpr std::size_t kKeptAnswers = 32;

/// Whoever asks for it has control once it is done.
bool mayGrant(RequestKind kind) {
    return kind == RequestKind::request || kind == RequestKind::takeOver || kind == RequestKind::accept;
}

} // namespace

ControlArbiter::ControlArbiter(std::set<std::string> supervisors, const LeaseTimes& times, StopHolders stops,
                               std::uint64_t epoch)
    : m_supervisors(std::move(supervisors))
    , m_times(times)
    , m_stops(std::move(stops))
    , m_epoch(epoch) {
}

bool ControlArbiter::alive(const std::string& console, std::int64_t now_ns) const {
    const auto found = m_consoles.find(console);
    return found != m_consoles.end() && now_ns - found->second.seen_ns <= m_times.presence_ns;
}

void ControlArbiter::requireNewPress() {
    m_moving = false;
    const auto found = m_consoles.find(m_controller);
    if (found != m_consoles.end())
        m_pressFloor = found->second.highestPress;
}

void ControlArbiter::closeOffer(RequestAnswer answer, const std::optional<std::string>& declined) {
    if (!m_offer)
        return;
    const auto asker = m_consoles.find(m_offer->asker);
    if (asker != m_consoles.end()) {
        Console& console = asker->second;
        const auto waiting = console.answers.find(m_offer->request);
        if (waiting != console.answers.end())
            waiting->second = answer;
        if (declined) {
            console.declined[m_offer->request] =
                declined->size() > kLongestReason_bytes ? std::string() : *declined;
            while (console.declined.size() > kKeptAnswers)
                console.declined.erase(console.declined.begin());
        }
    }
    m_offer.reset();
    requireNewPress();
}

void ControlArbiter::grant(const std::string& console, std::int64_t now_ns) {
    m_controller = console;
    ++m_epoch;
    m_controlUntil_ns = now_ns + m_times.control_ns;
    m_hasAccepted = false;
    requireNewPress();
}

void ControlArbiter::release(std::int64_t now_ns) {
    // Who gives control up agrees to a take-over.
    const std::string taker = m_offer && m_offer->takeOver && !m_stops.any() && alive(m_offer->to, now_ns)
                                  ? m_offer->to
                                  : std::string();
    closeOffer(taker.empty() ? RequestAnswer::expired : RequestAnswer::done);
    m_controller.clear();
    m_moving = false;
    m_hasAccepted = false;
    if (!taker.empty())
        grant(taker, now_ns);
}

void ControlArbiter::advance(std::int64_t now_ns) {
    if (!m_controller.empty() && now_ns > m_controlUntil_ns)
        release(now_ns);
    if (m_offer && now_ns > m_offer->until_ns) {
        const Offer offer = *m_offer;
        // Silence agrees to a take-over, unless STOP or the supervisor's own silence is in the way.
        const bool taken = offer.takeOver && !m_stops.any() && alive(offer.to, now_ns);
        closeOffer(taken ? RequestAnswer::done : RequestAnswer::expired);
        if (taken)
            grant(offer.to, now_ns);
    }
    if (m_moving && now_ns - m_lastAccepted_ns > m_times.motion_ns)
        m_moving = false;
}

bool ControlArbiter::presence(const std::string& console, const Presence& presence, std::int64_t now_ns) {
    advance(now_ns);
    const auto found = m_consoles.find(console);
    const bool isOther = found != m_consoles.end() && found->second.boot != presence.boot;
    if (presence.stopEngaged) {
        if (!m_stops.any())
            requireNewPress();
        const auto ofName =
            std::ranges::count(m_stops.consoles, console, [](const auto& stop) { return stop.first; });
        if (std::cmp_less(ofName, kMostStopsOfName))
            m_stops.consoles.emplace(console, presence.boot);
    } else if (m_stops.consoles.erase({console, presence.boot}) > 0) {
        // Only the program that engaged STOP withdraws it: one that was started anew knows nothing of it.
        requireNewPress();
    }
    if (isOther && alive(console, now_ns))
        return false;
    if (isOther) {
        if (m_controller == console)
            release(now_ns);
        else if (m_offer && m_offer->to == console)
            closeOffer(RequestAnswer::expired);
        m_consoles.erase(found);
    }
    const bool came = !alive(console, now_ns);
    Console& known = m_consoles[console];
    if (came)
        known.since_ns = now_ns;
    known.boot = presence.boot;
    known.viewer = presence.viewer;
    known.seen_ns = now_ns;
    if (m_controller == console)
        m_controlUntil_ns = now_ns + m_times.control_ns;
    return true;
}

RequestAnswer ControlArbiter::request(const std::string& console, const BootName& boot, std::uint64_t id,
                                      RequestKind kind, const std::string& target, std::int64_t now_ns) {
    advance(now_ns);
    const auto found = m_consoles.find(console);
    if (found == m_consoles.end() || found->second.boot != boot || !alive(console, now_ns))
        return RequestAnswer::noSuchConsole;
    if (const auto known = found->second.answers.find(id); known != found->second.answers.end())
        return known->second;
    if (mayGrant(kind) && now_ns - found->second.since_ns < m_times.known_ns)
        return RequestAnswer::waits;
    // Noted before it is carried out: an offer that ends at once finds where its answer belongs.
    found->second.answers[id] = RequestAnswer::waits;
    const RequestAnswer answer = carryOut(console, kind, target, id, now_ns);
    found->second.answers[id] = answer;
    while (found->second.answers.size() > kKeptAnswers)
        found->second.answers.erase(found->second.answers.begin());
    return answer;
}

RequestAnswer ControlArbiter::carryOut(const std::string& console, RequestKind kind,
                                       const std::string& target, std::uint64_t id, std::int64_t now_ns) {
    const bool isController = m_controller == console;
    const bool isSupervisor = m_supervisors.contains(console) && !m_consoles.at(console).viewer;
    switch (kind) {
    case RequestKind::request:
    case RequestKind::takeOver: {
        const bool takesOver = kind == RequestKind::takeOver;
        if (m_consoles.at(console).viewer || (takesOver && !isSupervisor))
            return RequestAnswer::notPermitted;
        if (m_stops.any())
            return RequestAnswer::stopped;
        if (isController)
            return RequestAnswer::done;
        if (m_controller.empty()) {
            grant(console, now_ns);
            return RequestAnswer::done;
        }
        if (!takesOver || m_offer)
            return RequestAnswer::busy;
        m_offer = Offer{console, true, now_ns + m_times.takeOver_ns, console, id};
        m_moving = false;
        return RequestAnswer::waits;
    }
    case RequestKind::release:
        if (!isController)
            return RequestAnswer::notController;
        release(now_ns);
        return RequestAnswer::done;
    case RequestKind::offer:
        if (!isController)
            return RequestAnswer::notController;
        if (m_stops.any())
            return RequestAnswer::stopped;
        if (m_offer)
            return RequestAnswer::busy;
        if (target == console || !alive(target, now_ns))
            return RequestAnswer::noSuchConsole;
        if (m_consoles.at(target).viewer)
            return RequestAnswer::notPermitted;
        m_offer = Offer{target, false, now_ns + m_times.offer_ns, console, id};
        m_moving = false;
        return RequestAnswer::waits;
    case RequestKind::accept:
        return answerOffer(console, true, {}, now_ns);
    case RequestKind::decline:
        return answerOffer(console, false, target, now_ns);
    case RequestKind::withdrawStop:
        if (!isSupervisor || alive(target, now_ns))
            return RequestAnswer::notPermitted;
        if (std::erase_if(m_stops.consoles, [&target](const auto& stop) { return stop.first == target; }) ==
            0)
            return RequestAnswer::noSuchConsole;
        requireNewPress();
        return RequestAnswer::done;
    case RequestKind::clearFault:
        if (!isController)
            return RequestAnswer::notController;
        if (m_faultCause)
            return RequestAnswer::busy;
        m_fault = false;
        requireNewPress();
        return RequestAnswer::done;
    }
    return RequestAnswer::notPermitted;
}

RequestAnswer ControlArbiter::answerOffer(const std::string& console, bool accepts, const std::string& reason,
                                          std::int64_t now_ns) {
    if (!m_offer)
        return RequestAnswer::expired;
    // A hand-over is accepted by the one who gets control; a take-over is agreed to by the one who loses it.
    // Who asked may give it up.
    const std::string& answers = m_offer->takeOver ? m_controller : m_offer->to;
    const bool givesUp = !accepts && console == m_offer->asker;
    if (console != answers && !givesUp)
        return RequestAnswer::notPermitted;
    if (accepts && m_stops.any())
        return RequestAnswer::stopped;
    const std::string to = m_offer->to;
    closeOffer(accepts ? RequestAnswer::done : RequestAnswer::expired,
               accepts || givesUp ? std::nullopt : std::optional(reason));
    if (accepts)
        grant(to, now_ns);
    return RequestAnswer::done;
}

CommandRefusal ControlArbiter::judge(const std::string& console, const CommandHead& head,
                                     std::int64_t now_ns) const {
    if (m_controller != console || m_offer)
        return CommandRefusal::notController;
    if (head.epoch != m_epoch)
        return CommandRefusal::oldEpoch;
    if (m_stops.any())
        return CommandRefusal::stopped;
    const Console& known = m_consoles.at(console);
    // A hold needs no press: it lets go.
    if (!head.hold && head.press <= m_pressFloor)
        return CommandRefusal::pressAnew;
    if (known.hasNumber && head.number <= known.lastNumber)
        return CommandRefusal::oldNumber;
    // Compared, not subtracted: what comes over the network may be any number.
    if (head.echoSite_ns > now_ns || head.echoSite_ns < now_ns - m_times.loopLimit_ns)
        return CommandRefusal::oldLoop;
    if (!head.armKnown)
        return CommandRefusal::unknownArm;
    if (!head.finite)
        return CommandRefusal::notFinite;
    if (!head.armLive || m_fault)
        return CommandRefusal::notLive;
    if (head.boot != known.boot)
        return CommandRefusal::otherBoot;
    return CommandRefusal::none;
}

CommandRefusal ControlArbiter::command(const std::string& console, const CommandHead& head,
                                       std::int64_t now_ns) {
    advance(now_ns);
    // After a gap the presses that were seen until now are too old.
    if (m_controller == console && m_hasAccepted && now_ns - m_lastAccepted_ns > m_times.gap_ns)
        requireNewPress();
    const CommandRefusal why = judge(console, head, now_ns);
    if (const auto found = m_consoles.find(console);
        found != m_consoles.end() && found->second.boot == head.boot) {
        Console& known = found->second;
        known.highestPress = std::max(known.highestPress, head.press);
        if (why == CommandRefusal::none) {
            known.lastNumber = head.number;
            known.hasNumber = true;
        }
    }
    if (why != CommandRefusal::none) {
        ++m_refused[static_cast<std::size_t>(why)];
        return why;
    }
    ++m_accepted;
    m_controlUntil_ns = now_ns + m_times.control_ns;
    m_lastAccepted_ns = now_ns;
    m_hasAccepted = true;
    m_moving = !head.hold;
    if (head.hold)
        requireNewPress();
    return why;
}

void ControlArbiter::withdrawStopsOfGone(std::int64_t now_ns) {
    const auto isGone = [&](const auto& stop) {
        const auto found = m_consoles.find(stop.first);
        return !alive(stop.first, now_ns) || found == m_consoles.end() || found->second.boot != stop.second;
    };
    if (std::erase_if(m_stops.consoles, isGone) > 0)
        requireNewPress();
}

void ControlArbiter::setSiteStop(bool engaged) {
    if (engaged != m_stops.site)
        requireNewPress();
    m_stops.site = engaged;
}

void ControlArbiter::setFaultCause(bool present) {
    m_faultCause = present;
    if (present && !m_fault) {
        m_fault = true;
        requireNewPress();
    }
}

Mode ControlArbiter::mode(std::int64_t now_ns) const {
    if (m_stops.any())
        return Mode::stopped;
    if (m_fault)
        return Mode::fault;
    if (m_controller.empty() || now_ns > m_controlUntil_ns)
        return Mode::free;
    if (m_offer)
        return Mode::offered;
    return m_moving && now_ns - m_lastAccepted_ns <= m_times.motion_ns ? Mode::moving : Mode::held;
}

std::int64_t ControlArbiter::controlLeft_ns(std::int64_t now_ns) const {
    return m_controller.empty() ? 0 : std::max<std::int64_t>(0, m_controlUntil_ns - now_ns);
}

std::int64_t ControlArbiter::offerLeft_ns(std::int64_t now_ns) const {
    return m_offer ? std::max<std::int64_t>(0, m_offer->until_ns - now_ns) : 0;
}

std::set<std::string> ControlArbiter::stopHolders() const {
    std::set<std::string> holders;
    for (const auto& [console, boot] : m_stops.consoles)
        holders.insert(console);
    if (m_stops.site)
        holders.insert(kSiteHolder);
    return holders;
}

std::set<std::string> ControlArbiter::viewers(std::int64_t now_ns) const {
    std::set<std::string> found;
    for (const auto& [name, console] : m_consoles) {
        if (console.viewer && alive(name, now_ns))
            found.insert(name);
    }
    return found;
}

RequestAnswer ControlArbiter::answerTo(const std::string& console, std::uint64_t id) const {
    const auto found = m_consoles.find(console);
    if (found == m_consoles.end())
        return RequestAnswer::waits;
    const auto answer = found->second.answers.find(id);
    return answer == found->second.answers.end() ? RequestAnswer::waits : answer->second;
}

std::optional<std::string> ControlArbiter::declinedFor(const std::string& console, std::uint64_t id) const {
    const auto found = m_consoles.find(console);
    if (found == m_consoles.end())
        return std::nullopt;
    const auto reason = found->second.declined.find(id);
    return reason == found->second.declined.end() ? std::nullopt : std::optional(reason->second);
}

bool ControlArbiter::isNameTaken(const std::string& console, const BootName& boot,
                                 std::int64_t since_ns) const {
    const auto found = m_consoles.find(console);
    return found != m_consoles.end() && found->second.boot != boot && found->second.seen_ns > since_ns;
}

} // namespace teleta::site
