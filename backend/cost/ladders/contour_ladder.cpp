// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/cubic_spline.h"
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace teleta::cost {

namespace {

using contour::Point;

constexpr double kTouchNoise_m = 0.0002;
constexpr std::size_t kCurvePoints = 360;
constexpr std::size_t kComparedPoints = 90;

/// A true outline by its length.
struct TrueOutline {
    double length_m = 0.0;
    bool closed = true;
    std::function<Point(double along_m)> at; ///< 0..length_m
};

TrueOutline circleOutline() {
    static constexpr double kRadius_m = 0.03;
    return {2.0 * std::numbers::pi * kRadius_m, true, [](double along_m) {
                const double angle = along_m / kRadius_m;
                return Point(kRadius_m * std::cos(angle), kRadius_m * std::sin(angle));
            }};
}

TrueOutline rectangleOutline() {
    static constexpr double kWidth_m = 0.08;
    static constexpr double kHeight_m = 0.05;
    return {2.0 * (kWidth_m + kHeight_m), true, [](double along_m) -> Point {
                if (along_m < kWidth_m)
                    return {along_m, 0.0};
                if (along_m < kWidth_m + kHeight_m)
                    return {kWidth_m, along_m - kWidth_m};
                if (along_m < 2.0 * kWidth_m + kHeight_m)
                    return {2.0 * kWidth_m + kHeight_m - along_m, kHeight_m};
                return {0.0, std::max(0.0, 2.0 * (kWidth_m + kHeight_m) - along_m)};
            }};
}

/// Two straight parts with an arc of 45 degrees between them.
TrueOutline bentOutline() {
    static constexpr double kStraight_m = 0.06;
    static constexpr double kRadius_m = 0.04;
    static constexpr double kBend_rad = 0.25 * std::numbers::pi;
    static constexpr double kArc_m = kRadius_m * kBend_rad;
    return {2.0 * kStraight_m + kArc_m, false, [](double along_m) {
                const double angle = std::clamp((along_m - kStraight_m) / kRadius_m, 0.0, kBend_rad);
                const double straight_m = std::max(0.0, along_m - kStraight_m - kArc_m);
                return Point(std::min(along_m, kStraight_m) + kRadius_m * std::sin(angle) +
                                 straight_m * std::cos(kBend_rad),
                             kRadius_m * (1.0 - std::cos(angle)) + straight_m * std::sin(kBend_rad));
            }};
}

/// A closed outline is touched from anywhere on, an open one from end to end.
std::vector<Point> touchOutline(const TrueOutline& outline, std::size_t count, std::size_t trial) {
    core::RandomStream random(trial, "contour ladder");
    const double first = outline.closed ? random.uniform() : 0.0;
    const double gaps = static_cast<double>(outline.closed ? count : count - 1);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = first + static_cast<double>(i) / gaps;
        const Point there =
            outline.at((outline.closed ? share - std::floor(share) : share) * outline.length_m);
        points.push_back(there + kTouchNoise_m * Point(random.normal(), random.normal()));
    }
    return points;
}

double distanceFromCurve_m(const Point& point, const std::vector<Point>& curve) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Point side = curve[i + 1] - curve[i];
        const double squared = side.squaredNorm();
        const double along =
            squared > 0.0 ? std::clamp((point - curve[i]).dot(side) / squared, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (curve[i] + along * side - point).squaredNorm());
    }
    return std::sqrt(nearest);
}

Rung contourRung(contour::SplineKind kind, std::size_t points,
                 const std::shared_ptr<const std::vector<TrueOutline>>& outlines) {
    const auto run = [=](Trial& trial) {
        const TrueOutline& outline = (*outlines)[trial.index() % outlines->size()];
        const std::vector<Point> touched = touchOutline(outline, points, trial.index());
        std::vector<Point> curve(kCurvePoints + 1);
        constexpr std::size_t kCalls = 4;
        trial.timed(kCalls, [&] {
            for (std::size_t call = 0; call < kCalls; ++call) {
                const auto spline = contour::CubicSpline::fit(touched, kind, outline.closed);
                for (std::size_t i = 0; i <= kCurvePoints; ++i)
                    curve[i] = spline->position_m(static_cast<double>(spline->segments()) *
                                                  static_cast<double>(i) / static_cast<double>(kCurvePoints));
            }
        });
        // A closed spline's last point is its first one only by wrapping around.
        if (outline.closed)
            curve.back() = curve.front();
        for (std::size_t i = 0; i < kComparedPoints; ++i)
            trial.error(distanceFromCurve_m(outline.at(outline.length_m * (static_cast<double>(i) + 0.5) /
                                                       static_cast<double>(kComparedPoints)),
                                            curve));
    };
    const std::string count = std::to_string(points);
    return {(kind == contour::SplineKind::approximating ? "approximating-" : "interpolating-") + count,
            count + " points", run};
}

} // namespace

Ladder contourLadder() {
    Ladder ladder;
    ladder.name = "contour";
    ladder.topic = Topic::touchedObject;
    ladder.title = LadderText::tr("Curve through contact points").toStdString();
    ladder.truth =
        LadderText::tr("distance of the true outline (circle, rectangle, bent profile) from the curve")
            .toStdString();
    ladder.errorUnit = "m";
    ladder.trials = 90;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const auto outlines = std::make_shared<const std::vector<TrueOutline>>(
            std::vector<TrueOutline>{circleOutline(), rectangleOutline(), bentOutline()});
        std::vector<Rung> rungs;
        for (const contour::SplineKind kind :
             {contour::SplineKind::approximating, contour::SplineKind::interpolating})
            for (const std::size_t points : {8U, 16U, 32U, 64U, 128U, 360U})
                rungs.push_back(contourRung(kind, points, outlines));
        const auto curve = std::make_shared<std::vector<Point>>(kCurvePoints + 1);
        constexpr std::size_t kCalls = 64;
        rungs.push_back(limitRung("points of the curve written once", kCalls, [curve](std::size_t index) {
            std::ranges::fill(*curve, Point::Constant(static_cast<double>(index)));
            return curve->back().x();
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
