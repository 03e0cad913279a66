// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dark_moments.h"

#include <Eigen/LU>
#include <opencv2/core/hal/intrin.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace teleta::vision {

namespace {

constexpr int kLanes = 4;
constexpr int kBlock = 2 * kLanes; ///< pixels that are added at once
constexpr std::uint8_t kWhite = 255;
constexpr int kCacheLine_px = 64;

/// The window in one row of the picture: w = (level - du (a du + slope))^2.
struct WindowRow {
    float a;
    float slope;
    float level;
    float first_px; ///< du of the first pixel
    float step_px;  ///< from pixel to pixel
};

class LaneSums {
public:
    explicit LaneSums(float ground)
        : m_ground(cv::v_setall_f32(ground)) {}

    /// Adds whole blocks of consecutive pixels. hidden: of the same pixels, or null.
    template <bool kHidden>
    void addRow(const std::uint8_t* pixels, const std::uint8_t* hidden, int count, const WindowRow& row,
                float dv) {
        const cv::v_float32x4 zero = cv::v_setzero_f32();
        const cv::v_float32x4 a = cv::v_setall_f32(row.a);
        const cv::v_float32x4 slope = cv::v_setall_f32(row.slope);
        const cv::v_float32x4 level = cv::v_setall_f32(row.level);
        const cv::v_float32x4 lanes = cv::v_setall_f32(kLanes * row.step_px);
        cv::v_float32x4 du = cv::v_setall_f32(row.first_px) +
                             cv::v_setall_f32(row.step_px) * cv::v_float32x4(0.0F, 1.0F, 2.0F, 3.0F);
        cv::v_float32x4 sum = zero;
        const auto add = [&](const cv::v_uint32x4& levels) {
            const cv::v_float32x4 inside = level - du * (a * du + slope);
            const cv::v_float32x4 dark =
                cv::v_max(m_ground - cv::v_cvt_f32(cv::v_reinterpret_as_s32(levels)), zero) & (inside > zero);
            const cv::v_float32x4 weight = inside * inside * dark;
            sum = sum + weight;
            m_sumU = m_sumU + weight * du;
            m_darkest = cv::v_max(m_darkest, dark);
            du = du + lanes;
        };
        for (int i = 0; i < count; i += kBlock) {
            cv::v_uint16x8 levels = cv::v_load_expand(pixels + i);
            if constexpr (kHidden)
                levels = levels | cv::v_load_expand(hidden + i);
            cv::v_uint32x4 low, high;
            cv::v_expand(levels, low, high);
            add(low);
            add(high);
        }
        m_sum = m_sum + sum;
        m_sumV = m_sumV + sum * cv::v_setall_f32(dv);
    }

    [[nodiscard]] DarkMoments moments() const {
        return {.sum = cv::v_reduce_sum(m_sum),
                .sum_px = {cv::v_reduce_sum(m_sumU), cv::v_reduce_sum(m_sumV)},
                .darkest = cv::v_reduce_max(m_darkest)};
    }

private:
    cv::v_float32x4 m_ground;
    cv::v_float32x4 m_sum = cv::v_setzero_f32();
    cv::v_float32x4 m_sumU = cv::v_setzero_f32();
    cv::v_float32x4 m_sumV = cv::v_setzero_f32();
    cv::v_float32x4 m_darkest = cv::v_setzero_f32();
};

/// The smallest multiple of a stride that is not less than a number of at least 0.
int onLattice(int number, int stride) {
    return stride == 1 ? number : (number + stride - 1) / stride * stride;
}

/// The pixel next to a place; far outside of any picture when there is none.
int nearestPixel(double place_px) {
    constexpr double kFarthest_px = 1e6;
    return static_cast<int>(std::floor(std::clamp(place_px, -kFarthest_px, kFarthest_px) + 0.5));
}

} // namespace

DotWindow::DotWindow(const Eigen::Matrix2d& metric, int stride)
    : m_a(static_cast<float>(metric(0, 0)))
    , m_b(static_cast<float>(2.0 * metric(0, 1)))
    , m_c(static_cast<float>(metric(1, 1)))
    , m_stride(stride) {
    // The centre is at most half a pixel from the middle of its pixel.
    constexpr double kOff_px = 0.51;
    const Eigen::Matrix2d cover = metric.inverse();
    const double width_px = std::sqrt(cover(0, 0));
    const double widestAt_px = cover(0, 1) / width_px;
    const int halfHeight = static_cast<int>(std::floor(std::sqrt(cover(1, 1)) + kOff_px));
    for (int row = -halfHeight; row <= halfHeight; ++row) {
        double left_px = std::numeric_limits<double>::infinity();
        double right_px = -left_px;
        const auto include = [&](double dv) {
            const double half = metric(0, 1) * dv;
            const double root =
                std::sqrt(std::max(0.0, half * half - metric(0, 0) * (metric(1, 1) * dv * dv - 1.0)));
            left_px = std::min(left_px, (-half - root) / metric(0, 0));
            right_px = std::max(right_px, (-half + root) / metric(0, 0));
        };
        const double highest = std::sqrt(cover(1, 1));
        for (const double off : {-kOff_px, kOff_px}) {
            include(std::clamp(row + off, -highest, highest));
            for (const double widest : {-widestAt_px, widestAt_px})
                include(
                    std::clamp(widest, std::max(row - kOff_px, -highest), std::min(row + kOff_px, highest)));
        }
        m_rows.push_back({static_cast<int>(std::ceil(left_px - kOff_px)),
                          static_cast<int>(std::floor(right_px + kOff_px)) + 1});
        m_halfWidth_px = std::max({m_halfWidth_px, -m_rows.back().first_px, m_rows.back().past_px - 1});
    }
}

DarkMoments darkMoments(const cv::Mat1b& frame, const cv::Mat1b& hidden, const DotWindow& window,
                        const Eigen::Vector2d& centre_px, float ground) {
    const int middleU = nearestPixel(centre_px.x());
    const int middleV = nearestPixel(centre_px.y());
    const auto centreU = static_cast<float>(centre_px.x());
    const auto centreV = static_cast<float>(centre_px.y());
    const int stride = window.stride();
    constexpr int kMost = 16 * kBlock;
    std::array<std::uint8_t, kMost> gathered{};
    LaneSums sums(std::min(ground, static_cast<float>(kWhite)));
    const int lastRow = std::min(frame.rows - 1, middleV + window.halfHeight_px());
    for (int v = onLattice(std::max(0, middleV - window.halfHeight_px()), stride); v <= lastRow;
         v += stride) {
        const DotWindow::Reach& reach = window.reach(v - middleV);
        const float dv = static_cast<float>(v) - centreV;
        const int u0 = onLattice(std::max(0, middleU + reach.first_px), stride);
        const int u1 = std::min(frame.cols, middleU + reach.past_px);
        WindowRow row{.a = window.a(),
                      .slope = window.b() * dv,
                      .level = 1.0F - window.c() * dv * dv,
                      .first_px = static_cast<float>(u0) - centreU,
                      .step_px = static_cast<float>(stride)};
        const std::uint8_t* pixels = frame[v];
        const std::uint8_t* hiddenHere = hidden.empty() ? nullptr : hidden[v];
        // A block may reach beyond the window, but not beyond the row.
        if (stride == 1 && u1 + kBlock <= frame.cols) {
            if (hiddenHere == nullptr)
                sums.addRow<false>(pixels + u0, nullptr, u1 - u0, row, dv);
            else
                sums.addRow<true>(pixels + u0, hiddenHere + u0, u1 - u0, row, dv);
            continue;
        }
        for (int u = u0; u < u1;) {
            row.first_px = static_cast<float>(u) - centreU;
            std::size_t count = 0;
            if (hiddenHere == nullptr) {
                for (; u < u1 && count < kMost; u += stride, ++count)
                    gathered[count] = pixels[u];
            } else {
                for (; u < u1 && count < kMost; u += stride, ++count)
                    gathered[count] = pixels[u] | hiddenHere[u];
            }
            for (std::size_t i = count; i % kBlock != 0; ++i)
                gathered[i] = kWhite;
            sums.addRow<false>(gathered.data(), nullptr, static_cast<int>(count), row, dv);
        }
    }
    return sums.moments();
}

void prefetch(const cv::Mat1b& frame, const DotWindow& window, const Eigen::Vector2d& centre_px) {
    const int middleU = nearestPixel(centre_px.x());
    const int middleV = nearestPixel(centre_px.y());
    const int u0 = std::max(0, middleU - window.halfWidth_px());
    const int u1 = std::min(frame.cols - 1, middleU + window.halfWidth_px());
    const int lastRow = std::min(frame.rows - 1, middleV + window.halfHeight_px());
    if (u0 > u1)
        return;
    for (int v = onLattice(std::max(0, middleV - window.halfHeight_px()), window.stride()); v <= lastRow;
         v += window.stride()) {
        const std::uint8_t* row = frame[v];
        for (int u = u0; u < u1; u += kCacheLine_px)
            __builtin_prefetch(row + u);
        __builtin_prefetch(row + u1);
    }
}

} // namespace teleta::vision
