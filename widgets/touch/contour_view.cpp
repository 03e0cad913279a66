// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/contour_view.h"

#include "widgets/base/focus_frame.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QMenu>
#include <QPainter>

namespace teleta::touch {

ContourView::ContourView(QWidget* parent)
    : FigureView(parent) {
    base::keepTranslated(this, &ContourView::retranslate);
}

void ContourView::retranslate() {
    setAccessibleName(tr("Explored contour"));
    setWhatsThis(
        tr("<p>The object from above, as far as it was explored: the points at which it was touched, the "
           "spline through them, and the vertices or the circle of the shape that was recognised.</p>"
           "<p>The confidence is that of the decision between the known shapes.</p>"));
    shown();
}

void ContourView::shown() {
    setAccessibleDescription(m_picture.headline() + QStringLiteral("; ") + m_picture.details());
    update();
}

void ContourView::setContour(const pipeline::ExploredContour& contour) {
    m_picture.contour = contour;
    shown();
}

void ContourView::clear() {
    m_picture.contour = {};
    shown();
}

void ContourView::setProvenance(base::Provenance provenance) {
    m_picture.provenance = provenance;
    update();
}

base::Figure ContourView::figure() {
    base::Figure figure;
    figure.name = tr("contour");
    figure.size_px = QSizeF(size());
    ContourPicture picture = m_picture;
    picture.font = font();
    figure.paint = [picture, size = figure.size_px](QPainter& painter) {
        picture.paint(painter, size, base::designedPalette(false));
    };
    figure.csv = [picture] { return picture.csv(); };
    return figure;
}

void ContourView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    QAction* forget = menu.addAction(tr("&Forget the explored contour"), this, &ContourView::forgetRequested);
    forget->setEnabled(!m_picture.contour.points_m.empty());
}

QSize ContourView::sizeHint() const {
    return {base::em(this, 30), base::em(this, 20)};
}

QSize ContourView::minimumSizeHint() const {
    return {base::em(this, 14), base::em(this, 11)};
}

void ContourView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    m_picture.font = font();
    m_picture.paint(painter, QSizeF(size()), palette());
    base::paintFocusFrame(painter, *this);
}

} // namespace teleta::touch
