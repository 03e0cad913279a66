// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/contour_view.h"

#include "widgets/base/on_change.h"

#include <QMenu>

namespace teleta::touch {

ContourView::ContourView(QWidget* parent)
    : PictureView(parent, {30, 20}, {14, 11}) {
    base::keepTranslated(this, &ContourView::retranslate);
}

void ContourView::retranslate() {
    setAccessibleName(tr("Explored contour"));
    setWhatsThis(tr(
        "<p>The object from above, as far as it was explored: the points at which it was touched, the "
        "spline through them, and the vertices or the circle of the shape that was recognised.</p>"
        "<p>The confidence is the share of such answers that are right. While the points do not decide, the "
        "shapes that come into question stand there with their probabilities.</p>"));
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

base::Figure ContourView::figure() {
    return figureOf(tr("contour"), m_picture, [picture = m_picture] { return picture.csv(); });
}

void ContourView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    QAction* forget = menu.addAction(tr("&Forget the explored contour"), this, &ContourView::forgetRequested);
    forget->setEnabled(!m_picture.contour.points_m.empty());
}

} // namespace teleta::touch
