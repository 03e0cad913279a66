// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/view3d/scene3d_stage.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/view3d/change_watch.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QTest>

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>

#include <array>
#include <cmath>

using namespace teleta;
using namespace teleta::test;
using view3d::CameraPreset;

namespace {

const Eigen::Vector3d kHand_m(0.4, 0.1, 0.3);

/// An arm of one link, with the array in its hand.
void giveArm(view3d::Scene3dView& view) {
    view3d::ArmLink link;
    link.length_m = 0.5;
    link.radius_m = 0.05;
    view.setArmLinks(std::array{link});
    Eigen::Isometry3d hand = Eigen::Isometry3d::Identity();
    hand.translation() = kHand_m;
    view.setSensorPose(hand);
}

} // namespace

/// The camera of the 3-D view goes along with a contact or the hand, until another source comes.
class Scene3dFollowingTest : public QObject {
    Q_OBJECT

private slots:
    void followingKeepsTheStrongestContactInTheMiddle() {
        Stage stage;
        QVERIFY(stage.ready());
        check(stage.view, "follow", true);
        for (std::uint64_t frame = 1; frame <= 400; ++frame) {
            stage.view.setSnapshot(
                test::pressed(kLayout, {{1, 0.015, 0.005, 1.0, 0.003}, {2, -0.015, 0.0, 0.4, 0.003}}, frame));
        }
        const Eigen::Vector3d focal(rendererOf(stage.view)->GetActiveCamera()->GetFocalPoint());
        const Eigen::Vector3d away = focal - Eigen::Vector3d(0.015, 0.005, 0.008);
        QVERIFY2(away.norm() < 0.005, qPrintable(QString::number(away.norm())));
        const view3d::Orbit before = stage.view.orbit();
        QCOMPARE(before.azimuth_rad, view3d::orbitOf(CameraPreset::isometric).azimuth_rad);

        // Without a contact it is the hand of an arm.
        giveArm(stage.view);
        for (std::uint64_t frame = 401; frame <= 800; ++frame)
            stage.view.setSnapshot(test::pressed(kLayout, {}, frame));
        const Eigen::Vector3d there(rendererOf(stage.view)->GetActiveCamera()->GetFocalPoint());
        QVERIFY2((there - kHand_m).norm() < 0.01, qPrintable(QString::number(there.z())));
    }

    void anArmThatCreepsIsDrawnLessOften() {
        view3d::MovingView view{{}, 500.0};
        view.state.points_m.push_back(kHand_m);
        Eigen::Vector3d& hand_m = view.state.points_m[0];
        int asked = 0;
        view3d::ChangeWatch watch([&view] { return view; }, [&asked] { ++asked; });
        const auto move = [&](double way_m) {
            hand_m.x() += way_m;
            watch.dataChanged();
        };
        move(0.0);
        QTRY_COMPARE(asked, 1);

        QElapsedTimer running;
        running.start();
        for (int step = 0; step < 1000; ++step) {
            move(1e-9);
            QCoreApplication::processEvents();
        }
        QVERIFY(asked <= 2 + running.elapsed() / view3d::ChangeWatch::kLongest_ms);
        const int before = asked;
        move(1e-9);
        QTRY_VERIFY(asked > before); // where it is in the end is drawn
        for (int step = 1; step <= 20; ++step) {
            const int rest = asked;
            move(0.01); // 5 px
            QTRY_COMPARE(asked, rest + 1);
        }
    }

    void anArmThatMovesIsDrawn() {
        Stage stage;
        QVERIFY(stage.ready());
        giveArm(stage.view);
        stage.settle();
        const std::uint64_t before = vtkOf(stage.view).framesRendered();
        Eigen::Isometry3d hand = stage.view.sensorPose();
        hand.translation().x() += 0.05;
        stage.view.setSensorPose(hand);
        stage.view.setSnapshot(test::pressed(kLayout, {}, 1));
        QTRY_VERIFY(vtkOf(stage.view).framesRendered() > before);
    }

    void anotherSourceIsSeenWholeWhateverWasFollowed_data() {
        QTest::addColumn<Qt::Key>("key");
        QTest::newRow("a contact or the hand") << Qt::Key_F;
        QTest::newRow("from the hand") << Qt::Key_6;
        QTest::newRow("moved nearer") << Qt::Key_Plus;
    }
    void anotherSourceIsSeenWholeWhateverWasFollowed() {
        QFETCH(Qt::Key, key);
        Stage stage;
        QVERIFY(stage.ready());
        QVERIFY(stage.focused());
        const auto distance_m = [&stage] {
            vtkCamera* camera = rendererOf(stage.view)->GetActiveCamera();
            return camera->GetDistance();
        };
        stage.view.setSnapshot(test::pressed(kLayout, {}, 1));
        const double whole_m = distance_m();
        giveArm(stage.view);
        QTest::keyClick(vtkOf(stage.view).focusProxy(), key);
        for (std::uint64_t frame = 2; frame <= 100; ++frame)
            stage.view.setSnapshot(test::pressed(kLayout, {}, frame));

        // The arm goes, an array on a table comes.
        stage.view.clear();
        stage.view.setArmLinks({});
        stage.view.setSensorPose(Eigen::Isometry3d::Identity());
        stage.view.frame();
        stage.view.setSnapshot(test::pressed(kLayout, {}, 101));
        QVERIFY(!stage.view.findChild<QAction*>("follow")->isChecked());
        QVERIFY(!stage.view.findChild<QAction*>("onHand")->isChecked());
        QVERIFY2(std::abs(distance_m() - whole_m) < 1e-6 * whole_m,
                 qPrintable(QString::number(distance_m())));
    }

    void fromTheHandTheCameraGoesWithTheArrayUntilAnotherViewIsChosen() {
        Stage stage;
        QVERIFY(stage.ready());
        QVERIFY(stage.focused());
        const auto moved = [&stage](const Eigen::Vector3d& way) -> Eigen::Vector3d {
            vtkCamera* camera = rendererOf(stage.view)->GetActiveCamera();
            const Eigen::Vector3d before(camera->GetPosition());
            stage.view.setSensorPose(Eigen::Translation3d(way) * stage.view.sensorPose());
            return Eigen::Vector3d(camera->GetPosition()) - before;
        };
        stage.view.setSnapshot(test::pressed(kLayout, {}, 1));
        QTest::keyClick(vtkOf(stage.view).focusProxy(), Qt::Key_6);
        QVERIFY((moved({0.4, 0.1, 0.3}) - Eigen::Vector3d(0.4, 0.1, 0.3)).norm() < 1e-9);
        QTest::keyClick(vtkOf(stage.view).focusProxy(), Qt::Key_1);
        QVERIFY(!stage.view.findChild<QAction*>("onHand")->isChecked());
        QVERIFY(moved({0.0, 0.0, 1e-3}).norm() < 1e-3);
    }
};

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    Scene3dFollowingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "scene3d_following_test.moc"
