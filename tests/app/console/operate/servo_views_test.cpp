// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/servo_views.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/servo/servo_runs_view.h"
#include "widgets/view3d/scene3d_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTest>

#include <array>
#include <cmath>

using namespace teleta;
using console::OperateDocks;
using console::ServoViews;

namespace {

void publish(servo::ServoLink& link, servo::TaskKind kind) {
    servo::ServoReport& report = link.reports.back();
    report = {};
    report.output.kind = kind;
    report.tasks = 1;
    report.plan[0] = kind;
    for (std::size_t i = 0; i < report.p_Base_Joint.size(); ++i)
        report.p_Base_Joint[i] = Eigen::Vector3d(0.0, 0.0, 0.15 * static_cast<double>(i));
    report.X_Base_Sensor.translation() = Eigen::Vector3d(0.0, 0.0, 1.1);
    link.reports.publish();
}

void explore(servo::ServoLink& link, double time_s, double x_m, std::uint64_t run = 0, bool moment = true) {
    servo::ServoStep step;
    step.run = run;
    step.time_s = time_s;
    step.task = servo::TaskKind::explore;
    step.touching = true;
    step.moment = moment;
    step.force_N = 5.0;
    step.p_Base_Contact = Eigen::Vector3d(x_m, 0.0, 0.4);
    link.steps.push(std::move(step));
}

} // namespace

/// A servo's link on one side, the views of the Operate page on the other.
class ServoViewsTest : public QObject {
    Q_OBJECT

private slots:
    void reportsReachThePanelAndWishesTheServo() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        views.setServo(link, QStringLiteral("bar"), base::Provenance::simulated);
        QVERIFY(!views.panel().isEnabled());
        publish(*link, servo::TaskKind::explore);
        views.tick();
        QVERIFY(views.panel().isEnabled());
        QCOMPARE(views.panel().findChild<QComboBox*>("servoTask")->currentText(),
                 QStringLiteral("1. Explore"));
        QVERIFY(!link->tuning.take().has_value());
        views.panel().findChild<QCheckBox*>(QStringLiteral("servoMoment"))->click();
        const auto wish = link->tuning.take();
        QVERIFY(wish.has_value());
        QVERIFY(!wish->moment);
        emit views.panel().taskRequested(2);
        QCOMPARE(link->task.take(), std::optional<std::size_t>(2));
        views.setServo(nullptr, {}, base::Provenance::live);
        QVERIFY(!views.panel().isEnabled());
        emit views.panel().taskRequested(1);
        QVERIFY(!link->task.take().has_value());
    }

    void theArmIsDrawnFromItsBaseToTheSensorAndTheArrayWhereTheSensorIs() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        views.setServo(link, QStringLiteral("bar"), base::Provenance::simulated);
        QVERIFY(scene.armBox_m().isEmpty());
        Eigen::Isometry3d X_Flange_Sensor = Eigen::Isometry3d::Identity();
        X_Flange_Sensor.translation().z() = 0.03;
        servo::LwrVector q_rad;
        q_rad << 0.2, 0.5, -0.1, -1.4, 0.3, 1.2, 0.4;
        const servo::LwrPosture posture = servo::LwrKinematics(X_Flange_Sensor).forward(q_rad);
        servo::ServoReport& report = link->reports.back();
        report = {};
        report.p_Base_Joint = posture.p_Base_Joint;
        report.X_Base_Sensor = posture.X_Base_Tool;
        const auto links = ServoViews::linksOf(report);
        link->reports.publish();
        views.tick();

        // Lengths of the arm's data sheet, each link from the end of the one before.
        const std::array length_m{0.310, 0.400, 0.390, 0.078 + 0.03};
        Eigen::Vector3d end_m = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < links.size(); ++i) {
            QVERIFY(std::abs(links[i].length_m - length_m[i]) < 1e-9);
            QVERIFY((links[i].X_World_Link.translation() - end_m).norm() < 1e-9);
            end_m = links[i].X_World_Link * Eigen::Vector3d(links[i].length_m, 0.0, 0.0);
        }
        QVERIFY((end_m - posture.X_Base_Tool.translation()).norm() < 1e-9);
        QVERIFY(scene.sensorPose().matrix() == posture.X_Base_Tool.matrix());
        QVERIFY(scene.armBox_m().contains(end_m));
        QVERIFY(scene.armBox_m().contains(Eigen::Vector3d(0.0, 0.0, 0.31)));

        views.setServo(nullptr, {}, base::Provenance::live);
        QVERIFY(scene.armBox_m().isEmpty());
        QVERIFY(scene.sensorPose().matrix() == Eigen::Matrix4d::Identity());
    }

    void whatTheArrayTouchesIsDrawnWhereItIs() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        link->body = {.name = "bar", .axis_m = {{-0.1, 0.0, -0.003}, {0.4, 0.0, -0.003}}, .radius_m = 0.003};
        views.setServo(link, QStringLiteral("bar"), base::Provenance::simulated);
        QVERIFY(scene.scenery().empty());
        publish(*link, servo::TaskKind::explore);
        views.tick();
        QCOMPARE(scene.scenery().size(), 1U);
        QCOMPARE(scene.scenery()[0].name, QStringLiteral("bar"));
        QVERIFY((scene.scenery()[0].axis_m[1] - Eigen::Vector3d(0.4, 0.0, -0.003)).norm() < 1e-12);
        servo::ServoReport& moved = link->reports.back();
        moved = link->reports.front();
        moved.X_Base_Object.translation() = Eigen::Vector3d(0.0, 0.0, 0.2);
        link->reports.publish();
        views.tick();
        QVERIFY((scene.scenery()[0].axis_m[1] - Eigen::Vector3d(0.4, 0.0, 0.197)).norm() < 1e-12);
        views.setServo(nullptr, {}, base::Provenance::live);
        QVERIFY(scene.scenery().empty());
    }

    void theEdgeIsKeptInStepsOfAMillimetreAndForgottenWithItsRun() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        views.setServo(link, QStringLiteral("bar"), base::Provenance::simulated);
        // 100 mm in steps of 0.05 mm.
        for (int i = 0; i <= 2000; ++i)
            explore(*link, 0.01 * i, 5e-5 * i);
        views.tick();
        QVERIFY(views.edge_m().size() > 90);
        QVERIFY(views.edge_m().size() <= 101);
        for (std::size_t i = 1; i < views.edge_m().size(); ++i)
            QVERIFY((views.edge_m()[i] - views.edge_m()[i - 1]).norm() >= ServoViews::kSpacing_m);
        explore(*link, 0.01, 0.3, 1);
        views.tick();
        QCOMPARE(views.edge_m().size(), std::size_t{1});
        QCOMPARE(views.edge_m().front().x(), 0.3);
    }

    void anEdgeThatIsFollowedForHoursIsBounded() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        views.setServo(link, QStringLiteral("bar"), base::Provenance::simulated);
        constexpr int kSteps = 3 * static_cast<int>(ServoViews::kMostPoints);
        for (int i = 0; i <= kSteps; ++i) {
            explore(*link, 0.01 * i, 0.0011 * i);
            if (i % 1000 == 0)
                views.tick();
        }
        views.tick();
        QVERIFY(views.edge_m().size() <= ServoViews::kMostPoints);
        QVERIFY(views.edge_m().size() > ServoViews::kMostPoints / 4);
        QCOMPARE(views.edge_m().front().x(), 0.0);
        QVERIFY(views.edge_m().back().x() > 0.0011 * kSteps - 0.01);
    }

    void runsOfTwoSourcesAreComparedAndOneGoesOnWhenItIsShownAgain() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto dzmp = std::make_shared<servo::ServoLink>();
        auto baseline = std::make_shared<servo::ServoLink>();
        views.setServo(baseline, QStringLiteral("bar"), base::Provenance::simulated);
        explore(*baseline, 1.0, 0.001, 0, false);
        explore(*baseline, 2.0, 0.002, 0, false);
        views.tick();
        views.setServo(dzmp, QStringLiteral("bar"), base::Provenance::simulated);
        explore(*dzmp, 1.0, 0.001);
        views.tick();
        views.setServo(baseline, QStringLiteral("bar"), base::Provenance::simulated);
        explore(*baseline, 2.1, 0.003, 0, false);
        views.tick();
        const auto runs = views.runs().runs().runs();
        QCOMPARE(runs.size(), std::size_t{2});
        QCOMPARE(QString::fromStdString(runs[0].name), QStringLiteral("bar, without DZMP"));
        QCOMPARE(QString::fromStdString(runs[1].name), QStringLiteral("bar, run 2"));
        QCOMPARE(runs[0].time_s.back(), 2.1);
    }

    void aServoThatIsLookedAtAgainShowsWhatItShowed() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto bar = std::make_shared<servo::ServoLink>();
        auto other = std::make_shared<servo::ServoLink>();
        views.setServo(bar, QStringLiteral("bar"), base::Provenance::simulated);
        publish(*bar, servo::TaskKind::explore);
        explore(*bar, 1.0, 0.010);
        explore(*bar, 2.0, 0.020);
        views.tick();
        for (const auto& between : {other, std::shared_ptr<servo::ServoLink>()}) {
            views.setServo(between, QStringLiteral("other"), base::Provenance::simulated);
            views.tick();
            QVERIFY(!views.panel().isEnabled());
            QVERIFY(views.edge_m().empty());
            QVERIFY(scene.armBox_m().isEmpty());
            // It says nothing more.
            views.setServo(bar, QStringLiteral("bar"), base::Provenance::simulated);
            views.tick();
            QVERIFY(views.panel().isEnabled());
            QCOMPARE(views.panel().findChild<QComboBox*>("servoTask")->currentText(),
                     QStringLiteral("1. Explore"));
            QCOMPARE(views.edge_m().size(), std::size_t{2});
            QVERIFY(!scene.armBox_m().isEmpty());
        }
        explore(*bar, 2.1, 0.030);
        views.tick();
        QCOMPARE(views.edge_m().size(), std::size_t{3});
        explore(*bar, 0.1, 0.040, 1);
        views.tick();
        QCOMPARE(views.edge_m().size(), std::size_t{1});
        QCOMPARE(views.runs().runs().runs().size(), std::size_t{2});
    }

    void eachKindOfSourceHasItsOwnDocks() {
        using Kind = OperateDocks::Kind;
        for (const Kind kind : {Kind::array, Kind::arm, Kind::servo}) {
            QVERIFY(OperateDocks::belongs(kind, OperateDocks::heatmap));
            QVERIFY(OperateDocks::belongs(kind, OperateDocks::processing));
            QCOMPARE(OperateDocks::belongs(kind, OperateDocks::stiffness), kind == Kind::arm);
            QCOMPARE(OperateDocks::belongs(kind, OperateDocks::servo), kind == Kind::servo);
            QCOMPARE(OperateDocks::belongs(kind, OperateDocks::runs), kind == Kind::servo);
            QVERIFY(!OperateDocks::belongs(kind, OperateDocks::camera));
        }
        for (const auto dock : {OperateDocks::camera, OperateDocks::events, OperateDocks::reconstruction})
            QVERIFY(OperateDocks::belongs(Kind::camera, dock));
        QVERIFY(!OperateDocks::belongs(Kind::camera, OperateDocks::heatmap));
    }
};

QTEST_MAIN(ServoViewsTest)
#include "servo_views_test.moc"
