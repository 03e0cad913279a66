// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/parts.h"
#include "tests/widgets/test_registry.h"
#include "widgets/calibrate/felt_panel.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace teleta;
using namespace teleta::calibrate;
using motors::MotorCalibration;

namespace {

/// A panel in an active window with a bracelet that can play.
struct Desk {
    Desk() {
        panel.show();
        active = QTest::qWaitForWindowActive(&panel);
        panel.setReady(true);
        QObject::connect(&panel, &FeltPanel::playRequested,
                         [this](const playback::Program& program) { played.push_back(program); });
        QObject::connect(&panel, &FeltPanel::finished,
                         [this](const MotorCalibration& calibration, const QString& text) {
                             result = calibration;
                             verdict = text;
                         });
    }
    /// The strongest drive of a motor in the newest presentation.
    [[nodiscard]] double drive(std::size_t motor) const {
        double highest = 0.0;
        for (double t_s = 0.0; t_s < played.back().duration_s; t_s += 0.01)
            highest = std::max(highest, played.back().evaluate(t_s)[motor]);
        return highest;
    }

    FeltPanel panel;
    bool active = false;
    std::vector<playback::Program> played;
    std::optional<MotorCalibration> result;
    QString verdict;
};

} // namespace

/// Asking a person what is felt, with real keys.
class FeltPanelTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheStartOfAPersonWhoAnswersByKeyboard() {
        Desk desk;
        QVERIFY(desk.active);
        desk.panel.begin(FeltTask::start({}, 2));
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        for (int i = 0; i < 200 && !desk.result; ++i) {
            QVERIFY(desk.played.back().raw);
            QCOMPARE(desk.drive(0), 0.0);
            QTest::keyClick(&desk.panel, desk.drive(2) >= 0.21 ? Qt::Key_Y : Qt::Key_N);
        }
        QVERIFY(desk.result.has_value());
        const motors::CalibratedMotor& motor = desk.result->motors[2];
        QVERIFY(std::abs(motor.profile.startDrive - 0.21) < 0.03);
        QVERIFY(motor.startError > 0.0);
        QVERIFY(!motor.profile.rangeAssumed);
        QVERIFY2(motor.profile.assumed, "its lag was not measured");
        QVERIFY(desk.verdict.contains(QLatin1String("Motor 3")));
        QVERIFY(desk.panel.task() == nullptr);
    }

    void countsNoAnswerBeforeSomethingWasPlayed() {
        Desk desk;
        desk.panel.begin(FeltTask::start({}, 0));
        QTest::keyClick(&desk.panel, Qt::Key_Y);
        QCOMPARE(desk.panel.task()->answers(), 0);
        QVERIFY(!test::part(desk.panel, "yes")->isEnabled());
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        QTest::keyClick(&desk.panel, Qt::Key_Right);
        QCOMPARE(desk.panel.task()->answers(), 1);
    }

    void takesAnswersBack() {
        Desk desk;
        desk.panel.begin(FeltTask::start({}, 0));
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        const double first = desk.drive(0);
        QTest::keyClick(&desk.panel, Qt::Key_Y);
        QVERIFY(desk.drive(0) < first);
        QTest::mouseClick(test::part(desk.panel, "undoAnswer"), Qt::LeftButton);
        QCOMPARE(desk.panel.task()->answers(), 0);
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        QCOMPARE(desk.drive(0), first);
        QTest::keyClick(&desk.panel, Qt::Key_Backspace);
        QCOMPARE(desk.panel.task()->answers(), 0);
    }

    void takesNoAnswerToWhatStopHasCutOff() {
        Desk desk;
        desk.panel.begin(FeltTask::start({}, 0));
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        desk.panel.setReady(false);
        QTest::keyClick(&desk.panel, Qt::Key_Y);
        desk.panel.setReady(true);
        QTest::keyClick(&desk.panel, Qt::Key_Y);
        QCOMPARE(desk.panel.task()->answers(), 0);
    }

    void saysWhenTheAnswersDoNotFitTogetherAndLetsThemBeTakenBack() {
        Desk desk;
        desk.panel.begin(FeltTask::start({}, 0));
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        for (int i = 0; i < 200 && !desk.panel.task()->done(); ++i)
            QTest::keyClick(&desk.panel, Qt::Key_N);
        QVERIFY(!desk.result);
        QVERIFY(desk.panel.task() != nullptr);
        QVERIFY(test::textOf(desk.panel, "question").contains(QLatin1String("contradict each other")));
        QVERIFY(!test::part(desk.panel, "play")->isEnabled());
        QVERIFY(test::part(desk.panel, "undoAnswer")->isEnabled());
        QTest::keyClick(&desk.panel, Qt::Key_Backspace);
        QVERIFY(test::part(desk.panel, "play")->isEnabled());
    }

    void balancesAllMotorsWithTheFirst() {
        Desk desk;
        desk.panel.begin(FeltTask::balance({}));
        QTest::keyClick(&desk.panel, Qt::Key_Space);
        const double reference = desk.drive(0);
        // Motor k is as strong as the reference at (1 + 0.05 k) times its drive.
        for (int i = 0; i < 400 && !desk.result; ++i) {
            const std::size_t motor = desk.panel.task()->motor();
            const double equal = reference * (1.0 + 0.05 * static_cast<double>(motor));
            QTest::keyClick(&desk.panel, desk.drive(motor) > equal ? Qt::Key_Y : Qt::Key_N);
        }
        QVERIFY(desk.result.has_value());
        // The weakest one, the last, keeps its full drive.
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            const double expected = (1.0 + 0.05 * static_cast<double>(i)) / 1.25;
            QVERIFY2(std::abs(desk.result->motors[i].profile.fullDrive - expected) < 0.06,
                     qPrintable(QString::number(desk.result->motors[i].profile.fullDrive)));
        }
    }

    void saysWhenSilenceMayBePlayedAndOnlyThen() {
        Desk desk;
        const auto says = [&](const char* words) {
            return std::ranges::any_of(desk.panel.findChildren<QLabel*>(), [&](const QLabel* label) {
                return label->text().contains(QLatin1String(words));
            });
        };
        desk.panel.begin(FeltTask::start({}, 0));
        QVERIFY(says("nothing is played"));
        desk.panel.begin(FeltTask::balance({}));
        QVERIFY(!says("nothing is played"));
        QVERIFY(!says("only when you are sure"));
        QVERIFY(says("Guess when you are not sure"));
    }

    void givingUpLeavesTheMotorsAsTheyWere() {
        Desk desk;
        QSignalSpy cancelled(&desk.panel, &FeltPanel::cancelled);
        desk.panel.begin(FeltTask::start({}, 0));
        QTest::mouseClick(test::part(desk.panel, "giveUp"), Qt::LeftButton);
        QCOMPARE(cancelled.size(), 1);
        QVERIFY(desk.panel.task() == nullptr);
        QVERIFY(!desk.result);
    }
};

namespace {
const test::Registration<FeltPanelTest> registration;
}
#include "felt_panel_test.moc"
