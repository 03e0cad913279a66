// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dot_tracker.h"

#include "backend/core/quantile.h"

#include <Eigen/LU>

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
constexpr double kSamplesAcross = 6.0; ///< at least so many of a dot, where there are so many pixels

double median(std::array<double, kMostNeighbours>& values, std::size_t count) {
    return core::upperMedianOf(std::span(values).first(count));
}

} // namespace

DotTracker::DotTracker(std::vector<TrackedDot> dots, const cv::Mat1b& mask, double dotDiameterShare)
    : m_dots(std::move(dots))
    , m_mask(mask)
    , m_windows(m_dots.size())
    // The window biases the centroid towards its middle, by the variance of the window over that of window
    // and dot together: 1/10 for (1 - q)^2 in a unit circle, and 1/16 of its squared diameter for a disc.
    , m_centroidGain(1.0 + dotDiameterShare * dotDiameterShare / 4.0 * 10.0 / 4.0) {
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
        window.stride = std::clamp(static_cast<int>(narrow_px * dotDiameterShare / kSamplesAcross), 1, 4);
        window.reach_px = std::max(1.5, std::sqrt(mean + spread));
        dot.now_px = dot.rest_px;
    }
}

DotTracker::Found DotTracker::centroid(const cv::Mat1b& frame, std::size_t dot,
                                       const Eigen::Vector2d& start_px, float gain, int steps) const {
    const Window& window = m_windows[dot];
    const auto a = static_cast<float>(m_dots[dot].metric(0, 0));
    const auto b = static_cast<float>(2.0 * m_dots[dot].metric(0, 1));
    const auto c = static_cast<float>(m_dots[dot].metric(1, 1));
    const float ground = window.ground * gain * kGroundShare;
    const float scale = ground > 0.0F ? 1.0F / ground : 0.0F;
    Found found{.place_px = start_px};
    for (int step = 0; step < steps; ++step) {
        // The sampled pixels lie on the same lattice in all frames, so that a dot at rest gives the same
        // samples.
        const int middle = static_cast<int>(std::lround(found.place_px.x()));
        const int v0 = std::max(0, static_cast<int>(std::lround(found.place_px.y())) - window.halfHeight) /
                       window.stride * window.stride;
        const int v1 =
            std::min(frame.rows - 1, static_cast<int>(std::lround(found.place_px.y())) + window.halfHeight);
        const int u0 = std::max(0, middle - window.halfWidth) / window.stride * window.stride;
        const int u1 = std::min(frame.cols - 1, middle + window.halfWidth);
        float sum = 0.0F;
        float darkest = 0.0F;
        float sumU = 0.0F;
        float sumV = 0.0F;
        for (int v = v0; v <= v1; v += window.stride) {
            const std::uint8_t* row = frame[v];
            const std::uint8_t* onPattern = m_mask[v];
            const float dv = static_cast<float>(v) - static_cast<float>(found.place_px.y());
            for (int u = u0; u <= u1; u += window.stride) {
                const float dark = ground - static_cast<float>(row[u]);
                if (dark <= 0.0F || onPattern[u] == 0)
                    continue;
                const float du = static_cast<float>(u) - static_cast<float>(found.place_px.x());
                const float outside = 1.0F - (a * du * du + b * du * dv + c * dv * dv);
                if (outside <= 0.0F)
                    continue;
                const float weight = outside * outside * dark;
                darkest = std::max(darkest, dark);
                sum += weight;
                sumU += weight * du;
                sumV += weight * dv;
            }
        }
        found.mass = static_cast<double>(sum * scale) * window.stride * window.stride;
        found.darkest = darkest * scale;
        if (!(sum > 0.0F))
            return found;
        const Eigen::Vector2d shift_px = m_centroidGain * Eigen::Vector2d(static_cast<double>(sumU / sum),
                                                                          static_cast<double>(sumV / sum));
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

std::size_t DotTracker::track(const cv::Mat1b& frame) {
    const float gain = brightness(frame) / static_cast<float>(m_referenceBrightness);
    if (!(gain > kLeastGain && gain < kMostGain)) {
        // After such a change in lighting nothing can be recognised.
        for (TrackedDot& dot : m_dots)
            dot.found = false;
        return 0;
    }
    m_before_px.resize(m_dots.size());
    for (std::size_t i = 0; i < m_dots.size(); ++i) {
        TrackedDot& dot = m_dots[i];
        m_before_px[i] = dot.now_px;
        dot.found = take(frame, i, dot.now_px + dot.velocity_px, gain);
        if (!dot.found && dot.velocity_px.squaredNorm() > 1.0)
            dot.found = take(frame, i, dot.now_px, gain);
    }
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
