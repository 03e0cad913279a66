// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTest>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

using teleta::view3d::VtkWidget;

/// Runs where OpenGL is missing or too old.
class NoGlTest : public QObject {
    Q_OBJECT

private slots:
    void aTextSaysWhyThereIsNoView() {
        VtkWidget view;
        view.resize(400, 300);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QTRY_VERIFY(!view.canRender());
        QVERIFY2(!view.fallbackText().isEmpty(), "no text");
        QVERIFY(view.fallbackText().contains(QStringLiteral("OpenGL")));
        // Something is written: the picture has more than its background.
        const QImage picture = view.grab().toImage();
        const QRgb background = picture.pixel(0, 0);
        bool written = false;
        for (int y = 0; y < picture.height() && !written; ++y) {
            for (int x = 0; x < picture.width() && !written; ++x) {
                written = picture.pixel(x, y) != background;
            }
        }
        QVERIFY(written);
    }

    void everyCallIsHarmless() {
        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* view = new VtkWidget;
        const vtkNew<vtkRenderer> renderer;
        view->renderWindow()->AddRenderer(renderer);
        dock->setWidget(view);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTRY_VERIFY(!view->canRender());
        view->requestRender();
        dock->setFloating(true);
        view->resize(10, 10);
        view->requestRender();
        dock->setFloating(false);
        QVERIFY(view->picture(2.0).isNull());
        QCOMPARE(view->framesRendered(), std::uint64_t{0});
        QTest::mouseClick(view, Qt::LeftButton);
        QTest::keyClick(view, Qt::Key_R);
        view->setOverlay({});
    }

    void theSceneViewIsHarmlessToo() {
        using namespace teleta;
        view3d::Scene3dView view;
        view.resize(500, 400);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QTRY_VERIFY(!view.findChild<view3d::VtkWidget*>()->canRender());
        const core::ArrayLayout layout;
        for (std::uint64_t frame = 1; frame < 4; ++frame) {
            view.setSnapshot(test::pressed(layout, {{1, 0.0, 0.0, 1.0}}, frame));
        }
        view.setSurface(view3d::Surface::cylinder);
        view.setArmLinks(std::vector<view3d::ArmLink>(2));
        view.setContour(std::vector<Eigen::Vector3d>{{0, 0, 0}}, {}, {}, QStringLiteral("point"));
        for (const char* action : {"follow", "parallel"})
            view.findChild<QAction*>(QLatin1String(action))->setChecked(true);
        view.look(view3d::CameraPreset::top);
        view.setProvenance(base::Provenance::simulated);
        QTest::keyClick(&view, Qt::Key_Right);
        QTest::keyClick(&view, Qt::Key_1);
        view.hide();
        view.show();
        view.clear();
        QVERIFY(!view.findChild<view3d::VtkWidget*>()->fallbackText().isEmpty());
    }
};

int main(int argc, char** argv) {
    teleta::view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    NoGlTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "no_gl_test.moc"
