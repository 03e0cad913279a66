// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/contour_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace teleta::contour {

/// A curve with a known length that can be walked along: straight edges, or a fine chain for a smooth one.
class Track {
public:
    Track(Points vertices, bool closed)
        : m_vertices(std::move(vertices)) {
        if (closed)
            m_vertices.push_back(m_vertices.front());
        m_at.push_back(0.0);
        for (std::size_t i = 1; i < m_vertices.size(); ++i)
            m_at.push_back(m_at.back() + (m_vertices[i] - m_vertices[i - 1]).norm());
    }
    [[nodiscard]] double length() const { return m_at.back(); }
    [[nodiscard]] Point at(double s) const {
        const auto next = std::upper_bound(m_at.begin(), m_at.end() - 1, s);
        const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next - m_at.begin()));
        const double step = m_at[i] - m_at[i - 1];
        return m_vertices[i - 1] + (s - m_at[i - 1]) / step * (m_vertices[i] - m_vertices[i - 1]);
    }

private:
    Points m_vertices;
    std::vector<double> m_at;
};

inline Points ellipseVertices(double a, double b, double from_rad, double to_rad, int steps = 720) {
    Points vertices;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / steps;
        vertices.emplace_back(a * std::cos(angle), b * std::sin(angle));
    }
    return vertices;
}

inline Points regularPolygon(int corners, double size) {
    Points vertices;
    for (int i = 0; i < corners; ++i)
        vertices.push_back(onCircle(0.5 * size, 2.0 * std::numbers::pi * i / corners));
    return vertices;
}

/// How an explorer touched a shape.
struct Exploration {
    int points = 20;
    double noise = 0.0;  ///< standard deviation per coordinate, as a share of the size
    double laps = 1.0;   ///< of a closed contour; 0.9 leaves a gap
    double jitter = 0.2; ///< of the spacing
    double start = 0.0;  ///< 0..1 of a closed contour
    bool reversed = false;
    double angle_rad = 0.0;
    Point shift_m = Point::Zero();
};

class RandomShapes {
public:
    explicit RandomShapes(unsigned seed)
        : m_engine(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_engine);
    }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

    /// Random pose, number of points, start, direction; a closed contour stops short of its start, comes back
    /// to it, or goes on beyond it.
    Exploration exploration(double largestNoise, double smallestNoise = 0.0) {
        Exploration e;
        e.points = integer(8, 60);
        e.noise = uniform(smallestNoise, largestNoise);
        e.start = uniform(0.0, 1.0);
        e.reversed = integer(0, 1) == 1;
        e.angle_rad = uniform(0.0, 2.0 * std::numbers::pi);
        e.shift_m = {uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
        const double oneStepShort = 1.0 - 1.0 / e.points;
        switch (integer(0, 3)) {
        case 0:
            e.laps = oneStepShort;
            break; // closed by one more step
        case 1:
            e.laps = 1.0;
            break; // the first point is touched again
        case 2:
            e.laps = uniform(1.0, 1.15);
            break; // goes on
        default:
            e.laps = oneStepShort - uniform(0.0, 0.08);
            break; // open
        }
        return e;
    }

    /// Points that the exploration takes from a shape of the given size.
    Points explore(const Track& track, bool closed, double size_m, const Exploration& e) {
        std::normal_distribution<double> normal(0.0, 1.0);
        const double range = closed ? e.laps : 1.0;
        const double step = range / (e.points - 1);
        Points points;
        for (int i = 0; i < e.points; ++i) {
            const bool end = !closed && (i == 0 || i + 1 == e.points);
            double s = i * step + (end ? 0.0 : e.jitter * step * uniform(-1.0, 1.0));
            s = closed ? s + e.start - std::floor(s + e.start) : std::clamp(s, 0.0, 1.0);
            const Point p = track.at(s * track.length());
            points.push_back(p + e.noise * size_m * Point(normal(m_engine), normal(m_engine)));
        }
        if (e.reversed)
            std::reverse(points.begin(), points.end());
        return moved(points, 1.0, e.angle_rad, e.shift_m);
    }

    Points circle(double size_m, const Exploration& e) {
        return explore(Track(ellipseVertices(0.5 * size_m, 0.5 * size_m, 0.0, 2.0 * std::numbers::pi), true),
                       true, size_m, e);
    }
    /// size_m: the longer side; the sides are at most 3 to 1.
    Points rectangle(double size_m, const Exploration& e, double aspect = 0.0) {
        const double other = size_m / (aspect > 0.0 ? aspect : uniform(1.0, 3.0));
        return explore(Track({{0, 0}, {size_m, 0}, {size_m, other}, {0, other}}, true), true, size_m, e);
    }
    /// size_m: the longest side; no angle under 30 degrees.
    Points triangle(double size_m, const Exploration& e) {
        constexpr double kLeast_rad = std::numbers::pi / 6.0;
        double a = 0.0, b = 0.0, c = 0.0;
        do {
            a = uniform(kLeast_rad, std::numbers::pi);
            b = uniform(kLeast_rad, std::numbers::pi);
            c = std::numbers::pi - a - b;
        } while (c < kLeast_rad);
        const double longest = std::max({std::sin(a), std::sin(b), std::sin(c)});
        const double side = size_m * std::sin(c) / longest;
        const double other = size_m * std::sin(b) / longest;
        return explore(Track({{0, 0}, {side, 0}, {other * std::cos(a), other * std::sin(a)}}, true), true,
                       size_m, e);
    }
    /// size_m: the largest distance in it; 60 to 270 degrees.
    Points arc(double size_m, const Exploration& e) {
        const double angle_rad = uniform(std::numbers::pi / 3.0, 1.5 * std::numbers::pi);
        const double radius_m =
            0.5 * size_m / (angle_rad < std::numbers::pi ? std::sin(0.5 * angle_rad) : 1.0);
        return explore(Track(ellipseVertices(radius_m, radius_m, 0.0, angle_rad), false), false, size_m, e);
    }
    Points line(double size_m, const Exploration& e) {
        return explore(Track({{0, 0}, {size_m, 0}}, false), false, size_m, e);
    }
    /// A cloud of the given extent at most.
    Points point(double extent_m, const Exploration& e) {
        Points points;
        for (int i = 0; i < e.points; ++i)
            points.push_back(onCircle(0.5 * extent_m * std::sqrt(uniform(0.0, 1.0)),
                                      uniform(0.0, 2.0 * std::numbers::pi)) +
                             e.shift_m);
        return points;
    }
    Points ellipse(double size_m, const Exploration& e) {
        const double minor = 0.5 * size_m / uniform(1.5, 2.5);
        return explore(Track(ellipseVertices(0.5 * size_m, minor, 0.0, 2.0 * std::numbers::pi), true), true,
                       size_m, e);
    }
    Points pentagon(double size_m, const Exploration& e) {
        return explore(Track(regularPolygon(5, size_m), true), true, size_m, e);
    }
    Points randomWalk(double size_m, const Exploration& e) {
        std::normal_distribution<double> normal(0.0, 0.1 * size_m);
        Points points{e.shift_m};
        while (static_cast<int>(points.size()) < e.points)
            points.push_back(points.back() + Point(normal(m_engine), normal(m_engine)));
        return points;
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace teleta::contour
