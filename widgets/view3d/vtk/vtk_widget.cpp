// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QEvent>
#include <QLabel>
#include <QLoggingCategory>
#include <QVBoxLayout>

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <utility>

namespace teleta::view3d {

namespace {

Q_LOGGING_CATEGORY(view3dLog, "teleta.view3d")

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

} // namespace

VtkWidget::VtkWidget(QWidget* parent)
    : QWidget(parent) {
    if (dynamic_cast<QtLogWindow*>(vtkOutputWindow::GetInstance()) == nullptr)
        vtkOutputWindow::SetInstance(vtkNew<QtLogWindow>());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);

    const vtkNew<vtkInteractorStyleTrackballCamera> style;
    m_interactor->SetRenderWindow(m_window);
    m_interactor->SetInteractorStyle(style);
    // A render event of VTK becomes a request: the widget draws only when it is painted.
    m_interactor->EnableRenderOff();
    m_onRender->SetClientData(this);
    m_onRender->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<VtkWidget*>(self)->requestRender(); });
    m_interactor->AddObserver(vtkCommand::RenderEvent, m_onRender);
    m_interactor->Initialize();

    if (findGlProblem() != GlProblem::none) {
        showFallback(findGlProblem());
        return;
    }
    m_canvas = new VtkCanvas(m_window, m_interactor, this);
    layout->addWidget(m_canvas);
    setFocusProxy(m_canvas);
    connect(m_canvas, &VtkCanvas::pixelScaleChanged, this, &VtkWidget::pixelScaleChanged);
    connect(m_canvas, &VtkCanvas::menuRequested, this, &VtkWidget::menuRequested);
    // Queued: the canvas is in the middle of its first repaint when it says so.
    connect(m_canvas, &VtkCanvas::contextRefused, this, &VtkWidget::showFallback, Qt::QueuedConnection);
}

VtkWidget::~VtkWidget() {
    m_interactor->RemoveObserver(m_onRender);
    // Before the render window, which has resources in the canvas's context.
    delete m_canvas;
    m_interactor->SetRenderWindow(nullptr);
}

QString VtkWidget::fallbackText() const {
    return m_fallback != nullptr ? m_fallback->text() : QString();
}

void VtkWidget::requestRender() {
    if (m_canvas != nullptr)
        m_canvas->requestRender();
}

void VtkWidget::setOverlay(VtkCanvas::Overlay overlay) {
    if (m_canvas != nullptr)
        m_canvas->setOverlay(std::move(overlay));
}

QImage VtkWidget::picture(double scale, PictureOverlay overlay) {
    return m_canvas != nullptr ? m_canvas->picture(scale, overlay == PictureOverlay::with) : QImage();
}

std::uint64_t VtkWidget::framesRendered() const {
    return m_canvas != nullptr ? m_canvas->framesRendered() : 0;
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
    m_problem = problem;
    if (m_fallback == nullptr) {
        setFocusProxy(nullptr);
        delete std::exchange(m_canvas, nullptr);
        m_fallback = new QLabel(this);
        m_fallback->setAlignment(Qt::AlignCenter);
        m_fallback->setWordWrap(true);
        m_fallback->setMargin(2 * fontMetrics().height());
        m_fallback->setBackgroundRole(QPalette::Base);
        m_fallback->setAutoFillBackground(true);
        layout()->addWidget(m_fallback);
        m_fallback->show();
    }
    writeFallback();
}

void VtkWidget::writeFallback() {
    if (m_fallback != nullptr) {
        m_fallback->setText(tr("The 3-D view is not available. %1\nAll other views work without it.")
                                .arg(describe(m_problem)));
    }
}

} // namespace teleta::view3d
