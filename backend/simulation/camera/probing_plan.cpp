// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/probing_plan.h"

#include "backend/core/random_stream.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::simulation {

namespace {

constexpr double kLifted_m = 0.004;
// Shares of the time for a hole.
constexpr double kDown = 0.3;
constexpr double kUp = 0.8;
constexpr double kLifted = 0.95;

} // namespace

ProbingPlan::ProbingPlan(const scene::Probing& probing, const scene::CameraSkin& skin, std::uint64_t seed)
    : m_probing(probing)
    , m_hole_s(probing.hole_s) {
    core::RandomStream random(seed, "probing");
    const auto place = [&](int ring, int hole) {
        const double share = probing.along > 1 ? static_cast<double>(ring) / (probing.along - 1) : 0.0;
        // Angles go on rising from ring to ring: the person walks around the tube.
        return SkinPlace{2.0 * std::numbers::pi * (ring + static_cast<double>(hole) / probing.around),
                         probing.first_z_m + share * (probing.last_z_m - probing.first_z_m)};
    };
    for (int ring = 0; ring < probing.along; ++ring) {
        for (int hole = 0; hole < probing.around; ++hole) {
            const SkinPlace noted = place(ring, hole);
            ProbedHole probed;
            probed.p_Sensor_Noted_m = {skin.radius_m * std::cos(noted.angle_rad),
                                       skin.radius_m * std::sin(noted.angle_rad), noted.z_m};
            // Always as many random numbers, so that a mistake changes nothing else.
            const double mistake = random.uniform();
            const bool aroundIt = random.uniform() < 0.5;
            const int side = random.uniform() < 0.5 ? -1 : 1;
            const double playAround_m = probing.play_m * random.normal();
            const double playAlong_m = probing.play_m * random.normal();
            probed.mistaken =
                mistake < probing.wrongShare && (aroundIt ? probing.around > 1 : probing.along > 1);
            const int otherRing = ring + side >= 0 && ring + side < probing.along ? ring + side : ring - side;
            const SkinPlace at = !probed.mistaken ? noted
                                 : aroundIt       ? place(ring, hole + side)
                                                  : place(otherRing, hole);
            probed.truly = {at.angle_rad + playAround_m / skin.radius_m, at.z_m + playAlong_m};
            m_holes.push_back(probed);
        }
    }
}

std::size_t ProbingPlan::holeAt(double time_s) const {
    const double hole = std::clamp(time_s / m_hole_s, 0.0, static_cast<double>(m_holes.size() - 1));
    return static_cast<std::size_t>(hole);
}

scene::Finger ProbingPlan::stick() const {
    scene::Finger stick{.name = "stick", .radius_m = m_probing.stickRadius_m, .keyframes = {}};
    double begin_s = 0.0;
    for (const ProbedHole& hole : m_holes) {
        const auto add = [&](double share, double depth_m) {
            stick.keyframes.push_back({.time_s = begin_s + share * m_hole_s,
                                       .angle_rad = hole.truly.angle_rad,
                                       .z_m = hole.truly.z_m,
                                       .depth_m = depth_m});
        };
        add(0.0, -kLifted_m);
        add(kDown, m_probing.depth_m);
        add(kUp, m_probing.depth_m);
        add(kLifted, -kLifted_m);
        begin_s += m_hole_s;
    }
    return stick;
}

} // namespace teleta::simulation
