// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/protocol/trial.h"

#include <QPalette>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace teleta::study {

/// A point of a curve.
struct CurvePoint {
    double x = 0.0;
    double y = 0.0;
    std::optional<Interval> interval = {}; ///< of y
};

struct CurveSeries {
    QString name;
    std::vector<CurvePoint> points; ///< with rising x
    bool marks = false;             ///< a dot at each point
};

/// Lines over a number, from 0 to `highest`.
struct CurveContent {
    QString name; ///< of the file
    QString title;
    QString xAxis; ///< with its unit
    QString yAxis;
    double lowestX = 0.0;
    double highestX = 1.0; ///< above lowestX
    double highest = 1.0;  ///< of y, above 0
    std::vector<CurveSeries> series;
    std::optional<double> reference; ///< a line across
    QString referenceName;
    QString nothing = {}; ///< what is said while there are no points; empty: the axes stand alone
    Mode mode = Mode::run;
};

void paintCurves(QPainter& painter, const QRectF& rect, const CurveContent& content, const QPalette& palette);

/// series,x,y,low,high; C locale, NA for missing values.
[[nodiscard]] QString curvesCsv(const CurveContent& content);

} // namespace teleta::study
