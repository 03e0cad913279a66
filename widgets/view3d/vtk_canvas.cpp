// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk_canvas.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace teleta::view3d {

namespace {

constexpr double kLogicalDpi = 96.0;

} // namespace

VtkCanvas::VtkCanvas(GuestRenderWindow* window, vtkRenderWindowInteractor* interactor, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_window(window)
    , m_interactor(interactor)
    , m_input(interactor) {
    setFocusPolicy(Qt::StrongFocus);
}

VtkCanvas::~VtkCanvas() {
    disconnect(m_contextGone);
    releaseContext();
}

void VtkCanvas::requestRender() {
    m_stale = true;
    update();
}

QSize VtkCanvas::deviceSize() const {
    return size() * devicePixelRatio(); // rounds as QOpenGLWidget does for its framebuffer
}

void VtkCanvas::setDeviceSize(const QSize& size, double pixelScale) {
    if (size == m_size && pixelScale == m_pixelScale) {
        return;
    }
    m_size = size;
    m_stale = true;
    m_interactor->UpdateSize(size.width(), size.height());
    m_window->SetSize(size.width(), size.height());
    if (pixelScale != m_pixelScale) {
        m_pixelScale = pixelScale;
        m_window->SetDPI(static_cast<int>(std::lround(kLogicalDpi * pixelScale)));
        emit pixelScaleChanged(pixelScale);
    }
}

void VtkCanvas::initializeGL() {
    // Floating a dock moves the widget to another window: Qt destroys this context and makes a new one.
    disconnect(m_contextGone);
    m_contextGone = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkCanvas::releaseContext);
    m_stale = true;
    if (!m_window->attach(context(), context()->surface())) {
        emit contextRefused();
    }
}

void VtkCanvas::releaseContext() {
    m_window->detach();
}

void VtkCanvas::paintGL() {
    const QSize device = deviceSize();
    if (!m_window->attached() || device.isEmpty()) {
        return;
    }
    setDeviceSize(device, devicePixelRatio());
    if (m_stale) {
        m_stale = false;
        m_window->renderGuarded();
        ++m_framesRendered;
    }
    makeCurrent();
    m_window->blitTo(defaultFramebufferObject(), device.width(), device.height());
    if (m_overlay) {
        // A painter on the widget itself would be led astray to the pixmap while QWidget::grab() runs.
        QOpenGLPaintDevice target(device);
        target.setDevicePixelRatio(devicePixelRatio());
        QPainter painter(&target);
        painter.setRenderHint(QPainter::Antialiasing);
        m_overlay(painter, size());
    }
}

QImage VtkCanvas::picture(double scale, bool withOverlay) {
    if (!m_window->attached() || deviceSize().isEmpty()) {
        return {};
    }
    m_window->MakeCurrent();
    GLint largest = 0;
    context()->functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    const QSize device = deviceSize();
    const double fits = static_cast<double>(largest) / std::max(device.width(), device.height());
    const double used = std::min(scale, fits);
    const QSize before = m_size;
    const double pixelScaleBefore = m_pixelScale;
    setDeviceSize(device * used, devicePixelRatio() * used);
    const int samples = m_window->GetMultiSamples();
    m_window->SetMultiSamples(GuestRenderWindow::kSamples); // a picture may take its time
    m_window->renderGuarded();

    const vtkNew<vtkUnsignedCharArray> pixels;
    m_window->GetPixelData(0, 0, m_size.width() - 1, m_size.height() - 1, 1, pixels, 0);
    QImage image;
    if (pixels->GetNumberOfValues() == 3LL * m_size.width() * m_size.height()) {
        image = QImage(pixels->GetPointer(0), m_size.width(), m_size.height(), 3LL * m_size.width(),
                       QImage::Format_RGB888)
                    .mirrored();
        image.setDevicePixelRatio(m_pixelScale);
    }
    m_window->SetMultiSamples(samples);
    if (!before.isEmpty()) {
        setDeviceSize(before, pixelScaleBefore);
    }
    requestRender();
    doneCurrent();
    if (!image.isNull() && withOverlay && m_overlay) {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        m_overlay(painter, size());
    }
    return image;
}

void VtkCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) {
        m_rightPress = event->position();
        m_rightDragged = false;
    }
    m_input.mouse(*event, devicePixelRatio());
    event->accept();
}

void VtkCanvas::mouseReleaseEvent(QMouseEvent* event) {
    m_input.mouse(*event, devicePixelRatio());
    event->accept();
    if (event->button() == Qt::RightButton && !m_rightDragged) {
        emit menuRequested(event->globalPosition().toPoint());
    }
}

void VtkCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    m_input.mouse(*event, devicePixelRatio());
    event->accept();
}

void VtkCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::RightButton) &&
        (event->position() - m_rightPress).manhattanLength() >= QApplication::startDragDistance()) {
        m_rightDragged = true;
    }
    m_input.mouse(*event, devicePixelRatio());
    event->accept();
}

void VtkCanvas::wheelEvent(QWheelEvent* event) {
    m_input.wheel(*event, devicePixelRatio());
    event->accept();
}

void VtkCanvas::keyPressEvent(QKeyEvent* event) {
    m_input.key(*event);
    event->ignore(); // shortcuts of the window, STOP first of all, must see every key
}

void VtkCanvas::keyReleaseEvent(QKeyEvent* event) {
    m_input.key(*event);
    event->ignore();
}

void VtkCanvas::contextMenuEvent(QContextMenuEvent* event) {
    // The right button also zooms: its menu opens on release, when nothing was dragged.
    if (event->reason() != QContextMenuEvent::Mouse) {
        emit menuRequested(mapToGlobal(rect().center()));
    }
    event->accept();
}

} // namespace teleta::view3d
