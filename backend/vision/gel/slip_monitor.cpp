// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/slip_monitor.h"

#include <algorithm>
#include <cmath>

namespace teleta::vision {

namespace {

constexpr std::size_t kLeastPlaces = 5;
constexpr std::size_t kMostProposals = 600;
constexpr double kNoises = 3.0;
constexpr double kShareOfMotion = 0.05;
constexpr double kPartly = 0.3;
constexpr double kWholly = 0.8;
constexpr double kOver = 0.2;
constexpr double kFallen = 0.8;
constexpr int kFrames = 2;
constexpr double kLeastPeak = 10.0; ///< noises; a smaller shear may fall by itself

struct Rigid {
    Eigen::Vector2d rest = Eigen::Vector2d::Zero(), now = Eigen::Vector2d::Zero(); ///< means
    double turn_rad = 0.0;
    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& place) const {
        const Eigen::Vector2d off = place - rest;
        const double c = std::cos(turn_rad);
        const double s = std::sin(turn_rad);
        return now + Eigen::Vector2d(c * off.x() - s * off.y(), s * off.x() + c * off.y());
    }
};

/// Least squares over the places that are picked; at least two.
template <typename Pick>
Rigid rigidOf(std::span<const ContactPlace> places, Pick pick) {
    Rigid rigid;
    double count = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!pick(i))
            continue;
        rigid.rest += places[i].rest_m;
        rigid.now += places[i].rest_m + places[i].moved_m;
        count += 1.0;
    }
    rigid.rest /= count;
    rigid.now /= count;
    double dot = 0.0, cross = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!pick(i))
            continue;
        const Eigen::Vector2d from = places[i].rest_m - rigid.rest;
        const Eigen::Vector2d to = places[i].rest_m + places[i].moved_m - rigid.now;
        dot += from.dot(to);
        cross += from.x() * to.y() - from.y() * to.x();
    }
    rigid.turn_rad = std::atan2(cross, dot);
    return rigid;
}

} // namespace

std::optional<SharedMotion> sharedMotion(std::span<const ContactPlace> places, double noise_m) {
    if (places.size() < kLeastPlaces)
        return std::nullopt;
    double largest_m = 0.0;
    for (const ContactPlace& place : places)
        largest_m = std::max(largest_m, place.moved_m.norm());
    const double tolerance_m = kNoises * noise_m + kShareOfMotion * largest_m;
    const auto agrees = [&](const Rigid& rigid, std::size_t i) {
        return (rigid.at(places[i].rest_m) - places[i].rest_m - places[i].moved_m).norm() <= tolerance_m;
    };
    const auto agreeing = [&](const Rigid& rigid) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            count += agrees(rigid, i) ? 1 : 0;
        return count;
    };
    const std::size_t pairs = places.size() * (places.size() - 1) / 2;
    const std::size_t stride = (pairs + kMostProposals - 1) / kMostProposals;
    Rigid best;
    std::size_t most = 0;
    // What slips lags behind. Where less than half of the places stick, a slice of those that slip may agree
    // as well; it is as thick on both sides of its middle, so that half as many are enough for the foremost.
    constexpr double kForemost = 0.45;
    double furthest_m = -1.0;
    for (const bool counting : {true, false}) {
        std::size_t number = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t k = i + 1; k < places.size(); ++k) {
                if (number++ % stride != 0 || (places[k].rest_m - places[i].rest_m).isZero(0.0))
                    continue;
                const Rigid rigid = rigidOf(places, [i, k](std::size_t n) { return n == i || n == k; });
                const std::size_t count = agreeing(rigid);
                if (counting) {
                    most = std::max(most, count);
                    continue;
                }
                const double moved_m = (rigid.now - rigid.rest).norm();
                const double enough = 2 * most >= places.size() ? 1.0 : kForemost;
                if (static_cast<double>(count) >= enough * static_cast<double>(most) &&
                    moved_m > furthest_m) {
                    furthest_m = moved_m;
                    best = rigid;
                }
            }
        }
    }
    if (most < 2)
        return std::nullopt;
    const Rigid fitted = rigidOf(places, [&](std::size_t n) { return agrees(best, n); });
    if (agreeing(fitted) >= agreeing(best))
        best = fitted;
    SharedMotion shared{.translation_m = best.now - best.rest, .turn_rad = best.turn_rad};
    for (std::size_t i = 0; i < places.size(); ++i) {
        shared.sticks.push_back(agrees(best, i));
        shared.sticking += shared.sticks.back() ? 1 : 0;
    }
    return shared;
}

SlipEvent SlipMonitor::next(std::optional<double> index, const Eigen::Vector2d& shear_m,
                            const Eigen::Vector2d& rimMoved_m, double noise_m) {
    const double shear = shear_m.norm();
    // Where the rim goes back, the load is taken away: the shear falls without slip.
    m_peak_m = rimMoved_m.dot(shear_m) < 0.0 ? shear : std::max(m_peak_m, shear);
    const bool fell = m_peak_m > kLeastPeak * noise_m && shear < kFallen * m_peak_m &&
                      rimMoved_m.dot(shear_m) > kNoises * noise_m * shear;
    if (index) {
        m_partly = *index >= kPartly ? m_partly + 1 : 0;
        m_wholly = *index >= kWholly ? m_wholly + 1 : 0;
        if (*index < kOver)
            m_toldPartly = m_toldWholly = false;
    }
    if (!m_toldWholly && (m_wholly >= kFrames || fell)) {
        m_toldWholly = m_toldPartly = true;
        m_peak_m = shear;
        return SlipEvent::slip;
    }
    if (!m_toldPartly && m_partly >= kFrames) {
        m_toldPartly = true;
        return SlipEvent::incipientSlip;
    }
    return SlipEvent::none;
}

} // namespace teleta::vision
