// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"
#include "backend/arm_model/tip_motion.h"
#include "backend/arm_model/urdf_reader.h"
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_arm.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/touch/jog/drive_sign.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/jog/joint_range.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

using namespace teleta;
using namespace teleta::touch;
using core::JointVector;

namespace {

/// A panel with an arm in an active window, beside a line that can take the focus from it.
struct Desk {
    Desk() {
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(panel);
        layout->addWidget(line);
        panel->setArm(test::sampleArm());
        core::JointSample sample;
        sample.angle_rad = {0.1, -0.2, 0.3, 1.5};
        panel->setSample(sample);
        panel->setDrive(core::ArmDrive::held);
        window.show();
        active = QTest::qWaitForWindowActive(&window);
        panel->setFocus();
    }
    void press(int key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyPress(panel, static_cast<Qt::Key>(key), modifiers);
    }
    void release(int key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyRelease(panel, static_cast<Qt::Key>(key), modifiers);
    }
    /// An arm of a URDF file of this repository; null: it cannot be read.
    std::shared_ptr<const arm_model::SerialChain> takeArm(const std::string& file) {
        const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/" + file);
        if (!model)
            return nullptr;
        const auto read = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                         "base_link", "tool0");
        if (!read)
            return nullptr;
        core::ArmDescription arm;
        arm.lowest_rad = read->lowest();
        arm.highest_rad = read->highest();
        arm.fastest_radPerS = read->fastest();
        const auto chain = std::make_shared<const arm_model::SerialChain>(*read);
        panel->setArm(arm, chain);
        return chain;
    }
    /// Shift and Q: the first joint turns up.
    void move() {
        press(Qt::Key_Shift);
        press(Qt::Key_Q, Qt::ShiftModifier);
    }
    [[nodiscard]] JointVector last() const { return requests.last()[0].value<JointVector>(); }
    [[nodiscard]] bool sentOneZeroAtTheEnd() const {
        return requests.size() >= 2 && last() == JointVector::zeros(4) &&
               requests[requests.size() - 2][0].value<JointVector>() != JointVector::zeros(4);
    }

    QWidget window;
    JogPanel* panel = new JogPanel(&window);
    QLineEdit* line = new QLineEdit(&window);
    QSignalSpy requests{panel, &JogPanel::jogRequested};
    bool active = false;
};

} // namespace

/// Moving the arm by hand, and above all not moving it.
class JogPanelTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsUnderTheMouseStaysWhenTheKeyboardComesAndGoes() {
        Desk desk;
        QVERIFY(desk.active);
        desk.window.resize(desk.window.minimumSizeHint().width(), desk.window.height());
        const auto* range = desk.panel->findChild<JointRange*>("range0");
        const auto place = [&] {
            QCoreApplication::processEvents();
            return range->mapTo(desk.panel, QPoint()).y();
        };
        QTest::mouseClick(desk.line, Qt::LeftButton);
        QVERIFY(desk.line->hasFocus());
        const int without = place();
        QTest::mouseClick(desk.panel, Qt::LeftButton, {}, QPoint(1, desk.panel->height() - 2));
        QVERIFY(desk.panel->hasFocus());
        QCOMPARE(place(), without);
        // With room in one line the hint takes no more than that.
        const int line = desk.panel->fontMetrics().height();
        desk.window.resize(80 * line, desk.window.height());
        QTRY_VERIFY2(place() < 5 * line, qPrintable(QString::number(place() / line)));
    }

    void aDirectionWithoutTheDeadManDoesNothing() {
        Desk desk;
        desk.press(Qt::Key_Q);
        QTest::mousePress(desk.panel->findChild<base::HoldButton*>("up1"), Qt::LeftButton);
        QVERIFY(!desk.panel->isMoving());
        QCOMPARE(desk.requests.size(), 0);
    }

    void anArmOfAFileHasTheNamesOfItsJointsAndItsTipMovesByItsGeometry() {
        Desk desk;
        QVERIFY(desk.active);
        const auto chain = desk.takeArm("tests/data/urdf/gripper.urdf");
        QVERIFY(chain);
        core::JointSample sample;
        const JointVector q{0.4, -1.1};
        sample.angle_rad = q;
        desk.panel->setSample(sample);
        QStringList names;
        for (const QLabel* label : desk.panel->findChildren<QLabel*>())
            names << label->text();
        QVERIFY(names.contains("shoulder") && names.contains("elbow"));

        // As its description says, whose numbers tip_motion_test checks; two links of 0.3 and 0.2 m cannot
        // keep the tip's direction, so it goes along x above all.
        desk.panel->setMode(JogPanel::Mode::tip);
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(desk.panel->isMoving());
        const double full = 0.2 * 0.25; // m/s: the panel begins with 20 %
        QCOMPARE(desk.last(),
                 arm_model::tipRates(*chain, q, {{full, 0.0, 0.0}, Eigen::Vector3d::Zero()}).rate);
        const double z2 = -0.2 * std::sin(q[0] + q[1]);
        const double z = -0.3 * std::sin(q[0]) + z2;
        QVERIFY(z * desk.last()[0] + z2 * desk.last()[1] > 0.1 * full);
        desk.release(Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(!desk.panel->isMoving());
    }

    /// An arm that is stretched out cannot move its tip along itself.
    void nearASingularityItSaysThatTheTipIsSlower() {
        Desk desk;
        QVERIFY(desk.active);
        QVERIFY(desk.takeArm("resources/arms/seven-joints.urdf"));
        desk.panel->setMode(JogPanel::Mode::tip);
        const auto* limits = desk.panel->findChild<QLabel*>("limits");
        const auto upFrom = [&](const JointVector& angle_rad) {
            core::JointSample sample;
            sample.angle_rad = sample.reference_rad = angle_rad;
            desk.panel->setSample(sample);
            desk.press(Qt::Key_Shift);
            desk.press(Qt::Key_E, Qt::ShiftModifier);
            desk.release(Qt::Key_E, Qt::ShiftModifier);
            desk.release(Qt::Key_Shift);
        };
        upFrom({0.0, 0.6, 0.0, -1.2, 0.0, 0.8, 0.0});
        QVERIFY(!limits->isVisible());
        upFrom(JointVector::zeros(7));
        QVERIFY(limits->isVisible());
        QCOMPARE(limits->text(), QStringLiteral("Near a singularity: slower."));
        // What is over leaves after a while.
        QTRY_VERIFY((desk.panel->setReport({}), !limits->isVisible()));
    }

    void whatIsInTheWayIsSaidAndTheArmMayStillBeAsked() {
        Desk desk;
        desk.panel->setHindrance("no controller reads /arm");
        const auto labels = desk.panel->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text() == "The arm does not move: no controller reads /arm.";
        }));
        QVERIFY(desk.panel->refusal().isEmpty());
        // A press is what clears a fault.
        desk.move();
        QVERIFY(desk.panel->isMoving());
        desk.panel->setHindrance({});
        QVERIFY(std::ranges::none_of(
            labels, [](const QLabel* label) { return label->text().contains("no controller"); }));
    }

    void aTipThatIsJoggedStopsWhenTheReadingsGetOldAndDoesNotGoOnByItself() {
        Desk desk;
        QVERIFY(desk.active);
        desk.panel->setMode(JogPanel::Mode::tip);
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(desk.panel->isMoving());
        desk.panel->setReadingsOld(true);
        QVERIFY(!desk.panel->isMoving());
        QVERIFY(desk.sentOneZeroAtTheEnd());
        QVERIFY(desk.panel->refusal().contains(QLatin1String("old")));
        QVERIFY2(desk.panel->findChild<QPushButton*>("hold")->isEnabled(), "holding the arm stays possible");
        desk.panel->setReadingsOld(false);
        QVERIFY(!desk.panel->isMoving());
        desk.press(Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(desk.panel->isMoving());
    }

    void theHandOnAMouseMovesTheTipWhileItsButtonIsHeld() {
        Desk desk;
        desk.panel->setHand(HandMotion{{1.0, 0.0, 0.0}, false});
        QVERIFY(!desk.panel->isMoving());
        desk.panel->setHand(HandMotion{{1.0, 0.0, 0.0}, true});
        QVERIFY(desk.panel->isMoving());
        const JointVector byHand = desk.last();
        desk.panel->setHand(std::nullopt);
        QVERIFY2(!desk.panel->isMoving(), "unplugged");
        QVERIFY(desk.sentOneZeroAtTheEnd());
        desk.panel->setMode(JogPanel::Mode::tip);
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_D, Qt::ShiftModifier);
        QCOMPARE(desk.last(), byHand);
    }

    void theHandIsWithoutEffectAfterStopAnotherArmOrAReplugUntilItsButtonWasLetGo_data() {
        QTest::addColumn<int>("event");
        QTest::newRow("stop") << 0;
        QTest::newRow("arm") << 1;
        QTest::newRow("replug") << 2;
        QTest::newRow("old readings") << 3;
    }
    void theHandIsWithoutEffectAfterStopAnotherArmOrAReplugUntilItsButtonWasLetGo() {
        QFETCH(int, event);
        Desk desk;
        const HandMotion held{{0.0, 0.5, 0.0}, true};
        desk.panel->setHand(HandMotion{});
        desk.panel->setHand(held);
        QVERIFY(desk.panel->isMoving());
        if (event == 0) {
            desk.panel->setStopEngaged(true);
            QVERIFY(!desk.panel->isMoving());
            desk.panel->setStopEngaged(false);
        } else if (event == 1) {
            desk.panel->setArm(std::nullopt);
            QVERIFY(!desk.panel->isMoving());
            desk.panel->setArm(test::sampleArm());
            core::JointSample sample;
            sample.angle_rad = {0.1, -0.2, 0.3, 1.5};
            desk.panel->setSample(sample);
        } else if (event == 2) {
            desk.panel->setHand(std::nullopt);
        } else {
            desk.panel->setReadingsOld(true);
            QVERIFY(!desk.panel->isMoving());
            desk.panel->setReadingsOld(false);
        }
        desk.panel->setHand(held);
        QVERIFY(!desk.panel->isMoving());
        desk.panel->setHand(HandMotion{});
        desk.panel->setHand(held);
        QVERIFY(desk.panel->isMoving());
    }

    void aPanelThatIsDestroyedWithTheFocusInItAsksForNothingAnyMore() {
        auto* window = new QWidget;
        auto* panel = new JogPanel(window);
        panel->setArm(test::sampleArm());
        window->show();
        QVERIFY(QTest::qWaitForWindowActive(window));
        auto* speed = panel->findChild<QSlider*>();
        speed->setFocus();
        QCOMPARE(QApplication::focusWidget(), speed);
        int requests = 0;
        connect(panel, &JogPanel::jogRequested, this, [&requests] { ++requests; });
        bool gone = false;
        // The last thing of a panel: its parts are destroyed after it, one of them with the focus.
        connect(panel, &QObject::destroyed, this, [&gone] { gone = true; });
        delete panel;
        QVERIFY(gone);
        QCOMPARE(requests, 0);
        delete window;
    }

    void aMenuThatOpensEndsTheMotionBecauseItGetsTheKeysFromThenOn() {
        Desk desk;
        QVERIFY(desk.active);
        desk.move();
        QVERIFY(desk.panel->isMoving());
        QMenu menu(&desk.window);
        menu.addAction(QStringLiteral("Any"));
        menu.popup(desk.window.mapToGlobal(QPoint(5, 5)));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        QCOMPARE(QApplication::activePopupWidget(), &menu);
        QVERIFY(!desk.panel->isMoving());
        QVERIFY(desk.sentOneZeroAtTheEnd());
        menu.close();
        QTest::qWait(0);
        QVERIFY(!desk.panel->isMoving());
    }

    void theDeadManWithoutADirectionDoesNothing() {
        Desk desk;
        desk.press(Qt::Key_Shift);
        QTest::mousePress(desk.panel->findChild<base::HoldButton*>("deadMan"), Qt::LeftButton);
        QVERIFY(!desk.panel->isMoving());
        QCOMPARE(desk.requests.size(), 0);
    }

    void bothTogetherTurnTheJointWithTheChosenShareOfItsSpeed() {
        Desk desk;
        desk.panel->setSpeed(50);
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_F, Qt::ShiftModifier); // elbow down
        QCOMPARE(desk.last(), (JointVector{0.0, 0.0, 0.0, -0.8}));
        desk.press(Qt::Key_W, Qt::ShiftModifier); // and shoulder pitch up
        QCOMPARE(desk.last(), (JointVector{0.0, 0.6, 0.0, -0.8}));
    }

    void shiftAndAButtonMoveToo() {
        Desk desk;
        desk.panel->setSpeed(100);
        QTest::mousePress(desk.panel->findChild<base::HoldButton*>("up2"), Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(desk.last(), (JointVector{0.0, 0.0, 1.4, 0.0}));
        QVERIFY(desk.panel->hasFocus());
        QTest::keyRelease(desk.panel, Qt::Key_Shift);
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void theButtonOnTheScreenIsADeadManForTheKeys() {
        Desk desk;
        QTest::mousePress(desk.panel->findChild<base::HoldButton*>("deadMan"), Qt::LeftButton);
        desk.press(Qt::Key_Q);
        QVERIFY(desk.panel->isMoving());
        QTest::mouseRelease(desk.panel->findChild<base::HoldButton*>("deadMan"), Qt::LeftButton);
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void lettingGoOfEitherSendsOneZeroAtOnce() {
        for (const int released : {int(Qt::Key_Shift), int(Qt::Key_Q)}) {
            Desk desk;
            desk.move();
            QCOMPARE(desk.requests.size(), 1);
            desk.release(released, released == Qt::Key_Q ? Qt::ShiftModifier : Qt::NoModifier);
            QCOMPARE(desk.requests.size(), 2);
            QVERIFY(desk.sentOneZeroAtTheEnd());
        }
    }

    void theRequestIsRepeatedWhileHeldAndNotAfterwards() {
        Desk desk;
        desk.move();
        QTRY_VERIFY(desk.requests.size() >= 4);
        for (const auto& request : desk.requests)
            QCOMPARE(request[0].value<JointVector>(), (JointVector{0.2, 0.0, 0.0, 0.0}));
        desk.release(Qt::Key_Shift);
        const auto sent = desk.requests.size();
        QVERIFY(!desk.requests.wait(4 * JogPanel::kPeriod_ms));
        QCOMPARE(desk.requests.size(), sent);
    }

    void repeatedKeysOfTheKeyboardChangeNothing() {
        Desk desk;
        desk.move();
        QKeyEvent up(QEvent::KeyRelease, Qt::Key_Q, Qt::ShiftModifier, QString(), true);
        QKeyEvent down(QEvent::KeyPress, Qt::Key_Q, Qt::ShiftModifier, QString(), true);
        QApplication::sendEvent(desk.panel, &up);
        QApplication::sendEvent(desk.panel, &down);
        QCOMPARE(desk.requests.size(), 1);
        QVERIFY(desk.panel->isMoving());
    }

    void losingTheFocusStops() {
        Desk desk;
        QVERIFY(desk.active);
        desk.move();
        desk.line->setFocus();
        QVERIFY(desk.sentOneZeroAtTheEnd());
        desk.panel->setFocus();
        QVERIFY(!desk.panel->isMoving());
    }

    void anotherWindowStops() {
        Desk desk;
        desk.move();
        QWidget other;
        other.show();
        QApplication::setActiveWindow(&other);
        QVERIFY(QTest::qWaitForWindowActive(&other));
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void hidingStops() {
        Desk desk;
        desk.move();
        desk.panel->hide();
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void destroyingStops() {
        Desk desk;
        desk.move();
        delete desk.panel;
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void aMouseThatLeavesTheButtonStopsAndItsReturnMovesNothing() {
        Desk desk;
        base::HoldButton* button = desk.panel->findChild<base::HoldButton*>("up0");
        QTest::mousePress(button, Qt::LeftButton, Qt::ShiftModifier, button->rect().center());
        QVERIFY(desk.panel->isMoving());
        const auto dragTo = [&](const QPoint& point) {
            QMouseEvent event(QEvent::MouseMove, point, button->mapToGlobal(point), Qt::NoButton,
                              Qt::LeftButton, Qt::ShiftModifier);
            QApplication::sendEvent(button, &event);
        };
        dragTo(QPoint(-5, 5));
        QVERIFY(desk.sentOneZeroAtTheEnd());
        dragTo(button->rect().center());
        QVERIFY(!desk.panel->isMoving());
    }

    void stopTakesEverythingBackAndSaysWhy() {
        Desk desk;
        desk.move();
        desk.panel->setStopEngaged(true);
        QVERIFY(desk.sentOneZeroAtTheEnd());
        QVERIFY(desk.panel->refusal().contains("STOP"));
        QVERIFY(!desk.panel->findChild<base::HoldButton*>("deadMan")->isEnabled());
        desk.move();
        QVERIFY(!desk.panel->isMoving());
        desk.panel->setStopEngaged(false);
        QVERIFY(desk.panel->refusal().isEmpty());
        QVERIFY(!desk.panel->isMoving());
    }

    void withoutAnArmItSaysWhyItCannot() {
        Desk desk;
        desk.move();
        desk.panel->setArm(std::nullopt);
        QVERIFY(desk.sentOneZeroAtTheEnd());
        QVERIFY(desk.panel->refusal().contains("No arm"));
        QVERIFY(!desk.panel->findChild<base::HoldButton*>("up0")->isEnabled());
        desk.move();
        QVERIFY(!desk.panel->isMoving());
    }

    void anArmThatWasRecordedCannotBeMovedAndThePanelSaysWhy() {
        Desk desk;
        core::ArmDescription arm = test::sampleArm();
        arm.recorded = true;
        desk.panel->setArm(arm);
        QVERIFY(desk.panel->refusal().contains("recording"));
        const auto buttons = desk.panel->findChildren<QAbstractButton*>();
        QVERIFY(buttons.size() > 8);
        for (const QAbstractButton* button : buttons)
            QVERIFY2(!button->isEnabled(), qPrintable(button->text()));
        desk.move();
        QVERIFY(!desk.panel->isMoving());
        QCOMPARE(desk.requests.size(), 0);
        desk.panel->setArm(test::sampleArm());
        QVERIFY(desk.panel->findChild<base::HoldButton*>("up0")->isEnabled());
    }

    void anArmOfSevenJointsHasButtonsAndKeysForEach() {
        Desk desk;
        core::ArmDescription arm = test::sampleArm();
        arm.lowest_rad = JointVector{-1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0};
        arm.highest_rad = arm.fastest_radPerS = JointVector{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        desk.panel->setMode(JogPanel::Mode::tip);
        desk.panel->setArm(arm);
        QVERIFY2(desk.panel->mode() == JogPanel::Mode::joints, "its tip cannot be moved");
        QVERIFY(desk.panel->findChild<JointRange*>("range6")->isVisible());
        QVERIFY(desk.panel->findChild<base::HoldButton*>("up6")->isVisible());
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_U, Qt::ShiftModifier);
        QCOMPARE(desk.last(), (JointVector{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2}));
        desk.release(Qt::Key_Shift);
        QCOMPARE(desk.last(), JointVector::zeros(7));
        desk.panel->setArm(test::sampleArm());
        QVERIFY(!desk.panel->findChild<JointRange*>("range6")->isVisible());
        QVERIFY(!desk.panel->findChild<base::HoldButton*>("up6")->isVisible());
    }

    void theTipMovesAlongTheAxesOfTheBase() {
        Desk desk;
        desk.panel->setMode(JogPanel::Mode::tip);
        QVERIFY(!desk.panel->findChild<base::HoldButton*>("up3")->isVisible());
        desk.press(Qt::Key_Shift);
        desk.press(Qt::Key_E, Qt::ShiftModifier); // z
        QVERIFY(desk.panel->isMoving());
        QVERIFY(std::abs(desk.last()[1]) + std::abs(desk.last()[3]) > 0.01);
        desk.panel->setMode(JogPanel::Mode::joints);
        QVERIFY(desk.sentOneZeroAtTheEnd());
    }

    void theProgramIsRunHeldAndRestarted() {
        Desk desk;
        QSignalSpy runs(desk.panel, &JogPanel::programRunRequested);
        QSignalSpy restarts(desk.panel, &JogPanel::programRestartRequested);
        QTest::mouseClick(desk.panel->findChild<QPushButton*>("run"), Qt::LeftButton);
        QTest::mouseClick(desk.panel->findChild<QPushButton*>("hold"), Qt::LeftButton);
        QTest::mouseClick(desk.panel->findChild<QPushButton*>("restart"), Qt::LeftButton);
        QCOMPARE(runs.size(), 2);
        QCOMPARE(runs[0][0].toBool(), true);
        QCOMPARE(runs[1][0].toBool(), false);
        QCOMPARE(restarts.size(), 1);
        core::ArmDescription plain = test::sampleArm();
        plain.hasProgram = false;
        desk.panel->setArm(plain);
        QVERIFY(!desk.panel->findChild<QPushButton*>("run")->isEnabled());
    }

    void anglesAreInDegreesAndTheEndOfTheRangeIsNamed() {
        Desk desk;
        QVERIFY2(desk.panel->findChild<touch::JointRange*>("range0")->text().contains("5.7"),
                 qPrintable(desk.panel->findChild<touch::JointRange*>("range0")->text()));
        QVERIFY(!desk.panel->findChild<touch::JointRange*>("range0")->atLimit());
        core::JointSample sample;
        sample.angle_rad = {1.5, 0.0, 0.0, 1.0};
        desk.panel->setSample(sample);
        QVERIFY(desk.panel->findChild<touch::JointRange*>("range0")->text().endsWith("limit"));
    }

    void saysThatTheKeysNeedAClickFirst() {
        Desk desk;
        QVERIFY(desk.active);
        const auto says = [&](const char* words) {
            const auto labels = desk.panel->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
                return label->isVisible() && label->text().contains(QLatin1String(words));
            });
        };
        QVERIFY(says("Hold Shift") && !says("Click here first"));
        QTest::mouseClick(desk.line, Qt::LeftButton);
        QVERIFY(says("Click here first") && says("Hold Shift"));
        QTest::mouseClick(desk.panel, Qt::LeftButton);
        QVERIFY(says("Hold Shift") && !says("Click here first"));
    }

    void theTipIsShownInMillimetresWhereItIsMoved() {
        Desk desk;
        desk.panel->setMode(JogPanel::Mode::tip);
        core::JointSample sample;
        sample.angle_rad = {0.1, -0.2, 0.3, 1.5};
        desk.panel->setSample(sample);
        const core::ArmDescription sampled = test::sampleArm();
        const arm::Arm4Kinematics kinematics({.upperArmLength_m = sampled.upperArmLength_m,
                                              .forearmLength_m = sampled.forearmLength_m,
                                              .halfThickness_m = sampled.halfThickness_m});
        const Eigen::Vector3d tip_m =
            kinematics.X_Base_Link(arm::Link::forearm, arm::JointVector(0.1, -0.2, 0.3, 1.5)) *
            Eigen::Vector3d(sampled.forearmLength_m, 0.0, 0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const auto* place = desk.panel->findChild<QLabel*>(QStringLiteral("place%1").arg(axis));
            QVERIFY(place->isVisible());
            QVERIFY2(place->text().contains(QString::number(std::abs(1e3 * tip_m[axis]), 'f', 1)),
                     qPrintable(place->text()));
        }
        QVERIFY(!desk.panel->findChild<touch::JointRange*>("range0")->isVisible());
        desk.panel->setMode(JogPanel::Mode::joints);
        QVERIFY(desk.panel->findChild<touch::JointRange*>("range3")->isVisible());
        QVERIFY(!desk.panel->findChild<QLabel*>("place0")->isVisible());
    }

    void theDriveIsAWord() {
        Desk desk;
        auto* sign = desk.panel->findChild<DriveSign*>();
        QCOMPARE(sign->text(), QString("held"));
        desk.panel->setDrive(core::ArmDrive::stopped);
        QCOMPARE(sign->text(), QString("stopped"));
        desk.panel->setArm(std::nullopt);
        QCOMPARE(sign->text(), QString("no arm"));
    }
};

namespace {
const test::Registration<JogPanelTest> registration;
}
#include "jog_panel_test.moc"
