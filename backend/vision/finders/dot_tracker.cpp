// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dot_tracker.h"

#include "backend/core/quantile.h"

#include <Eigen/LU>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::vision {

namespace {

constexpr int kSteps = 3;
constexpr float kLeastGain = 0.3F;
constexpr float kMostGain = 1.6F;
constexpr double kConverged_px = 0.02;
// Share of its darkness in the reference that a dot must have: on the far side of a press it is
// foreshortened.
constexpr double kLeastMass = 0.15;
constexpr double kMostMass = 3.0;
constexpr float kLeastContrast = 0.35F; ///< of that in the reference; evenly dark ground is no dot
constexpr double kLeastVelocity = 0.1;  ///< as a share of the tolerance; what is slower is noise
constexpr float kGroundShare = 0.78F;   ///< what is brighter is ground and noise
constexpr std::size_t kLeastNeighbours = 2;
constexpr std::size_t kMostNeighbours = 12;
constexpr int kRounds = 4;
constexpr int kClearMargin_px = 2;     ///< for rounding
constexpr int kPartsOfCore = 4;        ///< some parts of the dots take longer
constexpr std::size_t kReadAhead = 2;  ///< dots
constexpr double kSamplesAcross = 6.0; ///< at least so many of a dot, where there are so many pixels

/// How far a rectangle of pixels about a middle may grow on each side without containing a hidden pixel or
/// leaving the picture; -1: not even the rectangle does. sums: integral of the hidden pixels.
int clearAround_px(const cv::Mat1i& sums, const cv::Point& middle, int halfWidth_px, int halfHeight_px) {
    constexpr int kMost_px = 64;
    for (int grown_px = 0; grown_px <= kMost_px; ++grown_px) {
        const int u0 = middle.x - halfWidth_px - grown_px;
        const int v0 = middle.y - halfHeight_px - grown_px;
        const int u1 = middle.x + halfWidth_px + grown_px + 1;
        const int v1 = middle.y + halfHeight_px + grown_px + 1;
        if (u0 < 0 || v0 < 0 || u1 >= sums.cols || v1 >= sums.rows ||
            sums(v1, u1) - sums(v0, u1) - sums(v1, u0) + sums(v0, u0) != 0)
            return grown_px - 1;
    }
    return kMost_px;
}

double median(std::array<double, kMostNeighbours>& values, std::size_t count) {
    return core::upperMedianOf(std::span(values).first(count));
}

} // namespace

DotTracker::DotTracker(std::vector<TrackedDot> dots, const cv::Mat1b& mask, double dotDiameterShare,
                       int cores)
    : m_dots(std::move(dots))
    , m_hidden(mask == 0)
    , m_windows(m_dots.size())
    // The window biases the centroid towards its middle, by the variance of the window over that of window
    // and dot together: 1/10 for (1 - q)^2 in a unit circle, and 1/16 of its squared diameter for a disc.
    , m_centroidGain(1.0 + dotDiameterShare * dotDiameterShare / 4.0 * 10.0 / 4.0)
    , m_cores(std::max(1, cores)) {
    cv::Mat1i hiddenSums;
    cv::integral(m_hidden & 1, hiddenSums, CV_32S);
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        TrackedDot& dot = m_dots[i];
        Window& window = m_windows[i];
        if (dot.neighbours.size() > kMostNeighbours)
            dot.neighbours.resize(kMostNeighbours);
        const Eigen::Matrix2d cover = dot.metric.inverse();
        window.halfWidth = static_cast<int>(std::ceil(std::sqrt(cover(0, 0))));
        window.halfHeight = static_cast<int>(std::ceil(std::sqrt(cover(1, 1))));
        // Minor half axis of the window.
        const double mean = 0.5 * (cover(0, 0) + cover(1, 1));
        const double spread = std::hypot(0.5 * (cover(0, 0) - cover(1, 1)), cover(0, 1));
        const double narrow_px = std::sqrt(std::max(mean - spread, 0.0));
        const int stride = std::clamp(static_cast<int>(narrow_px * dotDiameterShare / kSamplesAcross), 1, 4);
        window.reach_px = std::max(1.5, std::sqrt(mean + spread));
        window.shape = DotWindow(dot.metric, stride);
        window.middle_px = dot.rest_px;
        window.clear_px =
            clearAround_px(hiddenSums, cv::Point(cvRound(dot.rest_px.x()), cvRound(dot.rest_px.y())),
                           window.halfWidth + kClearMargin_px, window.halfHeight + kClearMargin_px);
        dot.now_px = dot.rest_px;
    }
}

bool DotTracker::isClear(std::size_t dot, const Eigen::Vector2d& centre_px) const {
    const Window& window = m_windows[dot];
    return (centre_px - window.middle_px).cwiseAbs().maxCoeff() <= window.clear_px;
}

DotTracker::Found DotTracker::centroid(const cv::Mat1b& frame, std::size_t dot,
                                       const Eigen::Vector2d& start_px, float gain, int steps) const {
    const Window& window = m_windows[dot];
    const float ground = window.ground * gain * kGroundShare;
    const float scale = ground > 0.0F ? 1.0F / ground : 0.0F;
    static const cv::Mat1b kNothingHidden;
    Found found{.place_px = start_px};
    for (int step = 0; step < steps; ++step) {
        const cv::Mat1b& hidden = isClear(dot, found.place_px) ? kNothingHidden : m_hidden;
        const DarkMoments dark = darkMoments(frame, hidden, window.shape, found.place_px, ground);
        found.mass = static_cast<double>(dark.sum * scale) * window.shape.stride() * window.shape.stride();
        found.darkest = dark.darkest * scale;
        if (!(dark.sum > 0.0F))
            return found;
        const Eigen::Vector2d shift_px = m_centroidGain * (dark.sum_px / dark.sum).cast<double>();
        found.place_px += shift_px;
        if (shift_px.squaredNorm() < kConverged_px * kConverged_px)
            break;
    }
    return found;
}

float DotTracker::brightness(const cv::Mat1b& frame) const {
    // Mean over some pixels around each dot: follows lighting and exposure, but not single dots.
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_dots.size(); i += 3) {
        for (const double side : {-0.7, 0.0, 0.7}) {
            const int u = static_cast<int>(m_dots[i].rest_px.x() + side * m_windows[i].halfWidth);
            const int v = static_cast<int>(m_dots[i].rest_px.y() + side * m_windows[i].halfHeight);
            if (u < 0 || v < 0 || u >= frame.cols || v >= frame.rows)
                continue;
            sum += static_cast<double>(frame(v, u));
            ++count;
        }
    }
    return count == 0 ? 0.0F : static_cast<float>(sum / static_cast<double>(count));
}

std::size_t DotTracker::setReference(const cv::Mat1b& frame) {
    m_referenceBrightness = std::max(1.0F, brightness(frame));
    std::size_t count = 0;
    std::vector<std::uint8_t> levels;
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        TrackedDot& dot = m_dots[i];
        Window& window = m_windows[i];
        levels.clear();
        for (int v = -window.halfHeight; v <= window.halfHeight; ++v) {
            for (int u = -window.halfWidth; u <= window.halfWidth; ++u) {
                const int x = static_cast<int>(std::lround(dot.rest_px.x())) + u;
                const int y = static_cast<int>(std::lround(dot.rest_px.y())) + v;
                if (x >= 0 && y >= 0 && x < frame.cols && y < frame.rows)
                    levels.push_back(frame(y, x));
            }
        }
        dot.found = false;
        dot.now_px = dot.rest_px;
        if (levels.empty())
            continue;
        window.ground = static_cast<float>(core::orderStatistic(levels, levels.size() * 3 / 4));
        const Found found = centroid(frame, i, dot.rest_px, 1.0F, 3 * kSteps);
        window.mass = found.mass;
        window.darkest = found.darkest;
        dot.found = found.mass > 0.3 && (found.place_px - dot.rest_px).norm() < window.reach_px;
        if (!dot.found)
            continue;
        dot.rest_px = dot.now_px = found.place_px;
        ++count;
    }
    return count;
}

void DotTracker::forget() {
    for (TrackedDot& dot : m_dots) {
        dot.now_px = dot.rest_px;
        dot.velocity_px.setZero();
    }
}

bool DotTracker::take(const cv::Mat1b& frame, std::size_t dot, const Eigen::Vector2d& start_px, float gain) {
    const Window& window = m_windows[dot];
    if (!(window.mass > 0.0))
        return false;
    const Found found = centroid(frame, dot, start_px, gain, kSteps);
    if (found.mass < kLeastMass * window.mass || found.mass > kMostMass * window.mass ||
        found.darkest < kLeastContrast * window.darkest)
        return false;
    m_dots[dot].now_px = found.place_px;
    return true;
}

bool DotTracker::expected(std::size_t dot, Eigen::Vector2d& displacement_px) const {
    std::array<double, kMostNeighbours> u{};
    std::array<double, kMostNeighbours> v{};
    std::size_t count = 0;
    for (const std::size_t neighbour : m_dots[dot].neighbours) {
        if (!m_dots[neighbour].found)
            continue;
        const Eigen::Vector2d moved_px = m_dots[neighbour].now_px - m_dots[neighbour].rest_px;
        u[count] = moved_px.x();
        v[count] = moved_px.y();
        ++count;
    }
    if (count < kLeastNeighbours)
        return false;
    displacement_px = {median(u, count), median(v, count)};
    return true;
}

bool DotTracker::strays(std::size_t dot) const {
    // Near a skin at rest no dot is further from its neighbours than these have moved.
    double most_px2 = displacement_px(dot).squaredNorm();
    for (const std::size_t neighbour : m_dots[dot].neighbours) {
        if (m_dots[neighbour].found)
            most_px2 = std::max(most_px2, displacement_px(neighbour).squaredNorm());
    }
    // |displacement| <= most, |median of each coordinate| <= sqrt(2) most
    constexpr double kApart2 = 6.0;
    if (kApart2 * m_dots[dot].tolerance.squaredNorm() * most_px2 <= 1.0)
        return false;
    Eigen::Vector2d around_px;
    if (!expected(dot, around_px))
        return false;
    const Eigen::Vector2d apart_px = m_dots[dot].now_px - m_dots[dot].rest_px - around_px;
    return (m_dots[dot].tolerance * apart_px).squaredNorm() > 1.0;
}

void DotTracker::dropDoubles() {
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        for (const std::size_t k : m_dots[i].neighbours) {
            if (k < i || !m_dots[i].found || !m_dots[k].found)
                continue;
            const Eigen::Vector2d apart_px = m_dots[k].now_px - m_dots[i].now_px;
            if (apart_px.dot(m_dots[i].metric * apart_px) > 0.02)
                continue;
            Eigen::Vector2d around_px;
            const auto off_px = [&](std::size_t dot) {
                return expected(dot, around_px) ? (displacement_px(dot) - around_px).norm() : 0.0;
            };
            m_dots[off_px(i) > off_px(k) ? i : k].found = false;
        }
    }
}

void DotTracker::follow(const cv::Mat1b& frame, float gain, const cv::Range& dots) {
    const auto end = static_cast<std::size_t>(dots.end);
    for (auto i = static_cast<std::size_t>(dots.start); i < end; ++i) {
        TrackedDot& dot = m_dots[i];
        m_before_px[i] = dot.now_px;
        if (i + kReadAhead < end) {
            const TrackedDot& ahead = m_dots[i + kReadAhead];
            prefetch(frame, m_windows[i + kReadAhead].shape, ahead.now_px + ahead.velocity_px);
        }
        dot.found = take(frame, i, dot.now_px + dot.velocity_px, gain);
        if (!dot.found && dot.velocity_px.squaredNorm() > 1.0)
            dot.found = take(frame, i, dot.now_px, gain);
    }
}

std::size_t DotTracker::track(const cv::Mat1b& frame) {
    const float gain = brightness(frame) / static_cast<float>(m_referenceBrightness);
    if (!(gain > kLeastGain && gain < kMostGain)) {
        // After such a change in lighting nothing can be recognised.
        for (TrackedDot& dot : m_dots)
            dot.found = false;
        return 0;
    }
    m_before_px.resize(m_dots.size());
    const cv::Range all(0, static_cast<int>(m_dots.size()));
    if (m_cores > 1)
        cv::parallel_for_(
            all, [&](const cv::Range& some) { follow(frame, gain, some); }, kPartsOfCore * m_cores);
    else
        follow(frame, gain, all);
    dropDoubles();
    m_lost.clear();
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        if (m_dots[i].found && strays(i))
            m_dots[i].found = false;
        if (!m_dots[i].found && m_windows[i].mass > 0.0)
            m_lost.push_back(i);
    }
    // From the border of the lost dots inwards, one ring of neighbours per round.
    for (int round = 0; round < kRounds && !m_lost.empty(); ++round) {
        std::erase_if(m_lost, [&](std::size_t i) {
            Eigen::Vector2d around_px;
            if (!expected(i, around_px))
                return false;
            const Eigen::Vector2d start_px = m_dots[i].rest_px + around_px;
            m_dots[i].found = take(frame, i, start_px, gain) && !strays(i);
            if (!m_dots[i].found)
                m_dots[i].now_px = start_px;
            return m_dots[i].found;
        });
    }
    for (const std::size_t i : m_lost) {
        Eigen::Vector2d around_px;
        m_dots[i].now_px = m_dots[i].rest_px + (expected(i, around_px) ? around_px : Eigen::Vector2d::Zero());
    }
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        TrackedDot& dot = m_dots[i];
        dot.velocity_px = dot.now_px - m_before_px[i];
        if (!dot.found || (dot.tolerance * dot.velocity_px).norm() < kLeastVelocity)
            dot.velocity_px.setZero();
    }
    return static_cast<std::size_t>(std::ranges::count_if(m_dots, &TrackedDot::found));
}

} // namespace teleta::vision
