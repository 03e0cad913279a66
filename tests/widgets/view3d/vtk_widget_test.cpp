// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

using teleta::view3d::VtkWidget;

namespace {

constexpr QRgb kBackground = qRgb(0, 0, 255);
constexpr QRgb kSquare = qRgb(255, 128, 0);

/// A square of +-1 in the plane z = 0, seen by a parallel camera of height +-2: the square covers half the
/// height.
struct SquareScene {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkActor> actor;

    explicit SquareScene(VtkWidget& view) {
        const vtkNew<vtkPoints> points;
        points->InsertNextPoint(-1, -1, 0);
        points->InsertNextPoint(1, -1, 0);
        points->InsertNextPoint(1, 1, 0);
        points->InsertNextPoint(-1, 1, 0);
        const vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({0, 1, 2, 3});
        const vtkNew<vtkPolyData> square;
        square->SetPoints(points);
        square->SetPolys(cells);
        const vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(square);
        actor->SetMapper(mapper);
        actor->GetProperty()->SetColor(1.0, 128.0 / 255.0, 0.0);
        actor->GetProperty()->LightingOff();
        renderer->SetBackground(0, 0, 1);
        renderer->AddActor(actor);
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->ParallelProjectionOn();
        camera->SetParallelScale(2);
        camera->SetPosition(0, 0, 10);
        camera->SetFocalPoint(0, 0, 0);
        camera->SetViewUp(0, 1, 0);
        renderer->ResetCameraClippingRange();
        view.renderWindow()->AddRenderer(renderer);
    }
};

/// Shares of the picture in the square's colour, in the background's, and in neither.
struct Shares {
    double square = 0.0;
    double background = 0.0;
    double other = 0.0;
};

bool near(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) <= 2 && std::abs(qGreen(a) - qGreen(b)) <= 2 &&
           std::abs(qBlue(a) - qBlue(b)) <= 2;
}

Shares countColours(const QImage& picture) {
    Shares shares;
    const double pixel = 1.0 / (static_cast<double>(picture.width()) * picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb colour = picture.pixel(x, y);
            (near(colour, kSquare)       ? shares.square
             : near(colour, kBackground) ? shares.background
                                         : shares.other) += pixel;
        }
    }
    return shares;
}

/// Of a view of width x height the square covers (h/2)^2 / (w h) = h / (4 w).
bool showsTheSquare(const QImage& picture) {
    const Shares shares = countColours(picture);
    const double expected = 0.25 * picture.height() / picture.width();
    const double edge = 4.0 / picture.height(); // antialiased outline
    return std::abs(shares.square - expected) < edge && shares.other < edge &&
           qAlpha(picture.pixel(1, 1)) == 255;
}

bool drawn(VtkWidget& view, std::uint64_t atLeast = 1) {
    return QTest::qWaitFor([&] { return view.framesRendered() >= atLeast; });
}

bool isShown(VtkWidget& view) {
    view.show();
    return QTest::qWaitForWindowExposed(&view) && drawn(view);
}

/// Turns the camera by -200 deg per width while the left button is held, and zooms with the wheel.
class TurningStyle : public vtkInteractorStyle {
public:
    static TurningStyle* New();

    void OnLeftButtonDown() override { m_turns = true; }
    void OnLeftButtonUp() override { m_turns = false; }
    void OnMouseMove() override {
        if (!m_turns)
            return;
        const int moved = Interactor->GetEventPosition()[0] - Interactor->GetLastEventPosition()[0];
        m_camera->Azimuth(-200.0 * moved / Interactor->GetSize()[0]);
        Interactor->Render();
    }
    void OnMouseWheelForward() override { m_camera->SetParallelScale(m_camera->GetParallelScale() / 1.21); }
    void OnMouseWheelBackward() override { m_camera->SetParallelScale(m_camera->GetParallelScale() * 1.21); }

    vtkCamera* m_camera = nullptr;

private:
    bool m_turns = false;
};

vtkStandardNewMacro(TurningStyle);

} // namespace

class VtkWidgetTest : public QObject {
    Q_OBJECT

private slots:
    void theSceneCoversTheSharesOfThePictureThatItsGeometrySays() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(401, 301);
        QVERIFY(isShown(view));
        QVERIFY(view.canRender());
        const QImage picture = view.grab().toImage();
        QCOMPARE(picture.size(), QSize(401, 301) * view.devicePixelRatio());
        QVERIFY(showsTheSquare(picture));
        QCOMPARE(view.renderWindow()->GetSize()[0], picture.width());
    }

    void theSceneIsShownOnTheScreenAndNotOnlyInAGrab() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(320, 240);
        QVERIFY(isShown(view));
        QVERIFY(QTest::qWaitFor(
            [&] { return showsTheSquare(view.screen()->grabWindow(view.winId()).toImage()); }));
    }

    void aWindowWithAViewIsNotPutTogetherByOpenGl() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(320, 240);
        QVERIFY(isShown(view));
        QCOMPARE(view.windowHandle()->surfaceType(), QSurface::RasterSurface);
    }

    void nothingIsDrawnUntilSomethingChanged() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(320, 240);
        QVERIFY(isShown(view));
        const std::uint64_t frames = view.framesRendered();
        view.update();
        view.repaint();
        view.grab();
        QCOMPARE(view.framesRendered(), frames);
        view.requestRender();
        view.requestRender();
        view.grab();
        QCOMPARE(view.framesRendered(), frames + 1);
    }

    void theScreenKeepsTheLastFrameUntilTheNextIsDrawn() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(320, 240);
        QVERIFY(isShown(view));
        const QPoint middle(160, 120);
        const auto isOnScreen = [&](QRgb colour) {
            const QImage screen = view.screen()->grabWindow(view.winId()).toImage();
            return near(screen.pixel(middle * screen.width() / view.width()), colour);
        };
        QVERIFY(QTest::qWaitFor([&] { return isOnScreen(kSquare); }));
        const std::uint64_t frames = view.framesRendered();
        scene.actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
        view.requestRender();
        view.repaint(); // does not draw the scene, and waits for nothing
        QCOMPARE(view.framesRendered(), frames);
        QVERIFY(isOnScreen(kSquare));
        QVERIFY(QTest::qWaitFor([&] { return isOnScreen(qRgb(0, 255, 0)); }));
        QCOMPARE(view.framesRendered(), frames + 1);
        scene.actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
        view.requestRender();
        QVERIFY(QTest::qWaitFor([&] { return isOnScreen(qRgb(255, 0, 0)); }));
        QCOMPARE(view.framesRendered(), frames + 2);
    }

    void whatChangedWhileTheViewWasHiddenIsOnTheScreenWhenItAppears() {
        QWidget window;
        auto* view = new VtkWidget(&window);
        const SquareScene scene(*view);
        window.resize(320, 240);
        view->resize(320, 240);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const auto isOnScreen = [&](QRgb colour) {
            const QImage screen = window.screen()->grabWindow(window.winId()).toImage();
            return near(screen.pixel(screen.width() / 2, screen.height() / 2), colour);
        };
        QVERIFY(QTest::qWaitFor([&] { return isOnScreen(kSquare); }));
        view->hide();
        scene.actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
        view->requestRender();
        QCoreApplication::processEvents();
        view->show(); // and nobody asks again
        QVERIFY(QTest::qWaitFor([&] { return isOnScreen(qRgb(0, 255, 0)); }));
    }

    void resizingKeepsTheSceneInShape() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(320, 240);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        for (const QSize size :
             {QSize(641, 333), QSize(200, 200), QSize(500, 150), QSize(1, 1), QSize(320, 240)}) {
            view.resize(size);
            const QImage picture = view.grab().toImage();
            QCOMPARE(picture.size(), size * view.devicePixelRatio());
            if (size.width() > 1) {
                QVERIFY(showsTheSquare(picture));
            }
        }
    }

    void aFloatingDockAndADockedOneDrawTheSameScene() {
        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* view = new VtkWidget;
        view->setMinimumSize(400, 200); // wide enough that the square is not cut
        const SquareScene scene(*view);
        dock->setWidget(view);
        window.setCentralWidget(new QLabel(QStringLiteral("centre")));
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        window.resize(800, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(drawn(*view));
        QVERIFY(showsTheSquare(view->grab().toImage()));
        for (int round = 0; round < 3; ++round) {
            for (const bool floating : {true, false}) {
                const std::uint64_t frames = view->framesRendered();
                dock->setFloating(floating);
                if (floating) {
                    QVERIFY(QTest::qWaitForWindowExposed(dock));
                }
                QVERIFY(drawn(*view, frames + 1));
                QVERIFY(view->canRender());
                QVERIFY(showsTheSquare(view->grab().toImage()));
            }
        }
        // Closed and opened again, as from a page's menu.
        dock->close();
        dock->show();
        QVERIFY(showsTheSquare(view->grab().toImage()));
    }

    void aViewMayDieWhileTimersStillAskItToDraw() {
        QTimer timer;
        auto view = std::make_unique<VtkWidget>();
        const SquareScene scene(*view);
        int asked = 0;
        connect(&timer, &QTimer::timeout, view.get(), [&, raw = view.get()] {
            raw->requestRender();
            ++asked;
        });
        timer.start(0);
        view->resize(320, 240);
        view->show();
        QVERIFY(QTest::qWaitForWindowExposed(view.get()));
        QVERIFY(drawn(*view, 3));
        view.reset();
        const int atDeath = asked;
        QCoreApplication::processEvents();
        QCOMPARE(asked, atDeath);

        VtkWidget second; // the driver still works for the next one
        const SquareScene again(second);
        second.resize(320, 240);
        second.show();
        QVERIFY(QTest::qWaitForWindowExposed(&second));
        QVERIFY(showsTheSquare(second.grab().toImage()));
    }

    void aSceneThatOutlivesItsViewIsDrawnByTheNext() {
        auto first = std::make_unique<VtkWidget>();
        const SquareScene scene(*first);
        first->resize(300, 300);
        first->show();
        QVERIFY(QTest::qWaitForWindowExposed(first.get()));
        QVERIFY(showsTheSquare(first->grab().toImage()));
        first->renderWindow()->RemoveRenderer(scene.renderer);
        first.reset();

        VtkWidget second;
        second.renderWindow()->AddRenderer(scene.renderer);
        second.resize(300, 300);
        second.show();
        QVERIFY(QTest::qWaitForWindowExposed(&second));
        QVERIFY(showsTheSquare(second.grab().toImage()));
    }

    void aLargePictureIsTheSameSceneWithMorePixels() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(300, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QSignalSpy scales(&view, &VtkWidget::pixelScaleChanged);
        const QImage picture = view.picture(3.0);
        QCOMPARE(picture.size(), QSize(900, 600) * view.devicePixelRatio());
        QVERIFY(showsTheSquare(picture));
        QVERIFY(!scales.isEmpty());
        QCOMPARE(scales.last().first().toDouble(), view.devicePixelRatioF());
        QVERIFY(showsTheSquare(view.grab().toImage()));
        QCOMPARE(view.grab().toImage().size(), QSize(300, 200) * view.devicePixelRatio());
    }

    void theOverlayIsPaintedOverTheSceneInLogicalPixels() {
        VtkWidget view;
        const SquareScene scene(view);
        view.setOverlay([](QPainter& painter, const QSizeF& size) {
            painter.fillRect(QRectF(size.width() - 20.0, 0.0, 20.0, 20.0), QColor(0, 255, 0));
        });
        view.resize(300, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const double ratio = view.devicePixelRatioF();
        for (int round = 0; round < 2; ++round) { // OpenGL painting must not disturb the next VTK frame
            const QImage shown = view.grab().toImage();
            QCOMPARE(shown.pixel(shown.width() - 3, 3), qRgb(0, 255, 0));
            QVERIFY(near(shown.pixel(3, 3), kBackground));
            QVERIFY(near(shown.pixel(shown.width() - 1 - static_cast<int>(22 * ratio), 3), kBackground));
            QVERIFY(near(shown.pixel(shown.width() / 2, shown.height() / 2), kSquare));
            const QImage large = view.picture(2.0);
            QCOMPARE(large.pixel(large.width() - 3, 3), qRgb(0, 255, 0));
            QVERIFY(near(large.pixel(large.width() / 2, large.height() / 2), kSquare));
        }
    }

    void draggingWithTheLeftButtonTurnsTheCamera() {
        VtkWidget view;
        const SquareScene scene(view);
        const vtkNew<TurningStyle> style;
        style->m_camera = scene.renderer->GetActiveCamera();
        view.interactor()->SetInteractorStyle(style);
        view.resize(300, 200);
        QVERIFY(isShown(view));
        vtkCamera* camera = scene.renderer->GetActiveCamera();
        QWidget* canvas = view.focusProxy();
        QVERIFY(canvas != nullptr);
        const std::uint64_t frames = view.framesRendered();
        QTest::mousePress(canvas, Qt::LeftButton, {}, QPoint(150, 100));
        QTest::mouseMove(canvas, QPoint(180, 100));
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, QPoint(180, 100));
        // To the right by 30 of 300 px: by -20 deg.
        double direction[3];
        camera->GetDirectionOfProjection(direction);
        QVERIFY(direction[0] > 0.2);
        QVERIFY(std::abs(direction[1]) < 1e-6);
        QVERIFY(drawn(view, frames + 1));
    }

    void theWheelZoomsByWholeSteps() {
        VtkWidget view;
        const SquareScene scene(view);
        const vtkNew<TurningStyle> style;
        style->m_camera = scene.renderer->GetActiveCamera();
        view.interactor()->SetInteractorStyle(style);
        view.resize(300, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        vtkCamera* camera = scene.renderer->GetActiveCamera();
        const double before = camera->GetParallelScale();
        const auto turn = [&](int eighths) {
            QWheelEvent event(QPointF(150, 100), view.mapToGlobal(QPointF(150, 100)), {}, QPoint(0, eighths),
                              {}, {}, Qt::NoScrollPhase, false);
            QApplication::sendEvent(view.focusProxy(), &event);
        };
        turn(60);
        QCOMPARE(camera->GetParallelScale(), before);
        turn(60);
        QVERIFY(camera->GetParallelScale() < before);
        turn(-120);
        QVERIFY(std::abs(camera->GetParallelScale() - before) < 1e-9);
    }

    void keysAreLeftToTheWindowAround() {
        QWidget window;
        VtkWidget view(&window);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY2(view.canRender(), qPrintable(view.fallbackText()));
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(view.focusProxy(), &escape);
        QVERIFY(!escape.isAccepted());
    }

    void theRightButtonOpensTheMenuUnlessItDrags() {
        VtkWidget view;
        const SquareScene scene(view);
        view.resize(300, 200);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QSignalSpy menus(&view, &VtkWidget::menuRequested);
        QWidget* canvas = view.focusProxy();
        QTest::mouseClick(canvas, Qt::RightButton, {}, QPoint(50, 50));
        QCOMPARE(menus.size(), 1);
        QCOMPARE(menus.first().first().toPoint(), canvas->mapToGlobal(QPoint(50, 50)));
        QTest::mousePress(canvas, Qt::RightButton, {}, QPoint(50, 50));
        QMouseEvent move(QEvent::MouseMove, QPointF(50, 90), canvas->mapToGlobal(QPointF(50, 90)),
                         Qt::NoButton, Qt::RightButton, {});
        QApplication::sendEvent(canvas, &move);
        QTest::mouseRelease(canvas, Qt::RightButton, {}, QPoint(50, 90));
        QCOMPARE(menus.size(), 1);
    }
};

int main(int argc, char** argv) {
    teleta::view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    VtkWidgetTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "vtk_widget_test.moc"
