// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/event_model.h"

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

using pipeline::CameraEvent;
using Kind = CameraEvent::Kind;

/// A cell with a number, whose unit is in the title; empty when it is not known.
QVariant quantity(bool known, const QString& number) {
    return known ? QVariant(number.trimmed()) : QVariant();
}

/// Names in files, by kind.
constexpr std::array kNames{"begin", "bump", "end", "follow", "reference", "restart"};

} // namespace

void EventModel::append(const CameraEvent& happened) {
    putFirst(m_events, happened, kCapacity);
}

std::deque<CameraEvent> EventModel::takeEvents() {
    beginResetModel();
    std::deque<CameraEvent> events = std::exchange(m_events, {});
    endResetModel();
    return events;
}

void EventModel::setEvents(std::deque<CameraEvent> events) {
    beginResetModel();
    m_events = std::move(events);
    endResetModel();
}

QString EventModel::csv() const {
    QString text = QStringLiteral("time_s,event,contact_id,x_m,y_m,z_m,depth_m\n");
    const auto put = [&](double value, bool known, QChar separator) {
        text += base::csvNumber(known ? std::optional(value) : std::nullopt) + separator;
    };
    for (auto happened = m_events.rbegin(); happened != m_events.rend(); ++happened) {
        put(happened->time_s, true, u',');
        text += QLatin1String(kNames[static_cast<std::size_t>(happened->kind)]) + QLatin1Char(',');
        text += (happened->contact > 0 ? QString::number(happened->contact) : QStringLiteral("NA")) +
                QLatin1Char(',');
        for (const double value : happened->p_Sensor_m)
            put(value, happened->located, u',');
        put(happened->depth_m, happened->contact > 0, u'\n');
    }
    return text;
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const CameraEvent& happened = m_events[static_cast<std::size_t>(index.row())];
    const bool bumps = happened.kind == Kind::bumps;
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(index.column());
    if (role == Qt::ForegroundRole && bumps)
        return base::statusColours(QGuiApplication::palette()).lost;
    if (role == Qt::FontRole && bumps)
        return base::bold(QFont());
    if (role != Qt::DisplayRole)
        return {};
    const Eigen::Vector3d& p = happened.p_Sensor_m;
    switch (index.column()) {
    case time:
        return base::fixedDigits(happened.time_s, 3);
    case event: {
        static constexpr std::array kTexts{QT_TR_NOOP("touched"),         QT_TR_NOOP("BUMP"),
                                           QT_TR_NOOP("released"),        QT_TR_NOOP("arm follows"),
                                           QT_TR_NOOP("reference taken"), QT_TR_NOOP("restarted")};
        return tr(kTexts[static_cast<std::size_t>(happened.kind)]);
    }
    case contact:
        return happened.contact > 0 ? QVariant(happened.contact) : QVariant();
    case along:
        return quantity(happened.located, base::threeDigits(1e3 * p.z()));
    case around:
        return quantity(happened.located, base::wholeNumber(std::atan2(p.y(), p.x()) * 180.0 / M_PI));
    case depth:
        return quantity(happened.contact > 0 && std::isfinite(happened.depth_m),
                        base::threeDigits(1e3 * happened.depth_m));
    default:
        return {};
    }
}

QStringList EventModel::titles() const {
    static_assert(event == kEventColumn);
    const QString mm = QStringLiteral("mm");
    return {base::titleOverUnit(tr("Time"), QStringLiteral("s")),
            tr("Event"),
            tr("Contact"),
            base::titleOverUnit(tr("Along", "the tube"), mm),
            base::titleOverUnit(tr("Around", "the tube"), QStringLiteral("\u00b0")),
            base::titleOverUnit(tr("Depth"), mm)};
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && (section == along || section == around))
        return section == along ? tr("Along the tube") : tr("Around the tube");
    return EventListModel::headerData(section, orientation, role);
}

} // namespace teleta::camera
