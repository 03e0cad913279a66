// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/servo_views.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/view3d/scene3d_view.h"

#include <QCheckBox>
#include <QTest>

using namespace teleta;
using console::OperateDocks;
using console::ServoViews;

namespace {

void publish(servo::ServoLink& link, servo::TaskKind kind, std::uint64_t restarts = 0) {
    servo::ServoReport& report = link.reports.back();
    report = {};
    report.output.kind = kind;
    report.restarts = restarts;
    for (std::size_t i = 0; i < report.p_Base_Joint.size(); ++i)
        report.p_Base_Joint[i] = Eigen::Vector3d(0.0, 0.0, 0.15 * static_cast<double>(i));
    report.X_Base_Sensor.translation() = Eigen::Vector3d(0.0, 0.0, 1.1);
    link.reports.publish();
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
        views.setServo(link, base::Provenance::simulated);
        QVERIFY(!views.panel().isEnabled());
        publish(*link, servo::TaskKind::explore);
        views.tick();
        QVERIFY(views.panel().isEnabled());
        QCOMPARE(views.panel().taskText(), QStringLiteral("Explore"));
        QVERIFY(!link->tuning.take().has_value());
        views.panel().findChild<QCheckBox*>(QStringLiteral("servoMoment"))->click();
        const auto wish = link->tuning.take();
        QVERIFY(wish.has_value());
        QVERIFY(!wish->moment);
        emit views.panel().taskRequested(2);
        QCOMPARE(link->task.take(), std::optional<std::size_t>(2));
        views.setServo(nullptr, base::Provenance::live);
        QVERIFY(!views.panel().isEnabled());
        emit views.panel().taskRequested(1);
        QVERIFY(!link->task.take().has_value());
    }

    void theEdgeIsKeptInStepsOfAMillimetreAndForgottenWithItsRun() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        ServoViews views(scene, &parent);
        auto link = std::make_shared<servo::ServoLink>();
        views.setServo(link, base::Provenance::simulated);
        // 100 mm in steps of 0.05 mm.
        for (int i = 0; i <= 2000; ++i)
            link->contacts.push(Eigen::Vector3d(5e-5 * i, 0.0, 0.4));
        views.tick();
        QVERIFY(views.edge_m().size() > 90);
        QVERIFY(views.edge_m().size() <= 101);
        for (std::size_t i = 1; i < views.edge_m().size(); ++i)
            QVERIFY((views.edge_m()[i] - views.edge_m()[i - 1]).norm() >= ServoViews::kSpacing_m);
        publish(*link, servo::TaskKind::freeMotion, 1);
        views.tick();
        QVERIFY(views.edge_m().empty());
    }

    void eachKindOfSourceHasItsOwnDocks() {
        using Kind = OperateDocks::Kind;
        for (const Kind kind : {Kind::array, Kind::arm, Kind::servo}) {
            QVERIFY(OperateDocks::belongs(kind, OperateDocks::heatmap));
            QVERIFY(OperateDocks::belongs(kind, OperateDocks::processing));
            QCOMPARE(OperateDocks::belongs(kind, OperateDocks::stiffness), kind == Kind::arm);
            QCOMPARE(OperateDocks::belongs(kind, OperateDocks::servo), kind == Kind::servo);
            QVERIFY(!OperateDocks::belongs(kind, OperateDocks::camera));
        }
        for (const auto dock : {OperateDocks::camera, OperateDocks::events, OperateDocks::reconstruction})
            QVERIFY(OperateDocks::belongs(Kind::camera, dock));
        QVERIFY(!OperateDocks::belongs(Kind::camera, OperateDocks::heatmap));
    }
};

QTEST_MAIN(ServoViewsTest)
#include "servo_views_test.moc"
