// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/place_discs.h"

#include "widgets/base/colour_maps.h"
#include "widgets/tactile/heatmap_ink.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

namespace {

const QColor kDeadDisc(0x80, 0x80, 0x80);

/// Calls visit(taxel, box of its disc) for each taxel.
template <typename Visit>
void eachDisc(const HeatmapLayout& layout, const HeatmapContent& content, Visit visit) {
    for (int taxel = 0; taxel < content.snapshot.layout.grid().columns; ++taxel)
        visit(static_cast<std::size_t>(taxel), layout.taxelRect({0, taxel}));
}

} // namespace

void paintDiscs(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    eachDisc(layout, content, [&](std::size_t taxel, const QRectF& box) {
        if (content.isDead(taxel)) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(kDeadDisc, 1.0));
            painter.drawEllipse(box);
            const double reach = 0.5 * std::sqrt(0.5) * box.width();
            painter.drawLine(box.center() + QPointF(-reach, -reach), box.center() + QPointF(reach, reach));
            painter.drawLine(box.center() + QPointF(-reach, reach), box.center() + QPointF(reach, -reach));
            return;
        }
        const auto load = static_cast<double>(content.snapshot.load_N[taxel]);
        const double share = content.rangeTop > 0.0 ? load / content.rangeTop : 0.0;
        painter.setPen(QPen(kDeadDisc, 0.5));
        painter.setBrush(QColor(base::colourAt(base::cividis(), share)));
        painter.drawEllipse(box);
    });
    painter.restore();
}

void paintDiscRings(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content,
                    double width) {
    painter.setBrush(Qt::NoBrush);
    eachDisc(layout, content, [&](std::size_t taxel, const QRectF& box) {
        const contact::Contact* contact = content.contactAt(taxel);
        if (contact == nullptr)
            return;
        const double inset = std::min(0.5 * width + 1.0, 0.4 * box.width());
        const QRectF ring = box.adjusted(inset, inset, -inset, -inset);
        painter.setPen(QPen(kCasing, width + 2.0));
        painter.drawEllipse(ring);
        painter.setPen(QPen(base::identityColour(contact->id, true), width));
        painter.drawEllipse(ring);
    });
}

DiscEnds discEndsOf(const HeatmapLayout& layout, const HeatmapContent& content,
                    const contact::Contact& contact) {
    DiscEnds ends{layout.sensor().center(), layout.sensor().center()};
    bool isFirst = true;
    eachDisc(layout, content, [&](std::size_t taxel, const QRectF& box) {
        if (content.snapshot.labels[taxel] != contact.region)
            return;
        if (isFirst || box.top() < ends.above.y())
            ends.above = QPointF(box.center().x(), box.top());
        if (isFirst || box.bottom() > ends.below.y())
            ends.below = QPointF(box.center().x(), box.bottom());
        isFirst = false;
    });
    return ends;
}

} // namespace teleta::tactile
