// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/slip_monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace teleta::vision {

namespace {

constexpr std::size_t kLeastPlaces = 5;
constexpr std::size_t kMostProposals = 600;
constexpr double kNoises = 3.0;
constexpr double kShareOfMotion = 0.01;
constexpr double kLeastWay = 3.0; ///< tolerances; what moved less has not slipped yet
constexpr double kMostUnshared = 0.5;
/// With fewer places one more or less changes the extrapolation by more than what it corrects.
constexpr std::size_t kLeastExtrapolated = 25;
constexpr double kOver = 0.2;
constexpr double kFallen = 0.8;
constexpr int kFrames = 2;
constexpr double kLeastPeak = 10.0; ///< noises; a smaller shear may fall by itself

struct Rigid {
    Eigen::Vector2d rest = Eigen::Vector2d::Zero(), now = Eigen::Vector2d::Zero(); ///< means
    double cosine = 1.0, sine = 0.0;                                               ///< of the turn
    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& place) const {
        const Eigen::Vector2d off = place - rest;
        return now + Eigen::Vector2d(cosine * off.x() - sine * off.y(), sine * off.x() + cosine * off.y());
    }
};

/// Least squares; at least two places.
Rigid rigidOf(std::span<const ContactPlace> places) {
    Rigid rigid;
    for (const ContactPlace& place : places) {
        rigid.rest += place.rest_m;
        rigid.now += place.rest_m + place.moved_m;
    }
    rigid.rest /= static_cast<double>(places.size());
    rigid.now /= static_cast<double>(places.size());
    double dot = 0.0, cross = 0.0;
    for (const ContactPlace& place : places) {
        const Eigen::Vector2d from = place.rest_m - rigid.rest;
        const Eigen::Vector2d to = place.rest_m + place.moved_m - rigid.now;
        dot += from.dot(to);
        cross += from.x() * to.y() - from.y() * to.x();
    }
    if (const double size = std::hypot(dot, cross); size > 0.0) {
        rigid.cosine = dot / size;
        rigid.sine = cross / size;
    }
    return rigid;
}

/// What a place that lags counts for in the share that slips, so that the sum is what it would be without a
/// tolerance. The area that lags by more than l falls in a line over l^(2/3), since a lag grows from the edge
/// of what sticks with the power 3/2 of the distance. The line is fitted by least squares from 1 to 2.5 and
/// read at 0. relative: lag over the tolerance.
double slipWeight(double relative) {
    constexpr double kEnd = 2.5;
    constexpr double kWidth = kEnd - 1.0;
    constexpr double kMiddle = 0.5 * (kEnd + 1.0);
    const double x = std::min(std::cbrt(relative * relative), kEnd);
    if (!(x > 1.0))
        return 0.0;
    const double off = (x - kMiddle) / kWidth;
    return (x - 1.0) / kWidth + 6.0 * kMiddle / kWidth * (0.25 - off * off);
}

/// How far a place is behind where the rigid motion leads; 0 where that hardly moves.
double lagOf(const Rigid& rigid, const ContactPlace& place, double tolerance_m) {
    const Eigen::Vector2d led_m = rigid.at(place.rest_m) - place.rest_m;
    const double way_m = led_m.norm();
    return way_m > tolerance_m ? (led_m - place.moved_m).dot(led_m) / way_m : 0.0;
}

/// Whether the places went some way, and one rigid motion explains at least half of its squares. It explains
/// nothing of what only spreads.
bool moveAsOne(std::span<const ContactPlace> places, double tolerance_m) {
    const Rigid whole = rigidOf(places);
    double left_m2 = 0.0, all_m2 = 0.0;
    for (const ContactPlace& place : places) {
        left_m2 += (whole.at(place.rest_m) - place.rest_m - place.moved_m).squaredNorm();
        all_m2 += place.moved_m.squaredNorm();
    }
    const double least_m = kLeastWay * tolerance_m;
    return all_m2 > static_cast<double>(places.size()) * least_m * least_m &&
           left_m2 <= kMostUnshared * all_m2;
}

/// A motion and how many places agree with it.
struct Proposal {
    Rigid rigid;
    std::size_t count = 0;
};

} // namespace

std::optional<SharedMotion> sharedMotion(std::span<const ContactPlace> places, double noise_m) {
    if (places.size() < kLeastPlaces)
        return std::nullopt;
    double largest_m = 0.0;
    for (const ContactPlace& place : places)
        largest_m = std::max(largest_m, place.moved_m.norm());
    const double tolerance_m = kNoises * noise_m + kShareOfMotion * largest_m;
    const auto agrees = [tolerance_m](const Rigid& rigid, const ContactPlace& place) {
        return (rigid.at(place.rest_m) - place.rest_m - place.moved_m).norm() <= tolerance_m;
    };
    const auto proposed = [&](const Rigid& rigid) {
        const auto count =
            std::ranges::count_if(places, [&](const ContactPlace& place) { return agrees(rigid, place); });
        return Proposal{rigid, static_cast<std::size_t>(count)};
    };
    const std::size_t pairs = places.size() * (places.size() - 1) / 2;
    const std::size_t stride = (pairs + kMostProposals - 1) / kMostProposals;
    std::vector<Proposal> proposals;
    proposals.reserve(kMostProposals);
    std::size_t number = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t k = i + 1; k < places.size(); ++k) {
            if (number++ % stride != 0 || (places[k].rest_m - places[i].rest_m).isZero(0.0))
                continue;
            proposals.push_back(proposed(rigidOf(std::array{places[i], places[k]})));
            most = std::max(most, proposals.back().count);
        }
    }
    if (most < 2)
        return std::nullopt;
    // What slips lags behind. Where less than half of the places stick, a slice of those that slip may agree
    // as well; it is as thick on both sides of its middle, so that half as many are enough for the foremost.
    constexpr double kForemost = 0.45;
    const double enough = (2 * most >= places.size() ? 1.0 : kForemost) * static_cast<double>(most);
    double furthest_m = -1.0;
    Proposal best;
    for (const Proposal& proposal : proposals) {
        const double moved_m = (proposal.rigid.now - proposal.rigid.rest).norm();
        if (static_cast<double>(proposal.count) >= enough && moved_m > furthest_m) {
            furthest_m = moved_m;
            best = proposal;
        }
    }
    std::vector<ContactPlace> alike;
    std::ranges::copy_if(places, std::back_inserter(alike),
                         [&](const ContactPlace& place) { return agrees(best.rigid, place); });
    if (const Proposal fitted = proposed(rigidOf(alike)); fitted.count >= best.count)
        best = fitted;
    SharedMotion shared{.turn_rad = std::atan2(best.rigid.sine, best.rigid.cosine), .sticking = best.count};
    double slipping = 0.0;
    shared.movesAsOne = moveAsOne(places, tolerance_m);
    for (const ContactPlace& place : places) {
        shared.sticks.push_back(agrees(best.rigid, place));
        if (!shared.movesAsOne)
            continue;
        const double weight = slipWeight(std::max(0.0, lagOf(best.rigid, place, tolerance_m)) / tolerance_m);
        slipping += places.size() < kLeastExtrapolated ? std::min(1.0, weight) : weight;
    }
    shared.slipShare = std::min(1.0, slipping / static_cast<double>(places.size()));
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
        m_partly = *index >= kIncipientSlipIndex ? m_partly + 1 : 0;
        m_wholly = *index >= kSlipIndex ? m_wholly + 1 : 0;
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
