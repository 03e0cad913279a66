// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/gl_setup.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QDockWidget>
#include <QTest>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;

namespace {
constexpr int kPatience_ms = 60'000;
}

/// The console on a display that has no OpenGL.
class MainWindowWithoutGlTest : public QObject {
    Q_OBJECT

private slots:
    void theViewThatNeedsItSaysSoAndAllOthersWork() {
        QVERIFY(view3d::findGlProblem() != view3d::GlProblem::none);
        base::applyTheme(base::ThemeChoice::light);
        core::StopSwitch stop;
        ConsoleSettings settings(true);
        ConsoleOptions options;
        options.scenes << "teleta-touch";
        MainWindow window(options, settings, stop);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.openRequested(options);
        QTRY_VERIFY_WITH_TIMEOUT(
            window.sources().active() != nullptr && window.sources().active()->displayed > 3, kPatience_ms);
        auto* scene = window.findChild<view3d::Scene3dView*>();
        const auto* vtk = scene->findChild<view3d::VtkWidget*>();
        QVERIFY(scene->isVisible() && !vtk->canRender());
        QVERIFY2(vtk->fallbackText().contains("OpenGL"), qPrintable(vtk->fallbackText()));
        auto* dock = window.findChild<QDockWidget*>("reconstruction");
        for (const bool floats : {true, false}) {
            dock->setFloating(floats);
            const auto before = window.sources().active()->displayed;
            QTRY_VERIFY_WITH_TIMEOUT(window.sources().active()->displayed > before, kPatience_ms);
        }
        QVERIFY(!window.grab().isNull());
        QCOMPARE(window.operatePage().messages().count(), 0);
        QVERIFY(!window.anyFailure());
        window.close();
    }
};

int main(int argc, char* argv[]) {
    qputenv("QT_XCB_GL_INTEGRATION", "none");
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowWithoutGlTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_without_gl_test.moc"
