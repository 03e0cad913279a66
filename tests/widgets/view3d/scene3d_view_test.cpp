// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/view3d/scene3d_stage.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QHelpEvent>
#include <QMainWindow>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolTip>

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace teleta;
using namespace teleta::test;
using view3d::CameraPreset;
using view3d::Scene3dView;
using view3d::Surface;

class Scene3dViewTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() { base::applyTheme(base::ThemeChoice::light); }

    void aTouchMakesAPictureAndNotABlank() {
        Stage stage;
        QVERIFY(stage.ready());
        const std::size_t before = countColours(shown(stage.view));
        stage.view.setSnapshot(test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}}));
        QVERIFY2(countColours(shown(stage.view)) > before + 200, "only the empty scene");
    }

    void aContactHasItsColourWhereTheProjectionSays_data() {
        QTest::addColumn<int>("preset");
        QTest::addColumn<bool>("dark");
        QTest::addColumn<bool>("parallel");
        for (const bool dark : {false, true}) {
            for (const bool parallel : {false, true}) {
                for (const auto& [preset, name] : {std::pair(CameraPreset::front, "front"),
                                                   {CameraPreset::top, "top"},
                                                   {CameraPreset::side, "side"},
                                                   {CameraPreset::isometric, "isometric"}}) {
                    QTest::addRow("%s %s %s", name, dark ? "dark" : "light",
                                  parallel ? "parallel" : "perspective")
                        << static_cast<int>(preset) << dark << parallel;
                }
            }
        }
    }

    void aContactHasItsColourWhereTheProjectionSays() {
        QFETCH(int, preset);
        QFETCH(bool, dark);
        QFETCH(bool, parallel);
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        Stage stage;
        QVERIFY(stage.ready());
        check(stage.view, "parallel", parallel);
        const QColor colour = base::identityColour(2, dark);
        // Centre of a taxel: its peak is the load that was put in.
        const double x_m = kLayout.x_m(10), y_m = kLayout.y_m(1);
        stage.view.setSnapshot(test::pressed(kLayout, {{2, x_m, y_m, 1.0, 0.003}}, 1));
        stage.view.look(static_cast<CameraPreset>(preset));
        stage.settle();
        const QPoint there = pixelOf(stage.view, peakOf(x_m, y_m));
        QImage picture = shown(stage.view);
        QVERIFY(picture.rect().contains(there));
        QVERIFY2(
            hasHueOf(picture.pixel(there), colour),
            qPrintable(QColor(picture.pixel(there)).name() + QStringLiteral(" instead of ") + colour.name()));

        // The contact goes, its colour with it.
        stage.view.setSnapshot(test::pressed(kLayout, {}, 2));
        picture = shown(stage.view);
        QVERIFY(!hasHueOf(picture.pixel(there), colour));
    }

    void onTheCylinderAContactIsWhereTheWrappedArrayHasIt() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSurface(Surface::cylinder);
        const double x_m = kLayout.x_m(3), y_m = kLayout.y_m(0);
        stage.view.setSnapshot(test::pressed(kLayout, {{2, x_m, y_m, 1.0, 0.003}}));
        stage.view.look(CameraPreset::front); // row 0 is on the near side
        stage.settle();
        // On the cylinder the rise is a share of 2 radii at most, here 0.15 * 0.05.
        const double height_m = 0.06 * 0.0034 + 0.15 * 0.05;
        const double angle = y_m / 0.025;
        const Eigen::Vector3d foot(x_m, (0.025 + height_m) * std::sin(angle),
                                   (0.025 + height_m) * std::cos(angle));
        const QImage picture = shown(stage.view);
        QVERIFY(hasHueOf(picture.pixel(pixelOf(stage.view, foot)), base::identityColour(2, false)));
    }

    void aLoadedTaxelIsAsBrightAsItsPlaceInTheMap() {
        Stage stage;
        QVERIFY(stage.ready());
        check(stage.view, "parallel", true);
        auto snapshot = test::pressed(kLayout, {});
        const auto taxel = [](int row, int column) { return static_cast<std::size_t>(row * 14 + column); };
        snapshot.load_N[taxel(2, 4)] = 0.5F;
        snapshot.load_N[taxel(2, 9)] = 1.0F;
        stage.view.setSnapshot(snapshot);
        stage.view.look(CameraPreset::top);
        stage.settle();
        const QImage picture = shown(stage.view);
        const auto colourAt = [&](int row, int column) {
            return QColor(picture.pixel(pixelOf(stage.view, {kLayout.x_m(column), kLayout.y_m(row), 0.0})));
        };
        // Cividis rises in lightness from dark blue over grey to yellow; its ends and middle keep that under
        // the light.
        QVERIFY(colourAt(0, 0).lightnessF() < colourAt(2, 4).lightnessF());
        QVERIFY(colourAt(2, 4).lightnessF() < colourAt(2, 9).lightnessF());
        QVERIFY(hasHueOf(colourAt(0, 0).rgb(), QColor(base::cividis()[0])));
        QVERIFY(hasHueOf(colourAt(2, 9).rgb(), QColor(base::cividis()[255])));
    }

    void deadTaxelsAreCrossed() {
        Stage stage;
        QVERIFY(stage.ready());
        auto snapshot = test::pressed(kLayout, {});
        stage.view.setSnapshot(snapshot);
        stage.view.look(CameraPreset::top);
        const QColor lost = base::statusColours(base::designedPalette(false)).lost;
        const int before = countHue(shown(stage.view), lost);
        snapshot.dead[20] = 1;
        ++snapshot.frame;
        stage.view.setSnapshot(snapshot);
        QVERIFY(countHue(shown(stage.view), lost) > before + 10);
    }

    /// By a stripe on the screen, by the word in a picture that leaves the program.
    void dataThatAreNotLiveSayIt() {
        Stage stage;
        QVERIFY(stage.ready());
        const QColor violet = base::statusColours(base::designedPalette(false)).simulated;
        const auto copied = [&] {
            return vtkOf(stage.view).picture(1.0).convertToFormat(QImage::Format_RGB32);
        };
        stage.view.setSnapshot(test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}}));
        QCOMPARE(countHue(copied(), violet), 0);
        stage.view.setProvenance(base::Provenance::simulated);
        QVERIFY(countHue(copied(), violet) > 300);
        QCOMPARE(countHue(shown(stage.view), violet), 0);
        QCOMPARE(stage.view.grab().toImage().pixelColor(stage.view.width() / 2, 1), violet);
        stage.view.setProvenance(base::Provenance::recorded);
        QCOMPARE(countHue(copied(), violet), 0);
        stage.view.setProvenance(base::Provenance::live);
        QCOMPARE(countHue(copied(), violet), 0);
        QVERIFY(stage.view.grab().toImage().pixelColor(stage.view.width() / 2, 1) != violet);
    }

    void contourVerticesAndArmAreWhereTheyWerePut() {
        Stage stage;
        QVERIFY(stage.ready());
        std::vector<Eigen::Vector3d> curve;
        for (int i = 0; i <= 90; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 90;
            curve.emplace_back(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.0);
        }
        const std::vector<Eigen::Vector3d> vertices = {{0.02, 0.0, 0.0}};
        stage.view.setContour(vertices, curve, vertices, {});
        const auto linkAt = [](double y_m, double z_m) {
            return view3d::ArmLink{Eigen::Isometry3d(Eigen::Translation3d(-0.1, y_m, z_m)), 0.2, 0.02};
        };
        // The second one is between the camera and the curve, which shows through it.
        stage.view.setArmLinks(std::vector{linkAt(0.1, 0.0), linkAt(curve[10].y(), 0.05)});
        stage.view.look(CameraPreset::top);
        stage.settle();
        const QImage picture = shown(stage.view);
        const QPalette palette = base::designedPalette(false);
        QVERIFY(hasHueOf(picture.pixel(pixelOf(stage.view, curve[10])), palette.color(QPalette::Link)));
        QVERIFY(hasHueOf(picture.pixel(pixelOf(stage.view, {0.02, 0.0, 0.003})),
                         base::statusColours(palette).stale));
        // Half way along the link, 0.1 m from its joint: not the background.
        const QColor tube(picture.pixel(pixelOf(stage.view, {0.0, 0.1, 0.02})));
        QVERIFY(tube.lightnessF() < palette.color(QPalette::Base).lightnessF() - 0.05F);
        stage.view.setContour({}, {}, {}, {});
        stage.view.setArmLinks({});
        QCOMPARE(countHue(shown(stage.view), base::statusColours(palette).stale), 0);
    }

    void thePoseMovesTheSensor() {
        Stage stage;
        QVERIFY(stage.ready());
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translate(Eigen::Vector3d(0.3, -0.1, 0.2))
            .rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()));
        stage.view.setSensorPose(pose);
        const double x_m = kLayout.x_m(10), y_m = kLayout.y_m(1);
        stage.view.setSnapshot(test::pressed(kLayout, {{2, x_m, y_m, 1.0, 0.003}}));
        stage.settle();
        const QPoint there = pixelOf(stage.view, pose * peakOf(x_m, y_m));
        const QImage picture = shown(stage.view);
        QVERIFY(picture.rect().contains(there));
        QVERIFY(hasHueOf(picture.pixel(there), base::identityColour(2, false)));
    }

    void thePaletteChangesTheSceneWhileItRuns() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {{1, 0.0, 0.0, 1.0}}));
        const QRgb light = shown(stage.view).pixel(2, 2);
        base::applyTheme(base::ThemeChoice::dark);
        QVERIFY(QColor(light).lightnessF() > 0.9F);
        QTRY_VERIFY(QColor(shown(stage.view).pixel(2, 2)).lightnessF() < 0.2F);
        QVERIFY(countHue(shown(stage.view), base::identityColour(1, true)) > 20);
    }

    void presetsLookAlongTheirAxes_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<Eigen::Vector3d>("direction");
        QTest::addColumn<Eigen::Vector3d>("up");
        QTest::newRow("front") << int(Qt::Key_1) << Eigen::Vector3d(0, 1, 0) << Eigen::Vector3d(0, 0, 1);
        QTest::newRow("top") << int(Qt::Key_2) << Eigen::Vector3d(0, 0, -1) << Eigen::Vector3d(0, 1, 0);
        QTest::newRow("side") << int(Qt::Key_3) << Eigen::Vector3d(-1, 0, 0) << Eigen::Vector3d(0, 0, 1);
        QTest::newRow("isometric") << int(Qt::Key_4) << Eigen::Vector3d(-1, 1, -1).normalized()
                                   << Eigen::Vector3d(-1, 1, 2).normalized();
        QTest::newRow("home") << int(Qt::Key_Home) << Eigen::Vector3d(-1, 1, -1).normalized()
                              << Eigen::Vector3d(-1, 1, 2).normalized();
    }

    void presetsLookAlongTheirAxes() {
        QFETCH(int, key);
        QFETCH(Eigen::Vector3d, direction);
        QFETCH(Eigen::Vector3d, up);
        for (const auto modifier : {Qt::NoModifier, Qt::KeypadModifier}) {
            Stage stage;
            QVERIFY(stage.ready());
            QVERIFY(stage.focused());
            QTest::keyClick(&vtkOf(stage.view), Qt::Key_Right); // away from the start
            QTest::keyClick(vtkOf(stage.view).focusProxy(), static_cast<Qt::Key>(key), modifier);
            vtkCamera* camera = rendererOf(stage.view)->GetActiveCamera();
            const Eigen::Vector3d seen(camera->GetDirectionOfProjection());
            const Eigen::Vector3d seenUp(camera->GetViewUp());
            QVERIFY((seen - direction).norm() < 1e-9);
            QVERIFY((seenUp - up).norm() < 1e-9);
        }
    }

    void draggingTurnsTheCameraByHalfATurnPerHeight() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        stage.view.look(CameraPreset::side);
        stage.settle();
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        const double height = canvas->height();
        QTest::mousePress(canvas, Qt::LeftButton, {}, QPoint(240, 150));
        QTest::mouseMove(canvas, QPoint(280, 210));
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, QPoint(280, 210));
        const view3d::Orbit& orbit = stage.view.orbit();
        const double perPixel = std::numbers::pi / height;
        QVERIFY(std::abs(orbit.azimuth_rad + 40.0 * perPixel) < perPixel);
        QVERIFY(std::abs(orbit.elevation_rad - 60.0 * perPixel) < perPixel);
        const Eigen::Vector3d seen(rendererOf(stage.view)->GetActiveCamera()->GetDirectionOfProjection());
        QVERIFY((seen + orbit.direction()).norm() < 1e-9);
    }

    void aClickPicksTheObjectThatIsThereAndADragPicksNone() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        const Eigen::Vector3d first(-0.06, 0.04, 0.0);
        const Eigen::Vector3d second(0.06, -0.04, 0.0);
        const auto around = [](const Eigen::Vector3d& at) {
            return std::vector<Eigen::Vector3d>{at, at + Eigen::Vector3d(0.03, 0.0, 0.0)};
        };
        std::vector<view3d::DrawnObject> objects(2);
        objects[0].number = 7;
        objects[0].points_m = objects[0].curve_m = around(first);
        objects[1].number = 9;
        objects[1].points_m = objects[1].curve_m = around(second);
        objects[1].elsewhere = true; // its contour is drawn by something else
        stage.view.setObjects(objects);
        stage.view.look(CameraPreset::top);
        stage.settle();
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        const double scale = vtkOf(stage.view).devicePixelRatioF();
        const auto pointOf = [&](const Eigen::Vector3d& p_World) {
            return (QPointF(pixelOf(stage.view, p_World)) / scale).toPoint();
        };
        QSignalSpy picked(&stage.view, &Scene3dView::objectPicked);
        QTest::mouseClick(canvas, Qt::LeftButton, {}, pointOf(first));
        QTest::mouseClick(canvas, Qt::LeftButton, {}, pointOf(second + Eigen::Vector3d(0.015, 0.0, 0.0)));
        QCOMPARE(picked.size(), 2);
        QCOMPARE(picked[0][0].toULongLong(), 7ULL);
        QCOMPARE(picked[1][0].toULongLong(), 9ULL);
        QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(3, 3));
        const QPoint from = pointOf(first);
        QTest::mousePress(canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas, from + QPoint(60, 0));
        QTest::mouseMove(canvas, from);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, from);
        QCOMPARE(picked.size(), 2);
    }

    void aMarkedObjectIsDrawnLarger() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        std::vector<view3d::DrawnObject> objects(1);
        objects[0].number = 2;
        objects[0].points_m = objects[0].curve_m = {{-0.05, 0.05, 0.0}, {0.05, 0.05, 0.0}};
        stage.view.setObjects(objects);
        stage.view.look(CameraPreset::top);
        const QColor colour = base::identityColour(2, false);
        const int plain = countHue(shown(stage.view), colour);
        QVERIFY(plain > 0);
        objects[0].marked = true;
        stage.view.setObjects(objects);
        QVERIFY(countHue(shown(stage.view), colour) > 3 * plain / 2);
        objects[0].marked = false;
        objects[0].elsewhere = true;
        stage.view.setObjects(objects);
        QCOMPARE(countHue(shown(stage.view), colour), 0);
    }

    void panningMovesTheSceneWithTheMouse() {
        Stage stage;
        QVERIFY(stage.ready());
        check(stage.view, "parallel", true);
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        stage.view.look(CameraPreset::top);
        stage.settle();
        const QPoint before = pixelOf(stage.view, Eigen::Vector3d::Zero());
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        QTest::mousePress(canvas, Qt::LeftButton, Qt::ShiftModifier, QPoint(240, 150));
        QMouseEvent move(QEvent::MouseMove, QPointF(290, 130), canvas->mapToGlobal(QPointF(290, 130)),
                         Qt::NoButton, Qt::LeftButton, Qt::ShiftModifier);
        QApplication::sendEvent(canvas, &move);
        QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ShiftModifier, QPoint(290, 130));
        const QPoint moved = pixelOf(stage.view, Eigen::Vector3d::Zero()) - before;
        const double ratio = stage.view.devicePixelRatioF();
        QVERIFY(std::abs(moved.x() - 50.0 * ratio) <= 1.5 * ratio);
        QVERIFY(std::abs(moved.y() + 20.0 * ratio) <= 1.5 * ratio);
    }

    void theWholeSceneIsInsideThePictureWhateverItsShape() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        for (const QSize size : {QSize(640, 480), QSize(900, 320), QSize(300, 700)}) {
            stage.view.resize(size);
            for (const auto preset :
                 {CameraPreset::front, CameraPreset::top, CameraPreset::side, CameraPreset::isometric}) {
                for (const bool parallel : {false, true}) {
                    check(stage.view, "parallel", parallel);
                    stage.view.look(preset);
                    const QRect room = shown(stage.view).rect();
                    for (const double x_m : {-0.0238, 0.0238}) {
                        for (const double y_m : {-0.0102, 0.0102}) {
                            QVERIFY(room.contains(pixelOf(stage.view, {x_m, y_m, 0.0})));
                        }
                    }
                }
            }
        }
    }

    void aZoomedViewStaysWhenTheWindowChanges() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}));
        vtkCamera* camera = rendererOf(stage.view)->GetActiveCamera();
        QTest::keyClick(vtkOf(stage.view).focusProxy(), Qt::Key_Plus);
        const double distance_m = camera->GetDistance();
        stage.view.resize(900, 300);
        stage.settle();
        QCOMPARE(camera->GetDistance(), distance_m);
        stage.view.resetView();
        QVERIFY(camera->GetDistance() != distance_m);
    }

    void whileHiddenNothingIsDrawnAndThenTheNewestIs() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {}, 1));
        stage.settle();
        stage.view.hide();
        const std::uint64_t frames = vtkOf(stage.view).framesRendered();
        for (std::uint64_t frame = 2; frame < 20; ++frame) {
            stage.view.setSnapshot(test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}, frame));
            QCoreApplication::processEvents();
        }
        QCOMPARE(vtkOf(stage.view).framesRendered(), frames);
        stage.view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&stage.view));
        QVERIFY(countHue(shown(stage.view), base::identityColour(2, false)) > 20);
    }

    void aSnapshotThatCannotBeDrawnClearsTheView() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}));
        QVERIFY(countHue(shown(stage.view), base::identityColour(2, false)) > 20);
        auto broken = test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}, 2);
        broken.load_N.clear();
        stage.view.setSnapshot(broken);
        QCOMPARE(countHue(shown(stage.view), base::identityColour(2, false)), 0);
    }

    void layoutsOfAnySizeAreDrawn() {
        Stage stage;
        QVERIFY(stage.ready());
        std::uint64_t frame = 0;
        for (const core::ArrayLayout layout : {core::ArrayLayout{.rows = 1, .columns = 1, .pitchX_m = 0.0034},
                                               {.rows = 256, .columns = 256, .pitchX_m = 0.0005},
                                               {.rows = 27, .columns = 64, .pitchX_m = 0.0034},
                                               {.rows = 1, .columns = 200, .pitchX_m = 0.1}}) {
            for (const Surface surface : {Surface::plate, Surface::cylinder}) {
                stage.view.setSurface(surface);
                stage.view.setSnapshot(
                    test::pressed(layout, {{2, 0.0, 0.0, 1.0, 4.0 * layout.pitchX_m}}, ++frame));
                QVERIFY(countHue(shown(stage.view), base::identityColour(2, false)) > 10);
            }
        }
    }

    void theDockMayFloatAndComeBackWithTheSceneInIt() {
        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* view = new Scene3dView;
        view->setMinimumSize(400, 300);
        dock->setWidget(view);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        view->setSnapshot(test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}));
        QVERIFY(countHue(shown(*view), base::identityColour(2, false)) > 100);
        for (const bool floating : {true, false, true}) {
            const std::uint64_t frames = vtkOf(*view).framesRendered();
            dock->setFloating(floating);
            QVERIFY(QTest::qWaitFor([&] { return vtkOf(*view).framesRendered() > frames; }));
            QVERIFY(vtkOf(*view).canRender());
            QVERIFY(countHue(shown(*view), base::identityColour(2, false)) > 100);
        }
    }

    void theViewMayDieWhileSnapshotsArrive() {
        QTimer timer;
        std::uint64_t frame = 0;
        auto stage = std::make_unique<Stage>();
        connect(&timer, &QTimer::timeout, &stage->view, [&] {
            ++frame;
            stage->view.setSnapshot(
                test::pressed(kLayout, {{1, 1e-4 * static_cast<double>(frame % 100), 0.0, 1.0}}, frame));
        });
        timer.start(0);
        QVERIFY(stage->ready());
        QVERIFY(QTest::qWaitFor([&] { return vtkOf(stage->view).framesRendered() > 5; }));
        stage.reset();
        const std::uint64_t atDeath = frame;
        QCoreApplication::processEvents();
        QCOMPARE(frame, atDeath);
    }

    void aPictureGoesToTheClipboardForPaper() {
        base::applyTheme(base::ThemeChoice::dark);
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}));
        stage.settle();
        QVERIFY(stage.focused());
        QTest::keySequence(vtkOf(stage.view).focusProxy(), QKeySequence::Copy);
        const QImage copied = QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32);
        QVERIFY(!copied.isNull());
        QVERIFY(copied.width() >= 2 * vtkOf(stage.view).width());
        QVERIFY(QColor(copied.pixel(4, 4)).lightnessF() > 0.9F);
        QVERIFY(countHue(copied, base::identityColour(2, false)) > 100);
        QVERIFY(QColor(shown(stage.view).pixel(2, 2)).lightnessF() < 0.2F); // the view itself is as it was
    }

    void theMenuOffersEverythingWithText() {
        Stage stage;
        QVERIFY(stage.ready());
        QMenu menu;
        stage.view.fillMenu(menu);
        int actions = 0;
        for (const QAction* action : menu.actions()) {
            if (!action->isSeparator()) {
                ++actions;
                QVERIFY(!action->text().isEmpty());
            }
        }
        QVERIFY(actions >= 18);
        for (const QAction* action : stage.view.actions()) {
            QVERIFY(!action->toolTip().isEmpty());
        }
    }

    void hoveringNamesTheContact() {
        Stage stage;
        QVERIFY(stage.ready());
        stage.view.setSnapshot(test::pressed(kLayout, {{2, kLayout.x_m(10), kLayout.y_m(1), 1.0, 0.003}}));
        stage.settle();
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        const QPoint there = (QPointF(pixelOf(stage.view, peakOf(kLayout.x_m(10), kLayout.y_m(1)))) /
                              stage.view.devicePixelRatioF())
                                 .toPoint();
        QHelpEvent on(QEvent::ToolTip, there, canvas->mapToGlobal(there));
        QApplication::sendEvent(canvas, &on);
        QVERIFY(QToolTip::text().contains(QStringLiteral("2")));
        QVERIFY(QToolTip::text().contains(QStringLiteral("N")));
        QToolTip::hideText();
        QHelpEvent off(QEvent::ToolTip, QPoint(3, 200), canvas->mapToGlobal(QPoint(3, 200)));
        QApplication::sendEvent(canvas, &off);
        QTRY_VERIFY(!QToolTip::isVisible());
    }

    void geometryIsSavedFromTheView() {
        Stage stage;
        QVERIFY(stage.ready());
        const QTemporaryDir folder;
        QVERIFY(!stage.view.saveGeometry(folder.filePath(QStringLiteral("empty.stl"))));
        stage.view.setSnapshot(test::pressed(kLayout, {{2, 0.0, 0.0, 1.0}}));
        QVERIFY(stage.view.saveGeometry(folder.filePath(QStringLiteral("touch.stl"))));
        QVERIFY(QFileInfo(folder.filePath(QStringLiteral("touch.stl"))).size() > 84 + 50 * 800);
    }
};

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    Scene3dViewTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "scene3d_view_test.moc"
