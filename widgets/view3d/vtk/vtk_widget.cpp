// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_widget.h"

#include "widgets/view3d/vtk/gl_setup.h"
#include "widgets/view3d/vtk/vtk_canvas.h"

#include <QEvent>
#include <QLabel>
#include <QLoggingCategory>
#include <QVBoxLayout>

#include <vtkCallbackCommand.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <utility>

namespace teleta::view3d {

namespace {

Q_LOGGING_CATEGORY(view3dLog, "teleta.view3d")

/// Sends VTK's messages to Qt's log.
class QtLogWindow : public vtkOutputWindow {
public:
    static QtLogWindow* New();

    void DisplayText(const char* text) override { qCInfo(view3dLog, "%s", text); }
    void DisplayErrorText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayWarningText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayGenericWarningText(const char* text) override { qCWarning(view3dLog, "%s", text); }
    void DisplayDebugText(const char* text) override { qCDebug(view3dLog, "%s", text); }

protected:
    QtLogWindow() = default;
};

vtkStandardNewMacro(QtLogWindow);

/// VTK gives an interactor a style of its own, and warns when the module of that is not linked. What is shown
/// sets another.
vtkSmartPointer<vtkGenericRenderWindowInteractor> makeInteractor() {
    const int warns = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    auto made = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
    vtkObject::SetGlobalWarningDisplay(warns);
    return made;
}

} // namespace

struct VtkWidget::Parts {
    vtkNew<GuestRenderWindow> window;
    vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor = makeInteractor();
    vtkNew<vtkCallbackCommand> onRender;
    VtkCanvas* canvas = nullptr;
    QLabel* fallback = nullptr;
    GlProblem problem = GlProblem::none;
};

VtkWidget::VtkWidget(QWidget* parent)
    : QWidget(parent)
    , m_parts(std::make_unique<Parts>()) {
    if (dynamic_cast<QtLogWindow*>(vtkOutputWindow::GetInstance()) == nullptr)
        vtkOutputWindow::SetInstance(vtkNew<QtLogWindow>());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);

    m_parts->interactor->SetRenderWindow(m_parts->window);
    m_parts->interactor->SetInteractorStyle(nullptr); // what it shows decides how it is turned
    // A render event of VTK becomes a request: the widget draws only when it is painted.
    m_parts->interactor->EnableRenderOff();
    m_parts->onRender->SetClientData(this);
    m_parts->onRender->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<VtkWidget*>(self)->requestRender(); });
    m_parts->interactor->AddObserver(vtkCommand::RenderEvent, m_parts->onRender);
    m_parts->interactor->Initialize();

    // The driver is asked when there is something to paint: most of the window is shown without it.
    if (!platformHasOpenGl()) {
        showFallback(GlProblem::noGlPlatform);
        return;
    }
    auto* canvas = new VtkCanvas(m_parts->window, m_parts->interactor, this);
    m_parts->canvas = canvas;
    layout->addWidget(canvas);
    setFocusProxy(canvas);
    connect(canvas, &VtkCanvas::pixelScaleChanged, this, &VtkWidget::pixelScaleChanged);
    connect(canvas, &VtkCanvas::menuRequested, this, &VtkWidget::menuRequested);
    connect(canvas, &VtkCanvas::clicked, this, &VtkWidget::clicked);
    // Queued: the canvas is in the middle of its first repaint when it says so.
    connect(canvas, &VtkCanvas::contextRefused, this, &VtkWidget::showFallback, Qt::QueuedConnection);
}

VtkWidget::~VtkWidget() {
    m_parts->interactor->RemoveObserver(m_parts->onRender);
    // Before the render window, which has resources in the canvas's context.
    delete m_parts->canvas;
    m_parts->interactor->SetRenderWindow(nullptr);
}

vtkRenderWindow* VtkWidget::renderWindow() const {
    return m_parts->window;
}

vtkRenderWindowInteractor* VtkWidget::interactor() const {
    return m_parts->interactor;
}

bool VtkWidget::canRender() const {
    return m_parts->canvas != nullptr;
}

QString VtkWidget::fallbackText() const {
    return m_parts->fallback != nullptr ? m_parts->fallback->text() : QString();
}

void VtkWidget::requestRender() {
    if (m_parts->canvas != nullptr)
        m_parts->canvas->requestRender();
}

void VtkWidget::noteChange() {
    if (m_parts->canvas != nullptr)
        m_parts->canvas->noteChange();
}

void VtkWidget::setOverlay(Overlay overlay) {
    if (m_parts->canvas != nullptr)
        m_parts->canvas->setOverlay(std::move(overlay));
}

QImage VtkWidget::picture(double scale, PictureOverlay overlay) {
    return m_parts->canvas != nullptr ? m_parts->canvas->picture(scale, overlay == PictureOverlay::with)
                                      : QImage();
}

std::uint64_t VtkWidget::framesRendered() const {
    return m_parts->canvas != nullptr ? m_parts->canvas->framesRendered() : 0;
}

QSize VtkWidget::sizeHint() const {
    return minimumSizeHint() * 3;
}

QSize VtkWidget::minimumSizeHint() const {
    return {10 * fontMetrics().height(), 8 * fontMetrics().height()};
}

void VtkWidget::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        writeFallback();
    QWidget::changeEvent(event);
}

void VtkWidget::showFallback(GlProblem problem) {
    m_parts->problem = problem;
    if (m_parts->fallback == nullptr) {
        setFocusProxy(nullptr);
        delete std::exchange(m_parts->canvas, nullptr);
        m_parts->fallback = new QLabel(this);
        m_parts->fallback->setAlignment(Qt::AlignCenter);
        m_parts->fallback->setWordWrap(true);
        m_parts->fallback->setMargin(2 * fontMetrics().height());
        m_parts->fallback->setBackgroundRole(QPalette::Base);
        m_parts->fallback->setAutoFillBackground(true);
        layout()->addWidget(m_parts->fallback);
        m_parts->fallback->show();
    }
    writeFallback();
}

void VtkWidget::writeFallback() {
    if (m_parts->fallback != nullptr) {
        m_parts->fallback->setText(tr("The 3-D view is not available. %1\nAll other views work without it.")
                                       .arg(describe(m_parts->problem)));
    }
}

} // namespace teleta::view3d
