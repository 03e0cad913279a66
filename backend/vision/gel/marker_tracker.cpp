// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_tracker.h"

#include "backend/core/quantile.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kGate = 0.45;  ///< pitches a picture, from the expected place
constexpr double kAgree = 0.33; ///< pitches that a marker may move otherwise than its neighbours in a picture
constexpr double kSearch = 0.4; ///< pitches about the place to which neighbours lead
/// Shares of the contrast at rest: a pressed marker fades, and its light changes.
constexpr double kSpotShare = 0.2;
constexpr double kLeastShare = 0.25;
constexpr double kShade = 0.6; ///< of the contrast, at which a marker is as dark as can be
constexpr double kMostShare = 1.2;
constexpr double kLeastArea = 0.35; ///< of that at rest; a sliver is no marker
constexpr double kMostArea = 3.0;
constexpr double kFaintest = 2.0; ///< grey levels
constexpr double kShortest = 0.4; ///< what a distance between neighbours may shrink to
constexpr double kLongest = 2.0;
constexpr std::size_t kMost = 16;
constexpr double kMisled = 1.0; ///< pitches: what a marker without a spot costs a guess

double medianOfFew(std::array<double, kMost>& values, std::size_t count) {
    return core::medianOf(std::span(values).first(count));
}

} // namespace

MarkerTracker::MarkerTracker(MarkerDetector detector, const std::vector<MarkerCentre>& rest,
                             std::vector<std::vector<std::size_t>> neighbours)
    : m_detector(std::move(detector))
    , m_markers(rest.size())
    , m_states(rest.size())
    , m_neighbours(std::move(neighbours)) {
    std::vector<double> pitches, contrasts, shades;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        m_markers[i] = {.rest_px = rest[i].place_px, .now_px = rest[i].place_px, .found = true};
        m_states[i].contrast = rest[i].contrast;
        m_states[i].diameter_px = rest[i].diameter_px;
        m_states[i].wasFound = true;
        contrasts.push_back(rest[i].contrast);
        shades.push_back(1.0 - kShade * rest[i].contrast / std::max(1.0, rest[i].ground));
        double sum_px = 0.0;
        const std::size_t count = std::min<std::size_t>(4, m_neighbours[i].size());
        for (std::size_t n = 0; n < count; ++n)
            sum_px += (rest[m_neighbours[i][n]].place_px - rest[i].place_px).norm();
        if (count > 0) {
            m_states[i].pitch_px = sum_px / static_cast<double>(count);
            pitches.push_back(m_states[i].pitch_px);
        }
    }
    m_pitch_px = pitches.empty() ? 4.0 * m_detector.diameter_px() : core::medianOf(pitches);
    for (State& state : m_states) {
        if (!(state.pitch_px > 0.0))
            state.pitch_px = m_pitch_px;
    }
    if (contrasts.empty())
        return;
    m_leastContrast = std::max(kFaintest, kSpotShare * core::lowerQuantileOf(contrasts, 0.1));
    m_shadeShare = std::max(0.0, core::medianOf(shades));
}

void MarkerTracker::forget() {
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        m_markers[i].now_px = m_markers[i].rest_px;
        m_states[i].velocity_px.setZero();
    }
}

void MarkerTracker::sortSpots(const cv::Mat1b& picture) {
    m_detector.spots(picture, m_leastContrast, m_spots, m_shadeShare);
    m_squaresAcross = static_cast<int>(picture.cols / m_pitch_px) + 1;
    m_squaresDown = static_cast<int>(picture.rows / m_pitch_px) + 1;
    const auto squareOf = [&](const MarkerSpot& spot) {
        const int across =
            std::clamp(static_cast<int>(spot.place_px.x() / m_pitch_px), 0, m_squaresAcross - 1);
        const int down = std::clamp(static_cast<int>(spot.place_px.y() / m_pitch_px), 0, m_squaresDown - 1);
        return static_cast<std::size_t>(down * m_squaresAcross + across);
    };
    m_first.assign(static_cast<std::size_t>(m_squaresAcross * m_squaresDown) + 1, 0);
    for (const MarkerSpot& spot : m_spots)
        ++m_first[squareOf(spot)];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_inSquares.resize(m_spots.size());
    // Filled from the end of each square; the ends become the beginnings.
    for (std::size_t s = m_spots.size(); s-- > 0;)
        m_inSquares[--m_first[squareOf(m_spots[s])]] = s;
    m_taken.assign(m_spots.size(), 0);
}

std::size_t MarkerTracker::nearest(const Eigen::Vector2d& place_px, double reach_px) const {
    const auto square = [&](double at_px, int count) {
        return static_cast<int>(std::clamp(std::floor(at_px / m_pitch_px), -1.0, static_cast<double>(count)));
    };
    std::size_t best = kNone;
    double least = reach_px * reach_px;
    const int left = std::max(0, square(place_px.x() - reach_px, m_squaresAcross));
    const int right = std::min(m_squaresAcross - 1, square(place_px.x() + reach_px, m_squaresAcross));
    const int top = std::max(0, square(place_px.y() - reach_px, m_squaresDown));
    const int bottom = std::min(m_squaresDown - 1, square(place_px.y() + reach_px, m_squaresDown));
    for (int down = top; down <= bottom; ++down) {
        for (int across = left; across <= right; ++across) {
            const auto k = static_cast<std::size_t>(down * m_squaresAcross + across);
            for (std::size_t n = m_first[k]; n < m_first[k + 1]; ++n) {
                const std::size_t spot = m_inSquares[n];
                const double distance2 = (m_spots[spot].place_px - place_px).squaredNorm();
                if (m_taken[spot] == 0 && distance2 <= least) {
                    least = distance2;
                    best = spot;
                }
            }
        }
    }
    return best;
}

Eigen::Vector2d MarkerTracker::guessed_px(std::size_t marker, Guess guess) const {
    switch (guess) {
    case Guess::last:
        break;
    case Guess::ahead:
        return m_states[marker].before_px + m_states[marker].velocity_px;
    case Guess::rest:
        return m_markers[marker].rest_px;
    }
    return m_states[marker].before_px;
}

double MarkerTracker::disagreement(Guess guess, const std::vector<std::size_t>& spotOf) const {
    double sum = 0.0;
    std::array<double, kMost> u{}, v{};
    for (std::size_t i = 0; i < spotOf.size(); ++i) {
        if (spotOf[i] == kNone) {
            sum += m_states[i].wasFound || m_afterGap ? kMisled : 0.0;
            continue;
        }
        const auto moved = [&](std::size_t k) -> Eigen::Vector2d {
            return m_spots[spotOf[k]].place_px - guessed_px(k, guess);
        };
        std::size_t count = 0;
        for (const std::size_t k : m_neighbours[i]) {
            if (spotOf[k] == kNone || count == kMost)
                continue;
            const Eigen::Vector2d m = moved(k);
            u[count] = m.x();
            v[count++] = m.y();
        }
        if (count == 0)
            continue;
        const Eigen::Vector2d apart =
            moved(i) - Eigen::Vector2d(medianOfFew(u, count), medianOfFew(v, count));
        sum += std::min(kMisled, apart.norm() / m_states[i].pitch_px);
    }
    return sum;
}

double MarkerTracker::assign(Guess guess, std::vector<std::size_t>& spotOf) {
    std::ranges::fill(m_taken, std::uint8_t{0});
    spotOf.assign(m_markers.size(), kNone);
    m_pairs.clear();
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        // One that was lost is led by its neighbours.
        if (!m_states[i].wasFound && !m_afterGap)
            continue;
        const Eigen::Vector2d expected_px = guessed_px(i, guess);
        const std::size_t spot = nearest(expected_px, kGate * m_states[i].pitch_px);
        if (spot != kNone)
            m_pairs.push_back({(m_spots[spot].place_px - expected_px).squaredNorm(), i, spot});
    }
    std::ranges::sort(m_pairs, {}, &Pair::distance2_px);
    for (const Pair& pair : m_pairs) {
        if (m_taken[pair.spot] != 0)
            continue;
        m_taken[pair.spot] = 1;
        spotOf[pair.marker] = pair.spot;
    }
    return disagreement(guess, spotOf);
}

void MarkerTracker::take(std::size_t marker, std::size_t spot) {
    m_spotOf[marker] = spot;
    m_taken[spot] = 1;
    m_markers[marker].found = true;
    m_markers[marker].now_px = m_spots[spot].place_px;
}

void MarkerTracker::release(std::size_t marker) {
    if (m_spotOf[marker] != kNone)
        m_taken[m_spotOf[marker]] = 0;
    m_spotOf[marker] = kNone;
    m_markers[marker].found = false;
}

bool MarkerTracker::neighboursMoved(std::size_t marker, Eigen::Vector2d& moved_px) const {
    std::array<double, kMost> u{}, v{};
    std::size_t count = 0;
    for (const std::size_t k : m_neighbours[marker]) {
        if (!m_markers[k].found || !m_states[k].wasFound || count == kMost)
            continue;
        const Eigen::Vector2d moved = m_markers[k].now_px - m_states[k].before_px;
        u[count] = moved.x();
        v[count++] = moved.y();
    }
    if (count < 2)
        return false;
    moved_px = {medianOfFew(u, count), medianOfFew(v, count)};
    return true;
}

double MarkerTracker::strays(std::size_t marker) const {
    const TrackedMarker& own = m_markers[marker];
    double worst = 0.0;
    Eigen::Vector2d around_px;
    if (m_states[marker].wasFound && neighboursMoved(marker, around_px))
        worst = (own.now_px - m_states[marker].before_px - around_px).norm() /
                (kAgree * m_states[marker].pitch_px);
    // The picture of a gel is neither folded nor torn: most distances to neighbours stay of their size.
    std::size_t bad = 0;
    std::size_t all = 0;
    for (const std::size_t k : m_neighbours[marker]) {
        if (!m_markers[k].found)
            continue;
        const double rest_px = (m_markers[k].rest_px - own.rest_px).norm();
        const double now_px = (m_markers[k].now_px - own.now_px).norm();
        ++all;
        bad += now_px < kShortest * rest_px || now_px > kLongest * rest_px ? 1 : 0;
    }
    if (all > 0)
        worst = std::max(worst, 2.0 * static_cast<double>(bad) / static_cast<double>(all));
    return worst > 1.0 ? worst : 0.0;
}

bool MarkerTracker::led(std::size_t marker, Eigen::Vector2d& place_px) const {
    // Neighbours, then theirs: near a border one ring lies on one side.
    std::array<std::size_t, kMost> used{};
    std::size_t count = 0;
    const auto add = [&](std::size_t k) {
        if (k == marker || !m_markers[k].found || count == kMost)
            return;
        if (std::find(used.begin(), used.begin() + static_cast<std::ptrdiff_t>(count), k) ==
            used.begin() + static_cast<std::ptrdiff_t>(count))
            used[count++] = k;
    };
    for (const std::size_t k : m_neighbours[marker])
        add(k);
    if (count == 0)
        return false;
    if (count < 6) {
        for (const std::size_t k : m_neighbours[marker]) {
            for (const std::size_t further : m_neighbours[k])
                add(further);
        }
    }
    const Eigen::Vector2d own = m_markers[marker].rest_px;
    Eigen::Vector2d meanRest = Eigen::Vector2d::Zero();
    Eigen::Vector2d meanNow = meanRest;
    double sum = 0.0;
    std::array<double, kMost> weight{};
    for (std::size_t n = 0; n < count; ++n) {
        const Eigen::Vector2d off = m_markers[used[n]].rest_px - own;
        weight[n] = 1.0 / (off.squaredNorm() + 0.1 * m_pitch_px * m_pitch_px);
        sum += weight[n];
        meanRest += weight[n] * m_markers[used[n]].rest_px;
        meanNow += weight[n] * m_markers[used[n]].now_px;
    }
    meanRest /= sum;
    meanNow /= sum;
    Eigen::Matrix2d restRest = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d nowRest = restRest;
    for (std::size_t n = 0; n < count; ++n) {
        const Eigen::Vector2d rest = m_markers[used[n]].rest_px - meanRest;
        const Eigen::Vector2d now = m_markers[used[n]].now_px - meanNow;
        restRest += weight[n] * rest * rest.transpose();
        nowRest += weight[n] * now * rest.transpose();
    }
    Eigen::Matrix2d map = Eigen::Matrix2d::Identity();
    const double trace = restRest.trace();
    if (count >= 4 && restRest.determinant() > 0.02 * trace * trace) {
        map = nowRest * restRest.inverse();
    } else if (count >= 2 && trace > 0.0) {
        // A turn with a change of size, which two places tell.
        const double cosine = (nowRest(0, 0) + nowRest(1, 1)) / trace;
        const double sine = (nowRest(1, 0) - nowRest(0, 1)) / trace;
        map << cosine, -sine, sine, cosine;
    }
    place_px = meanNow + map * (own - meanRest);
    return place_px.allFinite();
}

void MarkerTracker::dropStrays() {
    // All are judged by the same neighbours, then the worst go: a stray makes its neighbours look bad.
    bool any = true;
    while (any) {
        any = false;
        m_strays.assign(m_markers.size(), 0.0);
        for (std::size_t i = 0; i < m_markers.size(); ++i) {
            if (m_markers[i].found)
                m_strays[i] = strays(i);
        }
        for (std::size_t i = 0; i < m_markers.size(); ++i) {
            if (m_strays[i] > 0.0 && std::ranges::all_of(m_neighbours[i], [&](std::size_t k) {
                    return m_strays[k] <= m_strays[i];
                })) {
                release(i);
                any = true;
            }
        }
    }
}

void MarkerTracker::searchLost() {
    bool any = true;
    while (any) {
        any = false;
        for (std::size_t i = 0; i < m_markers.size(); ++i) {
            if (m_markers[i].found)
                continue;
            const double reach_px = kSearch * m_states[i].pitch_px;
            Eigen::Vector2d place_px, moved_px;
            std::size_t spot = kNone;
            if (led(i, place_px))
                spot = nearest(place_px, reach_px);
            if (spot == kNone && m_states[i].wasFound && neighboursMoved(i, moved_px))
                spot = nearest(m_states[i].before_px + moved_px, reach_px);
            if (spot == kNone)
                continue;
            take(i, spot);
            if (strays(i) > 0.0)
                release(i);
            else
                any = true;
        }
    }
}

void MarkerTracker::refine(const cv::Mat1b& picture) {
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        TrackedMarker& marker = m_markers[i];
        if (!marker.found)
            continue;
        const auto centre =
            m_detector.centre(picture, marker.now_px, std::max(kFaintest, kLeastShare * m_states[i].contrast),
                              kMostShare * m_states[i].contrast);
        const double diameter_px = centre ? centre->diameter_px / m_states[i].diameter_px : 0.0;
        if (!centre || diameter_px * diameter_px < kLeastArea || diameter_px * diameter_px > kMostArea) {
            release(i);
            continue;
        }
        marker.now_px = centre->place_px;
    }
    // Two spots may lead to one marker.
    const double same_px = 0.5 * m_detector.diameter_px();
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        for (const std::size_t k : m_neighbours[i]) {
            if (k < i || !m_markers[i].found || !m_markers[k].found ||
                (m_markers[k].now_px - m_markers[i].now_px).norm() > same_px)
                continue;
            Eigen::Vector2d forOne_px, forOther_px;
            const double one = led(i, forOne_px) ? (forOne_px - m_markers[i].now_px).norm() : 0.0;
            const double other = led(k, forOther_px) ? (forOther_px - m_markers[k].now_px).norm() : 0.0;
            release(one > other ? i : k);
        }
    }
}

std::size_t MarkerTracker::track(const cv::Mat1b& picture) {
    std::size_t lostBefore = 0;
    double fastest_px = 0.0;
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        State& state = m_states[i];
        state.before_px = m_markers[i].now_px;
        state.wasFound = m_markers[i].found;
        lostBefore += state.wasFound ? 0 : 1;
        fastest_px = std::max(fastest_px, state.velocity_px.norm());
    }
    m_afterGap = 2 * lostBefore > m_markers.size();
    sortSpots(picture);
    double least = assign(Guess::last, m_spotOf);
    const auto alsoTry = [&](Guess guess) {
        const double cost = assign(guess, m_trial);
        if (cost < least) {
            least = cost;
            m_spotOf.swap(m_trial);
        }
    };
    if (fastest_px > 0.1 * m_pitch_px)
        alsoTry(Guess::ahead);
    if (m_afterGap)
        alsoTry(Guess::rest);
    std::ranges::fill(m_taken, std::uint8_t{0});
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        m_markers[i].found = false;
        if (m_spotOf[i] != kNone)
            take(i, m_spotOf[i]);
    }
    dropStrays();
    searchLost();
    refine(picture);
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        TrackedMarker& marker = m_markers[i];
        State& state = m_states[i];
        if (!marker.found) {
            Eigen::Vector2d place_px;
            marker.now_px = led(i, place_px) ? place_px : state.before_px;
            state.velocity_px.setZero();
            continue;
        }
        ++count;
        if (state.wasFound)
            state.velocity_px = marker.now_px - state.before_px;
        else
            state.velocity_px.setZero();
    }
    return count;
}

} // namespace teleta::vision
