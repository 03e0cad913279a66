// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/motors/measured_motor.h"
#include "tests/widgets/parts.h"
#include "tests/widgets/test_registry.h"
#include "widgets/calibrate/felt_panel.h"
#include "widgets/calibrate/motor_chart.h"
#include "widgets/calibrate/motor_table.h"
#include "widgets/calibrate/motors_view.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

using namespace teleta;
using namespace teleta::calibrate;
using motors::MotorCalibration;

namespace {

const simulated::SimulatedMotor kMotor{
    .rise_s = 0.024, .fall_s = 0.033, .start = 0.163, .fullSpeed_Hz = 250.0, .bend = 0.8};

BraceletFacts simulatedOne() {
    return {.name = QStringLiteral("Simulated bracelet"),
            .serial = QStringLiteral("simulated"),
            .ready = true,
            .simulated = true,
            .hasSensor = true,
            .speeds_Hz = std::nullopt};
}

struct Desk {
    Desk() {
        view.resize(1200, 800);
        view.show();
        active = QTest::qWaitForWindowActive(&view);
        MotorCalibration assumed;
        assumed.bracelet = "simulated";
        view.setCalibration(assumed);
        view.setFacts(simulatedOne());
        QObject::connect(&view, &MotorsView::calibrationChanged,
                         [this](const MotorCalibration& calibration) { changes.push_back(calibration); });
    }
    void fit(std::size_t motor) {
        const motors::MotorRecording recording = test::measured(kMotor, 1.0);
        view.takeFit(motor, recording, motors::fitMotor(recording));
    }
    [[nodiscard]] QString cell(int row, int column) const { return table->item(row, column)->text(); }
    [[nodiscard]] bool says(const char* words) const {
        for (const QLabel* label : view.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(QLatin1String(words)))
                return true;
        return false;
    }

    MotorsView view;
    MotorTable* table = view.findChild<MotorTable*>();
    bool active = false;
    std::vector<MotorCalibration> changes;
};

} // namespace

/// The steps of the calibration, as a person takes them.
class MotorsViewTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsMeasuredLooksSoAndKeepsItsNumberOrTheNameSomebodyGaveIt() {
        Desk desk;
        MotorCalibration own = desk.view.calibration();
        own.motors[1].profile.name = "left of the bone";
        desk.view.setCalibration(own);
        for (std::size_t motor = 0; motor < core::kTactors; ++motor) {
            desk.view.setMeasuring(motor, 0.9);
            QVERIFY(!desk.table->isEnabled());
            desk.fit(motor);
        }
        desk.view.setMeasuring(std::nullopt);
        QVERIFY(desk.table->isEnabled());
        for (int row = 0; row < int(core::kTactors); ++row) {
            QCOMPARE(desk.cell(row, 0),
                     row == 1 ? QString("left of the bone") : QString("Motor %1").arg(row + 1));
            for (int column = 0; column < desk.table->columnCount(); ++column)
                QCOMPARE(desk.table->item(row, column)->foreground().color(),
                         desk.table->palette().color(QPalette::Active, QPalette::Text));
        }
        QCOMPARE(desk.view.calibration().motors[0].profile.name, std::string());
        QCOMPARE(desk.view.calibration().motors[1].profile.name, std::string("left of the bone"));
    }

    void aMeasurementIsShownWhileItRuns() {
        Desk desk;
        auto* chart = desk.view.findChild<teleta::calibrate::MotorChart*>();
        QVERIFY(chart != nullptr);
        BraceletFacts facts = simulatedOne();
        facts.speeds_Hz = {0.0, 0.0, 120.0, 0.0, 0.0, 0.0};
        desk.view.setFacts(facts);
        for (int i = 1; i <= 20; ++i)
            desk.view.setMeasuring(2, 0.01 * i, 3, 6);
        QCOMPARE(chart->liveSpeeds(), std::size_t(20));
        QVERIFY(desk.says("3 of 6"));
        desk.view.setMeasuring(3, 0.0, 4, 6);
        QVERIFY(desk.says("4 of 6"));
        QCOMPARE(chart->liveSpeeds(), std::size_t(1)); // of the next one
        desk.view.setMeasuring(std::nullopt);
        QCOMPARE(chart->liveSpeeds(), std::size_t(0));
    }

    void whereThereIsLittleHeightTheCurvesStandBehindTheTable() {
        Desk desk;
        auto* chart = desk.view.findChild<MotorChart*>();
        auto* tabs = desk.view.findChild<QTabBar*>();
        QVERIFY(chart->isVisible() && desk.table->isVisible());
        QVERIFY(!tabs->isVisible());
        desk.view.resize(800, 420);
        QTRY_VERIFY(tabs->isVisible());
        QVERIFY(desk.table->isVisible());
        QVERIFY(!chart->isVisible());
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
        QTRY_VERIFY(chart->isVisible());
        QVERIFY2(chart->height() > desk.view.height() / 2, qPrintable(QString::number(chart->height())));
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(0).center());
        desk.view.setMeasuring(2, 0.1);
        QVERIFY2(chart->isVisible(), "what is measured is seen");
        desk.view.resize(1200, 800);
        QTRY_VERIFY(!tabs->isVisible());
        QVERIFY(chart->isVisible() && desk.table->isVisible());
    }

    void aLongStateIsCutAndToldByItsToolTip() {
        Desk desk;
        const int before = desk.view.minimumSizeHint().width();
        BraceletFacts weak = simulatedOne();
        weak.reserved = true;
        weak.strongest.fill(0.8);
        weak.strongest[1] = 0.9;
        desk.view.setFacts(weak);
        QVERIFY(desk.says("a study uses the bracelet"));
        QCOMPARE(desk.view.minimumSizeHint().width(), before);
    }

    void saysThatNothingIsCalibratedAndOffersWhatTheBraceletCan() {
        Desk desk;
        QVERIFY(desk.says("not calibrated"));
        QVERIFY(desk.says("SIMULATED"));
        QVERIFY(test::part(desk.view, "measure")->isEnabled());
        QVERIFY(!test::part(desk.view, "save")->isEnabled());
        BraceletFacts deaf = simulatedOne();
        deaf.hasSensor = false;
        desk.view.setFacts(deaf);
        QVERIFY(!test::part(desk.view, "measure")->isEnabled());
        QVERIFY(test::part(desk.view, "feel")->isEnabled());
        desk.view.setFacts({});
        QVERIFY(!test::part(desk.view, "feel")->isEnabled());
        QVERIFY(desk.says("No bracelet"));
    }

    void saysThatTheMotorsMayNotBeAsStrongAsTheyCan() {
        Desk desk;
        QVERIFY(!desk.says("Strongest"));
        BraceletFacts weak = simulatedOne();
        weak.strongest.fill(0.6);
        desk.view.setFacts(weak);
        QVERIFY(desk.says("Strongest, all motors: 60 %"));
        weak.strongest.fill(1.0);
        weak.strongest[3] = 0.25;
        desk.view.setFacts(weak);
        QVERIFY(desk.says("Strongest, motor 4: 25 %"));
        QVERIFY(!desk.says("all motors: "));
        desk.view.setFacts(simulatedOne());
        QVERIFY(!desk.says("Strongest"));
    }

    void takesAMeasurementShowsItAndUndoesIt() {
        Desk desk;
        QVERIFY(desk.active);
        desk.fit(3);
        QCOMPARE(desk.changes.size(), std::size_t(1));
        QCOMPARE(desk.table->selectedMotor(), std::size_t(3));
        QVERIFY(test::textOf(desk.view, "verdict").contains(QLatin1String("Motor 4")));
        const motors::CalibratedMotor& motor = desk.changes.back().motors[3];
        QVERIFY(std::abs(motor.profile.riseTime_s - test::rise90_s(kMotor)) < 5.0 * motor.riseError_s);
        QVERIFY(desk.cell(3, 6).contains(QLatin1String("measured")));
        QVERIFY(desk.cell(2, 6).contains(QLatin1String("assumed")));
        QVERIFY(desk.says("1 of 6 motors calibrated, not saved"));
        QVERIFY(test::part(desk.view, "save")->isEnabled());
        QTest::keyClick(desk.table, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.changes.size(), std::size_t(2));
        QVERIFY(!desk.view.calibration().measured());
        QVERIFY(desk.view.isSaved());
        QTest::mouseClick(test::part(desk.view, "redo"), Qt::LeftButton);
        QVERIFY(desk.view.calibration().measured());
        desk.view.markSaved();
        QVERIFY(desk.says("calibrated, saved"));
    }

    void saysWhyARecordingIsNoUseAndChangesNothing() {
        Desk desk;
        motors::MotorRecording recording = test::measured(kMotor, 1.0);
        std::ranges::fill(recording.speed_Hz, 0.0);
        desk.view.takeFit(0, recording, motors::fitMotor(recording));
        QVERIFY(desk.changes.empty());
        QVERIFY(test::textOf(desk.view, "verdict").contains(QLatin1String("does not turn")));
    }

    void asksForTheRecordingOfTheSelectedMotor() {
        Desk desk;
        QSignalSpy recordings(&desk.view, &MotorsView::recordingRequested);
        QSignalSpy measurements(&desk.view, &MotorsView::measureRequested);
        desk.table->selectMotor(4);
        QTest::mouseClick(test::part(desk.view, "recording"), Qt::LeftButton);
        QCOMPARE(recordings.size(), 1);
        QCOMPARE(recordings[0][0].value<std::size_t>(), std::size_t(4));
        QTest::mouseClick(test::part(desk.view, "measureAll"), Qt::LeftButton);
        QCOMPARE(measurements[0][0].value<std::vector<std::size_t>>().size(), std::size_t(6));
    }

    void findsAStartByFeelAndUndoesAnAnswerThenTheWhole() {
        Desk desk;
        QVERIFY(desk.active);
        QTest::mouseClick(test::part(desk.view, "feel"), Qt::LeftButton);
        auto* panel = desk.view.findChild<FeltPanel*>();
        QVERIFY(panel->isVisible());
        QVERIFY(!desk.table->isEnabled());
        QTest::keyClick(panel, Qt::Key_Space);
        QTest::keyClick(panel, Qt::Key_Y);
        QCOMPARE(panel->task()->answers(), 1);
        QTest::keyClick(panel, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(panel->task()->answers(), 0);
        QTest::keyClick(panel, Qt::Key_Space);
        for (int i = 0; i < 200 && panel->task() != nullptr; ++i) {
            const playback::Program program = panel->task()->presentation();
            QTest::keyClick(panel, program.evaluate(0.3)[0] > 0.3 ? Qt::Key_Y : Qt::Key_N);
        }
        QVERIFY(!panel->isVisible());
        QVERIFY(std::abs(desk.view.calibration().motors[0].profile.startDrive - 0.3) < 0.03);
        QVERIFY(desk.cell(0, 6).contains(QLatin1String("by feel")));
        QTest::mouseClick(test::part(desk.view, "undo"), Qt::LeftButton);
        QVERIFY(!desk.view.calibration().measured());
    }

    void answersLeaveWhatWasMeasuredMeanwhile() {
        Desk desk;
        desk.table->selectMotor(2);
        QTest::mouseClick(test::part(desk.view, "feel"), Qt::LeftButton);
        auto* panel = desk.view.findChild<FeltPanel*>();
        desk.fit(1); // its recording was being read when the questions began
        QTest::keyClick(panel, Qt::Key_Space);
        for (int i = 0; i < 200 && panel->task() != nullptr; ++i) {
            const playback::Program program = panel->task()->presentation();
            QTest::keyClick(panel, program.evaluate(0.3)[2] > 0.3 ? Qt::Key_Y : Qt::Key_N);
        }
        QVERIFY(panel->task() == nullptr);
        const auto& motors = desk.view.calibration().motors;
        QCOMPARE(motors[2].startFrom, motors::CalibratedMotor::Origin::answers);
        QCOMPARE(motors[1].startFrom, motors::CalibratedMotor::Origin::recording);
    }

    void anotherBraceletEndsTheQuestionsAboutTheOneBefore() {
        Desk desk;
        QTest::mouseClick(test::part(desk.view, "feel"), Qt::LeftButton);
        auto* panel = desk.view.findChild<FeltPanel*>();
        QTest::keyClick(panel, Qt::Key_Space);
        QTest::keyClick(panel, Qt::Key_Y);
        MotorCalibration other;
        other.bracelet = "TB-0042";
        desk.view.setCalibration(other);
        QVERIFY(panel->task() == nullptr);
        QVERIFY(!panel->isVisible());
        QVERIFY(desk.table->isEnabled());
        QCOMPARE(desk.view.calibration(), other);
    }

    void balancesByTheCurvesAndResets() {
        Desk desk;
        desk.fit(0);
        QVERIFY(!test::part(desk.view, "curves")->isEnabled());
        const motors::MotorRecording faster = test::measured(
            {.rise_s = 0.02, .fall_s = 0.03, .start = 0.2, .fullSpeed_Hz = 300.0, .bend = 1.0}, 0.5);
        desk.view.takeFit(1, faster, motors::fitMotor(faster));
        QTest::mouseClick(test::part(desk.view, "curves"), Qt::LeftButton);
        // 250 of 300 Hz on a straight curve.
        QVERIFY(std::abs(desk.view.calibration().motors[1].profile.fullDrive - 250.0 / 300.0) < 0.01);
        QTest::mouseClick(test::part(desk.view, "reset"), Qt::LeftButton);
        QVERIFY(!desk.view.calibration().measured());
        QCOMPARE(desk.view.calibration().bracelet, std::string("simulated"));
        QTest::mouseClick(test::part(desk.view, "undo"), Qt::LeftButton);
        QVERIFY(desk.view.calibration().measured());
    }

    void aProfileThatIsLoadedCanBeUndoneAndIsNotSavedAsTheBracelets() {
        Desk desk;
        desk.fit(3);
        const MotorCalibration measured = desk.view.calibration();
        MotorCalibration loaded = measured;
        loaded.motors[3].profile.startDrive = 0.31;
        desk.view.takeProfile(loaded);
        QCOMPARE(desk.changes.back(), loaded);
        QVERIFY(desk.says("not saved"));
        QTest::mouseClick(test::part(desk.view, "undo"), Qt::LeftButton);
        QCOMPARE(desk.changes.back(), measured);
    }

    void anotherBraceletIsAsItsFileHasItWhateverWasLoadedBefore() {
        Desk desk;
        MotorCalibration loaded;
        loaded.bracelet = "simulated";
        loaded.motors[0].startFrom = motors::CalibratedMotor::Origin::answers;
        desk.view.takeProfile(loaded);
        QVERIFY(!desk.view.isSaved());
        desk.view.setCalibration(MotorCalibration{}); // none is connected
        desk.view.setCalibration(loaded);             // as read from its file
        QVERIFY(desk.view.isSaved());
        QVERIFY(desk.says("calibrated, saved"));
    }

    void changesNoMotorOfABraceletThatAStudyUses() {
        Desk desk;
        desk.fit(0);
        desk.fit(1);
        const std::size_t before = desk.changes.size();
        BraceletFacts reserved = simulatedOne();
        reserved.ready = false;
        reserved.reserved = true;
        desk.view.setFacts(reserved);
        for (const char* name : {"undo", "redo", "load", "reset", "recording", "curves", "measure", "feel"})
            QVERIFY2(!test::part(desk.view, name)->isEnabled(), name);
        QVERIFY(desk.says("a study uses the bracelet"));
        QTest::keyClick(desk.table, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.changes.size(), before);
        // What is known may still be kept.
        QVERIFY(test::part(desk.view, "save")->isEnabled());
        desk.view.setFacts(simulatedOne());
        QVERIFY(test::part(desk.view, "reset")->isEnabled());
    }

    void locksTheStepsWhileItMeasures() {
        Desk desk;
        QSignalSpy cancelled(&desk.view, &MotorsView::cancelMeasureRequested);
        desk.view.setMeasuring(2, 0.3);
        QVERIFY(desk.says("Measuring motor 3"));
        QVERIFY(!desk.table->isEnabled());
        QTest::mouseClick(test::part(desk.view, "cancel"), Qt::LeftButton);
        QCOMPARE(cancelled.size(), 1);
        desk.view.setMeasuring(std::nullopt);
        QVERIFY(desk.table->isEnabled());
    }
};

namespace {
const test::Registration<MotorsViewTest> registration;
}
#include "motors_view_test.moc"
