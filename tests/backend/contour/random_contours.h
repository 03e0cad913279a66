// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/backend/contour/random_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace teleta::contour {

/// A contour of a known kind, as an explorer might have touched it.
struct RandomContour {
    const char* kind = "";
    Shape truth = Shape::unknown;
    double noise = 0.0; ///< standard deviation per coordinate, as a share of the size
    Points points_m;
};

/// Random contours for measuring how far a confidence can be trusted. Two thirds are of a named shape, one
/// third of none of them. All of them: 4 to 60 points (uniform in the logarithm), a size of 15 to 300 mm, any
/// place, turn and direction, noise of 0 to 6 % of the size. The points are
/// spaced evenly, about evenly or at random along the contour; some contours have a gap or go on beyond their
/// start, some were touched in any order, and some have one point that does not belong to them. Uses no code
/// of the recogniser.
class RandomContours {
public:
    explicit RandomContours(unsigned seed)
        : m_engine(seed) {}

    RandomContour next() { return uniform(0.0, 3.0) < 2.0 ? named() : other(); }

    /// A contour of a named shape: the smallest shares are those of the line and of the point.
    RandomContour named() {
        const double share = uniform(0.0, 1.0);
        if (share < 0.20)
            return closed("circle", Shape::circle, ellipseVertices(0.5, 0.5, 0.0, kTurn), kGapOfCircle);
        if (share < 0.28)
            return closed("square", Shape::rectangle, box(1.0), kGap);
        if (share < 0.42)
            return closed("rectangle", Shape::rectangle, box(1.0 / uniform(1.0, 3.0)), kGap);
        if (share < 0.62)
            return closed("triangle", Shape::triangle, triangle(), kGap);
        if (share < 0.80)
            return open("arc", Shape::arc, arc());
        if (share < 0.94)
            return open("line", Shape::line, {{-0.5, 0.0}, {0.5, 0.0}});
        return cloud("point", Shape::point, uniform(0.0005, 0.003));
    }

    /// A contour of no named shape.
    RandomContour other() {
        switch (integer(0, 15)) {
        case 0:
            return closed("two circles", Shape::unknown, twoCircles(), kGap);
        case 1:
            return closed("crescent", Shape::unknown, crescent(), kGap);
        case 2:
            return closed("star", Shape::unknown, star(), kGap);
        case 3:
            return closed("L", Shape::unknown, lShape(), kGap);
        case 4:
        case 5:
            return closed("blob", Shape::unknown, blob(), kGap);
        case 6:
            return open("spiral", Shape::unknown, spiral());
        case 7:
        case 8:
            return cloud("scattered", Shape::unknown, size_m());
        case 9:
            return walk();
        case 10: {
            const double minor = 0.5 / uniform(1.5, 2.5);
            return closed("ellipse", Shape::unknown, ellipseVertices(0.5, minor, 0.0, kTurn), kGap);
        }
        case 11:
            return closed("regular polygon", Shape::unknown, regularPolygon(integer(5, 6), 1.0), kGap);
        case 12:
            return closed("oblique", Shape::unknown, oblique(), kGap);
        case 13:
            return open("open chain", Shape::unknown, openChain());
        case 14:
            return open("wave", Shape::unknown, wave());
        default:
            return open("half an ellipse", Shape::unknown,
                        ellipseVertices(0.5, 0.5 * uniform(0.25, 0.6), 0.0, std::numbers::pi));
        }
    }

    /// So many points drawn from a square without a shape.
    RandomContour scattered(int points) {
        return placed("scattered", Shape::unknown, scatter(points), size_m(), 0.0);
    }

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_engine);
    }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }
    /// The size of a contour that is no point.
    double size_m() { return logUniform(0.015, 0.3); }
    /// Touches of a closed contour whose vertices are given in units of the size.
    RandomContour touched(const char* kind, Shape truth, const Points& vertices, int points, double noise) {
        return explored(kind, truth, Track(vertices, true), true, 0.0, points, noise);
    }
    Points triangle() {
        constexpr double kLeast_rad = std::numbers::pi / 7.0;
        double a = 0.0, b = 0.0, c = 0.0;
        do {
            a = uniform(kLeast_rad, std::numbers::pi);
            b = uniform(kLeast_rad, std::numbers::pi);
            c = std::numbers::pi - a - b;
        } while (c < kLeast_rad);
        const double longest = std::max({std::sin(a), std::sin(b), std::sin(c)});
        const double side = std::sin(b) / longest;
        return {{0.0, 0.0}, {std::sin(c) / longest, 0.0}, {side * std::cos(a), side * std::sin(a)}};
    }
    static Points box(double height) { return {{0.0, 0.0}, {1.0, 0.0}, {1.0, height}, {0.0, height}}; }

private:
    static constexpr double kTurn = 2.0 * std::numbers::pi;
    static constexpr double kGap = 0.2;          ///< largest part of a closed contour that is not touched
    static constexpr double kGapOfCircle = 0.11; ///< beyond this a circle is an arc

    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    double normal() { return std::normal_distribution<double>(0.0, 1.0)(m_engine); }
    bool chance(double share) { return uniform(0.0, 1.0) < share; }
    int count() { return static_cast<int>(logUniform(4.0, 61.0)); }
    double noise() { return uniform(0.0, 0.06); }

    RandomContour closed(const char* kind, Shape truth, const Points& vertices, double largestGap) {
        const double gap = chance(0.25) ? uniform(0.3, 1.0) * largestGap : 0.0;
        return explored(kind, truth, Track(vertices, true), true, gap, count(), noise());
    }
    RandomContour open(const char* kind, Shape truth, const Points& vertices) {
        return explored(kind, truth, Track(vertices, false), false, 0.0, count(), noise());
    }

    /// Places along a contour, 0..1, in the order of touch.
    std::vector<double> places(bool closed, double gap, int count) {
        const double range = closed && gap == 0.0 && chance(0.25) ? uniform(1.0, 1.15) : 1.0 - gap;
        const double step = closed && gap == 0.0 ? range / count : range / (count - 1);
        const double way = uniform(0.0, 1.0);
        std::vector<double> all;
        for (int i = 0; i < count; ++i) {
            const double even = i * step;
            const double jitter = way < 0.3 ? 0.0 : 0.4 * step * uniform(-1.0, 1.0);
            all.push_back(way < 0.7 ? even + jitter : uniform(0.0, range));
        }
        std::ranges::sort(all);
        const double start = closed ? uniform(0.0, 1.0) : 0.0;
        for (double& s : all)
            s = closed ? s + start - std::floor(s + start) : std::clamp(s, 0.0, 1.0);
        if (chance(0.5))
            std::ranges::reverse(all);
        if (chance(0.1))
            std::ranges::shuffle(all, m_engine);
        return all;
    }

    RandomContour explored(const char* kind, Shape truth, const Track& track, bool closed, double gap,
                           int count, double noise) {
        Points points;
        for (const double s : places(closed, gap, count))
            points.push_back(track.at(s * track.length()));
        if (count >= 12 && chance(0.05))
            points[static_cast<std::size_t>(integer(0, count - 1))] +=
                onCircle(logUniform(0.2, 10.0), uniform(0.0, kTurn));
        return placed(kind, truth, std::move(points), size_m(), noise);
    }

    RandomContour placed(const char* kind, Shape truth, Points points, double size_m, double noise) {
        for (Point& p : points)
            p += noise * Point(normal(), normal());
        return {
            kind, truth, noise,
            moved(std::move(points), size_m, uniform(0.0, kTurn), {uniform(-1.0, 1.0), uniform(-1.0, 1.0)})};
    }

    Points scatter(int count) {
        const bool round = chance(0.5);
        Points points;
        while (static_cast<int>(points.size()) < count) {
            const Point p(uniform(-0.5, 0.5), uniform(-0.5, 0.5));
            if (!round || p.norm() <= 0.5)
                points.push_back(p);
        }
        return points;
    }

    RandomContour cloud(const char* kind, Shape truth, double extent_m) {
        return placed(kind, truth, scatter(count()),
                      extent_m / (truth == Shape::point ? std::numbers::sqrt2 : 1.0), 0.0);
    }

    RandomContour walk() {
        Points points{Point::Zero()};
        const int n = count();
        while (static_cast<int>(points.size()) < n)
            points.push_back(points.back() + 0.2 * Point(normal(), normal()));
        return placed("walk", Shape::unknown, std::move(points), size_m(), 0.0);
    }

    /// An arc of 60 to 300 degrees whose largest distance is 1.
    Points arc() {
        const double angle_rad = uniform(std::numbers::pi / 3.0, kTurn - std::numbers::pi / 3.0);
        const double radius = 0.5 / (angle_rad < std::numbers::pi ? std::sin(0.5 * angle_rad) : 1.0);
        return ellipseVertices(radius, radius, 0.0, angle_rad);
    }

    /// Two circles that overlap, as one outline, or that touch.
    Points twoCircles() {
        const double other = uniform(0.5, 1.0);
        const double apart = uniform(0.75, 1.0) * (1.0 + other);
        const double x = (apart * apart + 1.0 - other * other) / (2.0 * apart);
        const double half_rad = std::acos(std::clamp(x, -1.0, 1.0));
        const double otherHalf_rad = std::acos(std::clamp((apart - x) / other, -1.0, 1.0));
        const double scale = 1.0 / (1.0 + other + apart);
        Points points = ellipseVertices(scale, scale, half_rad, kTurn - half_rad, 200);
        for (const Point& p : ellipseVertices(scale * other, scale * other, otherHalf_rad - std::numbers::pi,
                                              std::numbers::pi - otherHalf_rad, 200))
            points.push_back(p + Point(scale * apart, 0.0));
        return points;
    }

    Points crescent() {
        const double inner = uniform(0.15, 0.65);
        Points points = ellipseVertices(0.5, 0.5, 0.0, std::numbers::pi, 200);
        Points back = ellipseVertices(0.5, 0.5 * inner, 0.0, std::numbers::pi, 200);
        points.insert(points.end(), back.rbegin() + 1, back.rend() - 1);
        return points;
    }

    Points star() {
        const int arms = integer(4, 7);
        const double inner = uniform(0.3, 0.65);
        Points points;
        for (int i = 0; i < 2 * arms; ++i)
            points.push_back(onCircle(0.5 * (i % 2 == 0 ? 1.0 : inner), std::numbers::pi * i / arms));
        return points;
    }

    Points lShape() {
        const double height = uniform(0.6, 1.0);
        const double arm = uniform(0.2, 0.5);
        const double foot = uniform(0.2, 0.5) * height;
        return {{0.0, 0.0}, {1.0, 0.0}, {1.0, foot}, {arm, foot}, {arm, height}, {0.0, height}};
    }

    /// A smooth closed curve, 8 to 25 % (root mean square) off a circle.
    Points blob() {
        std::array<double, 4> sine{};
        std::array<double, 4> cosine{};
        double power = 0.0;
        for (std::size_t k = 0; k < sine.size(); ++k) {
            sine[k] = normal() / static_cast<double>(k + 1);
            cosine[k] = normal() / static_cast<double>(k + 1);
            power += 0.5 * (sine[k] * sine[k] + cosine[k] * cosine[k]);
        }
        const double scale = uniform(0.08, 0.25) / std::sqrt(power);
        Points points;
        for (int i = 0; i < 400; ++i) {
            const double angle_rad = kTurn * i / 400;
            double radius = 1.0;
            for (std::size_t k = 0; k < sine.size(); ++k) {
                const double order = static_cast<double>(k) + 2.0;
                radius +=
                    scale * (sine[k] * std::sin(order * angle_rad) + cosine[k] * std::cos(order * angle_rad));
            }
            points.push_back(onCircle(0.45 * std::max(0.1, radius), angle_rad));
        }
        return points;
    }

    Points spiral() {
        const double turns = uniform(1.2, 3.0);
        const double inner = uniform(0.1, 0.4);
        Points points;
        for (int i = 0; i <= 400; ++i)
            points.push_back(onCircle(0.5 * (inner + (1.0 - inner) * i / 400), kTurn * turns * i / 400));
        return points;
    }

    /// A parallelogram or trapezium that is far from a rectangle.
    Points oblique() {
        const double height = uniform(0.35, 0.8);
        const double shift = uniform(0.3, 0.7) * height;
        if (chance(0.5))
            return {{0.0, 0.0}, {0.9, 0.0}, {0.9 + shift, height}, {shift, height}};
        const double top = uniform(0.3, 0.65);
        const double left = uniform(0.0, 1.0) * (1.0 - top);
        return {{0.0, 0.0}, {1.0, 0.0}, {left + top, height}, {left, height}};
    }

    /// Two, three or four edges: a V, a U, a Z, a W.
    Points openChain() {
        const int edges = integer(2, 4);
        Points points{Point::Zero()};
        double angle_rad = 0.0;
        for (int i = 0; i < edges; ++i) {
            points.push_back(points.back() + onCircle(uniform(0.5, 1.0) / edges, angle_rad));
            angle_rad += (chance(0.5) ? 1.0 : -1.0) * uniform(0.35, 0.75) * std::numbers::pi;
        }
        return points;
    }

    Points wave() {
        const double height = uniform(0.08, 0.25);
        const double waves = uniform(0.9, 2.0);
        const double phase = uniform(0.0, kTurn);
        Points points;
        for (int i = 0; i <= 400; ++i)
            points.emplace_back(i / 400.0, height * std::sin(kTurn * waves * i / 400 + phase));
        return points;
    }

    std::mt19937_64 m_engine;
};

} // namespace teleta::contour
