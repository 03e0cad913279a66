// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/circle_fit.h"

#include "backend/contour/contour_order.h"
#include "backend/contour/curve_models.h"
#include "backend/contour/model_evidence.h"

#include <cmath>

namespace teleta::contour {

std::optional<Circle> fitCircle(std::span<const Point> points_m) {
    if (!areUsable(points_m))
        return std::nullopt;
    const PreparedContour contour = prepare(points_m);
    if (contour.points.size() < 3 || contour.extent_m == 0.0)
        return std::nullopt;
    const CurvedLineFit fitted = fitCurvedLine(contour.points);
    if (fitted.curve.straight())
        return std::nullopt;
    const Evidence judged = judge(fitted.fit.residuals, 1.0);
    return Circle{contour.toMetres(fitted.curve.centre()), contour.size_m * fitted.curve.radius(),
                  contour.size_m * rmsOfInliers(fitted.fit, judged)};
}

} // namespace teleta::contour
