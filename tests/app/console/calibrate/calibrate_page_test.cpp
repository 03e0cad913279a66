// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/calibrate_page.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/motors/motor_file.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "tests/backend/motors/measured_motor.h"
#include "tests/widgets/parts.h"
#include "widgets/base/background.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/motor_table.h"
#include "widgets/calibrate/motors_view.h"
#include "widgets/calibrate/step_list.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTranslator>

#include <algorithm>
#include <cstdint>
#include <latch>
#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletService;
using console::CalibratePage;

/// The page on the console's own bracelet, simulated: its motors are unequal, and nobody has told the page
/// how.
class CalibratePageTest : public QObject {
    Q_OBJECT

    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    std::unique_ptr<console::SourceManager> m_sources;
    std::unique_ptr<CalibratePage> m_page;
    QTimer m_clock;
    QTemporaryDir m_folder;

    calibrate::MotorsView& view() { return m_page->motors().view(); }
    [[nodiscard]] QString chip(int step) const {
        return m_page->findChild<calibrate::StepList*>()->stateText(step);
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        base::applyTheme(base::ThemeChoice::light);
    }
    void init() {
        QFile::remove(QString::fromStdString(motors::profilePath("simulated")));
        m_stop.release();
        m_station = test::patientBracelet(m_stop);
        m_sources = std::make_unique<console::SourceManager>(m_stop);
        m_page = std::make_unique<CalibratePage>(*m_station, *m_sources);
        m_page->resize(1200, 800);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
        connect(&m_clock, &QTimer::timeout, m_page.get(), [this] {
            m_station->tick();
            m_page->tick();
        });
        m_clock.start(10);
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY(m_station->isReady());
        QTRY_VERIFY(test::part(view(), "measure")->isEnabled()); // the page is told with the next tick
    }
    void cleanup() {
        m_clock.stop();
        m_page.reset();
        m_sources.reset();
        m_station.reset();
        QFile::remove(QString::fromStdString(motors::profilePath("simulated")));
    }

    void theListOfPartsHasRowsThatAFingerHits() {
        const auto* parts = m_page->findChild<calibrate::StepList*>();
        QCOMPARE(parts->count(), 4);
        for (int row = 0; row < parts->count(); ++row)
            QVERIFY(parts->visualItemRect(parts->item(row)).height() >= base::em(parts, 2.0));
    }

    void aSimulatedBraceletIsNamedInTheLanguageOfNow() {
        const auto isSaid = [this](const QString& text) {
            return std::ranges::any_of(view().findChildren<QLabel*>(),
                                       [&](const QLabel* label) { return label->text() == text; });
        };
        QVERIFY(isSaid("Simulated bracelet"));
        struct French : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char*, const char* text, const char*, int) const override {
                return QLatin1String(text) == QLatin1String("Simulated bracelet")
                           ? QStringLiteral("Bracelet simul\u00e9")
                           : QString();
            }
        } translator;
        QCoreApplication::installTranslator(&translator);
        QTRY_VERIFY(isSaid(QStringLiteral("Bracelet simul\u00e9")));
        QCoreApplication::removeTranslator(&translator);
        QTRY_VERIFY(isSaid("Simulated bracelet"));
    }

    void measuresASimulatedMotorThroughThePlayerAndFindsWhatItHides() {
        QTest::mouseClick(test::part(view(), "measure"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            view().calibration().measured() || !test::textOf(view(), "verdict").isEmpty(), 60'000);
        QVERIFY2(view().calibration().measured(), qPrintable(test::textOf(view(), "verdict")));
        const auto truth = simulated::unequalMotors()[0];
        const motors::CalibratedMotor& motor = view().calibration().motors[0];
        QVERIFY(std::abs(motor.profile.startDrive - truth.start) < 0.03);
        // The drive that is read belongs to a frame up to a millisecond old.
        QVERIFY(std::abs(motor.profile.riseTime_s - test::rise90_s(truth)) < 0.01);
        QVERIFY(std::abs(motor.profile.curve.back().speed_Hz - truth.fullSpeed_Hz) < 3.0);
        QCOMPARE(m_station->calibration(), view().calibration());
    }

    void stopEndsAMeasurementAndSaysSo() {
        QTest::mouseClick(test::part(view(), "measureAll"), Qt::LeftButton);
        QTRY_VERIFY(m_station->playingPosition_s().value_or(0.0) > 0.1);
        QTRY_COMPARE(chip(0), QString("running: 1 of 6"));
        m_stop.engage();
        QTRY_VERIFY_WITH_TIMEOUT(test::textOf(view(), "verdict").contains(QLatin1String("STOP")), 10'000);
        QVERIFY(!view().calibration().measured());
        QVERIFY(!test::part(view(), "measure")->isEnabled());
        QTRY_COMPARE(chip(0), QString("failed"));
        m_stop.release();
        QTRY_VERIFY(test::part(view(), "measure")->isEnabled());
        m_station->choose(BraceletChoice::none);
        QTRY_COMPARE(chip(0), QString("to do"));
    }

    void afterAFailureTheStepStillSaysThatAMotorIsNotSaved() {
        motors::MotorCalibration measured = view().calibration();
        measured.motors[0].profile.startDrive = 0.21;
        measured.motors[0].startFrom = motors::CalibratedMotor::Origin::recording;
        view().takeProfile(measured);
        QTRY_COMPARE(chip(0), QString("not saved"));
        QTest::mouseClick(test::part(view(), "measureAll"), Qt::LeftButton);
        QTRY_COMPARE(chip(0), QString("running: 1 of 6"));
        m_stop.engage();
        QTRY_VERIFY_WITH_TIMEOUT(test::textOf(view(), "verdict").contains(QLatin1String("STOP")), 10'000);
        QTRY_COMPARE(chip(0), QString("not saved"));
    }

    void leavesABraceletAloneThatIsReserved() {
        m_station->reserve(true);
        QTRY_VERIFY(!test::part(view(), "measure")->isEnabled());
        QVERIFY(!test::part(view(), "feel")->isEnabled());
        emit view().measureRequested({0});
        QVERIFY(!test::part(view(), "cancel")->isVisibleTo(&view())); // no measurement began
        m_station->reserve(false);
        QTRY_VERIFY(test::part(view(), "measure")->isEnabled());
    }

    void aMeasurementThatWaitsForAThreadDoesNotBeginAfterStopOrInAReservedBracelet_data() {
        QTest::addColumn<bool>("reserved");
        QTest::newRow("STOP") << false;
        QTest::newRow("reserved") << true;
    }
    void aMeasurementThatWaitsForAThreadDoesNotBeginAfterStopOrInAReservedBracelet() {
        QFETCH(bool, reserved);
        QThreadPool& pool = base::backgroundPool();
        QVERIFY(pool.waitForDone(60'000));
        std::latch end(1);
        const int threads = pool.maxThreadCount();
        for (int i = 0; i < threads; ++i)
            pool.start([&end] { end.wait(); });
        QTest::mouseClick(test::part(view(), "measure"), Qt::LeftButton);
        const bool waits = test::part(view(), "cancel")->isVisibleTo(&view());
        if (reserved)
            m_station->reserve(true);
        else
            m_stop.engage();
        const bool refused =
            QTest::qWaitFor([this] { return !test::textOf(view(), "verdict").isEmpty(); }, 20'000);
        const QString verdict = test::textOf(view(), "verdict");
        const bool stillWaits = test::part(view(), "cancel")->isVisibleTo(&view());
        m_stop.release();
        end.count_down(); // whatever came out: the pool is everybody's
        QVERIFY(pool.waitForDone(60'000));
        QVERIFY(waits);
        QVERIFY(refused);
        QVERIFY(!stillWaits);
        QVERIFY2(verdict.contains(reserved ? QLatin1String("study") : QLatin1String("STOP")),
                 qPrintable(verdict));
        QCOMPARE(m_station->session()->player().counters().framesWritten, std::uint64_t{0});
        m_station->reserve(false);
    }

    void aChangedProfileReachesAReservedBraceletOnlyWhenItIsGivenBack() {
        m_station->reserve(true);
        motors::MotorCalibration full = m_station->calibration();
        for (motors::CalibratedMotor& motor : full.motors) {
            motor.profile.startDrive = 0.95;
            motor.profile.fullDrive = 1.0;
            motor.profile.rangeAssumed = false;
        }
        m_station->setCalibration(full);
        const auto drive = [&] {
            return static_cast<double>(m_station->session()->source().motorSpeeds()->drive[0]) /
                   core::kFullDrive;
        };
        m_station->session()->player().play(
            {.evaluate = [](double) { return core::Intensities{0.4}; }, .duration_s = 600.0});
        QTRY_VERIFY(drive() > 0.39);
        QTRY_VERIFY(m_station->playingPosition_s().value_or(0.0) > 0.3);
        QVERIFY(drive() < 0.41);
        m_station->reserve(false);
        QTRY_VERIFY(drive() > 0.96); // 0.95 + 0.4 * 0.05
    }

    void aPageThatIsClosedEndsItsMeasurement() {
        QTest::mouseClick(test::part(view(), "measureAll"), Qt::LeftButton);
        QTRY_VERIFY(m_station->playingPosition_s().value_or(0.0) > 0.1);
        m_page.reset();
        QTRY_VERIFY(!m_station->playingPosition_s());
    }

    void anotherBraceletEndsAMeasurement() {
        QTest::mouseClick(test::part(view(), "measure"), Qt::LeftButton);
        QTRY_VERIFY(m_station->playingPosition_s().has_value());
        m_station->choose(BraceletChoice::none);
        QTRY_VERIFY(!test::part(view(), "feel")->isEnabled());
        QVERIFY(!view().calibration().measured());
    }

    void keepsAProfileForTheBraceletAndUsesItTheNextTime() {
        const motors::MotorRecording recording =
            test::measured({.rise_s = 0.02, .fall_s = 0.03, .start = 0.25, .fullSpeed_Hz = 240.0}, 0.5);
        QFile file(m_folder.filePath("m.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(test::recordingText(recording)));
        file.close();
        m_page->motors().openRecording(5, m_folder.filePath("m.csv"));
        QTRY_VERIFY(view().calibration().measured());
        const motors::MotorCalibration measured = view().calibration();
        QTRY_COMPARE(chip(0), QString("not saved"));
        QTest::mouseClick(test::part(view(), "save"), Qt::LeftButton);
        QTRY_VERIFY(view().isSaved());
        QTRY_COMPARE(chip(0), QString("1 of 6 done"));
        QVERIFY(QFileInfo::exists(QString::fromStdString(motors::profilePath("simulated"))));
        m_station->choose(BraceletChoice::none);
        QTRY_VERIFY(!view().calibration().measured());
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY(view().calibration().measured());
        QCOMPARE(view().calibration(), measured);
        QVERIFY(view().isSaved());
    }

    void theStepOfTheCameraFollowsItsPairs() {
        QCOMPARE(chip(1), QString("to do"));
        m_page->camera().probe();
        QTRY_COMPARE(chip(1), QString("running"));
        QTRY_COMPARE_WITH_TIMEOUT(chip(1), QString("not saved"), 60'000);
        m_page->camera().savePairs(m_folder.filePath("pairs.csv"));
        QTRY_COMPARE(chip(1), QString("done"));
        m_page->camera().setPairs({m_page->camera().work().pairs.front()});
        QTRY_COMPARE(chip(1), QString("failed"));
    }

    void saysWhenARecordingOrAProfileIsOfNoUse() {
        QSignalSpy troubles(&m_page->motors(), &console::MotorCalibrator::trouble);
        m_page->motors().openRecording(0, m_folder.filePath("none.csv"));
        QTRY_VERIFY(test::textOf(view(), "verdict").contains(QLatin1String("none.csv")));
        motors::MotorCalibration other;
        other.bracelet = "TB-0042";
        QVERIFY(motors::writeMotors(other, m_folder.filePath("other.toml").toStdString()));
        m_page->motors().load(m_folder.filePath("other.toml"));
        QTRY_COMPARE(troubles.size(), 1);
        QVERIFY(troubles[0][1].toString().contains(QLatin1String("TB-0042")));
        QCOMPARE(m_page->messages().count(), 1);
    }

    void aGoodProfileMendsAStepThatFailed() {
        m_page->motors().openRecording(0, m_folder.filePath("none.csv"));
        QTRY_COMPARE(chip(0), QString("failed"));
        QVERIFY(motors::writeMotors(view().calibration(), m_folder.filePath("good.toml").toStdString()));
        m_page->motors().load(m_folder.filePath("good.toml"));
        QTRY_VERIFY(chip(0) != QString("failed"));
    }

    void aDamagedProfileIsReportedAndTheMotorsAreAssumed() {
        m_station->choose(BraceletChoice::none);
        const QString path = QString::fromStdString(motors::profilePath("simulated"));
        QDir().mkpath(QFileInfo(path).absolutePath());
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("format = \"teleta-motors\"\nversion = 1\nbracelet = \"simulated\"\n[[motor]\n");
        file.close();
        m_station->choose(BraceletChoice::simulated);
        QTRY_COMPARE(m_page->messages().count(), 1);
        QTRY_VERIFY(m_station->isReady());
        QVERIFY(!m_station->calibration().measured());
    }
};

QTEST_MAIN(CalibratePageTest)
#include "calibrate_page_test.moc"
