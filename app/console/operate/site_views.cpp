// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/site_views.h"

#include "backend/core/steady_time.h"

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

SiteBarState stateOf(const site_link::SiteClient& site, const site_link::SiteView& view,
                     const QString& lastRefusal) {
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
    if (view.loop_s)
        state.loop_s = std::round(1e4 * *view.loop_s) / 1e4;
    if (view.clock)
        state.clockBound_s = std::round(static_cast<double>(view.clock->bound_ns) * 1e-5) * 1e-4;
    state.statesLost = view.statesLost;
    state.refused = view.refused;
    state.lastRefusal = lastRefusal;
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
    connect(m_bar, &SiteBar::takeOverRequested, this, [this] { ask(RequestKind::takeOver); });
    connect(m_bar, &SiteBar::accepted, this, [this] { ask(RequestKind::accept); });
    connect(m_bar, &SiteBar::declined, this, [this] { ask(RequestKind::decline); });
    connect(m_bar, &SiteBar::faultCleared, this, [this] { ask(RequestKind::clearFault); });
    connect(m_bar, &SiteBar::handOverRequested, this,
            [this](const QString& console) { ask(RequestKind::offer, console); });
    connect(m_bar, &SiteBar::stopWithdrawn, this,
            [this](const QString& holder) { ask(RequestKind::withdrawStop, holder); });
}

bool SiteViews::mayRequest() const {
    const SiteBarState& state = m_bar->state();
    return !m_site.expired() && state.reached && !state.viewer && state.controller.isEmpty();
}

void SiteViews::setSite(const std::shared_ptr<site_link::SiteClient>& site) {
    if (site && site == m_site.lock())
        return;
    m_site = site;
    m_bar->setVisible(site != nullptr);
    m_bar->setState({});
    if (!site)
        return;
    const site_link::SiteView view = site->view();
    m_answered = view.request ? view.request->id : 0;
    m_boots = view.boots;
    m_bar->setState(stateOf(*site, view, refusalText(view.lastRefusal)));
    if (m_warned.lock() == site)
        return;
    m_warned = site;
    for (const std::string& warning : site->keyWarnings())
        m_messages.post({Message::Severity::warning, text(warning), tr("Ask for new keys in time."), {}});
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
    const SiteBarState now = stateOf(*site, view, refusalText(view.lastRefusal));
    m_bar->setState(now);
    tellChanges(before, now);
    tellAnswer(view);
    if (std::exchange(m_boots, view.boots) != view.boots)
        m_messages.post({Message::Severity::warning,
                         tr("%1 was started anew.").arg(now.site),
                         tr("Request control again."),
                         {}});
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
                         tr("Control was handed to you by %1.").arg(before.controller),
                         tr("Let go of the switch and press it again."),
                         {}});
    if (before.controls && !now.controls && now.reached)
        m_messages.post({Message::Severity::warning,
                         now.controller.isEmpty() ? tr("You no longer control %1.").arg(now.site)
                                                  : tr("%1 controls %2 now.").arg(now.controller, now.site),
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
    const QString why = answerText(view.request->answer);
    if (!why.isEmpty())
        m_messages.post({Message::Severity::warning, why, {}, {}});
}

QString SiteViews::answerText(RequestAnswer answer) {
    switch (answer) {
    case RequestAnswer::waits:
    case RequestAnswer::done:
        break;
    case RequestAnswer::busy:
        return tr("Refused: another console is in control, or the cause is still there.");
    case RequestAnswer::notPermitted:
        return tr("Refused: this console may not do that.");
    case RequestAnswer::noSuchConsole:
        return tr("Refused: there is no such console.");
    case RequestAnswer::notController:
        return tr("Refused: this console is not in control.");
    case RequestAnswer::stopped:
        return tr("Refused: STOP is engaged.");
    case RequestAnswer::expired:
        return tr("Nobody answered in time, or it was declined.");
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
