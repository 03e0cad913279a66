// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/touch_model.h"

#include "widgets/base/icons.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/touch/safety_sign.h"
#include "widgets/touch/touch_texts.h"

#include <QGuiApplication>
#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <QStringList>

#include <algorithm>
#include <array>

namespace teleta::touch {

using pipeline::TouchRecord;

namespace {

constexpr double kPerMilli = 1e3;
constexpr char16_t kHidden = 0x2013; ///< in the place of a component that the torques do not show

QString dash() {
    return QString(QChar(0x2014));
}

/// Three digits without the filling that keeps changing numbers in place: a row never changes.
QString plain(double value) {
    return base::threeDigits(value).remove(QChar(0x2007));
}

QString triple(const std::array<QString, 3>& numbers, const QString& unit) {
    return base::withUnit(QStringLiteral("%1,\u2002%2,\u2002%3").arg(numbers[0], numbers[1], numbers[2]),
                          unit);
}

QString pointText(const TouchRecord& record) {
    if (!record.located)
        return dash();
    std::array<QString, 3> numbers;
    for (int i = 0; i < 3; ++i)
        numbers[static_cast<std::size_t>(i)] =
            base::wholeNumber(record.p_Base_Contact_m[i] * kPerMilli).remove(QChar(0x2007));
    return triple(numbers, QStringLiteral("mm"));
}

QString forceText(const TouchRecord& record) {
    if (!record.force || std::ranges::none_of(record.force->observable, [](bool seen) { return seen; }))
        return dash();
    std::array<QString, 3> numbers;
    for (std::size_t i = 0; i < 3; ++i)
        numbers[i] = record.force->observable[i] ? plain(record.force->force_N[static_cast<int>(i)])
                                                 : QString(QChar(kHidden));
    return triple(numbers, QStringLiteral("N"));
}

QString forceTip(const TouchRecord& record) {
    if (!record.force)
        return TouchModel::tr("No force: the skin did not feel where the contact is.");
    const arm::ContactForce& force = *record.force;
    constexpr std::array<char16_t, 3> kAxes{u'x', u'y', u'z'};
    QStringList lines;
    for (std::size_t i = 0; i < 3; ++i) {
        const QChar axis(kAxes[i]);
        const auto at = static_cast<int>(i);
        lines << (force.observable[i]
                      ? TouchModel::tr("%1: %2 ± %3 N")
                            .arg(axis, plain(force.force_N[at]), plain(force.forceSd_N[at]))
                      : TouchModel::tr("%1: not observable in this configuration of the arm").arg(axis));
    }
    lines << TouchModel::tr("condition number %1, unexplained torque %2 Nm")
                 .arg(plain(force.conditionNumber), QLocale().toString(force.residual_Nm, 'g', 3));
    return lines.join(u'\n');
}

QString stiffnessText(const TouchRecord& record) {
    if (!record.stiffness)
        return record.refusal ? TouchModel::tr("none") : dash();
    const stiffness::Stiffness& object = record.stiffness->object;
    const QString interval = TouchTexts::interval(object);
    const QString estimate = TouchTexts::estimate(object);
    return interval.isEmpty() ? estimate : TouchModel::tr("%1 (%2)").arg(estimate, interval);
}

QString stiffnessTip(const TouchRecord& record) {
    if (record.stiffness)
        return QStringList{TouchModel::tr("95 % interval in brackets; %1, %n sample(s)", nullptr,
                                          static_cast<int>(record.stiffness->samples))
                               .arg(TouchTexts::method(record.stiffness->method)),
                           TouchTexts::warnings(*record.stiffness)}
            .join(u'\n')
            .trimmed();
    if (record.refusal)
        return TouchTexts::refusal(*record.refusal);
    return TouchModel::tr("No stiffness: the skin did not feel where the contact is.");
}

bool hasMaterial(const TouchRecord& record) {
    return record.stiffness && record.stiffness->materialKnown();
}

QString materialText(const TouchRecord& record) {
    if (!record.stiffness)
        return dash();
    if (!record.stiffness->materialKnown())
        return TouchModel::tr("cannot tell");
    const stiffness::Material material = record.stiffness->material;
    const QString name = TouchTexts::material(material);
    const QString safety = TouchTexts::safety(stiffness::isSafe(material));
    return record.stiffness->materialCertain ? TouchModel::tr("%1, %2").arg(name, safety)
                                             : TouchModel::tr("%1 (not certain), %2").arg(name, safety);
}

QString displayText(const TouchRecord& record, int column) {
    switch (column) {
    case TouchModel::number:
        return QString::number(record.number);
    case TouchModel::time:
        return base::withUnit(QLocale().toString(record.start_s, 'f', 3), QStringLiteral("s"));
    case TouchModel::point:
        return pointText(record);
    case TouchModel::distance:
        return record.located
                   ? base::withUnit(plain(record.contactDistance_m * kPerMilli), QStringLiteral("mm"))
                   : dash();
    case TouchModel::force:
        return forceText(record);
    case TouchModel::stiffness:
        return stiffnessText(record);
    case TouchModel::material:
        return materialText(record);
    case TouchModel::level:
        return hasMaterial(record) ? QString::number(stiffness::level(record.stiffness->material)) : dash();
    case TouchModel::condition:
        return record.force ? plain(record.force->conditionNumber) : dash();
    default:
        return {};
    }
}

QString toolTip(const TouchRecord& record, int column) {
    switch (column) {
    case TouchModel::time:
        return TouchModel::tr("First torque above the noise at %1 s, estimated %2 ms later; evaluated: %3")
            .arg(QLocale().toString(record.start_s, 'f', 3),
                 plain(static_cast<double>(record.ready_ns - record.start_ns) * 1e-6),
                 TouchTexts::joint(record.joint, record.joints));
    case TouchModel::point:
    case TouchModel::distance:
        return record.located
                   ? TouchModel::tr("x, y, z in the frame of the arm's base; the distance is from the "
                                    "joint that presses: along the forearm from the elbow")
                   : TouchModel::tr("The skin did not feel this contact.");
    case TouchModel::force:
    case TouchModel::condition:
        return forceTip(record);
    case TouchModel::stiffness:
    case TouchModel::material:
    case TouchModel::level:
        return stiffnessTip(record);
    default:
        return {};
    }
}

/// What a cell is sorted by; empty when there is no value.
QVariant sortValue(const TouchRecord& record, int column) {
    switch (column) {
    case TouchModel::number:
        return QVariant::fromValue<qulonglong>(record.number);
    case TouchModel::time:
        return record.start_s;
    case TouchModel::point:
        return record.located ? QVariant(record.p_Base_Contact_m.x()) : QVariant();
    case TouchModel::distance:
        return record.located ? QVariant(record.contactDistance_m) : QVariant();
    case TouchModel::force:
        return record.force ? QVariant(record.force->force_N.norm()) : QVariant();
    case TouchModel::stiffness:
        if (!record.stiffness)
            return {};
        return record.stiffness->object.value_NPerM.value_or(
            record.stiffness->object.lower95_NPerM.value_or(0.0));
    case TouchModel::material:
    case TouchModel::level:
        return hasMaterial(record) ? QVariant(stiffness::level(record.stiffness->material)) : QVariant();
    case TouchModel::condition:
        return record.force ? QVariant(record.force->conditionNumber) : QVariant();
    default:
        return {};
    }
}

bool isLeftAligned(int column) {
    return column == TouchModel::stiffness || column == TouchModel::material;
}

QIcon safetyIcon(bool safe) {
    constexpr int kSide_px = 48; // scaled down by the view
    const QPalette palette = QGuiApplication::palette();
    QIcon icon;
    const auto add = [&](QIcon::Mode mode, const QColor& colour) {
        QPixmap picture(kSide_px, kSide_px);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paintSafetyShape(painter, QRectF(picture.rect()), safe, colour);
        painter.end();
        icon.addPixmap(picture, mode);
    };
    add(QIcon::Normal, safetyColour(safe, palette));
    add(QIcon::Selected, palette.color(QPalette::HighlightedText));
    return icon;
}

QStringList fieldsOf(const TouchRecord& record) {
    const auto located = [&record](double value) {
        return TouchTexts::fileNumber(record.located ? std::optional(value) : std::nullopt);
    };
    QStringList fields{QString::number(record.number),
                       TouchTexts::fileNumber(record.start_s),
                       TouchTexts::fileNumber(record.ready_s),
                       QString::number(record.joint + 1),
                       TouchTexts::fileNumber(record.torque_Nm),
                       located(record.contactDistance_m),
                       located(record.side_rad)};
    for (int i = 0; i < 3; ++i)
        fields << located(record.p_Base_Contact_m[i]);
    for (int i = 0; i < 3; ++i)
        fields << TouchTexts::fileNumber(record.force && record.force->observable[static_cast<std::size_t>(i)]
                                             ? std::optional(record.force->force_N[i])
                                             : std::nullopt);
    fields << TouchTexts::fileNumber(record.force ? std::optional(record.force->conditionNumber)
                                                  : std::nullopt);
    if (record.stiffness) {
        const stiffness::TouchStiffness& s = *record.stiffness;
        fields << TouchTexts::fileNumber(s.object.value_NPerM)
               << TouchTexts::fileNumber(s.object.lower95_NPerM)
               << TouchTexts::fileNumber(s.object.upper95_NPerM) << TouchTexts::fileMaterial(s)
               << TouchTexts::fileSafety(s) << TouchTexts::fileLevel(s);
    } else {
        for (int i = 0; i < 6; ++i)
            fields << QStringLiteral("NA");
    }
    fields << (record.refusal ? QString::fromLatin1(stiffness::toString(*record.refusal))
                              : QStringLiteral("NA"))
           << (record.stiffness ? TouchTexts::fileWarnings(*record.stiffness) : QStringLiteral("NA"));
    return fields;
}

} // namespace

TouchModel::TouchModel(std::size_t capacity, QObject* parent)
    : TitledModel(kColumns, parent)
    , m_capacity(std::max<std::size_t>(1, capacity)) {
}

std::optional<int> TouchModel::rowOf(std::uint64_t touch) const {
    const auto found =
        std::ranges::find_if(m_records, [touch](const TouchRecord& r) { return r.number == touch; });
    if (found == m_records.end())
        return std::nullopt;
    return static_cast<int>(found - m_records.begin());
}

void TouchModel::put(const TouchRecord& record) {
    if (const auto row = rowOf(record.number)) {
        m_records[static_cast<std::size_t>(*row)] = record;
        emit dataChanged(index(*row, 0), index(*row, kColumns - 1));
        return;
    }
    putFirst(m_records, record, m_capacity);
}

void TouchModel::clear() {
    beginResetModel();
    m_records.clear();
    endResetModel();
}

QVariant TouchModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const TouchRecord& touch = record(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return displayText(touch, index.column());
    case kSortRole:
        return sortValue(touch, index.column());
    case Qt::ToolTipRole:
        return toolTip(touch, index.column());
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (isLeftAligned(index.column()) ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::DecorationRole:
        if (index.column() == material && hasMaterial(touch))
            return safetyIcon(stiffness::isSafe(touch.stiffness->material));
        if (index.column() == TouchModel::stiffness && touch.stiffness && !touch.stiffness->warnings.empty())
            return base::themeIcon(base::Icon::warning);
        return {};
    case Qt::AccessibleDescriptionRole:
        if (index.column() == TouchModel::stiffness && touch.stiffness)
            return TouchTexts::warnings(*touch.stiffness);
        return {};
    default:
        return {};
    }
}

QVariant TouchModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isLeftAligned(section) ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::ToolTipRole) {
        if (section == force)
            return tr("Force at the contact; a dash marks what the arm cannot observe in this pose");
        if (section == condition)
            return tr("Condition number of the force: longest over shortest lever; large is bad");
        if (section == distance)
            return tr(
                "Distance of the contact from the joint that presses: along the forearm from the elbow");
        return {};
    }
    return TitledModel::headerData(section, orientation, role);
}

QStringList TouchModel::titles() const {
    return {tr("No."),       tr("Time"),     tr("Contact x, y, z"), tr("Along link"), tr("Force x, y, z"),
            tr("Stiffness"), tr("Material"), tr("Level"),           tr("Condition")};
}

QString touchesText(const std::vector<TouchRecord>& records, QChar separator) {
    QString text =
        QStringLiteral("touch,start_s,ready_s,joint,torque_nm,contact_distance_m,side_rad,x_m,y_m,z_m,"
                       "force_x_n,force_y_n,force_z_n,condition_number,object_stiffness_n_per_m,"
                       "object_stiffness_lower_95,object_stiffness_upper_95,material,safe,level,"
                       "refusal,warnings\n");
    text.replace(u',', separator);
    for (const TouchRecord& record : records)
        text += fieldsOf(record).join(separator) + u'\n';
    return text;
}

} // namespace teleta::touch
