// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/site/site_bar.h"

#include "widgets/base/compose.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace teleta::site_view {

namespace {

using Mode = SiteBarState::Mode;

constexpr int kLeaseSteps = 100;
constexpr double kPerMs = 1e3;
/// Characters; the site drops what is too long for it.
constexpr int kLongestReason = 100;

QString millisecondsOf(double time_s) {
    return QString::number(time_s * kPerMs, 'f', time_s < 0.01 ? 1 : 0);
}

QToolButton* makeMenuButton(const char* name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setMenu(new QMenu(button));
    return button;
}

} // namespace

SiteBar::SiteBar(QWidget* parent)
    : QWidget(parent)
    , m_headline(new QLabel(this))
    , m_lease(new QProgressBar(this))
    , m_details(new QLabel(this))
    , m_request(makeButton("requestControl", &SiteBar::controlRequested))
    , m_accept(makeButton("accept", &SiteBar::accepted))
    , m_decline(makeButton("decline", &SiteBar::decline))
    , m_reason(new QLineEdit(this))
    , m_takeOver(makeButton("takeOver", &SiteBar::takeOverRequested))
    , m_clearFault(makeButton("clearFault", &SiteBar::faultCleared))
    , m_handOver(makeMenuButton("handOver", this))
    , m_withdraw(makeMenuButton("withdrawStop", this))
    , m_release(makeButton("releaseControl", &SiteBar::releaseRequested)) {
    m_headline->setObjectName(QStringLiteral("headline"));
    m_details->setObjectName(QStringLiteral("details"));
    m_reason->setObjectName(QStringLiteral("reason"));
    m_reason->setMaxLength(kLongestReason);
    connect(m_reason, &QLineEdit::returnPressed, this, &SiteBar::decline);
    // What other consoles call themselves is no markup.
    m_headline->setTextFormat(Qt::PlainText);
    m_details->setTextFormat(Qt::PlainText);
    m_lease->setRange(0, kLeaseSteps);
    m_lease->setTextVisible(false);
    QSizePolicy kept = m_details->sizePolicy();
    kept.setHorizontalPolicy(QSizePolicy::Ignored);
    m_details->setSizePolicy(kept);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this),
                               base::grid(this, 0.5));
    layout->setSpacing(base::grid(this));
    layout->addWidget(m_headline);
    layout->addWidget(m_lease);
    layout->addWidget(m_details, 1);
    base::addWidgets(layout, {m_request, m_accept, m_reason, m_decline, m_takeOver, m_clearFault, m_withdraw,
                              m_handOver, m_release});
    base::keepTranslated(this, &SiteBar::refresh);
    base::onChange(this, &SiteBar::restyle, {QEvent::PaletteChange, QEvent::FontChange});
    restyle();
}

QPushButton* SiteBar::makeButton(const char* name, void (SiteBar::*wanted)()) {
    auto* button = new QPushButton(this);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, wanted);
    return button;
}

void SiteBar::setState(const SiteBarState& state) {
    if (state == m_state)
        return;
    // A menu that is open is not filled anew under the pointer.
    const bool otherMenus = state.others != m_state.others || state.stopHolders != m_state.stopHolders ||
                            state.persons != m_state.persons;
    m_state = state;
    if (otherMenus)
        fillMenus();
    refresh();
}

QString SiteBar::headline() const {
    const QString& site = m_state.site;
    if (!m_state.reached)
        return tr("%1 does not answer (%2 s)").arg(site, QString::number(m_state.silent_s, 'f', 1));
    if (m_state.mode == Mode::stopped)
        return tr("%1: STOP is held by %2").arg(site, m_state.stopHolders.join(QStringLiteral(", ")));
    if (m_state.mode == Mode::offered && m_state.offeredHere)
        return tr("%1: %2 offers you control").arg(site, m_state.who(m_state.controller));
    if (m_state.mode == Mode::offered && m_state.controls)
        return tr("%1: handing control to %2").arg(site, m_state.who(m_state.offeredTo));
    if (m_state.mode == Mode::fault)
        return tr("%1: an arm has a fault").arg(site);
    if (m_state.controls)
        return m_state.mode == Mode::moving ? tr("%1: you are moving it").arg(site)
                                            : tr("%1: you control").arg(site);
    if (!m_state.controller.isEmpty())
        return tr("%1: %2 controls").arg(site, m_state.who(m_state.controller));
    return m_state.viewer ? tr("%1: viewing").arg(site) : tr("%1: nobody controls").arg(site);
}

QString SiteBar::details() const {
    QStringList parts;
    if (m_state.loop_s)
        parts << tr("loop %1 ms").arg(millisecondsOf(*m_state.loop_s));
    if (m_state.clockBound_s)
        parts << tr("clock \u00b1%1 ms").arg(millisecondsOf(*m_state.clockBound_s));
    if (m_state.refused > 0 && !m_state.lastRefusal.isEmpty())
        parts << tr("%1 refused: %2").arg(m_state.refused).arg(m_state.lastRefusal);
    return parts.join(QStringLiteral("  \u00b7  "));
}

QString SiteBar::withPerson(const QString& console) const {
    const QString person = m_state.persons.value(console);
    return person.isEmpty() ? console : tr("%1 (%2)", "a console and who sits there").arg(console, person);
}

/// What a look at the site needs seldom, a line each.
QStringList SiteBar::moreDetails() const {
    const auto joined = [this](const QStringList& consoles) {
        QStringList names;
        for (const QString& console : consoles)
            names << withPerson(console);
        return names.join(QStringLiteral(", "));
    };
    QStringList lines;
    if (!m_state.controller.isEmpty())
        lines << tr("In control: %1").arg(withPerson(m_state.controller));
    if (!m_state.viewers.isEmpty())
        lines << tr("Viewers: %1").arg(joined(m_state.viewers));
    if (m_state.medianLoop_s && m_state.slowLoop_s)
        lines << tr("Loop: median %1 ms, 99 %: %2 ms")
                     .arg(millisecondsOf(*m_state.medianLoop_s), millisecondsOf(*m_state.slowLoop_s));
    if (m_state.clockOffset_s && m_state.clockBound_s)
        lines << tr("Clock offset: %1 s \u00b1 %2 ms")
                     .arg(QString::number(*m_state.clockOffset_s, 'f', 3),
                          millisecondsOf(*m_state.clockBound_s));
    lines << tr("%n state(s) of the site were lost on the way", nullptr,
                static_cast<int>(std::min<std::uint64_t>(m_state.statesLost, 1'000'000)));
    for (const auto& [stream, lost] : m_state.losses)
        lines << tr("Lost on the way, %1: %2").arg(stream, QLocale().toString(qulonglong{lost}));
    for (const auto& [reason, count] : m_state.refusedBy)
        lines << tr("Refused: %1 (%2)", "a reason and how often")
                     .arg(reason, QLocale().toString(qulonglong{count}));
    return lines;
}

void SiteBar::decline() {
    emit declined(m_reason->text().trimmed());
    m_reason->clear();
}

void SiteBar::refresh() {
    m_headline->setText(headline());
    m_details->setText(details());
    // Names are no markup.
    QStringList lines;
    for (const QString& line : moreDetails())
        lines << line.toHtmlEscaped();
    const QString tip =
        QStringLiteral("<p style='white-space:pre'>%1</p>").arg(lines.join(QStringLiteral("<br>")));
    for (QLabel* label : {m_headline, m_details}) {
        label->setToolTip(tip);
        label->setAccessibleDescription(moreDetails().join(QStringLiteral("; ")));
    }
    m_lease->setVisible(m_state.reached && m_state.controls);
    m_lease->setValue(static_cast<int>(std::lround(std::clamp(m_state.leaseShare, 0.0, 1.0) * kLeaseSteps)));
    m_lease->setToolTip(tr("Control lease: how long control stays here without an answer"));

    const bool reached = m_state.reached;
    const bool offered = reached && m_state.mode == Mode::offered;
    const bool answers = offered && (m_state.offeredHere || m_state.controls);
    m_request->setText(tr("Request control"));
    m_request->setVisible(reached && !m_state.viewer && m_state.controller.isEmpty() &&
                          m_state.mode != Mode::stopped);
    // Of a take-over, who loses control agrees; of a hand-over, who gets it.
    m_accept->setText(m_state.offeredHere ? tr("Accept control") : tr("Agree"));
    m_accept->setVisible(answers);
    m_decline->setText(m_state.offeredHere ? tr("Decline") : tr("Keep control"));
    m_decline->setVisible(answers);
    m_reason->setVisible(answers);
    m_reason->setPlaceholderText(tr("Reason (if you decline)"));
    m_reason->setAccessibleName(tr("Reason for declining"));
    m_reason->setToolTip(tr("The other console shows it"));
    if (!answers)
        m_reason->clear();
    m_takeOver->setText(tr("Take over\u2026"));
    m_takeOver->setToolTip(tr("For supervisors: the other console has 5 s to decline"));
    m_takeOver->setVisible(reached && !m_state.viewer && !m_state.controller.isEmpty() && !m_state.controls &&
                           !offered);
    m_clearFault->setText(tr("Clear the fault"));
    m_clearFault->setVisible(reached && m_state.controls && m_state.mode == Mode::fault);
    m_handOver->setText(tr("Hand over"));
    m_handOver->setVisible(reached && m_state.controls && !offered && !m_state.others.isEmpty());
    m_withdraw->setText(tr("Withdraw STOP"));
    m_withdraw->setToolTip(tr("For supervisors, once the console that engaged STOP is gone"));
    m_withdraw->setVisible(reached && !m_state.viewer && m_state.mode == Mode::stopped &&
                           !m_withdraw->menu()->isEmpty());
    m_release->setText(tr("Release control"));
    m_release->setVisible(reached && m_state.controls && !offered);
    restyle();
}

void SiteBar::fillMenus() {
    m_handOver->menu()->clear();
    for (const QString& console : m_state.others)
        m_handOver->menu()->addAction(base::withoutMnemonic(withPerson(console)), this,
                                      [this, console] { emit handOverRequested(console); });
    m_withdraw->menu()->clear();
    for (const QString& holder : m_state.stopHolders)
        m_withdraw->menu()->addAction(base::withoutMnemonic(holder), this,
                                      [this, holder] { emit stopWithdrawn(holder); });
}

void SiteBar::restyle() {
    const base::StatusColours& colours = base::statusColours(palette());
    const bool bad = !m_state.reached || m_state.mode == Mode::stopped || m_state.mode == Mode::fault;
    base::setTextColour(m_headline, bad                ? colours.lost
                                    : m_state.controls ? colours.live
                                                       : palette().color(QPalette::WindowText));
    m_headline->setFont(base::bold(font()));
    base::setTextColour(m_details, colours.neutral);
    m_lease->setFixedSize(base::em(this, 4), base::em(this, 0.5));
}

} // namespace teleta::site_view
