// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/figure/figure_view.h"
#include "widgets/base/theme.h"

#include <QPainter>

#include <utility>

namespace teleta::base {

/// A view of a picture. The picture is a value with a font and paint(QPainter&, const QSizeF&, const
/// QPalette&), so that an exported figure keeps its own copy. Thread: GUI.
template <typename Picture>
class PictureView : public FigureView {
public:
    [[nodiscard]] const Picture& picture() const { return m_picture; }
    /// For a picture with a provenance: a stripe on the screen, a badge in what leaves the program.
    void setProvenance(Provenance provenance) {
        m_picture.provenance = provenance;
        showProvenance(this, provenance);
        update();
    }

protected:
    using FigureView::FigureView;

    /// A picture on white, as large as the view.
    [[nodiscard]] Figure figureOf(const QString& name, Picture picture, std::function<QString()> csv) const {
        picture.font = font();
        return {.name = name,
                .size_px = QSizeF(size()),
                .paint = [picture = std::move(picture), size = QSizeF(size())](
                             QPainter& painter) { picture.paint(painter, size, designedPalette(false)); },
                .csv = std::move(csv)};
    }

    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        m_picture.font = font();
        m_picture.paint(painter, QSizeF(size()), palette());
        paintFocusFrame(painter, *this);
    }

    Picture m_picture;
};

} // namespace teleta::base
