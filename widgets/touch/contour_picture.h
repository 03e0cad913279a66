// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"
#include "widgets/base/controls/badge.h"

#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <QTransform>

#include <optional>

class QPainter;

namespace teleta::touch {

/// The explored contour from above, to scale: what the view and its exported figures draw. x to the right, y
/// up, in mm. Thread: GUI (fonts).
class ContourPicture {
    Q_DECLARE_TR_FUNCTIONS(ContourPicture)

public:
    pipeline::ExploredContour contour;
    base::Provenance provenance = base::Provenance::live;
    QFont font;

    /// What was recognised, in words: shape and confidence.
    [[nodiscard]] QString headline() const;
    /// Its measures: radius, or edges; and the number of points.
    [[nodiscard]] QString details() const;
    /// From metres in the base to points of a picture of this size; empty without points.
    [[nodiscard]] std::optional<QTransform> mapping(const QSizeF& size) const;
    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// x_m,y_m: the points, as `teleta contour` reads them.
    [[nodiscard]] QString csv() const;

private:
    [[nodiscard]] QRectF plotRect(const QSizeF& size) const;
    void paintHead(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    void paintAxes(QPainter& painter, const QRectF& plot, const QTransform& toPlot,
                   const QPalette& palette) const;
    void paintShape(QPainter& painter, const QRectF& plot, const QTransform& toPlot,
                    const QPalette& palette) const;
};

} // namespace teleta::touch
