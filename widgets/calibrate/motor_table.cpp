// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/motor_table.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHeaderView>

namespace teleta::calibrate {

namespace {

using Origin = motors::CalibratedMotor::Origin;

enum Column { kMotor, kStart, kFull, kRise, kFall, kSpeed, kSource, kColumns };

Qt::Alignment alignmentOf(int column) {
    return (column == kMotor || column == kSource ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
}

QString withError(double value, double error, int decimals) {
    QString text = base::fixedDigits(value, decimals);
    if (error > 0.0)
        text += QStringLiteral(" \u00b1 ") + base::fixedDigits(error, decimals);
    return text;
}

} // namespace

MotorTable::MotorTable(QWidget* parent)
    : QTableWidget(static_cast<int>(core::kTactors), kColumns, parent) {
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setAlternatingRowColors(true);
    setWordWrap(false);
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    setTabKeyNavigation(false);
    base::keepTranslated(this, &MotorTable::retranslate);
    selectRow(0);
    connect(this, &QTableWidget::itemSelectionChanged, this, [this] { emit motorSelected(selectedMotor()); });
    base::onChange(this, &MotorTable::fill, {QEvent::PaletteChange});
}

void MotorTable::setCalibration(const motors::MotorCalibration& calibration) {
    m_calibration = calibration;
    fill();
}

std::size_t MotorTable::selectedMotor() const {
    const int row = currentRow();
    return row >= 0 ? static_cast<std::size_t>(row) : 0;
}

void MotorTable::selectMotor(std::size_t motor) {
    selectRow(static_cast<int>(motor));
}

void MotorTable::fill() {
    const auto originText = [](Origin origin) {
        return origin == Origin::assumed   ? tr("assumed")
               : origin == Origin::answers ? tr("by feel")
                                           : tr("measured");
    };
    // Colours of the enabled table: it is also filled while a measurement disables it.
    const QColor faint = palette().color(QPalette::Active, QPalette::PlaceholderText);
    const QColor ink = palette().color(QPalette::Active, QPalette::Text);
    const std::string assumedName = pattern::MotorProfile::assumedCoinMotor().name;
    for (int row = 0; row < rowCount(); ++row) {
        const motors::CalibratedMotor& motor = m_calibration.motors[static_cast<std::size_t>(row)];
        const pattern::MotorProfile& profile = motor.profile;
        const auto set = [&](int column, const QString& text, bool assumed) {
            auto* cell = item(row, column);
            if (cell == nullptr) {
                cell = new QTableWidgetItem;
                setItem(row, column, cell);
            }
            cell->setText(text);
            cell->setForeground(assumed ? faint : ink);
            cell->setTextAlignment(alignmentOf(column));
        };
        const bool range = motor.startFrom == Origin::assumed;
        const bool lag = motor.lagFrom == Origin::assumed;
        // Profiles saved by earlier versions contain the name of the assumed motor.
        set(kMotor,
            profile.name.empty() || profile.name == assumedName ? tr("Motor %1").arg(row + 1)
                                                                : QString::fromStdString(profile.name),
            false);
        set(kStart, withError(100.0 * profile.startDrive, 100.0 * motor.startError, 1), range);
        set(kFull, base::fixedDigits(100.0 * profile.fullDrive, 1), range);
        set(kRise, withError(1e3 * profile.riseTime_s, 1e3 * motor.riseError_s, 1), lag);
        set(kFall, withError(1e3 * profile.fallTime_s, 1e3 * motor.fallError_s, 1), lag);
        set(kSpeed, base::fixedDigits(steadySpeed_Hz(profile, profile.fullDrive), 0), lag);
        set(kSource,
            motor.startFrom == motor.lagFrom ? originText(motor.lagFrom)
            : !lag && !range                 ? tr("measured, by feel", "where the values come from")
            : motor.startFrom == Origin::answers || motor.lagFrom == Origin::answers
                ? tr("partly by feel", "where the values come from")
                : tr("partly measured", "where the values come from"),
            range && lag);
        item(row, kSource)
            ->setToolTip(tr("start %1, lag and curve %2", "where the values come from")
                             .arg(originText(motor.startFrom), originText(motor.lagFrom)));
    }
}

void MotorTable::retranslate() {
    setAccessibleName(tr("Motors of the bracelet"));
    const QString percent = QStringLiteral("%");
    const QString ms = QStringLiteral("ms");
    setHorizontalHeaderLabels({tr("Motor"), base::titleOverUnit(tr("Start"), percent),
                               base::titleOverUnit(tr("Full"), percent), base::titleOverUnit(tr("Rise"), ms),
                               base::titleOverUnit(tr("Fall"), ms),
                               base::titleOverUnit(tr("Speed"), QStringLiteral("Hz")), tr("Source")});
    for (int column = 0; column < kColumns; ++column)
        horizontalHeaderItem(column)->setTextAlignment(alignmentOf(column));
    const QStringList tips{QString(),
                           tr("Drive at which the motor begins to turn, with its standard error"),
                           tr("Drive of intensity 1, so that all motors are equally strong"),
                           tr("From rest to 90 % of a speed"),
                           tr("From a speed to 10 % of it"),
                           tr("Speed at the full drive of this motor"),
                           QString()};
    for (int column = 0; column < kColumns; ++column)
        horizontalHeaderItem(column)->setToolTip(tips[column]);
    fill();
}

} // namespace teleta::calibrate
