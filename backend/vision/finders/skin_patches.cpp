// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/skin_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace teleta::vision {

namespace {

constexpr std::size_t kLeastAround = 3; ///< known neighbours that tell of a point that is not known
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
// A small press covers only a few points. An exponent below 1 spreads the weight of its centre over more of
// them; the smaller it is, the more the border counts, which noise and a neighbouring contact displace.
constexpr double kWeightPower = 0.75;

double turn(double to_rad, double from_rad) {
    return std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

} // namespace

std::vector<SkinPatch> SkinPatches::find(std::span<const SkinNode> nodes,
                                         std::span<const std::vector<std::size_t>> neighbours) {
    m_moved_m.resize(nodes.size());
    m_straysBefore.swap(m_strays);
    m_strays.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        m_moved_m[i] = nodes[i].known ? std::hypot(nodes[i].around_m, nodes[i].inward_m) : 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].known)
            continue;
        // A hole in a patch would displace its centre.
        double sum_m = 0.0;
        std::size_t count = 0;
        for (const std::size_t k : neighbours[i]) {
            sum_m += nodes[k].known ? m_moved_m[k] : 0.0;
            count += nodes[k].known ? 1 : 0;
        }
        m_moved_m[i] = count >= kLeastAround ? sum_m / static_cast<double>(count) : 0.0;
    }
    const double floor_m = m_settings.floorShare * m_settings.threshold_m;
    m_watershed.flood(
        m_moved_m, neighbours, [&](std::size_t node) { return m_moved_m[node] > floor_m; },
        [&](double summit_m, double pass_m) { return summit_m - pass_m < m_settings.prominence * summit_m; });

    std::map<std::size_t, SkinPatch> byRoot;
    for (const std::size_t i : m_watershed.order())
        byRoot[m_watershed.rootOf(i)].nodes.push_back(i);
    std::vector<SkinPatch> patches;
    for (auto& [root, patch] : byRoot) {
        if (patch.nodes.size() < m_settings.leastNodes || m_moved_m[root] <= m_settings.threshold_m)
            continue;
        double sum = 0.0;
        double angle = 0.0;
        double along = 0.0;
        patch.peak_m = m_moved_m[root];
        for (const std::size_t i : patch.nodes) {
            // The weight starts at zero, so that a point just above the floor does not pull the centre
            // towards itself.
            const double weight = std::pow(m_moved_m[i] - floor_m, kWeightPower);
            sum += weight;
            // The displacement around the tube is known; that along it cannot be distinguished from depth.
            angle += weight * (turn(nodes[i].angle_rad, nodes[root].angle_rad) +
                               (nodes[i].known ? nodes[i].around_m : 0.0) / m_settings.radius_m);
            along += weight * nodes[i].z_m;
        }
        measureDepth(nodes, patch);
        patch.angle_rad = turn(nodes[root].angle_rad + angle / sum, 0.0);
        patch.z_m = along / sum;
        patches.push_back(std::move(patch));
    }
    std::ranges::sort(patches, [](const SkinPatch& a, const SkinPatch& b) {
        return a.peak_m != b.peak_m ? a.peak_m > b.peak_m : a.nodes.front() < b.nodes.front();
    });
    return patches;
}

std::size_t SkinPatches::loneJump(std::span<const SkinNode> nodes, const SkinPatch& patch) const {
    std::size_t first = kNone;
    double most_m = 0.0;
    double next_m = 0.0;
    for (const std::size_t i : patch.nodes) {
        if (!nodes[i].known || !isKnownBefore(nodes, i))
            continue;
        const double deepened_m = nodes[i].inward_m - nodes[i].inwardBefore_m;
        if (deepened_m > most_m) {
            next_m = std::exchange(most_m, deepened_m);
            first = i;
        } else if (deepened_m > next_m) {
            next_m = deepened_m;
        }
    }
    return most_m > m_settings.loneJump_m + m_settings.loneJumpShare * next_m ? first : kNone;
}

bool SkinPatches::isKnownBefore(std::span<const SkinNode> nodes, std::size_t node) const {
    return std::isfinite(nodes[node].inwardBefore_m) &&
           std::ranges::find(m_straysBefore, node) == m_straysBefore.end();
}

void SkinPatches::measureDepth(std::span<const SkinNode> nodes, SkinPatch& patch) {
    const std::size_t alone = loneJump(nodes, patch);
    if (alone != kNone)
        m_strays.push_back(alone);
    double inward_m = 0.0;
    double inwardBefore_m = 0.0;
    bool knownBefore = false;
    std::size_t lost = 0;
    for (const std::size_t i : patch.nodes) {
        const bool before = isKnownBefore(nodes, i);
        if (!nodes[i].known) {
            lost += before ? 1 : 0;
            continue;
        }
        if (i == alone)
            continue;
        patch.depth_m = std::max(patch.depth_m, nodes[i].inward_m);
        if (before) {
            inward_m = std::max(inward_m, nodes[i].inward_m);
            inwardBefore_m = std::max(inwardBefore_m, nodes[i].inwardBefore_m);
            knownBefore = true;
        }
    }
    if (knownBefore)
        patch.deepened_m = inward_m - inwardBefore_m;
    if (lost >= m_settings.leastLost)
        patch.deepened_m = std::max(knownBefore ? patch.deepened_m : 0.0, m_settings.jump_m);
}

double SkinPatches::smoothed_m(std::span<const SkinNode> nodes, std::span<const std::size_t> candidates,
                               double angle_rad, double z_m, double width_m) const {
    double sum = 0.0;
    double moved = 0.0;
    for (const std::size_t i : candidates) {
        if (!nodes[i].known)
            continue;
        const double around_m = m_settings.radius_m * turn(nodes[i].angle_rad, angle_rad);
        const double along_m = nodes[i].z_m - z_m;
        const double weight =
            std::exp(-0.5 * (around_m * around_m + along_m * along_m) / (width_m * width_m));
        sum += weight;
        moved += weight * std::hypot(nodes[i].around_m, nodes[i].inward_m);
    }
    return sum > 1e-12 ? moved / sum : 0.0;
}

} // namespace teleta::vision
