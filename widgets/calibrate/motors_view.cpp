// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/motors_view.h"

#include "backend/motors/excitation.h"
#include "backend/motors/strength_balance.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLocale>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <utility>

namespace teleta::calibrate {

namespace {

/// Share of a measurement's time without readings above which the user is asked to measure again.
constexpr double kBusyShare = 0.01;

/// A view that is lower has the chart behind the table.
constexpr double kLowView_em = 36.0;

enum Page { kSteps, kFelt, kMeasuring };

using Origin = motors::CalibratedMotor::Origin;

/// The motors whose strength is limited, in the words of the panel that sets it; empty: none.
QString limitsText(const core::Intensities& strongest) {
    const auto say = [](const char* words) {
        return QCoreApplication::translate("teleta::bracelet::StrengthPanel", words);
    };
    const auto line = [&](const QString& who, double share) {
        return who + QStringLiteral(": ") +
               say("%1 %").arg(QLocale().toString(static_cast<int>(std::lround(100.0 * share))));
    };
    const auto [lowest, highest] = std::ranges::minmax(strongest);
    if (!(lowest < 1.0))
        return {};
    if (lowest == highest)
        return line(say("Strongest, all motors"), lowest);
    QStringList lines;
    for (std::size_t i = 0; i < strongest.size(); ++i)
        if (strongest[i] < 1.0)
            lines << line(say("Strongest, motor %1").arg(i + 1), strongest[i]);
    return lines.join(QStringLiteral(", "));
}

} // namespace

MotorsView::MotorsView(QWidget* parent)
    : CalibrationView({"undo", "redo", "load", "copy", "reset", "save"}, parent) {
    m_heading->setFont(base::bold(base::sized(font(), base::kTitleText)));
    m_steps->addWidget(makeSteps());
    m_steps->addWidget(m_felt);
    m_steps->addWidget(makeMeasuring());
    m_views->setDocumentMode(true);
    m_views->setTabBarAutoHide(true);
    // Its tab bar takes the focus by itself: as its proxy it would keep the key Tab in the table.
    m_views->setFocusProxy(nullptr);
    m_views->setFocusPolicy(Qt::NoFocus);
    m_views->addTab(m_table, QString());
    auto* upper = new QSplitter(Qt::Horizontal, this);
    upper->setChildrenCollapsible(false);
    upper->addWidget(m_views);
    upper->addWidget(m_steps);
    upper->setStretchFactor(0, 3);
    upper->setStretchFactor(1, 2);
    m_parts->setChildrenCollapsible(false);
    m_parts->addWidget(upper);
    m_parts->addWidget(m_chart);
    m_parts->setStretchFactor(0, 1);
    m_parts->setStretchFactor(1, 1);
    page().addWidget(m_parts, 1);

    connect(m_table, &MotorTable::motorSelected, this, &MotorsView::refresh);
    connect(m_chart, &MotorChart::exportFailed, this, &MotorsView::exportFailed);
    connect(m_felt, &FeltPanel::playRequested, this, &MotorsView::playRequested);
    connect(m_felt, &FeltPanel::cancelled, this, [this] {
        emit stopRequested();
        refresh();
    });
    connect(m_felt, &FeltPanel::finished, this,
            [this](const motors::MotorCalibration& calibration, const QString& text) {
                edit(calibration);
                verdict()->setText(text);
            });
    const auto act = [this](const char* name, auto slot) {
        connect(button(name), &QPushButton::clicked, this, slot);
    };
    act("copy", &MotorsView::copyRequested);
    act("reset", &MotorsView::reset);
    act("curves", &MotorsView::balanceByCurves);
    act("excitation", &MotorsView::excitationFileRequested);
    act("recording", [this] { emit recordingRequested(m_table->selectedMotor()); });
    act("measure", [this] { emit measureRequested({m_table->selectedMotor()}); });
    act("measureAll", [this] {
        std::vector<std::size_t> motors(core::kTactors);
        std::iota(motors.begin(), motors.end(), std::size_t{0});
        emit measureRequested(motors);
    });
    act("cancel", &MotorsView::cancelMeasureRequested);
    act("feel", [this] { ask(FeltTask::start(m_calibration, m_table->selectedMotor())); });
    act("balance", [this] { ask(FeltTask::balance(m_calibration)); });
    base::keepTranslated(this, &MotorsView::retranslate);
    base::onChange(this, &MotorsView::refresh, {QEvent::PaletteChange});
}

void MotorsView::resizeEvent(QResizeEvent* event) {
    CalibrationView::resizeEvent(event);
    for (QLabel* group : m_groups)
        group->setVisible(!isNarrow()); // the buttons say it, too
    const bool isLow = height() < base::em(this, kLowView_em);
    if (isLow == (m_views->count() > 1))
        return;
    if (isLow) {
        m_views->addTab(m_chart, tr("Curves"));
    } else {
        m_parts->addWidget(m_chart);
        m_chart->show();
    }
}

void MotorsView::ask(FeltTask task) {
    m_felt->begin(std::move(task));
    refresh();
    m_felt->setFocus();
}

QWidget* MotorsView::makeSteps() {
    auto* page = new QWidget(this);
    auto* grid = new QGridLayout;
    const auto addRow = [&](std::initializer_list<const char*> names) {
        const int row = grid->rowCount();
        m_groups.push_back(new QLabel(page));
        grid->addWidget(m_groups.back(), row, 0);
        for (int column = 1; const char* name : names) {
            QPushButton* made = addButton(name, page);
            made->setMinimumHeight(base::em(this, 2.2));
            grid->addWidget(made, row, column++);
        }
    };
    addRow({"measureAll", "measure"});
    addRow({"feel", "balance"});
    addRow({"curves"});
    addRow({"recording", "excitation"});
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(m_heading);
    layout->addWidget(m_speed);
    layout->addLayout(grid);
    layout->addWidget(verdict());
    layout->addStretch(1);
    return page;
}

QWidget* MotorsView::makeMeasuring() {
    auto* page = new QWidget(this);
    m_measureText->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_measureText->setWordWrap(true);
    m_progress->setRange(0, 100);
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(m_measureText);
    layout->addWidget(m_progress);
    layout->addWidget(addButton("cancel", page));
    layout->addStretch(1);
    return page;
}

void MotorsView::setFacts(const BraceletFacts& facts) {
    if (facts == m_facts)
        return;
    BraceletFacts atOldSpeeds = facts;
    atOldSpeeds.speeds_Hz = m_facts.speeds_Hz;
    const bool onlySpeedsChanged = atOldSpeeds == m_facts;
    m_facts = facts;
    m_felt->setReady(facts.ready);
    const std::size_t motor = m_table->selectedMotor();
    // The text changes less often than the numbers: the progress bar shows the movement.
    m_speed->setText(facts.speeds_Hz
                         ? tr("Turning at %1 Hz, measured by the bracelet's sensor.")
                               .arg(base::wholeNumber(std::max((*facts.speeds_Hz)[motor], 0.0)).trimmed())
                         : QString());
    if (!onlySpeedsChanged)
        refresh();
}

void MotorsView::setCalibration(const motors::MotorCalibration& calibration) {
    m_evidence = {};
    verdict()->clear();
    m_felt->end(); // its answers concern the previous motors
    forgetChanges();
    m_calibration = calibration;
    m_table->setCalibration(calibration);
    refresh();
}

void MotorsView::takeProfile(const motors::MotorCalibration& profile) {
    m_felt->end();
    verdict()->clear();
    edit(profile);
    refresh();
}

void MotorsView::edit(const motors::MotorCalibration& after) {
    if (after != m_calibration)
        change([this, after] { take(after); }, [this, before = m_calibration] { take(before); });
}

void MotorsView::take(const motors::MotorCalibration& calibration) {
    m_calibration = calibration;
    m_felt->setCalibration(calibration);
    m_table->setCalibration(calibration);
    refresh();
    emit calibrationChanged(calibration);
}

void MotorsView::undo() {
    if (m_felt->task() != nullptr)
        m_felt->undoAnswer();
    else if (!m_measuring && !m_facts.reserved)
        changes().undo();
}

void MotorsView::redo() {
    if (m_felt->task() == nullptr && !m_measuring && !m_facts.reserved)
        changes().redo();
}

void MotorsView::reset() {
    motors::MotorCalibration assumed;
    assumed.bracelet = m_calibration.bracelet;
    edit(assumed);
    verdict()->setText(tr("All motors use assumed values again. Undo brings the measurements back."));
}

void MotorsView::balanceByCurves() {
    motors::MotorCalibration after = m_calibration;
    const pattern::MotorProfiles balanced = motors::balancedBySpeed(after.profiles());
    for (std::size_t i = 0; i < core::kTactors; ++i)
        after.motors[i].profile = balanced[i];
    edit(after);
    verdict()->setText(tr("Every measured motor is now limited to the top speed of the slowest one."));
}

void MotorsView::setMeasuring(std::optional<std::size_t> motor, double progress, std::size_t number,
                              std::size_t of) {
    static const double kDuration_s = motors::stairsAndPulses().duration_s;
    m_progress->setValue(static_cast<int>(100.0 * progress));
    if (motor != m_measuring)
        m_chart->endLive();
    if (motor && m_facts.speeds_Hz)
        m_chart->addLive(progress * kDuration_s, (*m_facts.speeds_Hz)[*motor], kDuration_s);
    if (motor == m_measuring)
        return;
    m_measuring = motor;
    if (motor) {
        m_measureText->setText(
            of > 1 ? tr("Measuring motor %1, %2 of %3: steps up to full drive, then pulses.")
                         .arg(*motor + 1)
                         .arg(number)
                         .arg(of)
                   : tr("Measuring motor %1: steps up to full drive, then pulses.").arg(*motor + 1));
        m_table->selectMotor(*motor);
        if (m_views->count() > 1)
            m_views->setCurrentWidget(m_chart);
    }
    refresh();
}

void MotorsView::takeFit(std::size_t motor, const motors::MotorRecording& recording,
                         const core::Expected<motors::MotorFit>& fit) {
    m_table->selectMotor(motor);
    if (!fit) {
        const core::Error& why = fit.error();
        QString text =
            tr("Motor %1 was not calibrated. %2", "a motor, and why not")
                .arg(motor + 1)
                .arg(QString::fromStdString(why.where.file.empty() ? why.message : core::describe(why)));
        // What was expected of a person, not of a file, is what to do next.
        if (why.where.file.empty() && !why.expected.empty())
            text += QLatin1Char('\n') + tr("What to do: %1.").arg(QString::fromStdString(why.expected));
        verdict()->setText(text);
        return;
    }
    m_evidence[motor] = std::make_shared<const MotorChart::Evidence>(MotorChart::Evidence{recording, *fit});
    motors::MotorCalibration after = m_calibration;
    motors::CalibratedMotor& known = after.motors[motor];
    std::string name = known.profile.name;
    // The name of the assumed motor is not a name given by the user.
    if (name == pattern::MotorProfile::assumedCoinMotor().name)
        name.clear();
    known.profile = fit->profile;
    known.profile.name = std::move(name);
    known.startFrom = known.lagFrom = Origin::recording;
    known.startError = fit->startError;
    known.riseError_s = fit->riseError_s;
    known.fallError_s = fit->fallError_s;
    edit(after);
    QString text =
        tr("Motor %1: starts at %2 to %3 % of the drive, rises in %4 \u00b1 %5 ms, falls in %6 \u00b1 "
           "%7 ms, reaches %8 Hz.")
            .arg(motor + 1)
            .arg(base::fixedDigits(100.0 * fit->startLow, 1), base::fixedDigits(100.0 * fit->startHigh, 1),
                 base::fixedDigits(1e3 * fit->profile.riseTime_s, 1),
                 base::fixedDigits(1e3 * fit->riseError_s, 1),
                 base::fixedDigits(1e3 * fit->profile.fallTime_s, 1),
                 base::fixedDigits(1e3 * fit->fallError_s, 1),
                 base::fixedDigits(fit->profile.curve.back().speed_Hz, 0));
    if (fit->gapShare > kBusyShare)
        text +=
            QLatin1Char(' ') + tr("The computer was busy: %1 % of the time has no readings. Measure again "
                                  "with fewer programs running.")
                                   .arg(base::fixedDigits(100.0 * fit->gapShare, 0));
    verdict()->setText(text);
}

QString MotorsView::calibratedText() const {
    const auto measured =
        static_cast<int>(std::ranges::count_if(m_calibration.motors, &motors::CalibratedMotor::measured));
    const auto all = static_cast<int>(m_calibration.motors.size());
    if (measured < all)
        return (isSaved() ? tr("%n of %1 motors calibrated, saved", nullptr, measured)
                          : tr("%n of %1 motors calibrated, not saved", nullptr, measured))
            .arg(all);
    return isSaved() ? tr("calibrated, saved") : tr("calibrated, not saved");
}

void MotorsView::refresh() {
    const std::size_t motor = m_table->selectedMotor();
    m_steps->setCurrentIndex(m_measuring ? kMeasuring : m_felt->task() != nullptr ? kFelt : kSteps);
    showTitle(m_facts.name.isEmpty() ? tr("No bracelet") : m_facts.name);
    const bool measured = m_calibration.measured();
    QString state = m_facts.serial.isEmpty() ? tr("Choose a bracelet in the menu Bracelet.")
                    : !measured              ? tr("not calibrated: the motors use assumed values")
                                             : calibratedText();
    if (m_facts.reserved)
        state += QStringLiteral(" \u00b7 ") + tr("a study uses the bracelet: its motors cannot be changed");
    if (const QString limits = limitsText(m_facts.strongest); !limits.isEmpty())
        state += QStringLiteral(" \u00b7 ") + limits;
    const base::StatusColours& status = base::statusColours(palette());
    showState(state, m_facts.simulated ? base::Provenance::simulated : base::Provenance::live,
              m_facts.simulated                                        ? status.simulated
              : measured && std::ranges::min(m_facts.strongest) >= 1.0 ? status.live
                                                                       : status.stale);
    m_heading->setText(tr("Motor %1").arg(motor + 1));
    const bool idle = !m_measuring && m_felt->task() == nullptr;
    m_table->setEnabled(idle);
    const bool known = !m_facts.serial.isEmpty();
    const bool editable = idle && !m_facts.reserved;
    enable("undo", m_felt->task() != nullptr || (editable && changes().canUndo()));
    enable("redo", editable && changes().canRedo());
    enable("load", editable && known);
    enable("copy", idle && measured);
    enable("reset", editable && measured);
    enable("recording", editable);
    enable("save", idle && known && !isSaved());
    enable("measure", m_facts.ready && m_facts.hasSensor);
    enable("measureAll", m_facts.ready && m_facts.hasSensor);
    button("measureAll")->setDefault(m_facts.hasSensor);
    button("feel")->setDefault(!m_facts.hasSensor);
    enable("feel", m_facts.ready);
    enable("balance", m_facts.ready);
    const auto hasCurve =
        std::ranges::count_if(m_calibration.motors, [](const motors::CalibratedMotor& known_) {
            return known_.lagFrom != Origin::assumed;
        });
    enable("curves", editable && hasCurve > 1);
    button("measure")->setToolTip(
        m_facts.hasSensor ? tr("Drive the motor up and down and record it with the bracelet's sensor")
                          : tr("This bracelet has no sensor: open a recording, or answer by feel"));
    showChart();
}

void MotorsView::showChart() {
    const std::size_t motor = m_table->selectedMotor();
    const motors::CalibratedMotor& known = m_calibration.motors[motor];
    auto evidence = m_evidence[motor];
    // After an undo the recording no longer belongs to the curve.
    if (evidence && evidence->fit.profile.curve != known.profile.curve)
        evidence = nullptr;
    m_chart->setMotor(motor, known, evidence,
                      m_facts.simulated ? base::Provenance::simulated : base::Provenance::live);
}

void MotorsView::retranslate() {
    m_views->setTabText(0, tr("Motors"));
    if (m_views->count() > 1)
        m_views->setTabText(1, tr("Curves"));
    name("undo", tr("Undo"), tr("Undo the last change or answer (Ctrl+Z)"));
    name("redo", tr("Redo"), tr("Redo the change undone last"));
    name("load", tr("&Load\u2026"), tr("Load a profile of this bracelet from a file"));
    name("copy", tr("Save a &copy\u2026"), tr("Save the profile to another file"));
    name("reset", tr("Rese&t"), tr("Discard the measurements"));
    name("save", tr("&Save"),
         tr("Save the profile for this bracelet: it is used whenever the bracelet is connected"));
    const std::array<QString, 4> groups{tr("With its sensor"), tr("By feel"), tr("By the curves"),
                                        tr("In files")};
    for (std::size_t i = 0; i < groups.size(); ++i)
        m_groups[i]->setText(groups[i]);
    name("measure", tr("&Measure this motor"), QString());
    name("measureAll", tr("Measure all si&x"), tr("One after another, with the bracelet's sensor"));
    name("recording", tr("&Open a recording\u2026"),
         tr("CSV with time_s, commanded, and speed_hz (tachometer) or signal (accelerometer, microphone)"));
    name("excitation", tr("Save the &excitation\u2026"),
         tr("Save the drive signal of a measurement as CSV, to record with a sensor of your own"));
    name("feel", tr("Fi&nd the start by feel"),
         tr("Plays weaker and stronger bursts; you say what you felt"));
    name("balance", tr("Balance b&y feel"), tr("Compare the strength of each motor with that of motor 1"));
    name("curves", tr("Balance by the c&urves"),
         tr("Limit all measured motors to the top speed of the slowest"));
    name("cancel", tr("Stop measuring"), QString());
    setAccessibleName(tr("Calibration of the bracelet's motors"));
    refresh();
}

} // namespace teleta::calibrate
