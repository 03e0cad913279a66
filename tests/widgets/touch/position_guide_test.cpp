// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/jog_rates.h"
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_arm.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/jog/position_guide.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>

using namespace teleta;
using namespace teleta::touch;
using Eigen::Vector3d;

namespace {

constexpr double kFast_mPerS = 0.25;
constexpr double kPeriod_s = 0.001;

/// A tip that does what it is told.
struct Tip {
    Vector3d at_m{0.3, 0.1, -0.2};

    void follow(PositionGuide& guide, double duration_s, bool held, bool clutch, const Vector3d& hand_m) {
        for (int i = 0; i < std::lround(duration_s / kPeriod_s); ++i)
            at_m += kPeriod_s * guide.velocity_mPerS(held, clutch, hand_m, at_m, kFast_mPerS);
    }
};

/// A panel whose arm goes where it is told at once, in steps of the panel's period.
struct Follower {
    Follower() {
        panel.setArm(test::sampleArm());
        sample.angle_rad = sample.reference_rad = {0.1, -0.2, 0.3, 1.5};
        panel.setSample(sample);
        panel.setDrive(core::ArmDrive::held);
        panel.setMode(JogPanel::Mode::tip);
        panel.setWay(JogPanel::Way::position);
        panel.setSpeed(100);
        panel.show();
        active = QTest::qWaitForWindowActive(&panel);
        panel.setFocus();
    }
    /// While Shift is held; QTest's own would let go of it with the key.
    void key(QEvent::Type type, Qt::Key key) {
        QKeyEvent event(type, key, Qt::ShiftModifier);
        QCoreApplication::sendEvent(&panel, &event);
    }
    void click(Qt::Key key) {
        this->key(QEvent::KeyPress, key);
        this->key(QEvent::KeyRelease, key);
    }
    [[nodiscard]] Vector3d tip() const { return arm::tipPosition(test::sampleArm(), sample.reference_rad); }
    /// Looks at the hand as the console does, and moves.
    void look(const HandMotion& hand, int looks) {
        for (int i = 0; i < looks; ++i) {
            panel.setHand(hand);
            for (std::size_t joint = 0; joint < sample.reference_rad.size(); ++joint)
                sample.reference_rad[joint] += 0.033 * panel.rate_radPerS()[joint];
            panel.setSample(sample);
        }
    }
    /// Takes hold with the mouse and leads the tip up by a share of the full step. Returns where it then is.
    Vector3d leadByMouse(double share) {
        look({}, 1);
        look({{0, 0, 0}, true, false}, 1);
        look({{0, 0, share}, true, false}, 200);
        return tip();
    }

    JogPanel panel;
    core::JointSample sample;
    bool active = false;
};

} // namespace

/// Leading the tip by position, with a clutch.
class PositionGuideTest : public QObject {
    Q_OBJECT

private slots:
    void theTipGoesAsFarAsTheHandFromWhereItWasTakenHoldOf() {
        PositionGuide guide;
        Tip tip;
        const Vector3d start_m = tip.at_m;
        const Vector3d hand_m(0.5, 0.5, 0.5); // where a hand takes hold does not matter
        tip.follow(guide, 0.1, true, false, hand_m);
        QVERIFY(tip.at_m == start_m);
        tip.follow(guide, 4.0, true, false, hand_m + Vector3d(0.02, 0.0, -0.01));
        QVERIFY((tip.at_m - start_m - Vector3d(0.02, 0.0, -0.01)).norm() < 2 * PositionGuide::kArrived_m);
    }

    void theSpeedIsLimitedAndFallsOffNearTheAim() {
        PositionGuide guide;
        const Vector3d tip_m(0.3, 0.0, 0.0);
        (void)guide.velocity_mPerS(true, false, Vector3d::Zero(), tip_m, kFast_mPerS);
        const auto speedFor = [&](double hand_m) {
            return guide.velocity_mPerS(true, false, Vector3d(hand_m, 0, 0), tip_m, kFast_mPerS).x();
        };
        QCOMPARE(speedFor(1.0), kFast_mPerS);
        QCOMPARE(speedFor(0.01), 0.01 * PositionGuide::kGain_perS);
        QCOMPARE(speedFor(-0.01), -0.01 * PositionGuide::kGain_perS);
        QCOMPARE(speedFor(0.5 * PositionGuide::kArrived_m), 0.0);
    }

    void aTipThatIsSeenLateIsLedMoreSlowlyAndDoesNotSwing_data() {
        QTest::addColumn<double>("there_s");
        QTest::addColumn<double>("back_s");
        QTest::newRow("young readings") << 0.03 << 0.0;
        QTest::newRow("old readings") << 0.0 << 0.45;
        QTest::newRow("commands are late, too") << 0.45 << 0.45;
    }
    void aTipThatIsSeenLateIsLedMoreSlowlyAndDoesNotSwing() {
        QFETCH(double, there_s);
        QFETCH(double, back_s);
        constexpr double kWay_m = 0.05;
        PositionGuide guide;
        // A plant that takes what it is told after there_s and is seen after back_s.
        std::deque<double> told(static_cast<std::size_t>(std::lround(there_s / kPeriod_s)), 0.0);
        std::deque<double> seen(static_cast<std::size_t>(std::lround(back_s / kPeriod_s)), 0.0);
        double x_m = 0.0;
        double furthest_m = 0.0;
        double hand_m = 0.0; // takes hold first
        for (int i = 0; i < 40'000; ++i) {
            seen.push_back(x_m);
            const Vector3d tip_m(seen.front(), 0.0, 0.0);
            seen.pop_front();
            told.push_back(
                guide.velocity_mPerS(true, false, Vector3d(hand_m, 0, 0), tip_m, kFast_mPerS, back_s).x());
            x_m += kPeriod_s * told.front();
            told.pop_front();
            furthest_m = std::max(furthest_m, x_m);
            hand_m = kWay_m;
        }
        QVERIFY2(furthest_m < kWay_m + PositionGuide::kArrived_m, qPrintable(QString::number(furthest_m)));
        QVERIFY(std::abs(x_m - kWay_m) < 2 * PositionGuide::kArrived_m);
    }

    void thePanelLeadsTheMoreSlowlyTheOlderItsReadingsAre() {
        Follower arm;
        QVERIFY(arm.active);
        const auto fastest = [&] {
            double rate = 0.0;
            for (const double each : arm.panel.rate_radPerS())
                rate = std::max(rate, std::abs(each));
            return rate;
        };
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        arm.click(Qt::Key_D);
        arm.look({}, 1);
        const double young = fastest();
        QVERIFY(young > 0.0);
        arm.panel.setReadingsAge(0.45);
        arm.look({}, 1);
        QVERIFY(fastest() > 0.0);
        QVERIFY(fastest() < 0.2 * young);
    }

    void theClutchLetsTheHandGoBackWithoutTheTip() {
        PositionGuide guide;
        Tip tip;
        const Vector3d start_m = tip.at_m;
        for (int stroke = 0; stroke < 3; ++stroke) {
            tip.follow(guide, 0.01, true, false, Vector3d::Zero());
            tip.follow(guide, 4.0, true, false, Vector3d(0.03, 0.0, 0.0));
            const Vector3d there_m = tip.at_m;
            tip.follow(guide, 1.0, true, true, Vector3d(0.01, 0.0, 0.0));
            QVERIFY(tip.at_m == there_m);
        }
        QVERIFY(std::abs(tip.at_m.x() - start_m.x() - 0.09) < 1e-3);
    }

    void stepsOfATipThatCannotFollowAreNotSavedUp() {
        PositionGuide guide;
        Tip tip;
        const Vector3d start_m = tip.at_m;
        for (int i = 0; i < 10; ++i) { // the tip leans on something
            (void)guide.velocity_mPerS(true, false, Vector3d::Zero(), tip.at_m, kFast_mPerS);
            guide.step(Vector3d(0.05, 0.0, 0.0));
        }
        guide.step(Vector3d(0.0, 0.0, 0.0));
        tip.follow(guide, 4.0, true, false, Vector3d::Zero()); // which yields
        QVERIFY(std::abs((tip.at_m - start_m).x() - PositionGuide::kLongestLead_m) <
                2 * PositionGuide::kArrived_m);
        // The first step back counts at once.
        for (int i = 0; i < 10; ++i)
            guide.step(Vector3d(0.05, 0.0, 0.0));
        guide.step(Vector3d(-0.05, 0.0, 0.0));
        tip.follow(guide, 4.0, true, false, Vector3d::Zero());
        QVERIFY(std::abs((tip.at_m - start_m).x() - 1.5 * PositionGuide::kLongestLead_m) <
                4 * PositionGuide::kArrived_m);
    }

    void lettingGoAndNumbersThatAreNoneStandStill() {
        PositionGuide guide;
        const Vector3d tip_m = Vector3d::Zero();
        const Vector3d far_m(0.1, 0.0, 0.0);
        (void)guide.velocity_mPerS(true, false, Vector3d::Zero(), tip_m, kFast_mPerS);
        QVERIFY(guide.isHeld());
        QVERIFY(guide.velocity_mPerS(false, false, far_m, tip_m, kFast_mPerS).isZero());
        QVERIFY(!guide.isHeld());
        const double nan = std::numeric_limits<double>::quiet_NaN();
        (void)guide.velocity_mPerS(true, false, Vector3d::Zero(), tip_m, kFast_mPerS);
        QVERIFY(guide.velocity_mPerS(true, false, Vector3d(nan, 0, 0), tip_m, kFast_mPerS).isZero());
        QVERIFY(guide.velocity_mPerS(true, false, far_m, Vector3d(nan, 0, 0), kFast_mPerS).isZero());
        guide.step(far_m); // of nobody's hold
        QVERIFY(guide.velocity_mPerS(true, false, far_m, tip_m, kFast_mPerS).isZero());
    }

    void aKeyIsAStepOfTheTipWhileTheDeadManIsHeld() {
        Follower arm;
        QVERIFY(arm.active);
        QTest::keyClick(&arm.panel, Qt::Key_D);
        QVERIFY2(!arm.panel.isMoving(), "without the dead man");
        const Vector3d start_m = arm.tip();
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        arm.click(Qt::Key_D);
        QVERIFY2(arm.panel.isMoving(), "also after the key was let go: it is a step");
        arm.look({}, 200);
        const Vector3d moved_m = arm.tip() - start_m;
        QVERIFY2(std::abs(moved_m.x() - JogPanel::kFullStep_m) < 1e-3,
                 qPrintable(QString::number(moved_m.x())));
        QVERIFY(!arm.panel.isMoving());
        arm.click(Qt::Key_W);
        QVERIFY(arm.panel.isMoving());
        QTest::keyRelease(&arm.panel, Qt::Key_Shift);
        QVERIFY2(!arm.panel.isMoving(), "the dead man ends the step");
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        QVERIFY2(!arm.panel.isMoving(), "and it does not go on by itself");
    }

    void theSliderIsTheLengthOfAStepAndSaysSo() {
        Follower arm;
        QVERIFY(arm.active);
        const auto says = [&](const QString& text) {
            return std::ranges::any_of(arm.panel.findChildren<QLabel*>(), [&](const QLabel* label) {
                return label->text().replace(QChar(0x00a0), u' ') == text;
            });
        };
        arm.panel.setSpeed(20);
        QVERIFY(says("10.0 mm"));
        const Vector3d start_m = arm.tip();
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        arm.click(Qt::Key_A);
        arm.click(Qt::Key_A);
        arm.look({}, 200);
        QVERIFY(std::abs((arm.tip() - start_m).x() + 0.02) < 1e-3);
        arm.panel.setWay(JogPanel::Way::velocity);
        QVERIFY(says("20 %"));
        QVERIFY(!says("10.0 mm"));
    }

    void theClutchKeyAndStopStandStillAndGiveUpTheRest() {
        Follower arm;
        QVERIFY(arm.active);
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        arm.click(Qt::Key_D);
        QVERIFY(arm.panel.isMoving());
        arm.key(QEvent::KeyPress, Qt::Key_C);
        QVERIFY2(!arm.panel.isMoving(), "clutch");
        arm.key(QEvent::KeyRelease, Qt::Key_C);
        QVERIFY(!arm.panel.isMoving());
        arm.click(Qt::Key_D);
        QVERIFY(arm.panel.isMoving());
        arm.panel.setStopEngaged(true);
        QVERIFY2(!arm.panel.isMoving(), "STOP wins");
        arm.click(Qt::Key_D);
        QVERIFY(!arm.panel.isMoving());
        arm.panel.setStopEngaged(false);
        QVERIFY(!arm.panel.isMoving());
    }

    void aMouseLeadsTheTipAndItsSecondButtonIsTheClutch() {
        Follower arm;
        const Vector3d start_m = arm.tip();
        arm.look({{0, 0, 0}, false, false}, 1);
        arm.look({{0, 0, 0}, true, false}, 1);
        arm.look({{0, 0, 1.0}, true, false}, 200);
        QVERIFY(std::abs((arm.tip() - start_m).z() - JogPanel::kFullStep_m) < 1e-3);
        QVERIFY(!arm.panel.isMoving());
        arm.look({{0, 0, 0}, true, true}, 20);
        QVERIFY(std::abs((arm.tip() - start_m).z() - JogPanel::kFullStep_m) < 1e-3);
        arm.look({{0, 0, 0}, true, false}, 1);
        arm.look({{0, 0, 1.0}, true, false}, 200);
        QVERIFY(std::abs((arm.tip() - start_m).z() - 2.0 * JogPanel::kFullStep_m) < 2e-3);
        arm.look({{1.0, 0, 0}, false, false}, 5);
        QVERIFY2(!arm.panel.isMoving(), "the dead man");
    }

    void theKeysTakeOverFromTheMouseAndGiveBackWhereTheTipIs() {
        Follower arm;
        const Vector3d there_m = arm.leadByMouse(0.6);
        const HandMotion still{{0, 0, 0.6}, true, false};
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        QVERIFY2(!arm.panel.isMoving(), "not back to where the mouse took hold");
        arm.look(still, 50);
        QVERIFY(arm.tip() == there_m);
        arm.click(Qt::Key_D);
        arm.look(still, 200);
        const Vector3d aside_m = arm.tip();
        QVERIFY(std::abs((aside_m - there_m).x() - JogPanel::kFullStep_m) < 1e-3);
        QTest::keyRelease(&arm.panel, Qt::Key_Shift);
        QVERIFY2(!arm.panel.isMoving(), "nor out to where it was led before");
        arm.look(still, 50);
        QVERIFY(arm.tip() == aside_m);
        arm.look({{0, 0, 0.8}, true, false}, 200);
        QVERIFY2(std::abs((arm.tip() - aside_m).z() - 0.2 * JogPanel::kFullStep_m) < 1e-3,
                 "from there the mouse leads on");
    }

    void aJointThatIsJoggedBetweenIsNotDrivenBackByTheMouse() {
        Follower arm;
        arm.panel.setMode(JogPanel::Mode::joints);
        (void)arm.leadByMouse(0.6);
        const HandMotion still{{0, 0, 0.6}, true, false};
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        QVERIFY(!arm.panel.isMoving());
        const double before_rad = arm.sample.reference_rad[0];
        arm.key(QEvent::KeyPress, Qt::Key_Q);
        arm.look(still, 10);
        QVERIFY(arm.sample.reference_rad[0] > before_rad + 0.1);
        arm.key(QEvent::KeyRelease, Qt::Key_Q);
        const Vector3d jogged_m = arm.tip();
        QTest::keyRelease(&arm.panel, Qt::Key_Shift);
        QVERIFY(!arm.panel.isMoving());
        arm.look(still, 50);
        QVERIFY(arm.tip() == jogged_m);
    }

    void aStepNeedsTheDeadManOfTheKeysAlsoWhileTheMouseLeads() {
        Follower arm;
        const Vector3d there_m = arm.leadByMouse(0.0);
        QTest::keyClick(&arm.panel, Qt::Key_D);
        QTest::mouseClick(arm.panel.findChild<base::HoldButton*>("up0"), Qt::LeftButton);
        arm.look({{0, 0, 0}, true, false}, 50);
        QVERIFY(arm.tip() == there_m);
    }

    void whatHeldTheTipBeforeAProgramMovedItDoesNotTakeItBack() {
        Follower arm;
        QTest::keyPress(&arm.panel, Qt::Key_Shift);
        arm.look({}, 1);
        arm.panel.letGo(); // as when a program begins
        arm.sample.reference_rad = arm.sample.angle_rad = {0.5, -0.4, 0.6, 1.2};
        arm.panel.setSample(arm.sample);
        const Vector3d there_m = arm.tip();
        arm.click(Qt::Key_D); // with Shift still held
        arm.look({}, 200);
        const Vector3d moved_m = arm.tip() - there_m;
        QVERIFY(std::abs(moved_m.x() - JogPanel::kFullStep_m) < 1e-3);
        QVERIFY(std::hypot(moved_m.y(), moved_m.z()) < 5e-3);
        QTest::keyRelease(&arm.panel, Qt::Key_Shift);

        arm.leadByMouse(0.6);
        arm.panel.letGo();
        arm.sample.reference_rad = arm.sample.angle_rad = {0.1, -0.2, 0.3, 1.5};
        arm.panel.setSample(arm.sample);
        const Vector3d again_m = arm.tip();
        arm.look({{0, 0, 0.6}, true, false}, 50);
        QVERIFY2(arm.tip() == again_m, "its button was not let go");
    }

    void anotherScaleMovesNothingByItself() {
        Follower arm;
        const Vector3d there_m = arm.leadByMouse(1.0);
        arm.panel.setSpeed(20);
        QVERIFY(!arm.panel.isMoving());
        arm.look({{0, 0, 1.0}, true, false}, 50);
        QVERIFY(arm.tip() == there_m);
        arm.look({{0, 0, 0.5}, true, false}, 200);
        QVERIFY(std::abs((arm.tip() - there_m).z() + 0.5 * 0.2 * JogPanel::kFullStep_m) < 1e-3);
    }

    void theTextsTellWhatEndsTheMotion() {
        Follower arm;
        const auto tip = [&] { return arm.panel.findChild<base::HoldButton*>("up0")->toolTip(); };
        QVERIFY2(tip().contains("step"), qPrintable(tip()));
        QVERIFY(!arm.panel.whatsThis().contains("either"));
        arm.panel.setWay(JogPanel::Way::velocity);
        QVERIFY2(!tip().contains("step"), qPrintable(tip()));
        QVERIFY(arm.panel.whatsThis().contains("either"));
        arm.panel.setWay(JogPanel::Way::position);
        arm.panel.setMode(JogPanel::Mode::joints); // which go by velocity
        QVERIFY(!tip().contains("step"));
        QVERIFY(arm.panel.whatsThis().contains("either"));
    }
};

namespace {
const test::Registration<PositionGuideTest> registration;
}
#include "position_guide_test.moc"
