// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/gel/gel_view.h"

#include "widgets/base/on_change.h"

#include <QKeyEvent>
#include <QMenu>

namespace teleta::camera {

GelView::GelView(QWidget* parent)
    : PictureView(parent, {40, 30}, {14, 10}) {
    base::keepTranslated(this, &GelView::retranslate);
}

void GelView::setSnapshot(const pipeline::GelSnapshot* snapshot) {
    if (snapshot == nullptr)
        m_picture.shown = {};
    else if (!m_picture.paused)
        m_picture.shown = *snapshot;
    else
        return;
    update();
}

void GelView::setArrowsShown(bool shown) {
    m_picture.arrows = shown;
    update();
}

void GelView::setEnlargement(double factor) {
    m_picture.enlargement = factor;
    update();
}

void GelView::setPaused(bool paused) {
    m_picture.paused = paused;
    update();
}

base::Figure GelView::figure() {
    GelPicture picture = m_picture;
    picture.paused = false;
    return figureOf(tr("gel"), picture, [text = m_picture.csv()] { return text; });
}

QString GelView::toolTipAt(const QPointF& point) const {
    const int contact = m_picture.contactAt(point, QSizeF(size()));
    return contact < 0 ? QString() : GelPicture::wordsFor(m_picture.shown, static_cast<std::size_t>(contact));
}

void GelView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space)
        emit pauseRequested(!m_picture.paused);
    else
        FigureView::keyPressEvent(event);
}

void GelView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    menu.addAction(m_picture.paused ? tr("&Resume") : tr("&Pause the picture"), this,
                   [this] { emit pauseRequested(!m_picture.paused); });
    menu.addAction(tr("Take the gel at &rest anew"), this, &GelView::referenceRequested);
}

void GelView::retranslate() {
    setAccessibleName(tr("Picture of the gel"));
    setWhatsThis(
        tr("<p>What the camera sees of the gel. Arrows show, enlarged, how far each marker has moved "
           "from its place at rest; a cross is a marker that is lost. Outlines are contacts, each in "
           "the colour of its number.</p><p>The slip index is the share of the contact's markers that "
           "do not move with it: green while it sticks, amber when a part of it slips, red when all "
           "of it does.</p>"));
    update();
}

} // namespace teleta::camera
