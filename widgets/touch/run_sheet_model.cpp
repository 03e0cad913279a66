// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/run_sheet_model.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/undo_step.h"
#include "widgets/touch/touch_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::touch {

using pipeline::FoundObject;

namespace {

constexpr int kPlainDigits = 9;
constexpr int kLongestName = 200;
constexpr int kUndoDepth = 200;

QString plain(std::optional<double> value) {
    return value && std::isfinite(*value) ? QString::number(*value, 'g', kPlainDigits) : QStringLiteral("NA");
}

/// One field of a CSV file (RFC 4180).
QString quoted(const QString& text) {
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r'))
        return text;
    return u'"' + QString(text).replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString sourceName(base::Provenance provenance) {
    switch (provenance) {
    case base::Provenance::live:
    case base::Provenance::unguarded:
        break;
    case base::Provenance::recorded:
        return QStringLiteral("recorded");
    case base::Provenance::recordedSimulation:
        return QStringLiteral("recorded_simulation");
    case base::Provenance::simulated:
        return QStringLiteral("simulated");
    }
    return QStringLiteral("live");
}

/// Titles stand over their cells: words at the left, numbers at the right.
int alignmentOf(int column) {
    switch (column) {
    case RunSheetModel::number:
    case RunSheetModel::time:
    case RunSheetModel::place:
    case RunSheetModel::touches:
    case RunSheetModel::force:
        return int(Qt::AlignVCenter | Qt::AlignRight);
    default:
        return int(Qt::AlignVCenter | Qt::AlignLeft);
    }
}

QString noValue() {
    return QChar(0x2014);
}

struct ContactText {
    Q_DECLARE_TR_FUNCTIONS(RunSheet)

public:
    static QString of(contact::ContactType type) {
        if (type == contact::ContactType::none)
            return noValue();
        return type == contact::ContactType::edge ? tr("edge") : tr("point");
    }
};

} // namespace

RunSheetModel::Notes::Notes()
    : undo(std::make_unique<QUndoStack>()) {
    undo->setUndoLimit(kUndoDepth);
}

void RunSheetModel::setObjects(const std::vector<FoundObject>& objects) {
    const bool isSameRun = objects.size() >= m_notes.objects;
    if (!isSameRun)
        clear();
    const bool grows = objects.size() > m_objects.size();
    m_objects = objects;
    m_notes.objects = objects.size();
    if (grows)
        showKept();
    if (m_kept.empty())
        return;
    // Not the names: the editor of a name would lose what was typed so far.
    emit dataChanged(index(0, number), index(rowCount() - 1, number));
    tellChanged(time);
}

RunSheetModel::Notes RunSheetModel::takeNotes() {
    Notes notes = std::exchange(m_notes, Notes());
    m_objects.clear();
    showKept();
    return notes;
}

void RunSheetModel::setNotes(Notes notes) {
    m_objects.clear();
    m_notes = std::move(notes);
    showKept();
}

void RunSheetModel::showKept() {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        if (!m_notes.removed.contains(m_objects[i].number))
            kept.push_back(i);
    // New ones come at the end: selection and an open editor stay.
    const bool appends =
        kept.size() > m_kept.size() && std::equal(m_kept.begin(), m_kept.end(), kept.begin());
    if (kept == m_kept)
        return;
    if (appends) {
        beginInsertRows({}, static_cast<int>(m_kept.size()), static_cast<int>(kept.size()) - 1);
        m_kept = std::move(kept);
        endInsertRows();
        return;
    }
    beginResetModel();
    m_kept = std::move(kept);
    endResetModel();
}

void RunSheetModel::rename(std::uint64_t object, const QString& text) {
    const QString taken = text.simplified().left(kLongestName);
    const QString before = nameOf(object);
    if (taken != before)
        m_notes.undo->push(new base::UndoStep(
            tr("Rename object %1").arg(object), [=, this] { applyName(object, taken); },
            [=, this] { applyName(object, before); }));
}

void RunSheetModel::remove(const std::vector<std::uint64_t>& objects) {
    if (!objects.empty())
        m_notes.undo->push(new base::UndoStep(
            tr("Delete from the run sheet"), [=, this] { applyRemoved(objects, true); },
            [=, this] { applyRemoved(objects, false); }));
}

void RunSheetModel::applyName(std::uint64_t object, const QString& text) {
    m_notes.names[object] = text;
    for (int row = 0; row < rowCount(); ++row)
        if (this->object(row).number == object)
            emit dataChanged(index(row, Column::name), index(row, Column::name));
}

void RunSheetModel::applyRemoved(const std::vector<std::uint64_t>& objects, bool removed) {
    for (const std::uint64_t object : objects) {
        if (removed)
            m_notes.removed.insert(object);
        else
            m_notes.removed.erase(object);
    }
    showKept();
}

const FoundObject& RunSheetModel::object(int row) const {
    return m_objects[m_kept[static_cast<std::size_t>(row)]];
}

QString RunSheetModel::nameOf(std::uint64_t object) const {
    const auto found = m_notes.names.find(object);
    return found == m_notes.names.end() ? QString() : found->second;
}

QVariant RunSheetModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(index.column());
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    const FoundObject& object = this->object(index.row());
    const QLocale locale;
    switch (index.column()) {
    case number:
        return QString::number(object.number);
    case name:
        return nameOf(object.number);
    case time:
        return base::withUnit(locale.toString(object.first_s, 'f', 3), QStringLiteral("s"));
    case place: {
        const auto millimetres = [](double value_m) { return base::fixedDigits(1e3 * value_m, 0); };
        return base::withUnit(QStringLiteral("%1, %2").arg(millimetres(object.p_Base_Centre_m.x()),
                                                           millimetres(object.p_Base_Centre_m.y())),
                              QStringLiteral("mm"));
    }
    case touches:
        return locale.toString(static_cast<qulonglong>(object.touches));
    case contact:
        return ContactText::of(object.contact);
    case force:
        return base::withUnit(base::threeDigits(object.highestForce_N), QStringLiteral("N"))
            .remove(QChar(0x2007));
    case stiffness: {
        if (!object.stiffness)
            return noValue();
        const QString interval = TouchTexts::interval(*object.stiffness);
        return interval.isEmpty()
                   ? TouchTexts::estimate(*object.stiffness)
                   : QStringLiteral("%1 (%2)").arg(TouchTexts::estimate(*object.stiffness), interval);
    }
    case material:
        return object.material ? QStringLiteral("%1, %2").arg(
                                     TouchTexts::material(*object.material),
                                     TouchTexts::safety(teleta::stiffness::isSafe(*object.material)))
                               : noValue();
    case shape:
        return object.recognition ? TouchTexts::recognition(*object.recognition) : noValue();
    default:
        return {};
    }
}

QStringList RunSheetModel::titles() const {
    return {tr("No."),
            tr("Name"),
            tr("Found at"),
            tr("Place x, y"),
            tr("Touches"),
            tr("Contact"),
            tr("Force when evaluated"),
            tr("Stiffness"),
            tr("Material"),
            tr("Shape")};
}

QVariant RunSheetModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole)
        return alignmentOf(section);
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == time)
        return tr("When its first touch began, as in Touches");
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == force)
        return tr("The highest force of all its touches, from the torques of the joints");
    return TitledModel::headerData(section, orientation, role);
}

Qt::ItemFlags RunSheetModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == name ? flags | Qt::ItemIsEditable : flags;
}

bool RunSheetModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || index.column() != name)
        return false;
    rename(object(index.row()).number, value.toString());
    return true;
}

QString runSheetText(const RunSheetModel& model, base::Provenance provenance) {
    const QString source = sourceName(provenance);
    QString text = QStringLiteral("object,name,time_s,x_m,y_m,touches,contact_type,force_n,stiffness_n_per_m,"
                                  "stiffness_lower_95,stiffness_upper_95,material,shape,confidence,source\n");
    for (int row = 0; row < model.rowCount(); ++row) {
        const FoundObject& object = model.object(row);
        const stiffness::Stiffness known = object.stiffness.value_or(stiffness::Stiffness{});
        const auto& recognition = object.recognition;
        const QStringList fields{
            QString::number(object.number),
            quoted(model.nameOf(object.number)),
            plain(object.first_s),
            plain(object.p_Base_Centre_m.x()),
            plain(object.p_Base_Centre_m.y()),
            QString::number(object.touches),
            QLatin1String(contact::toString(object.contact)),
            plain(object.highestForce_N),
            plain(known.value_NPerM),
            plain(known.lower95_NPerM),
            plain(known.upper95_NPerM),
            QLatin1String(object.material ? stiffness::toString(*object.material) : "NA"),
            QLatin1String(recognition ? contour::toString(recognition->shape) : "NA"),
            plain(recognition ? std::optional(recognition->confidence) : std::nullopt),
            source};
        text += fields.join(u',') + u'\n';
    }
    return text;
}

} // namespace teleta::touch
