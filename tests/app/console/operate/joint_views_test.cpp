// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/arm_views.h"
#include "app/console/operate/docks/operate_docks.h"
#include "backend/arm_model/motion_limits.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/core/device/arm_report.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "tests/backend/pipeline/pad_on_arm.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/backend/pipeline/scripted_source.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/charts/joint_chart_view.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/scene3d_view.h"

#include <QAction>
#include <QDataStream>
#include <QIODevice>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace teleta;
using console::OperateDocks;
using core::JointVector;

namespace {

std::shared_ptr<const arm_model::SerialChain> sevenJoints() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
    if (!model)
        qFatal("%s", core::describe(model.error()).c_str());
    auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                "base_link", "tool0");
    return chain ? std::make_shared<const arm_model::SerialChain>(std::move(*chain)) : nullptr;
}

/// A real arm, of which only the joints are known.
class BareArm : public test::ScriptedArmSource, public core::ReportingArm {
public:
    explicit BareArm(const arm_model::SerialChain& chain) {
        m_description.name = "robot";
        m_description.nominalRate_Hz = 0.0;
        m_description.lowest_rad = chain.lowest();
        m_description.highest_rad = chain.highest();
        m_description.fastest_radPerS = chain.fastest();
    }
    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }
    [[nodiscard]] std::string hindrance() const override { return inTheWay; }
    [[nodiscard]] core::ArmReport report() const override { return told; }

    void setUnguarded() { m_description.guarded = false; }

    std::string inTheWay;
    core::ArmReport told;

private:
    core::ArmDescription m_description;
};

/// The views with such an arm, in a window with the keyboard.
struct Desk {
    Desk() {
        views.addTo(docks);
        docks.add(OperateDocks::reconstruction, scene);
        // The other views of the page are not needed here, but their docks are.
        for (const OperateDocks::Dock dock :
             {OperateDocks::heatmap, OperateDocks::charts, OperateDocks::processing, OperateDocks::servo,
              OperateDocks::runs, OperateDocks::camera, OperateDocks::events, OperateDocks::gel,
              OperateDocks::gelEvents, OperateDocks::scene, OperateDocks::marks})
            docks.add(dock, new QWidget);
        docks.begin();
        docks.setKind(OperateDocks::Kind::joints);
        docks.resize(1200, 800);
        docks.show();
        views.setArm(channel, base::Provenance::live);
        jog = docks.findChild<touch::JogPanel*>();
        chart = docks.findChild<charts::JointChartView*>();
    }

    void tell(const JointVector& angle_rad) {
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.sourceTime_s = 1e-9 * static_cast<double>(sample.time_ns);
        sample.angle_rad = sample.reference_rad = angle_rad;
        (void)arm->push(sample);
        (void)channel->process();
        views.tick();
    }

    std::shared_ptr<const arm_model::SerialChain> chain = sevenJoints();
    BareArm* arm = new BareArm(*chain); // owned by the channel
    std::shared_ptr<pipeline::JointChannel> channel =
        std::make_shared<pipeline::JointChannel>(std::unique_ptr<core::ArmSource>(arm), chain);
    core::StopSwitch stop;
    console::BraceletService bracelet{stop};
    OperateDocks docks;
    view3d::Scene3dView* scene = new view3d::Scene3dView(&docks);
    console::ArmViews views{stop, bracelet, *scene, &docks};
    touch::JogPanel* jog = nullptr;
    charts::JointChartView* chart = nullptr;
};

/// The arm with a pad, in the views of a desk, whose chart shows torques alone.
struct ArmWithPad {
    explicit ArmWithPad(Desk& desk)
        : arm(new BareArm(*desk.chain)) {
        auto made = pipeline::ArmChannel::withPad(
            std::unique_ptr<core::ArmSource>(arm),
            std::make_shared<pipeline::TouchChannel>(std::unique_ptr<core::TactileSource>(array),
                                                     pipeline::ChannelSettings{}),
            desk.chain, pad);
        if (!made)
            return;
        channel = *made;
        desk.chart->setAnglesShown(false);
        desk.docks.setKind(OperateDocks::Kind::arm);
        desk.views.setArm(channel, base::Provenance::live);
    }
    core::PadPlacement pad = test::padOnLinkFive();
    BareArm* arm; // both are owned by the channel
    test::ScriptedSource* array =
        new test::ScriptedSource(core::ArrayLayout{.rows = 9, .columns = 9, .pitchX_m = 0.005});
    std::shared_ptr<pipeline::ArmChannel> channel;
};

} // namespace

/// An arm without a tactile skin: its joints are shown, drawn and moved.
class JointViewsTest : public QObject {
    Q_OBJECT

private slots:
    void onlyWhatAnArmWithoutASkinHasIsShown() {
        Desk desk;
        QVERIFY(!desk.views.arm());
        QCOMPARE(desk.views.joints(), desk.channel);
        for (std::size_t dock = 0; dock < OperateDocks::kDocks; ++dock) {
            const bool expected = dock == OperateDocks::reconstruction || dock == OperateDocks::joints ||
                                  dock == OperateDocks::jog || dock == OperateDocks::scene ||
                                  dock == OperateDocks::marks;
            QCOMPARE(OperateDocks::belongs(OperateDocks::Kind::joints, dock), expected);
        }
        QVERIFY(desk.jog->isVisible());
    }

    void aPadIsDrawnOnItsLinkAndItsTouchesAreShown() {
        Desk desk;
        const ArmWithPad made(desk);
        QVERIFY(made.channel != nullptr);
        QCOMPARE(desk.views.arm(), made.channel);
        const JointVector q{0.3, -0.7, 0.2, 1.1, -0.4, 0.8, 0.5};
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.sourceTime_s = 1e-9 * static_cast<double>(sample.time_ns);
        sample.angle_rad = sample.reference_rad = q;
        sample.torque_Nm = JointVector::zeros(7);
        (void)made.arm->push(sample);
        std::vector<float> frame(81, 0.0F);
        frame[3 * 9 + 6] = 2.0F; // the fourth row, the seventh column
        (void)made.array->push(frame, sample.sourceTime_s);
        (void)made.channel->process();
        desk.views.tick();
        const std::size_t link = *desk.chain->model().findLink(made.pad.link);
        const Eigen::Isometry3d X_Base_Pad =
            desk.chain->linkPoses(q)[link] * pipeline::X_Link_Sensor(made.pad);
        QVERIFY(desk.scene->sensorPose().isApprox(X_Base_Pad, 1e-9));
        QVERIFY(!desk.scene->armBox_m().isEmpty());
        const auto& contact = made.channel->snapshot().contact;
        QVERIFY(contact.has_value());
        QVERIFY((contact->p_Base_Contact_m - X_Base_Pad * Eigen::Vector3d(0.010, -0.005, 0.0)).norm() < 1e-9);
        QVERIFY2(desk.jog->refusal().isEmpty(), qPrintable(desk.jog->refusal()));
        QVERIFY(!desk.chart->findChild<QAction*>("angles")->isChecked());
    }

    void theAnglesOfAnArmWithAPadAreShownWhereItTellsNoTorques() {
        Desk desk;
        const ArmWithPad made(desk);
        QVERIFY(made.channel != nullptr);
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.angle_rad = sample.reference_rad = JointVector::zeros(7);
        (void)made.arm->push(sample);
        (void)made.channel->process();
        desk.views.tick();
        auto* angles = desk.chart->findChild<QAction*>("angles");
        QVERIFY(angles->isChecked());
        angles->trigger(); // what somebody chooses stays
        sample.time_ns = core::steadyNow_ns();
        (void)made.arm->push(sample);
        (void)made.channel->process();
        desk.views.tick();
        QVERIFY(!angles->isChecked());
    }

    void theArmIsDrawnWhereItsJointsAre() {
        Desk desk;
        JointVector q = JointVector::zeros(7);
        desk.tell(q);
        const Eigen::AlignedBox3d straight = desk.scene->armBox_m();
        QVERIFY(!straight.isEmpty());
        const Eigen::Vector3d tip = desk.chain->X_Base_Tip(q).translation();
        QVERIFY(straight.contains(tip) && straight.contains(Eigen::Vector3d::Zero().eval()));
        q[1] = 1.2;
        desk.tell(q);
        const Eigen::Vector3d moved = desk.chain->X_Base_Tip(q).translation();
        QVERIFY((moved - tip).norm() > 0.1);
        QVERIFY(desk.scene->armBox_m().contains(moved));
        QVERIFY(!desk.scene->armBox_m().contains(tip));
    }

    void theLinksAreDrawnAsTheirDescriptionHasThem() {
        Desk desk;
        const JointVector q = JointVector::zeros(7);
        // The foot of this arm has a radius of 80 mm, and everything above it is thinner.
        QTRY_VERIFY((desk.tell(q), std::abs(desk.scene->armBox_m().min().x() + 0.08) < 1e-4));
        QVERIFY(std::abs(desk.scene->armBox_m().max().y() - 0.08) < 1e-4);
        // Another source is not drawn as this one.
        desk.views.setArm(nullptr, base::Provenance::live);
        QVERIFY(desk.scene->armBox_m().isEmpty());
    }

    void aMeshThatIsMissingIsNamedAndTubesAreDrawn() {
        Desk desk;
        const auto model = arm_model::parseUrdf(
            "<robot name=\"r\"><link name=\"base_link\"/><link name=\"tool0\"><visual><geometry>"
            "<mesh filename=\"package://r/none.stl\"/></geometry></visual></link><joint name=\"j\" "
            "type=\"revolute\"><parent link=\"base_link\"/><child link=\"tool0\"/><origin xyz=\"0.5 0 0\"/>"
            "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>"
            "</robot>",
            "r.urdf");
        QVERIFY(model);
        auto made = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                   "base_link", "tool0");
        QVERIFY(made);
        const auto chain = std::make_shared<const arm_model::SerialChain>(std::move(*made));
        auto* arm = new BareArm(*chain);
        const auto channel = std::make_shared<pipeline::JointChannel>(std::unique_ptr<core::ArmSource>(arm),
                                                                      chain, "/nowhere");
        QSignalSpy failed(&desk.views, &console::ArmViews::meshesFailed);
        desk.views.setArm(channel, base::Provenance::live);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed.front().front().toString().contains("/nowhere/r/none.stl"));
        core::JointSample sample;
        sample.angle_rad = sample.reference_rad = JointVector::zeros(1);
        (void)arm->push(sample);
        (void)channel->process();
        desk.views.tick();
        QVERIFY(desk.scene->armBox_m().contains(Eigen::Vector3d(0.5, 0.0, 0.0)));
    }

    /// The tip of the stretched arm has the axes of the base.
    void aForceAtTheWristIsToldAndDrawn() {
        Desk desk;
        auto* arm = new BareArm(*desk.chain);
        arm->hasWrench = true;
        desk.views.setArm(
            std::make_shared<pipeline::JointChannel>(std::unique_ptr<core::ArmSource>(arm), desk.chain),
            base::Provenance::live);
        const auto* told = desk.jog->findChild<QLabel*>("wrench");
        QVERIFY(!told->isVisible());
        const auto tick = [&](std::int64_t age_ns) {
            core::JointSample sample;
            sample.time_ns = core::steadyNow_ns();
            sample.angle_rad = sample.reference_rad = JointVector::zeros(7);
            (void)arm->push(sample);
            (void)arm->push(core::WrenchSample{.time_ns = sample.time_ns - age_ns,
                                               .force_N = {0.0, 3.0, 4.0},
                                               .torque_Nm = {0.0, 0.0, 0.25}});
            (void)desk.views.joints()->process();
            desk.views.tick();
        };
        tick(0);
        QVERIFY(told->isVisible());
        QVERIFY2(told->text().contains("5.00") && told->text().contains("0.25"), qPrintable(told->text()));
        QVERIFY(desk.scene->force());
        const Eigen::Isometry3d X_Base_Tip = desk.chain->X_Base_Tip(JointVector::zeros(7));
        QVERIFY(desk.scene->force()->p_World_m.isApprox(X_Base_Tip.translation()));
        QVERIFY(desk.scene->force()->force_N.isApprox(X_Base_Tip.linear() * Eigen::Vector3d(0, 3, 4)));
        tick(1'000'000'000);
        QVERIFY2(!told->isVisible(), "an old force is not shown");
        QVERIFY(!desk.scene->force());
    }

    void anArmThatNothingStopsSaysSo() {
        Desk desk;
        const auto text = [&] {
            QString all;
            for (const QLabel* label : desk.jog->findChildren<QLabel*>())
                all += label->text() + QLatin1Char('\n');
            return all;
        };
        desk.tell(JointVector::zeros(7));
        QVERIFY(!text().contains("UNGUARDED"));
        auto* arm = new BareArm(*desk.chain);
        arm->setUnguarded();
        const auto channel =
            std::make_shared<pipeline::JointChannel>(std::unique_ptr<core::ArmSource>(arm), desk.chain);
        QVERIFY(!channel->summary().guarded);
        desk.views.setArm(channel, base::Provenance::unguarded);
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.angle_rad = sample.reference_rad = JointVector::zeros(7);
        (void)arm->push(sample);
        (void)channel->process();
        desk.views.tick();
        QVERIFY(text().contains("UNGUARDED"));
    }

    void torquesThatNobodyTellsAreAGapAndTheAnglesAreShownInstead() {
        Desk desk;
        JointVector q = JointVector::zeros(7);
        q[6] = 0.25;
        desk.tell(q);
        QCOMPARE(desk.chart->history().size(), std::size_t(1));
        QVERIFY(std::isnan(desk.chart->history().value(0, 0)));
        QCOMPARE(desk.chart->history().value(13, 0), 0.25);
        const auto* angles = desk.chart->findChild<QAction*>("angles");
        QVERIFY(angles->isChecked());
    }

    void aPressBeginsWithAZeroSoThatTheArmKnowsThatTheSwitchWasLetGo() {
        Desk desk;
        desk.tell(JointVector::zeros(7));
        desk.docks.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&desk.docks));
        desk.jog->setFocus();
        desk.arm->commands.clear();
        QTest::keyPress(desk.jog, Qt::Key_Shift);
        QVERIFY(desk.arm->commands.empty());
        QTest::keyPress(desk.jog, Qt::Key_Q, Qt::ShiftModifier);
        QCOMPARE(desk.arm->commands.size(), std::size_t(2));
        QCOMPARE(desk.arm->commands[0].rate_radPerS, JointVector::zeros(7));
        QVERIFY(desk.arm->commands[1].rate_radPerS[0] > 0.0);
        // Held on: no further zero among the rates.
        QTRY_VERIFY(desk.arm->commands.size() >= 4);
        for (std::size_t i = 1; i < desk.arm->commands.size(); ++i)
            QVERIFY(desk.arm->commands[i].rate_radPerS[0] > 0.0);
        QTest::keyRelease(desk.jog, Qt::Key_Q, Qt::ShiftModifier);
        QCOMPARE(desk.arm->commands.back().rate_radPerS, JointVector::zeros(7));
        const std::size_t before = desk.arm->commands.size();
        QTest::keyPress(desk.jog, Qt::Key_Q, Qt::ShiftModifier);
        QCOMPARE(desk.arm->commands.size(), before + 2);
        QCOMPARE(desk.arm->commands[before].rate_radPerS, JointVector::zeros(7));
        // STOP ends it.
        desk.stop.engage();
        desk.views.tick();
        QCOMPARE(desk.arm->commands.back().rate_radPerS, JointVector::zeros(7));
        QVERIFY(!desk.jog->isMoving());
    }

    void whatIsInTheWayStandsInTheJogView() {
        Desk desk;
        desk.arm->inTheWay = "no controller reads /arm_controller/joint_trajectory";
        desk.tell(JointVector::zeros(7));
        const auto says = [&desk](const QString& text) {
            return std::ranges::any_of(desk.jog->findChildren<QLabel*>(),
                                       [&](const QLabel* label) { return label->text().contains(text); });
        };
        QVERIFY(says("no controller reads /arm_controller/joint_trajectory."));
        desk.arm->inTheWay.clear();
        desk.tell(JointVector::zeros(7));
        QVERIFY(!says("no controller"));
    }

    void whatTheArmTellsOfItselfStandsBesideItsJoints() {
        Desk desk;
        const JointVector q = JointVector::zeros(7);
        QSignalSpy unknown(&desk.views, &console::ArmViews::jointsUnknown);
        const auto* limits = desk.jog->findChild<QLabel*>("limits");
        const auto* joint = desk.jog->findChild<QLabel*>("told1");
        desk.tell(q);
        QVERIFY(!limits->isVisible() && !joint->isVisible());
        desk.arm->told.activeLimits = static_cast<std::uint32_t>(arm_model::MotionFlag::tipSpeed) |
                                      static_cast<std::uint32_t>(arm_model::MotionFlag::acceleration);
        desk.arm->told.effort = q;
        desk.arm->told.effort[1] = -1.5;
        desk.arm->told.effortIsCurrent = true;
        desk.arm->told.unknownJoints = {"finger", "thumb"};
        desk.tell(q);
        QVERIFY(limits->isVisible() && joint->isVisible());
        QCOMPARE(limits->text(), QStringLiteral("Active limits: tip speed."));
        QCOMPARE(joint->text().trimmed(), QStringLiteral("\u22121.50\u00a0A"));
        QCOMPARE(unknown.size(), 1);
        QVERIFY(unknown.front().front().toString().endsWith("finger, thumb."));
        desk.arm->told.rate_radPerS = q;
        desk.arm->told.rate_radPerS[1] = 0.5;
        desk.arm->told.effort = {};
        desk.arm->told.activeLimits = 0;
        desk.tell(q);
        // 0.5 rad/s
        QCOMPARE(joint->text().trimmed(), QStringLiteral("28.6\u00a0\u00b0/s"));
        // A limit that acts no more leaves after a while.
        QTRY_VERIFY((desk.tell(q), !limits->isVisible()));
        QCOMPARE(unknown.size(), 1);
        desk.arm->told.unknownJoints.emplace_back("palm");
        desk.tell(q);
        QCOMPARE(unknown.size(), 2);
        QVERIFY(unknown.back().front().toString().endsWith(": palm."));
        // Another arm has not told anything.
        desk.views.setArm(nullptr, base::Provenance::live);
        QVERIFY(!joint->isVisible());
    }

    void anArmThatIsSilentIsNotMoved() {
        Desk desk;
        desk.tell(JointVector::zeros(7));
        QVERIFY2(desk.jog->refusal().isEmpty(), qPrintable(desk.jog->refusal()));
        QTRY_VERIFY((desk.views.tick(), desk.jog->refusal().contains("old")));
    }

    void aStopBetweenTwoTicksLetsGoOfTheKeys() {
        Desk desk;
        desk.tell(JointVector::zeros(7));
        QVERIFY2(desk.jog->refusal().isEmpty(), qPrintable(desk.jog->refusal()));
        QTest::keyPress(desk.jog, Qt::Key_Shift);
        QTest::keyPress(desk.jog, Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(desk.jog->isMoving());
        desk.stop.engage();
        desk.stop.release();
        desk.tell(JointVector::zeros(7));
        QVERIFY(!desk.jog->isMoving());
        desk.tell(JointVector::zeros(7));
        QVERIFY(!desk.jog->isMoving());
        // The panel can be used again, by another press.
        QVERIFY2(desk.jog->refusal().isEmpty(), qPrintable(desk.jog->refusal()));
        QTest::keyRelease(desk.jog, Qt::Key_W, Qt::ShiftModifier);
        QTest::keyRelease(desk.jog, Qt::Key_Shift);
        QTest::keyPress(desk.jog, Qt::Key_Shift);
        QTest::keyPress(desk.jog, Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(desk.jog->isMoving());
    }

    void theFormerArmIsStoppedAndItsChartComesBack() {
        Desk desk;
        desk.tell(JointVector::zeros(7));
        desk.views.setArm(nullptr, base::Provenance::live);
        QVERIFY(desk.scene->armBox_m().isEmpty());
        QCOMPARE(desk.chart->history().size(), std::size_t(0));
        QVERIFY(!desk.jog->refusal().isEmpty());
        desk.views.setArm(desk.channel, base::Provenance::live);
        QCOMPARE(desk.chart->history().size(), std::size_t(1));
    }

    void layoutsOfAProgramThatKnewFewerKindsAreTaken() {
        Desk desk;
        desk.docks.setKind(OperateDocks::Kind::array);
        QDataStream stream(desk.docks.saveLayouts());
        qint32 version = 0;
        QByteArray layout;
        stream >> version;
        QByteArray older;
        QDataStream out(&older, QIODevice::WriteOnly);
        out << version;
        for (int kind = 0; kind < 4; ++kind) {
            stream >> layout;
            out << layout;
        }
        QVERIFY(!stream.atEnd());
        QVERIFY(desk.docks.restoreLayouts(older));
        QVERIFY(!desk.docks.restoreLayouts(older.first(3)));
    }
};

QTEST_MAIN(JointViewsTest)
#include "joint_views_test.moc"
