// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/gel/gel_event_model.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/theme.h"

#include <QFont>
#include <QGuiApplication>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace teleta::camera {

namespace {

using pipeline::GelEvent;
using GelEventKind = GelEvent::Kind;

/// A cell with a length in mm, as the title says; empty when it is not known.
QVariant lengthCell(const GelEvent& happened, double length_m) {
    return happened.contact > 0 && std::isfinite(length_m)
               ? QVariant(base::threeDigits(1e3 * length_m).trimmed())
               : QVariant();
}

/// Names in files, by kind.
constexpr std::array kGelNames{"begin",        "incipient_slip", "slip",     "end",  "reference", "restart",
                               "picture_dark", "light_jump",     "gel_torn", "bump", "follow"};

} // namespace

std::deque<GelEvent> GelEventModel::takeEvents() {
    beginResetModel();
    std::deque<GelEvent> events = std::exchange(m_events, {});
    endResetModel();
    return events;
}

void GelEventModel::setEvents(std::deque<GelEvent> events) {
    beginResetModel();
    m_events = std::move(events);
    endResetModel();
}

QString GelEventModel::csv() const {
    QString text = QStringLiteral("time_s,event,contact_id,x_m,y_m,shear_x_m,shear_y_m,slip_index\n");
    for (auto happened = m_events.rbegin(); happened != m_events.rend(); ++happened) {
        const bool isOfContact = happened->contact > 0;
        text += base::csvNumber(happened->time_s) + QLatin1Char(',');
        text += QLatin1String(kGelNames[static_cast<std::size_t>(happened->kind)]) + QLatin1Char(',');
        text += (isOfContact ? QString::number(happened->contact) : QStringLiteral("NA")) + QLatin1Char(',');
        for (const double value :
             {happened->centre_m.x(), happened->centre_m.y(), happened->shear_m.x(), happened->shear_m.y()})
            text += base::csvNumber(isOfContact ? std::optional(value) : std::nullopt) + QLatin1Char(',');
        text += base::csvNumber(happened->slipIndex) + QLatin1Char('\n');
    }
    return text;
}

QVariant GelEventModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const GelEvent& happened = m_events[static_cast<std::size_t>(index.row())];
    const bool slips = happened.kind == GelEventKind::slip || happened.kind == GelEventKind::bumps;
    const bool begins = happened.kind == GelEventKind::incipientSlip;
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(index.column());
    const base::StatusColours& colours = base::statusColours(QGuiApplication::palette());
    if (role == Qt::ForegroundRole && (slips || begins))
        return slips ? colours.lost : colours.stale;
    if (role == Qt::FontRole && slips)
        return base::bold(QFont());
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case time:
        return base::fixedDigits(happened.time_s, 3);
    case event: {
        static constexpr std::array kTexts{QT_TR_NOOP("touched"),
                                           QT_TR_NOOP("incipient slip"),
                                           QT_TR_NOOP("SLIP"),
                                           QT_TR_NOOP("released"),
                                           QT_TR_NOOP("rest taken"),
                                           QT_TR_NOOP("restarted"),
                                           QT_TR_NOOP("picture is dark"),
                                           QT_TR_NOOP("light jumped"),
                                           QT_TR_NOOP("gel torn?"),
                                           QT_TR_NOOP("BUMP"),
                                           QT_TR_NOOP("arm follows")};
        return tr(kTexts[static_cast<std::size_t>(happened.kind)]);
    }
    case contact:
        return happened.contact > 0 ? QVariant(happened.contact) : QVariant();
    case x:
        return lengthCell(happened, happened.centre_m.x());
    case y:
        return lengthCell(happened, happened.centre_m.y());
    case shear:
        return lengthCell(happened, happened.shear_m.norm());
    case slipIndex:
        return happened.slipIndex ? QVariant(base::fixedDigits(happened.slipIndex, 2)) : QVariant();
    default:
        return {};
    }
}

QStringList GelEventModel::titles() const {
    static_assert(event == kEventColumn);
    const QString mm = QStringLiteral("mm");
    return {base::titleOverUnit(tr("Time"), QStringLiteral("s")),
            tr("Event"),
            tr("Contact"),
            base::titleOverUnit(tr("x"), mm),
            base::titleOverUnit(tr("y"), mm),
            base::titleOverUnit(tr("Shear"), mm),
            tr("Slip index")};
}

} // namespace teleta::camera
