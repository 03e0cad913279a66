// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/recording_dialog.h"

#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

namespace teleta::console {

namespace {

QDoubleSpinBox* makeNumber(double value, double low, double high, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(decimals);
    box->setRange(low, high);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setValue(value);
    return box;
}

} // namespace

RecordingDialog::RecordingDialog(app::CsvRequest request, QWidget* parent)
    : QDialog(parent)
    , m_request(std::move(request))
    , m_taxels(m_request.layout.taxels())
    , m_rows(new QSpinBox)
    , m_columns(new QSpinBox)
    , m_pitch_mm(makeNumber(m_request.layout.pitchX_m * 1e3, 0.001, 10'000.0, 3))
    , m_tare(new QLineEdit(QString::fromStdString(m_request.tarePath)))
    , m_gains(new QLineEdit(QString::fromStdString(m_request.gainsPath)))
    , m_inverted(new QCheckBox(tr("The &values fall under load")))
    , m_gain(makeNumber(m_request.gain, 1e-6, 1e6, 6))
    , m_threshold(makeNumber(m_request.threshold_N, 1e-6, 1e9, 3))
    , m_unit(new QLineEdit(QString::fromStdString(m_request.loadUnit)))
    , m_rate_Hz(makeNumber(m_request.rate_Hz, 0.0, 100'000.0, 1))
    , m_loop(new QCheckBox(tr("&Start again at the end")))
    , m_verdict(new QLabel) {
    setWindowTitle(tr("Open recording"));
    for (QSpinBox* box : {m_rows, m_columns})
        box->setRange(1, core::ArrayLayout::kMaximumSide);
    m_rows->setValue(m_request.layout.rows);
    m_columns->setValue(m_request.layout.columns);
    m_pitch_mm->setSuffix(tr(" mm"));
    m_rate_Hz->setSuffix(tr(" Hz"));
    m_rate_Hz->setSpecialValueText(tr("as recorded"));
    m_inverted->setChecked(m_request.inverted);
    m_loop->setChecked(m_request.loop);
    auto* tareRow = fileRow(m_tare, tr("Choose the recording of the unloaded array"),
                            tr("Recording of the unloaded array"), tr("Frames (*.csv)"));
    auto* gainsRow = fileRow(m_gains, tr("Choose the gains of the taxels"), tr("Gains of the taxels"),
                             tr("Gains (*.csv)"));

    auto* sizeRow = new QHBoxLayout;
    sizeRow->addWidget(m_rows);
    sizeRow->addWidget(new QLabel(tr("rows \u00d7", "N rows x M columns")));
    sizeRow->addWidget(m_columns);
    sizeRow->addWidget(new QLabel(tr("columns")));
    sizeRow->addStretch(1);
    m_rows->setAccessibleName(tr("Rows"));
    m_columns->setAccessibleName(tr("Columns"));

    auto* form = new QFormLayout;
    auto* file = new QLabel(QFileInfo(QString::fromStdString(m_request.path)).fileName());
    file->setToolTip(QString::fromStdString(m_request.path));
    form->addRow(tr("Recording:"), file);
    base::addFormRow(*form, tr("&Array:"), sizeRow, m_rows);
    form->addRow(QString(), m_verdict);
    form->addRow(tr("&Pitch:"), m_pitch_mm);
    base::addFormRow(*form, tr("&Unloaded (tare):"), tareRow, m_tare);
    base::addFormRow(*form, tr("Gains of the ta&xels:"), gainsRow, m_gains);
    form->addRow(QString(), m_inverted);
    form->addRow(tr("&Gain:"), m_gain);
    form->addRow(tr("Unit of the &load:"), m_unit);
    form->addRow(tr("&Threshold:"), m_threshold);
    form->addRow(tr("&Rate:"), m_rate_Hz);
    form->addRow(QString(), m_loop);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Open);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);

    connect(m_rows, &QSpinBox::valueChanged, this, &RecordingDialog::check);
    connect(m_columns, &QSpinBox::valueChanged, this, &RecordingDialog::check);
    check();
}

app::CsvRequest RecordingDialog::request() const {
    app::CsvRequest request = m_request;
    request.layout = {m_rows->value(), m_columns->value(), m_pitch_mm->value() * 1e-3};
    request.tarePath = m_tare->text().trimmed().toStdString();
    request.gainsPath = m_gains->text().trimmed().toStdString();
    request.inverted = m_inverted->isChecked();
    request.gain = m_gain->value();
    request.threshold_N = m_threshold->value();
    request.loadUnit = m_unit->text().trimmed().toStdString();
    request.rate_Hz = m_rate_Hz->value();
    request.loop = m_loop->isChecked();
    return request;
}

void RecordingDialog::check() {
    const auto taxels =
        static_cast<std::size_t>(m_rows->value()) * static_cast<std::size_t>(m_columns->value());
    const bool fits = taxels == m_taxels;
    m_verdict->setText(fits ? tr("%n taxel(s), as in the file", nullptr, static_cast<int>(m_taxels))
                            : tr("%1 taxels, but the file has %2").arg(taxels).arg(m_taxels));
    QPalette colours = palette();
    if (!fits)
        colours.setColor(QPalette::WindowText, base::statusColours(colours).lost);
    m_verdict->setPalette(colours);
    m_accept->setEnabled(fits);
}

QHBoxLayout* RecordingDialog::fileRow(QLineEdit* line, const QString& toolTip, const QString& title,
                                      const QString& filter) {
    line->setPlaceholderText(tr("none"));
    line->setClearButtonEnabled(true);
    line->setMinimumWidth(base::em(this, 20));
    auto* choose = new QToolButton;
    choose->setText(tr("\u2026"));
    choose->setToolTip(toolTip);
    choose->setAccessibleName(toolTip);
    connect(choose, &QToolButton::clicked, this, [this, line, title, filter] {
        base::askToOpen(this,
                        {.title = title,
                         .filters = {filter},
                         .folder = QFileInfo(QString::fromStdString(m_request.path)).path()},
                        [line](const QString& path) { line->setText(path); });
    });
    auto* row = new QHBoxLayout;
    row->addWidget(line, 1);
    row->addWidget(choose);
    return row;
}

} // namespace teleta::console
