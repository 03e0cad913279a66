// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/frame_dialog.h"

#include "app/console/sources/frame_preview.h"
#include "backend/core/data/array_layout.h"
#include "backend/frames/frame_reader.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace teleta::console {

namespace {

constexpr std::array<const char*, 5> kTimeUnits{"s", "ms", "us", "ns", "iso"};

QDoubleSpinBox* makeNumber(double value, double highest, int decimals, const QString& suffix) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(decimals);
    box->setRange(0.0, highest);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(suffix);
    box->setValue(value);
    return box;
}

} // namespace

FrameDialog::FrameDialog(const frames::FrameRequest& request, const QString& why, QWidget* parent)
    : QDialog(parent)
    , m_request(request)
    , m_array(base::named<QComboBox>("array"))
    , m_layout(base::named<QLineEdit>("layout"))
    , m_axis(new QComboBox)
    , m_rows(base::named<QSpinBox>("rows"))
    , m_columns(base::named<QSpinBox>("columns"))
    , m_pitch_mm(makeNumber(1e3 * request.pitch_m.value_or(0.0), 10'000.0, 3, tr(" mm")))
    , m_taxelColumns(base::named<QLineEdit>("taxelColumns"))
    , m_timeColumn(new QLineEdit(QString::fromStdString(request.timeColumn)))
    , m_timeUnit(new QComboBox)
    , m_rate_Hz(makeNumber(request.rate_Hz.value_or(0.0), 100'000.0, 3, tr(" Hz")))
    , m_threshold(makeNumber(request.threshold.value_or(0.0), 1e9, 3, {}))
    , m_verdict(new QLabel)
    , m_preview(new FramePreview(why, this)) {
    setWindowTitle(tr("Open frames"));
    m_timeColumn->setObjectName(QStringLiteral("timeColumn"));
    m_rate_Hz->setObjectName(QStringLiteral("rate"));
    m_threshold->setObjectName(QStringLiteral("threshold"));
    m_threshold->setSpecialValueText(tr("0.2 N, or one count"));
    m_threshold->setToolTip(tr("Load from which a taxel is in contact, in the unit of the values"));
    m_array->setEditable(true);
    m_array->setInsertPolicy(QComboBox::NoInsert);
    m_array->setEditText(QString::fromStdString(request.array));
    m_array->lineEdit()->setPlaceholderText(tr("the only one, or the one named frames"));
    m_array->setMinimumWidth(base::em(this, 22));
    m_layout->setText(QString::fromStdString(request.knownPath));
    m_layout->setPlaceholderText(tr("only for taxels off a grid, or with three components"));
    m_layout->setToolTip(
        tr("The device file of the array, or a file with its table [layout]: it says where the "
           "taxels are. Rows, columns and pitch are not needed then."));
    m_axis->addItems({tr("as the file says"), tr("the first"), tr("the last")});
    m_axis->setCurrentIndex(static_cast<int>(request.axis));
    for (QSpinBox* box : {m_rows, m_columns}) {
        box->setRange(0, core::ArrayLayout::kMaximumSide);
        box->setSpecialValueText(tr("as the file says"));
    }
    m_rows->setValue(request.rows.value_or(0));
    m_columns->setValue(request.columns.value_or(0));
    m_rows->setAccessibleName(tr("Rows"));
    m_columns->setAccessibleName(tr("Columns"));
    for (QDoubleSpinBox* box : {m_pitch_mm, m_rate_Hz})
        box->setSpecialValueText(tr("as the file says"));
    m_taxelColumns->setText(QString::fromStdString(frames::textOf(request.taxelColumns)));
    m_taxelColumns->setPlaceholderText(QStringLiteral("2..85"));
    m_taxelColumns->setToolTip(tr("Columns of a table that are taxels, counted from 1"));
    m_timeColumn->setPlaceholderText(tr("name or number of the column"));
    m_timeUnit->addItem(tr("as the name of the column ends"));
    for (const char* unit : kTimeUnits)
        m_timeUnit->addItem(QLatin1String(unit));
    m_timeUnit->setCurrentIndex(std::max(0, m_timeUnit->findText(QString::fromStdString(request.timeUnit))));

    auto* reason = new QLabel(withoutOptions(why));
    reason->setObjectName(QStringLiteral("why"));
    reason->setWordWrap(true);
    reason->setVisible(!why.isEmpty());
    reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* sizeRow = new QHBoxLayout;
    sizeRow->addWidget(m_rows);
    sizeRow->addWidget(new QLabel(tr("rows \u00d7", "N rows x M columns")));
    sizeRow->addWidget(m_columns);
    sizeRow->addWidget(new QLabel(tr("columns")));
    sizeRow->addStretch(1);

    auto* form = new QFormLayout;
    auto* file = new QLabel(QFileInfo(QString::fromStdString(request.path)).fileName());
    file->setToolTip(QString::fromStdString(request.path));
    form->addRow(tr("File:"), file);
    form->addRow(tr("&Name of the frames:"), m_array);
    auto* choose = new QPushButton(tr("Choose\u2026"));
    choose->setAutoDefault(false);
    auto* layoutRow = new QHBoxLayout;
    layoutRow->addWidget(m_layout, 1);
    layoutRow->addWidget(choose);
    base::addFormRow(*form, tr("File of the &array:"), layoutRow, m_layout);
    form->addRow(tr("&Dimension that counts the frames:"), m_axis);
    base::addFormRow(*form, tr("&Shape:"), sizeRow, m_rows);
    form->addRow(tr("&Pitch:"), m_pitch_mm);
    form->addRow(tr("Co&lumns of the taxels:"), m_taxelColumns);
    form->addRow(tr("Column of the &times:"), m_timeColumn);
    form->addRow(tr("&Unit of the times:"), m_timeUnit);
    form->addRow(tr("&Rate, without times:"), m_rate_Hz);
    form->addRow(tr("In contact &from:"), m_threshold);
    form->addRow(QString(), m_verdict);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Open);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_array, &QComboBox::editTextChanged, this, &FrameDialog::check);
    connect(choose, &QPushButton::clicked, this, &FrameDialog::chooseLayout);
    for (QLineEdit* text : {m_layout, m_taxelColumns, m_timeColumn})
        connect(text, &QLineEdit::textChanged, this, &FrameDialog::check);
    for (QComboBox* box : {m_axis, m_timeUnit})
        connect(box, &QComboBox::currentIndexChanged, this, &FrameDialog::check);
    for (QSpinBox* box : {m_rows, m_columns})
        connect(box, &QSpinBox::valueChanged, this, &FrameDialog::check);
    connect(m_rate_Hz, &QDoubleSpinBox::valueChanged, this, &FrameDialog::check);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(reason);
    auto* both = new QHBoxLayout;
    both->addLayout(form);
    both->addSpacing(base::grid(this, 2));
    both->addWidget(m_preview, 1);
    layout->addLayout(both, 1);
    layout->addWidget(buttons);
    check();
    base::runInBackground(
        this, [path = request.path] { return frames::arraysIn(path); },
        [this](const std::vector<std::string>& names) { offerArrays(names); });
}

void FrameDialog::chooseLayout() {
    const QString near =
        m_layout->text().isEmpty() ? QString::fromStdString(m_request.path) : m_layout->text();
    base::askToOpen(this,
                    {.title = tr("File of the array"),
                     .filters = {tr("Arrays (*.toml)")},
                     .folder = QFileInfo(near).absolutePath()},
                    [this](const QString& path) { m_layout->setText(path); });
}

void FrameDialog::offerArrays(const std::vector<std::string>& names) {
    const QString typed = m_array->currentText();
    const QSignalBlocker quiet(m_array);
    for (const std::string& name : names)
        if (!name.empty())
            m_array->addItem(QString::fromStdString(name));
    // None is chosen: each of them can be the frames.
    m_array->setCurrentIndex(-1);
    m_array->setEditText(typed);
}

void FrameDialog::check() {
    const QString columns = m_taxelColumns->text().trimmed();
    const bool fits = columns.isEmpty() || frames::columnRangesOf(columns.toStdString());
    m_verdict->setText(fits ? QString() : tr("Columns are numbers and ranges, such as 2..85 or 2..10,12."));
    base::setTextColour(m_verdict, base::statusColours(palette()).lost);
    m_accept->setEnabled(fits);
    const bool isKnown = !m_layout->text().trimmed().isEmpty();
    for (QWidget* field :
         {static_cast<QWidget*>(m_rows), static_cast<QWidget*>(m_columns), static_cast<QWidget*>(m_pitch_mm)})
        field->setEnabled(!isKnown);
    if (fits)
        m_preview->setRequest(request());
}

frames::FrameRequest FrameDialog::request() const {
    const auto side = [](const QSpinBox& box) {
        return box.value() > 0 ? std::optional(box.value()) : std::nullopt;
    };
    const auto number = [](const QDoubleSpinBox& box, double scale) {
        return box.value() > 0.0 ? std::optional(scale * box.value()) : std::nullopt;
    };
    frames::FrameRequest request = m_request;
    request.array = m_array->currentText().trimmed().toStdString();
    request.axis = static_cast<frames::FrameAxis>(m_axis->currentIndex());
    request.knownPath = m_layout->text().trimmed().toStdString();
    const bool isKnown = !request.knownPath.empty();
    request.rows = isKnown ? std::nullopt : side(*m_rows);
    request.columns = isKnown ? std::nullopt : side(*m_columns);
    request.pitch_m = isKnown ? std::nullopt : number(*m_pitch_mm, 1e-3);
    request.rate_Hz = number(*m_rate_Hz, 1.0);
    request.threshold = number(*m_threshold, 1.0);
    request.taxelColumns = frames::columnRangesOf(m_taxelColumns->text().trimmed().toStdString())
                               .value_or(std::vector<frames::ColumnRange>());
    request.timeColumn = m_timeColumn->text().trimmed().toStdString();
    request.timeUnit =
        m_timeUnit->currentIndex() > 0 ? m_timeUnit->currentText().toStdString() : std::string();
    return request;
}

} // namespace teleta::console
