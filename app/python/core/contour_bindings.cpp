// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/core/core_bindings.h"
#include "backend/contour/cubic_spline.h"
#include "backend/contour/shape_recogniser.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace teleta::python {

namespace {

using contour::CubicSpline;
using contour::Point;
using contour::Recognition;
using contour::Shape;

/// The keys of `teleta contour --json`.
py::dict toDict(const std::vector<Point>& points, const Recognition& seen) {
    std::vector<double> vertices;
    for (const Point& vertex : seen.vertices_m)
        vertices.insert(vertices.end(), {vertex.x(), vertex.y()});
    const auto corners = static_cast<py::ssize_t>(seen.vertices_m.size());
    py::dict probabilities;
    for (std::size_t i = 0; i < contour::kShapes; ++i)
        probabilities[contour::toString(static_cast<Shape>(i))] = seen.probability[i];
    py::list candidates;
    for (const Shape shape : seen.candidates())
        candidates.append(contour::toString(shape));
    py::dict fields;
    fields["points"] = points.size();
    fields["shape"] = contour::toString(seen.shape);
    fields["confidence"] = seen.confidence;
    fields["candidates"] = py::tuple(candidates);
    fields["probabilities"] = probabilities;
    fields["closed"] = seen.closed;
    fields["vertices"] = arrayOf(std::move(vertices), {corners, 2});
    if (seen.circle) {
        py::dict circle;
        circle["x"] = seen.circle->centre_m.x();
        circle["y"] = seen.circle->centre_m.y();
        circle["radius"] = seen.circle->radius_m;
        circle["rms"] = seen.circle->rms_m;
        fields["circle"] = circle;
    } else {
        fields["circle"] = py::none();
    }
    return fields;
}

py::dict describe(const py::object& pointsArgument, bool interpolating, const std::optional<bool>& closed,
                  long long samples, double resolution_m) {
    const auto array = realArray<double>(pointsArgument, "points_m");
    needShape(array, "points_m", {-1, 2}, "(n, 2)");
    if (samples < 2 || samples > 10'000'000)
        throw wrongValue("samples", "2 to 10000000", std::to_string(samples));
    contour::RecognitionSettings settings;
    settings.resolution_m = positive(resolution_m, "resolution_m");
    settings.closed = closed;
    std::vector<Point> points;
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        points.emplace_back(array.data()[2 * i], array.data()[2 * i + 1]);

    std::optional<Recognition> seen;
    std::optional<CubicSpline> spline;
    const auto count = static_cast<std::size_t>(samples);
    std::vector<double> ts(count);
    std::vector<double> xs_m(count);
    std::vector<double> ys_m(count);
    std::vector<double> curvatures_perM(count);
    double length_m = 0.0;
    double largest_perM = 0.0;
    {
        const py::gil_scoped_release released;
        seen = contour::recogniseShape(points, settings);
        if (seen)
            spline = CubicSpline::fit(points,
                                      interpolating ? contour::SplineKind::interpolating
                                                    : contour::SplineKind::approximating,
                                      seen->closed);
        if (spline) {
            length_m = spline->length_m();
            for (std::size_t i = 0; i < count; ++i) {
                const auto last = static_cast<double>(samples - 1);
                const double t = static_cast<double>(spline->segments()) * static_cast<double>(i) / last;
                const Point place_m = spline->position_m(t);
                ts[i] = static_cast<double>(i) / last;
                xs_m[i] = place_m.x();
                ys_m[i] = place_m.y();
                curvatures_perM[i] = spline->curvature_perM(t);
                largest_perM = std::max(largest_perM, std::abs(curvatures_perM[i]));
            }
        }
    }
    if (!spline)
        throw Failure({core::ErrorKind::badInput,
                       points.empty() ? "there are no points" : "a coordinate is not finite or too large",
                       "a row (x, y) in metres for each point of contact",
                       {}});
    py::dict fields = toDict(points, *seen);
    fields["length_m"] = length_m;
    fields["max_curvature_per_m"] = largest_perM;
    py::dict curve;
    curve["t"] = arrayOf(std::move(ts));
    curve["x_m"] = arrayOf(std::move(xs_m));
    curve["y_m"] = arrayOf(std::move(ys_m));
    curve["curvature_per_m"] = arrayOf(std::move(curvatures_perM));
    fields["curve"] = curve;
    return fields;
}

} // namespace

void bindContour(py::module_& module) {
    module.def("contour", &describe);
}

} // namespace teleta::python
