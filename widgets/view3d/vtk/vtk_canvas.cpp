// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_canvas.h"

#include "backend/core/steady_time.h"
#include "widgets/base/picture_property.h"

#include <QApplication>
#include <QBackingStore>
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QOpenGLFunctions>
#include <QPainter>

#include <vtkCommand.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::view3d {

namespace {

constexpr double kLogicalDpi = 96.0;
constexpr int kLookAgain_ms = 2; ///< for a frame being drawn by the driver

/// VTK's events of a button.
struct ButtonEvents {
    Qt::MouseButton button;
    unsigned long press, doubleClick, release;
};
constexpr std::array<ButtonEvents, 3> kButtons{
    {{Qt::LeftButton, vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonDoubleClickEvent,
      vtkCommand::LeftButtonReleaseEvent},
     {Qt::MiddleButton, vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonDoubleClickEvent,
      vtkCommand::MiddleButtonReleaseEvent},
     {Qt::RightButton, vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonDoubleClickEvent,
      vtkCommand::RightButtonReleaseEvent}}};

} // namespace

VtkCanvas::VtkCanvas(GuestRenderWindow* window, vtkRenderWindowInteractor* interactor, QWidget* parent)
    : QWidget(parent)
    , m_window(window)
    , m_interactor(interactor) {
    setFocusPolicy(Qt::StrongFocus);
    setProperty(base::kPictureProperty, true);
    setAttribute(Qt::WA_OpaquePaintEvent); // so that what is below is not painted as well
    m_lookAgain.setTimerType(Qt::PreciseTimer);
    m_lookAgain.setInterval(kLookAgain_ms);
    m_lookAgain.setObjectName(QStringLiteral("look"));
    connect(&m_lookAgain, &QTimer::timeout, this, &VtkCanvas::lookForFrame);
}

VtkCanvas::~VtkCanvas() {
    RenderQueue::instance().leave(*this);
    m_window->detach();
}

void VtkCanvas::requestRender() {
    m_stale = m_changed = true;
    // An invisible view does not wait for a turn: it is repainted when it appears.
    if (!visibleRegion().isEmpty())
        RenderQueue::instance().ask(*this);
}

QSize VtkCanvas::deviceSize() const {
    return size() * devicePixelRatio(); // rounds as Qt does for the window
}

void VtkCanvas::setDeviceSize(const QSize& size, double pixelScale) {
    if (size == m_size && pixelScale == m_pixelScale)
        return;
    m_size = size;
    m_stale = m_changed = true;
    m_drawing = false; // of another size
    m_quality.restart();
    m_window->setQuality(m_quality.level());
    m_interactor->UpdateSize(size.width(), size.height());
    m_window->SetSize(size.width(), size.height());
    if (pixelScale != m_pixelScale) {
        m_pixelScale = pixelScale;
        m_window->SetDPI(static_cast<int>(std::lround(kLogicalDpi * pixelScale)));
        emit pixelScaleChanged(pixelScale);
    }
}

bool VtkCanvas::makeContext() {
    if (m_window->attached() || m_refused)
        return !m_refused;
    const auto refuse = [this](GlProblem problem) {
        m_refused = true;
        emit contextRefused(problem);
        return false;
    };
    if (const GlProblem problem = findGlProblem(); problem != GlProblem::none)
        return refuse(problem);
    if (!m_context.isValid()) {
        if (!m_context.create())
            return refuse(GlProblem::contextRefused);
        m_surface.setFormat(m_context.format());
        m_surface.create();
    }
    if (!m_surface.isValid() || !m_context.makeCurrent(&m_surface))
        return refuse(GlProblem::contextRefused);
    return m_window->attach(&m_context, &m_surface) || refuse(GlProblem::driverRefused);
}

void VtkCanvas::turnHasCome() {
    if (!m_stale || visibleRegion().isEmpty())
        return;
    if (m_frame.isNull() || deviceSize() != m_size) {
        update(); // there is nothing to show meanwhile
    } else if (!m_drawing) {
        beginFrame();
        m_lookAgain.start();
    } // or it asks again when that one has ended
}

void VtkCanvas::beginFrame() {
    m_begun_ns = core::steadyNow_ns();
    m_stale = m_changed = false;
    m_drawing = true;
    m_window->renderGuarded();
}

void VtkCanvas::endFrame() {
    m_lookAgain.stop();
    m_drawing = false;
    m_isFine = false;
    m_frame = m_window->frame();
    m_frame.setDevicePixelRatio(m_pixelScale);
    ++m_framesRendered;
    const std::int64_t ended_ns = core::steadyNow_ns();
    RenderQueue::instance().drawn(*this, m_begun_ns, ended_ns);
    if (m_quality.drawn(ended_ns - m_begun_ns))
        m_window->setQuality(m_quality.level());
    if (m_stale)
        requestRender();
}

void VtkCanvas::lookForFrame() {
    if (!m_drawing) {
        m_lookAgain.stop();
    } else if (m_window->isDrawn()) {
        endFrame();
        update();
    }
}

bool VtkCanvas::paintsOnScreen() const {
    QPoint offset;
    QBackingStore* screen = backingStore();
    return screen != nullptr && redirected(&offset) == screen->paintDevice();
}

void VtkCanvas::paintEvent(QPaintEvent* /*event*/) {
    const QSize device = deviceSize();
    if (device.isEmpty())
        return;
    if (!makeContext()) {
        QPainter(this).fillRect(rect(), palette().window()); // until the reason is shown instead
        return;
    }
    setDeviceSize(device, devicePixelRatio());
    const bool fits = m_frame.size() == device && m_frame.devicePixelRatio() == m_pixelScale;
    if (!paintsOnScreen()) {
        if (!fits || m_changed || !m_isFine)
            m_frame = finePicture();
    } else if (!fits) {
        if (m_stale)
            beginFrame();
        if (m_drawing)
            endFrame();
    } else if (m_stale) {
        requestRender(); // there were no requests while it was hidden
    }
    QPainter painter(this);
    if (m_frame.isNull()) // it could not be read
        painter.fillRect(rect(), palette().window());
    painter.drawImage(QPointF(), m_frame);
    if (m_overlay) {
        painter.setRenderHint(QPainter::Antialiasing);
        m_overlay(painter, size());
    }
}

QImage VtkCanvas::finePicture() {
    m_framesRendered += m_changed || m_drawing ? 1 : 0; // not for another picture of the same scene
    m_drawing = false;                                  // the window now draws another picture
    const int samples = m_window->GetMultiSamples();
    m_window->setQuality(FrameQuality::Level::plain);
    m_window->SetMultiSamples(GuestRenderWindow::kSamples); // a picture may take longer
    m_window->renderGuarded();
    QImage image = m_window->frame();
    image.setDevicePixelRatio(m_pixelScale);
    m_stale = m_changed = false;
    m_isFine = true;
    m_window->SetMultiSamples(samples);
    m_window->setQuality(m_quality.level());
    return image;
}

QImage VtkCanvas::picture(double scale, bool withOverlay) {
    if (deviceSize().isEmpty() || !makeContext())
        return {};
    m_window->MakeCurrent();
    GLint largest = 0;
    m_context.functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    const QSize device = deviceSize();
    const double fits = static_cast<double>(largest) / std::max(device.width(), device.height());
    const double used = std::min(scale, fits);
    const QSize before = m_size;
    const double pixelScaleBefore = m_pixelScale;
    const FrameQuality quality = m_quality; // the picture does not change how quick the frames are
    setDeviceSize(device * used, devicePixelRatio() * used);
    QImage image = finePicture();
    if (!before.isEmpty())
        setDeviceSize(before, pixelScaleBefore);
    m_quality = quality;
    m_window->setQuality(m_quality.level());
    requestRender();
    if (!image.isNull() && withOverlay && m_overlay) {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        m_overlay(painter, size());
    }
    return image;
}

void VtkCanvas::placeMouse(const QSinglePointEvent& event, int repeat) {
    const QPointF device = event.position() * devicePixelRatio();
    const Qt::KeyboardModifiers keys = event.modifiers();
    m_interactor->SetEventInformationFlipY(
        static_cast<int>(std::floor(device.x())), static_cast<int>(std::floor(device.y())),
        keys.testFlag(Qt::ControlModifier) ? 1 : 0, keys.testFlag(Qt::ShiftModifier) ? 1 : 0, 0, repeat);
    m_interactor->SetAltKey(keys.testFlag(Qt::AltModifier) ? 1 : 0);
}

void VtkCanvas::passOn(QMouseEvent* event) {
    const bool twice = event->type() == QEvent::MouseButtonDblClick;
    placeMouse(*event, twice ? 1 : 0);
    event->accept();
    const auto* button = std::ranges::find(kButtons, event->button(), &ButtonEvents::button);
    if (event->type() == QEvent::MouseMove) {
        m_interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
    } else if (button != kButtons.end() && event->type() == QEvent::MouseButtonRelease) {
        m_interactor->InvokeEvent(button->release);
    } else if (button != kButtons.end()) {
        // The second press of a double click counts as a press: drags can start with it.
        m_interactor->InvokeEvent(button->press);
        if (twice)
            m_interactor->InvokeEvent(button->doubleClick);
    }
}

void VtkCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) {
        m_rightPress = event->position();
        m_rightDragged = false;
    } else if (event->button() == Qt::LeftButton) {
        m_leftPress = event->position();
    }
    passOn(event);
}

void VtkCanvas::mouseReleaseEvent(QMouseEvent* event) {
    passOn(event);
    if (event->button() == Qt::RightButton && !m_rightDragged)
        emit menuRequested(event->globalPosition().toPoint());
    if (event->button() == Qt::LeftButton && m_leftPress)
        emit clicked(event->position().toPoint());
    m_leftPress.reset();
}

void VtkCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    passOn(event);
}

void VtkCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::RightButton) &&
        (event->position() - m_rightPress).manhattanLength() >= QApplication::startDragDistance())
        m_rightDragged = true;
    if (m_leftPress &&
        (event->position() - *m_leftPress).manhattanLength() >= QApplication::startDragDistance())
        m_leftPress.reset();
    passOn(event);
}

void VtkCanvas::wheelEvent(QWheelEvent* event) {
    placeMouse(*event, 0);
    event->accept();
    // Touchpads send fractions of a step; Alt turns the wheel sideways in some desktops.
    const QPoint turned = event->angleDelta();
    m_wheelRest += turned.y() != 0 ? turned.y() : turned.x();
    constexpr int kStep = QWheelEvent::DefaultDeltasPerStep;
    for (; m_wheelRest >= kStep; m_wheelRest -= kStep)
        m_interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
    for (; m_wheelRest <= -kStep; m_wheelRest += kStep)
        m_interactor->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
}

void VtkCanvas::contextMenuEvent(QContextMenuEvent* event) {
    // The right button also zooms: its menu opens on release, when nothing was dragged.
    if (event->reason() != QContextMenuEvent::Mouse)
        emit menuRequested(mapToGlobal(rect().center()));
    event->accept();
}

} // namespace teleta::view3d
