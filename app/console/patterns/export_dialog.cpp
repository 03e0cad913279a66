// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/export_dialog.h"

#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <array>
#include <utility>

namespace teleta::console {

using pattern::PatternFormat;

namespace {

struct Format {
    PatternFormat format;
    const char* ending;
    const char* name;
    const char* about;
};

constexpr std::array kFormats{
    Format{PatternFormat::hjif, ".hjif", QT_TRANSLATE_NOOP("ExportDialog", "HJIF (ISO/IEC 23090-31)"),
           QT_TRANSLATE_NOOP("ExportDialog",
                             "One channel per motor, with its place on the forearm. Can be read back.")},
    Format{PatternFormat::hapticZip, ".haptic.zip",
           QT_TRANSLATE_NOOP("ExportDialog", "Haptic clips (.haptic in a zip)"),
           QT_TRANSLATE_NOOP("ExportDialog", "One clip per motor. Can be read back.")},
    Format{PatternFormat::ahapZip, ".ahap.zip", QT_TRANSLATE_NOOP("ExportDialog", "AHAP (in a zip)"),
           QT_TRANSLATE_NOOP("ExportDialog", "One file per motor, for Core Haptics. Can be read back.")},
    Format{PatternFormat::tact, ".tact", QT_TRANSLATE_NOOP("ExportDialog", "tact"),
           QT_TRANSLATE_NOOP("ExportDialog",
                             "Six motors on the forearm, whole milliseconds; slopes become steps of "
                             "20 ms. Can be read back.")},
    Format{PatternFormat::csv, ".csv", QT_TRANSLATE_NOOP("ExportDialog", "CSV table"),
           QT_TRANSLATE_NOOP("ExportDialog", "Columns time_s, t1 to t6: one sample per row.")},
    Format{PatternFormat::wav, ".wav", QT_TRANSLATE_NOOP("ExportDialog", "WAV, six channels"),
           QT_TRANSLATE_NOOP("ExportDialog",
                             "16-bit samples, 1 is full scale. Vibrations drive voice coils; bare "
                             "intensities are for programs that make the vibration themselves.")}};

} // namespace

ExportDialog::ExportDialog(pattern::MotorProfiles motors, QString suggested, QWidget* parent)
    : QDialog(parent)
    , m_motors(std::move(motors))
    , m_suggested(std::move(suggested))
    , m_format(base::named<QComboBox>("format", this))
    , m_about(new QLabel(this))
    , m_rate(base::named<QDoubleSpinBox>("rate", this))
    , m_content(base::named<QComboBox>("content", this))
    , m_signal(base::named<QComboBox>("signal", this))
    , m_carrier(base::named<QDoubleSpinBox>("carrier", this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Export pattern"));
    for (const Format& format : kFormats)
        m_format->addItem(tr(format.name), static_cast<int>(format.format));
    m_about->setWordWrap(true);
    m_about->setMinimumWidth(base::em(this, 24));
    m_rate->setRange(pattern::kLowestRate_Hz, pattern::kHighestRate_Hz);
    m_rate->setSuffix(QStringLiteral(" Hz"));
    m_content->addItem(tr("commanded intensities"));
    m_content->addItem(tr("predicted intensities"));
    m_signal->addItem(tr("vibrations"));
    m_signal->addItem(tr("bare intensities"));
    m_carrier->setSuffix(QStringLiteral(" Hz"));
    m_carrier->setRange(1.0, 0.5 * pattern::kHighestRate_Hz);
    m_carrier->setValue(pattern::kCarrier_Hz);
    auto* where = m_buttons->addButton(tr("Choose file\u2026"), QDialogButtonBox::AcceptRole);
    where->setDefault(true);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Format:"), m_format);
    form->addRow(QString(), m_about);
    form->addRow(tr("&Rate:"), m_rate);
    form->addRow(tr("&Values:"), m_content);
    form->addRow(tr("&Signal:"), m_signal);
    form->addRow(tr("Frequenc&y:"), m_carrier);
    form->addRow(m_buttons);
    connect(m_signal, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_carrier->setEnabled(m_signal->isEnabled() && index == 0); });
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::showFormat);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ExportDialog::askWhere);
    showFormat();
}

void ExportDialog::choose(PatternFormat format) {
    m_format->setCurrentIndex(m_format->findData(static_cast<int>(format)));
}

void ExportDialog::showFormat() {
    const Format& format = kFormats[static_cast<std::size_t>(m_format->currentIndex())];
    const bool wav = format.format == PatternFormat::wav;
    const bool sampled = wav || format.format == PatternFormat::csv;
    m_about->setText(tr(format.about));
    m_rate->setEnabled(sampled);
    m_content->setEnabled(sampled);
    m_signal->setEnabled(wav);
    m_carrier->setEnabled(wav && m_signal->currentIndex() == 0);
    m_rate->setDecimals(wav ? 0 : 3);
    m_rate->setMinimum(wav ? 1.0 : pattern::kLowestRate_Hz);
    // A format without samples has no rate.
    m_rate->setSpecialValueText(sampled ? QString() : QStringLiteral("\u2014"));
    m_rate->setValue(wav ? pattern::kWavRate_Hz : sampled ? pattern::kCsvRate_Hz : m_rate->minimum());
}

pattern::SampleOptions ExportDialog::samples() const {
    pattern::SampleOptions samples;
    if (!m_rate->isEnabled())
        return samples;
    samples.rate_Hz = m_rate->value();
    if (m_content->currentIndex() == 1)
        samples.motors = m_motors;
    if (m_carrier->isEnabled())
        samples.carrier_Hz = m_carrier->value();
    return samples;
}

QString ExportDialog::ending() const {
    return QLatin1String(kFormats[static_cast<std::size_t>(m_format->currentIndex())].ending);
}

void ExportDialog::askWhere() {
    base::askToSave(this,
                    {.title = tr("Export pattern"),
                     .filters = {m_format->currentText() + QStringLiteral(" (*%1)").arg(ending())},
                     .suffix = ending().mid(1),
                     .name = m_suggested + ending()},
                    [this](const QString& path) {
                        emit chosen(path.endsWith(ending(), Qt::CaseInsensitive) ? path : path + ending(),
                                    samples());
                        accept();
                    });
}

} // namespace teleta::console
