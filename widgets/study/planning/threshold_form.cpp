// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/planning/threshold_form.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/study_names.h"

#include <initializer_list>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kWhole_percent = 100.0;
constexpr double kWeibullSlope = 3.5;
constexpr int kMostTrials = 1000;
/// Spreads of a straight scale start as these shares of the levels.
constexpr double kUsualSlopeShare = 0.1;
constexpr double kUsualWidthShare = 0.05;

/// Whether the function that is fitted is a Weibull function, whose slope has no unit.
bool isWeibull(const StudyTask& task) {
    return task.design != Design::compare && task.levels.range.scale == LevelScale::log10;
}

} // namespace

ThresholdForm::ThresholdForm(QWidget* parent)
    : QWidget(parent) {
    m_form->setContentsMargins(0, 0, 0, 0);
    for (QDoubleSpinBox* share : {m_lapse_percent, m_guess_percent}) {
        share->setDecimals(1);
        share->setSingleStep(1.0);
        share->setSuffix(QStringLiteral(" %"));
        share->setValue(2.0);
    }
    m_lapse_percent->setRange(0.0, 20.0);
    m_guess_percent->setRange(0.0, 50.0);
    m_trials->setRange(0, kMostTrials);
    for (const auto& [label, field] : {std::pair<QLabel*, QWidget*>{m_thresholdLabel, m_threshold},
                                       {m_slopeLabel, m_slope},
                                       {m_lapseLabel, m_lapse_percent},
                                       {m_guessLabel, m_guess_percent},
                                       {m_sdLabel, m_sd},
                                       {m_widthLabel, m_width},
                                       {m_trialsLabel, m_trials}}) {
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    m_form->setHorizontalSpacing(base::grid(this, 2));
    m_form->setVerticalSpacing(base::grid(this));
    base::keepTranslated(this, &ThresholdForm::retranslate);
}

void ThresholdForm::setTask(const StudyTask& task) {
    const bool isSame = task.id == m_task.id && task.design == m_task.design &&
                        task.levels.vary == m_task.levels.vary &&
                        task.levels.range.scale == m_task.levels.range.scale;
    m_task = task;
    const LevelRange& range = task.levels.range;
    const bool isLog = range.scale == LevelScale::log10;
    const double whole = onScale(range.scale, range.highest) - onScale(range.scale, range.lowest);
    for (QDoubleSpinBox* place : {m_threshold, m_slope, m_sd, m_width}) {
        place->setDecimals(4);
        place->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    }
    m_threshold->setRange(range.lowest, range.highest);
    const double levels = range.highest - range.lowest;
    m_slope->setRange(0.001, isWeibull(task) ? 20.0 : levels);
    m_sd->setRange(0.0, whole);
    m_width->setRange(0.0001, whole);
    const bool hasGuess = task.design == Design::yesNo || task.design == Design::sameDifferent;
    m_form->setRowVisible(m_guess_percent, hasGuess);
    if (!isSame) {
        m_threshold->setValue(fromScale(range.scale, onScale(range.scale, range.lowest) + 0.5 * whole));
        m_slope->setValue(isWeibull(task) ? kWeibullSlope : kUsualSlopeShare * levels);
        m_sd->setValue(isLog ? 0.15 : kUsualSlopeShare * whole);
        m_width->setValue(isLog ? 0.1 : kUsualWidthShare * whole);
    }
    retranslate();
}

TaskTruth ThresholdForm::truth() const {
    TaskTruth truth;
    truth.id = m_task.id;
    truth.threshold =
        ThresholdTruth{m_threshold->value(), m_slope->value(), m_lapse_percent->value() / kWhole_percent,
                       m_guess_percent->value() / kWhole_percent, m_sd->value()};
    return truth;
}

ThresholdWish ThresholdForm::wish() const {
    ThresholdWish wish{m_width->value(), {}};
    if (m_trials->value() > 0)
        wish.trials = static_cast<std::size_t>(m_trials->value());
    return wish;
}

void ThresholdForm::setTruthEnabled(bool enabled) {
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_threshold, m_slope, m_lapse_percent, m_guess_percent, m_sd})
        field->setEnabled(enabled);
}

void ThresholdForm::retranslate() {
    const QString unit = displayUnit(m_task.levels.vary);
    const bool isLog = m_task.levels.range.scale == LevelScale::log10;
    const QString scale = isLog ? tr("log10 units") : unit;
    m_thresholdLabel->setText(tr("&Threshold"));
    m_threshold->setSuffix(QLatin1Char(' ') + unit);
    m_slopeLabel->setText(isWeibull(m_task) ? tr("Slope (Wei&bull)") : tr("Spread of the fu&nction"));
    m_slope->setSuffix(isWeibull(m_task) ? QString() : QLatin1Char(' ') + unit);
    m_lapseLabel->setText(tr("&Lapses"));
    m_guessLabel->setText(tr("&Yes without a stimulus"));
    m_sdLabel->setText(tr("Spread of &participants"));
    m_sd->setSuffix(QLatin1Char(' ') + scale);
    m_widthLabel->setText(tr("Interval at &most \u00b1"));
    m_width->setSuffix(QLatin1Char(' ') + scale);
    m_width->setToolTip(tr("How far the 95 % interval of the mean threshold may reach to each side"));
    m_trialsLabel->setText(tr("Trials of a trac&k"));
    m_trials->setSpecialValueText(tr("as in the protocol"));
    m_trials->setToolTip(tr("Of constant stimuli: at each level"));
    for (const auto& [label, field] : {std::pair<QLabel*, QWidget*>{m_thresholdLabel, m_threshold},
                                       {m_slopeLabel, m_slope},
                                       {m_lapseLabel, m_lapse_percent},
                                       {m_guessLabel, m_guess_percent},
                                       {m_sdLabel, m_sd},
                                       {m_widthLabel, m_width},
                                       {m_trialsLabel, m_trials}})
        field->setAccessibleName(label->text().remove(QLatin1Char('&')));
}

} // namespace teleta::study
