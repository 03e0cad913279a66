// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/site/site_views.h"

#include "app/console/operate/site/site_events.h"
#include "backend/core/steady_time.h"
#include "widgets/base/background.h"

#include <QDebug>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

using chrome::Message;
using site::CommandRefusal;
using site::RequestAnswer;
using site::RequestKind;
using site_view::SiteBarState;

QString text(const std::string& from) {
    return QString::fromStdString(from);
}

QStringList texts(const std::vector<std::string>& from) {
    QStringList list;
    for (const std::string& one : from)
        list << text(one);
    return list;
}

/// Times of the bar: it is drawn anew only when what it says changes.
double rounded(double time_s) {
    return std::round(1e4 * time_s) / 1e4;
}

/// Of the last command that was refused, in numbers where there are some.
QString lastRefusalOf(const site_link::SiteClient& site, const site_link::SiteView& view) {
    const double limit_s = site.loopLimit_s();
    if (view.lastRefusal != CommandRefusal::oldLoop || limit_s <= 0.0)
        return SiteViews::refusalText(view.lastRefusal);
    return view.loop_s && *view.loop_s > limit_s
               ? SiteViews::tr("the loop takes %1 s, the limit is %2 s")
                     .arg(*view.loop_s, 0, 'f', 2)
                     .arg(limit_s, 0, 'f', 2)
               : SiteViews::tr("the loop takes longer than %1 s").arg(limit_s, 0, 'f', 2);
}

SiteBarState stateOf(const site_link::SiteClient& site, const site_link::SiteView& view) {
    const std::string& own = site.file().console;
    SiteBarState state;
    state.site = text(site.file().name);
    state.viewer = site.file().viewer;
    state.reached = view.reached;
    // In tenths: the bar is drawn anew only when what it says changes.
    state.silent_s = view.reached
                         ? 0.0
                         : std::floor(10.0 * core::elapsed_s(view.lastState_ns, core::steadyNow_ns())) / 10.0;
    state.mode = static_cast<SiteBarState::Mode>(view.mode);
    state.controller = text(view.controller);
    state.controls = view.granted && view.controller == own;
    state.offeredTo = text(view.offeredTo);
    state.offeredHere = view.offeredTo == own;
    state.offerLeft_s = std::ceil(view.offerLeft_s);
    state.leaseShare = std::round(20.0 * view.controlLeft_s / std::max(1e-3, site.controlLease_s())) / 20.0;
    state.stopHolders = texts(view.stopHolders);
    state.stopsItself = state.stopHolders.contains(text(own));
    for (const std::string& console : view.consoles) {
        if (console != own && std::ranges::find(view.viewers, console) == view.viewers.end())
            state.others << text(console);
    }
    state.viewers = texts(view.viewers);
    for (const auto& [console, person] : view.persons)
        state.persons.insert(text(console), text(person));
    if (view.loop_s)
        state.loop_s = rounded(*view.loop_s);
    if (view.loops) {
        state.medianLoop_s = rounded(view.loops->median_s);
        state.slowLoop_s = rounded(view.loops->slow_s);
    }
    if (view.shownOffset_ns)
        state.clockOffset_s = std::round(static_cast<double>(*view.shownOffset_ns) * 1e-6) * 1e-3;
    if (view.clock)
        state.clockBound_s = std::round(static_cast<double>(view.clock->bound_ns) * 1e-5) * 1e-4;
    state.statesLost = view.statesLost;
    state.refused = view.refused;
    state.lastRefusal = lastRefusalOf(site, view);
    for (std::size_t why = 1; why < view.refusedBy.size(); ++why) {
        if (view.refusedBy[why] > 0)
            state.refusedBy.emplace_back(SiteViews::refusalText(static_cast<CommandRefusal>(why)),
                                         view.refusedBy[why]);
    }
    return state;
}

} // namespace

SiteViews::SiteViews(chrome::MessageBar& messages, QWidget* parent)
    : QObject(parent)
    , m_messages(messages)
    , m_bar(new site_view::SiteBar(parent)) {
    using site_view::SiteBar;
    m_bar->hide();
    connect(m_bar, &SiteBar::controlRequested, this, &SiteViews::request);
    connect(m_bar, &SiteBar::releaseRequested, this, &SiteViews::release);
    connect(m_bar, &SiteBar::takeOverRequested, this, &SiteViews::takeOver);
    connect(m_bar, &SiteBar::accepted, this, [this] { ask(RequestKind::accept); });
    connect(m_bar, &SiteBar::declined, this,
            [this](const QString& reason) { ask(RequestKind::decline, reason); });
    connect(m_bar, &SiteBar::faultCleared, this, [this] { ask(RequestKind::clearFault); });
    connect(m_bar, &SiteBar::handOverRequested, this, &SiteViews::handOver);
    connect(m_bar, &SiteBar::stopWithdrawn, this,
            [this](const QString& holder) { ask(RequestKind::withdrawStop, holder); });
}

bool SiteViews::mayRequest() const {
    const SiteBarState& state = m_bar->state();
    return !m_site.expired() && state.reached && !state.viewer && state.controller.isEmpty();
}

bool SiteViews::mayTakeOver() const {
    const SiteBarState& state = m_bar->state();
    return !m_site.expired() && state.reached && !state.viewer && !state.controller.isEmpty() &&
           !state.controls && state.mode != SiteBarState::Mode::offered;
}

SiteViews::Successors SiteViews::successors() const {
    const SiteBarState& state = m_bar->state();
    Successors found;
    if (m_site.expired() || !controls() || state.mode == SiteBarState::Mode::offered)
        return found;
    for (const QString& console : state.others)
        found.emplace_back(console, state.persons.value(console));
    return found;
}

void SiteViews::setSite(const std::shared_ptr<site_link::SiteClient>& site) {
    if (site && site == m_site.lock())
        return;
    m_site = site;
    m_bar->setVisible(site != nullptr);
    m_bar->setState({});
    if (!site) {
        tellPossibilities();
        return;
    }
    const site_link::SiteView view = site->view();
    m_answered = view.request ? view.request->id : 0;
    m_boots = view.boots;
    m_losses.clear();
    showState(*site, view);
    tellKeys(site->keyWarnings());
    m_nextKeys_ns = core::steadyNow_ns() + m_keyPeriod.count();
}

void SiteViews::setKeyPeriod(std::chrono::nanoseconds period) {
    m_keyPeriod = period;
    m_nextKeys_ns = core::steadyNow_ns() + period.count();
}

/// Each is told once, whatever is shown meanwhile.
void SiteViews::tellKeys(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        if (m_keyWarnings.insert(warning).second)
            m_messages.post({Message::Severity::warning, text(warning), tr("Ask for new keys in time."), {}});
    }
}

/// A console may run for weeks, in which its keys come to their end.
void SiteViews::lookAtKeys(const site_link::SiteClient& site) {
    const std::int64_t now_ns = core::steadyNow_ns();
    if (now_ns < m_nextKeys_ns)
        return;
    m_nextKeys_ns = now_ns + m_keyPeriod.count();
    base::runInBackground(
        this, [meeting = site.file().meeting] { return meeting.keyWarnings(); },
        [this](const std::vector<std::string>& warnings) { tellKeys(warnings); });
}

std::optional<site::ClockOffset> SiteViews::clock() const {
    const auto site = m_site.lock();
    return site ? site->view().clock : std::nullopt;
}

void SiteViews::tick() {
    const auto site = m_site.lock();
    if (!site)
        return;
    const site_link::SiteView view = site->view();
    const SiteBarState before = m_bar->state();
    showState(*site, view);
    const SiteBarState now = m_bar->state();
    tellChanges(before, now);
    tellAnswer(view);
    tellEvents(*site);
    lookAtKeys(*site);
    if (std::exchange(m_boots, view.boots) != view.boots)
        m_messages.post({Message::Severity::warning,
                         tr("%1 was started anew.").arg(now.site),
                         tr("Request control again."),
                         {}});
}

void SiteViews::showState(const site_link::SiteClient& site, const site_link::SiteView& view) {
    SiteBarState state = stateOf(site, view);
    state.losses = m_losses;
    m_bar->setState(state);
    tellPossibilities();
}

void SiteViews::tellPossibilities() {
    std::tuple now(mayRequest(), mayTakeOver(), controls(), successors());
    if (std::exchange(m_possible, now) != now)
        emit possibilitiesChanged();
}

void SiteViews::tellEvents(site_link::SiteClient& site) {
    for (const site_link::RemoteEvent& event : site.takeEvents()) {
        const QString sentence = siteEventText(text(site.file().name), event);
        if (isNotice(event))
            m_messages.post({event.severity > 1 ? Message::Severity::error : Message::Severity::warning,
                             sentence,
                             {},
                             {}});
        else
            qInfo().noquote() << sentence;
        emit happened(site.readTime_ns(event.site_ns, core::steadyNow_ns()), sentence);
    }
}

void SiteViews::ask(RequestKind kind, const QString& target) {
    if (const auto site = m_site.lock())
        site->request(kind, target.toStdString());
}

void SiteViews::tellChanges(const SiteBarState& before, const SiteBarState& now) {
    if (before.site != now.site)
        return;
    if (now.controls && !before.controls && now.reached && !before.controller.isEmpty())
        m_messages.post({Message::Severity::information,
                         tr("Control was handed to you by %1.").arg(before.who(before.controller)),
                         tr("Let go of the switch and press it again."),
                         {}});
    if (before.controls && !now.controls && now.reached)
        m_messages.post({Message::Severity::warning,
                         now.controller.isEmpty()
                             ? tr("You no longer control %1.").arg(now.site)
                             : tr("%1 controls %2 now.").arg(now.who(now.controller), now.site),
                         {},
                         {}});
    QStringList others = now.stopHolders;
    for (const QString& holder : before.stopHolders)
        others.removeAll(holder);
    if (!others.isEmpty() && !now.stopsItself)
        m_messages.post({Message::Severity::warning,
                         tr("STOP is held by %1.").arg(others.join(QStringLiteral(", "))),
                         tr("It can be withdrawn there, or by a supervisor."),
                         {}});
    if (before.reached && !now.reached)
        m_messages.post({Message::Severity::error,
                         tr("%1 does not answer; its arms are held.").arg(now.site),
                         tr("The site holds its arms by itself when no command comes."),
                         {}});
}

void SiteViews::tellAnswer(const site_link::SiteView& view) {
    if (!view.request || view.request->id == m_answered || view.request->answer == RequestAnswer::waits)
        return;
    m_answered = view.request->id;
    const auto site = m_site.lock();
    const QString why = answerText(*view.request, site ? text(site->file().console) : QString());
    if (!why.isEmpty())
        m_messages.post({Message::Severity::warning, why, {}, {}});
}

QString SiteViews::answerText(const site_link::RequestOutcome& outcome, const QString& console) {
    const bool isOfAnother = outcome.kind == RequestKind::offer || outcome.kind == RequestKind::withdrawStop;
    switch (outcome.answer) {
    case RequestAnswer::waits:
    case RequestAnswer::done:
        break;
    case RequestAnswer::busy:
        return tr("Refused: another console is in control, or the cause is still there.");
    case RequestAnswer::notPermitted:
        return tr("Refused: this console may not do that.");
    case RequestAnswer::noSuchConsole:
        return isOfAnother ? tr("Refused: there is no such console.")
                           : tr("Refused: another program named %1 is connected.").arg(console);
    case RequestAnswer::notController:
        return tr("Refused: this console is not in control.");
    case RequestAnswer::stopped:
        return tr("Refused: STOP is engaged.");
    case RequestAnswer::expired:
        if (outcome.declined)
            return outcome.declined->empty() ? tr("It was declined.")
                                             : tr("It was declined: %1").arg(text(*outcome.declined));
        return tr("Nobody answered in time.");
    }
    return {};
}

QString SiteViews::refusalText(CommandRefusal why) {
    switch (why) {
    case CommandRefusal::none:
        break;
    case CommandRefusal::notController:
        return tr("not in control");
    case CommandRefusal::oldEpoch:
        return tr("control has changed since");
    case CommandRefusal::stopped:
        return tr("STOP is engaged");
    case CommandRefusal::pressAnew:
        return tr("the switch must be let go and pressed again");
    case CommandRefusal::oldNumber:
        return tr("it was overtaken");
    case CommandRefusal::oldLoop:
        return tr("the loop takes too long");
    case CommandRefusal::unknownArm:
        return tr("the arm is not known");
    case CommandRefusal::notFinite:
        return tr("it was no number");
    case CommandRefusal::notLive:
        return tr("the arm is not live");
    case CommandRefusal::otherBoot:
        return tr("another program has this console's name");
    }
    return {};
}

} // namespace teleta::console
