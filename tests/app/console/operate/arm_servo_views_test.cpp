// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/arm_servo_views.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/joint_views.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/arm_channel.h"
#include "tests/backend/arm_servo/servo_bench.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/backend/pipeline/scripted_source.h"
#include "widgets/servo/arm/arm_servo_panel.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/scene3d_view.h"

#include <QComboBox>
#include <QTest>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

using namespace teleta;
using arm_servo::ArmServoPanel;
using arm_servo::Stage;
using console::OperateDocks;
using core::JointVector;

namespace {

class PaddedArm : public test::ScriptedArmSource {
public:
    explicit PaddedArm(core::ArmDescription description)
        : m_description(std::move(description)) {}
    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }

private:
    core::ArmDescription m_description;
};

/// Jogging and servo tasks of an arm with a pad, in a window with the keyboard.
struct Desk {
    Desk() {
        core::ArmDescription description = arm_servo::test::armWithPad(*chain);
        description.nominalRate_Hz = 0.0; // its readings come as the test tells them
        arm = new PaddedArm(description);
        array = new test::ScriptedSource(core::ArrayLayout{}, 4096);
        channel = *pipeline::ArmChannel::withPad(
            std::unique_ptr<core::ArmSource>(arm),
            std::make_shared<pipeline::TouchChannel>(std::unique_ptr<core::TactileSource>(array),
                                                     pipeline::ChannelSettings{}),
            chain, *description.pad);
        joints.addTo(docks);
        for (std::size_t dock = 0; dock < OperateDocks::kDocks; ++dock)
            if (dock != OperateDocks::joints && dock != OperateDocks::jog &&
                dock != OperateDocks::reconstruction)
                docks.add(static_cast<OperateDocks::Dock>(dock), new QWidget);
        docks.add(OperateDocks::reconstruction, scene);
        docks.begin();
        docks.setKind(OperateDocks::Kind::arm);
        docks.resize(1400, 1000);
        docks.show();
        docks.activateWindow();
        (void)QTest::qWaitForWindowActive(&docks);
        joints.setArm(channel, base::Provenance::live);
        servo.setArm(channel);
        jog = docks.findChild<touch::JogPanel*>();
        panel = docks.findChild<ArmServoPanel*>();
        tell();
    }

    /// A reading and a frame, and a tick that shows them.
    void tell() {
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.sourceTime_s = 1e-9 * static_cast<double>(sample.time_ns);
        sample.angle_rad = sample.reference_rad = arm_servo::test::kLookingDown_rad;
        (void)arm->push(sample);
        (void)array->push(std::vector<float>(core::ArrayLayout{}.taxels(), 0.0F), sample.sourceTime_s);
        (void)channel->process();
        (void)channel->skin()->update();
        joints.tick();
        servo.tick();
    }
    [[nodiscard]] Stage stage() const { return servo.servo()->servo().stage(); }
    /// A rehearsal that counts; it takes as long as it must.
    [[nodiscard]] bool rehearse() {
        panel->setFocus();
        QTest::keyPress(panel, Qt::Key_Space);
        const std::int64_t begin_ns = core::steadyNow_ns();
        while (core::steadyNow_ns() - begin_ns < 1'100'000'000)
            tell();
        QTest::keyRelease(panel, Qt::Key_Space);
        return stage() == Stage::rehearsed;
    }
    [[nodiscard]] bool isToldToMove() const {
        return !arm->commands.empty() && std::ranges::any_of(arm->commands.back().rate_radPerS,
                                                             [](double rate) { return rate != 0.0; });
    }

    std::shared_ptr<const arm_model::SerialChain> chain = test::chainOf("resources/arms/seven-joints.urdf");
    PaddedArm* arm = nullptr; // both are owned by the channel
    test::ScriptedSource* array = nullptr;
    std::shared_ptr<pipeline::ArmChannel> channel;
    core::StopSwitch stop;
    OperateDocks docks;
    view3d::Scene3dView* scene = new view3d::Scene3dView(&docks);
    console::JointViews joints{stop, *scene, &docks};
    console::ArmServoViews servo{stop, joints, &docks};
    touch::JogPanel* jog = nullptr;
    ArmServoPanel* panel = nullptr;
};

} // namespace

/// Servo tasks on an arm with a pad, by press and hold.
class ArmServoViewsTest : public QObject {
    Q_OBJECT

private slots:
    void thePanelIsThereForAnArmWithAPadOnly() {
        Desk desk;
        QVERIFY(desk.panel->isVisibleTo(&desk.docks));
        QVERIFY(desk.servo.servo() != nullptr);
        desk.servo.setArm(nullptr);
        QVERIFY(!desk.panel->isVisibleTo(&desk.docks));
        QVERIFY(desk.servo.servo() == nullptr);
    }

    void theFirstPressTellsTheArmNothingAndTheSecondOneMovesIt() {
        Desk desk;
        QVERIFY(desk.rehearse());
        QVERIFY(desk.arm->commands.empty());
        QTest::keyPress(desk.panel, Qt::Key_Space);
        QCOMPARE(desk.arm->commands.back().rate_radPerS, JointVector::zeros(7));
        for (int i = 0; i < 5; ++i)
            desk.tell();
        QVERIFY(desk.isToldToMove());
        // At once, not with the next tick.
        QTest::keyRelease(desk.panel, Qt::Key_Space);
        QVERIFY(!desk.isToldToMove());
        const std::size_t told = desk.arm->commands.size();
        for (int i = 0; i < 5; ++i)
            desk.tell();
        QCOMPARE(desk.arm->commands.size(), told);
    }

    void stopAndJoggingAndAnotherTaskEndIt() {
        for (int way = 0; way < 4; ++way) {
            Desk desk;
            QVERIFY(desk.rehearse());
            QTest::keyPress(desk.panel, Qt::Key_Space);
            for (int i = 0; i < 5; ++i)
                desk.tell();
            QVERIFY(desk.isToldToMove());
            if (way == 0) { // between two ticks
                desk.stop.engage();
                desk.stop.release();
                desk.tell();
            } else if (way == 1) {
                desk.panel->findChild<QComboBox*>("armTask")->setCurrentIndex(2);
            } else if (way == 2) {
                desk.jog->setFocus();
                QVERIFY(!desk.isToldToMove());
                QTest::keyPress(desk.jog, Qt::Key_Shift);
                QTest::keyPress(desk.jog, Qt::Key_Q, Qt::ShiftModifier);
                QVERIFY(desk.isToldToMove());
                QTest::keyRelease(desk.jog, Qt::Key_Q, Qt::ShiftModifier);
                QTest::keyRelease(desk.jog, Qt::Key_Shift);
            } else {
                desk.servo.setArm(nullptr);
                QVERIFY(!desk.isToldToMove());
                continue;
            }
            QVERIFY2(!desk.isToldToMove(), qPrintable(QString::number(way)));
            desk.tell();
            QCOMPARE(desk.stage(), Stage::idle);
            QVERIFY(!desk.isToldToMove());
        }
    }
};

QTEST_MAIN(ArmServoViewsTest)
#include "arm_servo_views_test.moc"
