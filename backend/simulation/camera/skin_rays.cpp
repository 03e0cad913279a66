// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin_rays.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

constexpr int kMarchSteps = 8;
constexpr int kMostSearchSteps = 50;
constexpr double kCloseEnough_m = 1e-9; ///< above or under the skin
constexpr double kCloseEnough = 1e-5;   ///< of the way through the depth of the skin

/// Of all presses together, wherever they are: those that can overlap count with one another.
double deepestOverlap_m(const SkinDeformation& deformation) {
    double deepest_m = 0.0;
    for (const SkinDeformation::Press& press : deformation.presses()) {
        double sum_m = 0.0;
        for (const SkinDeformation::Press& other : deformation.presses()) {
            const double around_m =
                deformation.tubeRadius_m() *
                std::remainder(press.press.centre.angle_rad - other.press.centre.angle_rad,
                               2.0 * std::numbers::pi);
            const double along_m = press.press.centre.z_m - other.press.centre.z_m;
            if (std::hypot(around_m, along_m) < press.imprint.influence_m() + other.imprint.influence_m())
                sum_m += other.imprint.deepest_m();
        }
        deepest_m = std::max(deepest_m, sum_m);
    }
    return deepest_m;
}

} // namespace

SkinRays::SkinRays(const SkinDeformation& deformation, const Eigen::Vector3d& lens_m)
    : m_lens_m(lens_m)
    , m_radius_m(deformation.tubeRadius_m())
    , m_inner_m(std::max(m_radius_m - deformation.deepest_m(), 0.0))
    , m_skinEnds(deformation.deepest_m() > 0.0 ? deepestOverlap_m(deformation) / deformation.deepest_m()
                                               : 0.0)
    , m_onAxis(lens_m.head<2>() == Eigen::Vector2d::Zero()) {
    const double aside_m = lens_m.head<2>().norm();
    // As seen from the axis, a ray turns by no more than the lens is aside.
    m_mostAround_m =
        aside_m < m_inner_m ? m_radius_m * std::asin(aside_m / m_inner_m) : std::numbers::pi * m_radius_m;
    for (const SkinDeformation::Press& press : deformation.presses())
        m_presses.push_back({&press, std::remainder(press.press.centre.angle_rad, 2.0 * std::numbers::pi)});
}

SkinRays::Way SkinRays::wayTo(const SkinPlace& place) const {
    Way way;
    if (m_onAxis) {
        way.enters = m_inner_m / m_radius_m;
    } else {
        const Eigen::Vector2d lens_m = m_lens_m.head<2>();
        const Eigen::Vector2d hit_m =
            m_radius_m * Eigen::Vector2d(std::cos(place.angle_rad), std::sin(place.angle_rad));
        way.way_m = hit_m - lens_m;
        // |lens + t way| = inner
        const double a = way.way_m.squaredNorm();
        const double b = lens_m.dot(way.way_m);
        const double c = lens_m.squaredNorm() - m_inner_m * m_inner_m;
        way.enters = c >= 0.0 ? 0.0 : -c / (b + std::sqrt(b * b - a * c));
        const Eigen::Vector2d entry_m = lens_m + way.enters * way.way_m;
        way.around_m =
            m_radius_m * std::atan2(hit_m.x() * entry_m.y() - hit_m.y() * entry_m.x(), hit_m.dot(entry_m));
    }
    way.along_m = -(1.0 - way.enters) * (place.z_m - m_lens_m.z());
    way.square_m2 = way.around_m * way.around_m + way.along_m * way.along_m;
    return way;
}

bool SkinRays::follow(const SkinPlace& place, SkinPlace& rest) {
    m_chords.clear();
    Way way;
    bool hasWay = false;
    double from = 1.0;
    double to = 0.0;
    for (const Reaching& reaching : m_presses) {
        const double influence_m = reaching.press->imprint.influence_m();
        const double around_m = m_radius_m * wrapped_rad(place.angle_rad - reaching.angle_rad);
        const double along_m = place.z_m - reaching.press->press.centre.z_m;
        // A way leads toward the lens.
        if (std::abs(around_m) > influence_m + m_mostAround_m || along_m < -influence_m)
            continue;
        if (!hasWay)
            way = wayTo(place);
        hasWay = true;
        const double b = around_m * way.around_m + along_m * way.along_m;
        const double c = around_m * around_m + along_m * along_m;
        const double inside = b * b - way.square_m2 * (c - influence_m * influence_m);
        if (!(inside > 0.0) || way.square_m2 <= 0.0)
            continue;
        const double root = std::sqrt(inside);
        const double begins = std::max((-b - root) / way.square_m2, 0.0);
        const double ends = std::min((-b + root) / way.square_m2, m_skinEnds);
        if (begins >= ends)
            continue;
        from = std::min(from, begins);
        to = std::max(to, ends);
        m_chords.push_back({reaching.press, b, c});
    }
    if (m_chords.empty())
        return false;
    const double u = meets(way, from, to);
    if (u < 0.0)
        return false;
    rest = {place.angle_rad + u * way.around_m / m_radius_m, place.z_m + u * way.along_m};
    for (const Chord& chord : m_chords) {
        const SkinPress& press = chord.press->press;
        if (press.dragAround_m == 0.0 && press.dragAlong_m == 0.0)
            continue;
        const double s_m = std::sqrt(std::max(chord.c + u * (2.0 * chord.b + u * way.square_m2), 0.0));
        const double share = chord.press->imprint.dragShare(s_m);
        rest.angle_rad -= share * press.dragAround_m / m_radius_m;
        rest.z_m -= share * press.dragAlong_m;
    }
    return true;
}

double SkinRays::above_m(const Way& way, double u) const {
    double above_m = 0.0;
    if (m_onAxis) {
        above_m = u * (m_radius_m - m_inner_m);
    } else {
        const double t = 1.0 - u * (1.0 - way.enters);
        above_m = m_radius_m - (m_lens_m.head<2>() + t * way.way_m).norm();
    }
    for (const Chord& chord : m_chords)
        above_m -= chord.press->imprint.depth_m(
            std::sqrt(std::max(chord.c + u * (2.0 * chord.b + u * way.square_m2), 0.0)));
    return above_m;
}

double SkinRays::meets(const Way& way, double from, double to) const {
    // Between the presses the ray is above the skin, so only the steps among them are looked at, and the one
    // before.
    const auto step = [&](int i) { return m_skinEnds * (1.0 - static_cast<double>(i) / kMarchSteps); };
    const int first = std::max(static_cast<int>(std::ceil((1.0 - to / m_skinEnds) * kMarchSteps)), 1);
    double over = step(first - 1);
    double overHeight_m = above_m(way, over);
    double under = over;
    double underHeight_m = overHeight_m;
    for (int i = first; i <= kMarchSteps && underHeight_m > 0.0; ++i) {
        const double u = step(i);
        if (u < from)
            return -1.0;
        const double height_m = above_m(way, u);
        under = u;
        underHeight_m = height_m;
        if (height_m > 0.0 && i < kMarchSteps) {
            over = u;
            overHeight_m = height_m;
        }
    }
    if (!(overHeight_m > 0.0 && underHeight_m < 0.0))
        return under;
    double u = under;
    double height_m = underHeight_m;
    for (int i = 0;
         i < kMostSearchSteps && std::abs(height_m) > kCloseEnough_m && std::abs(under - over) > kCloseEnough;
         ++i) {
        const bool wasOver = height_m > 0.0;
        const double before_m = height_m;
        u = over + (under - over) * overHeight_m / (overHeight_m - underHeight_m);
        height_m = above_m(way, u);
        const bool isOver = height_m > 0.0;
        // Keeps an end from standing still (Anderson and Bjoerck).
        if (i > 0 && isOver == wasOver) {
            const double left = 1.0 - height_m / before_m;
            (isOver ? underHeight_m : overHeight_m) *= left > 0.0 ? left : 0.5;
        }
        (isOver ? over : under) = u;
        (isOver ? overHeight_m : underHeight_m) = height_m;
    }
    return u;
}

} // namespace teleta::simulation
