// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/camera_view.h"

#include "widgets/base/on_change.h"

#include <QKeyEvent>
#include <QMenu>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace teleta::camera {

namespace {

constexpr double kCameraZoomStep = 1.25;

} // namespace

CameraView::CameraView(QWidget* parent)
    : PictureView(parent, {40, 30}, {14, 10}) {
    base::keepTranslated(this, &CameraView::retranslate);
}

void CameraView::setSnapshot(const pipeline::CameraSnapshot* snapshot) {
    if (snapshot == nullptr) {
        m_picture.shown = {};
        m_bump_s.reset();
        m_picture.bumpFade = 0.0;
        showAll();
        return;
    }
    if (m_picture.paused)
        return;
    m_picture.shown = *snapshot;
    if (snapshot->bump) {
        m_bump_s = snapshot->time_s;
        m_picture.bumped = snapshot->bump->contact;
    }
    const double age_s = m_bump_s ? snapshot->time_s - *m_bump_s : kBumpShown_s;
    m_picture.bumpFade = std::clamp(1.0 - age_s / kBumpShown_s, 0.0, 1.0);
    update();
}

void CameraView::setArrowsShown(bool shown) {
    m_picture.arrows = shown;
    update();
}

void CameraView::setPaused(bool paused) {
    m_picture.paused = paused;
    update();
}

base::Figure CameraView::figure() {
    CameraPicture picture = m_picture;
    picture.paused = false;
    return figureOf(tr("camera"), picture, [text = m_picture.csv()] { return text; });
}

void CameraView::showAll() {
    m_picture.zoom = 1.0;
    m_picture.centre = {0.5, 0.5};
    update();
}

QString CameraView::toolTipAt(const QPointF& point) const {
    const int contact = m_picture.contactAt(point, QSizeF(size()));
    return contact < 0 ? QString()
                       : m_picture.wordsFor(m_picture.shown.contacts[static_cast<std::size_t>(contact)]);
}

void CameraView::wheelEvent(QWheelEvent* event) {
    if (!event->modifiers().testFlag(Qt::ControlModifier) || m_picture.isEmpty()) {
        QWidget::wheelEvent(event);
        return;
    }
    m_picture.zoomAt(event->position(), QSizeF(size()),
                     std::pow(kCameraZoomStep, event->angleDelta().y() / 120.0));
    update();
    event->accept();
}

void CameraView::mousePressEvent(QMouseEvent* event) {
    m_dragged = event->position();
    QWidget::mousePressEvent(event);
    event->accept();
}

void CameraView::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton))
        return;
    m_picture.moveBy(event->position() - m_dragged, QSizeF(size()));
    m_dragged = event->position();
    update();
}

void CameraView::mouseDoubleClickEvent(QMouseEvent*) {
    showAll();
}

void CameraView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle(0.5 * width(), 0.5 * height());
    if (event->key() == Qt::Key_Space) {
        emit pauseRequested(!m_picture.paused);
    } else if (event->key() == Qt::Key_Home) {
        showAll();
    } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
        m_picture.zoomAt(middle, QSizeF(size()), kCameraZoomStep);
        update();
    } else if (event->key() == Qt::Key_Minus) {
        m_picture.zoomAt(middle, QSizeF(size()), 1.0 / kCameraZoomStep);
        update();
    } else {
        FigureView::keyPressEvent(event);
    }
}

void CameraView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    menu.addAction(m_picture.paused ? tr("&Resume") : tr("&Pause the picture"), this,
                   [this] { emit pauseRequested(!m_picture.paused); });
    menu.addAction(tr("Show &all"), this, &CameraView::showAll);
}

void CameraView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_picture.moveBy({}, QSizeF(size()));
}

void CameraView::retranslate() {
    setAccessibleName(tr("Camera picture"));
    setWhatsThis(
        tr("<p>What the camera sees inside the tube. Lines show, enlarged, how far the printed pattern has "
           "moved since nothing touched the tube; outlines are contacts, each in the colour of its "
           "number.</p><p>Ctrl+wheel zooms, dragging moves, a double click shows all.</p>"));
    update();
}

} // namespace teleta::camera
