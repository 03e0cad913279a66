// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dot_detection.h"
#include "backend/vision/finders/dot_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::vision {
namespace {

constexpr int kSide_px = 240;
constexpr double kPitch_px = 24.0;
constexpr double kDiameter_px = 9.0;

/// A grid of soft-edged dark discs; shift moves all of them.
struct Grid {
    std::vector<Eigen::Vector2d> places;

    Grid() {
        for (double v = 30.0; v < kSide_px - 20; v += kPitch_px) {
            for (double u = 30.0; u < kSide_px - 20; u += kPitch_px)
                places.emplace_back(u + 0.3, v - 0.2);
        }
    }
    [[nodiscard]] cv::Mat1b draw(const Eigen::Vector2d& shift_px, double brightness = 1.0) const {
        cv::Mat1b image(kSide_px, kSide_px);
        for (int v = 0; v < kSide_px; ++v) {
            for (int u = 0; u < kSide_px; ++u) {
                double cover = 0.0;
                for (const Eigen::Vector2d& place : places)
                    cover = std::max(cover, std::clamp(0.5 * kDiameter_px + 0.5 -
                                                           (Eigen::Vector2d(u, v) - place - shift_px).norm(),
                                                       0.0, 1.0));
                image(v, u) = cv::saturate_cast<std::uint8_t>(brightness * (180.0 - 130.0 * cover));
            }
        }
        return image;
    }
    [[nodiscard]] DotTracker tracker(int cores = 1) const {
        std::vector<TrackedDot> dots;
        const double window_px = 0.62 * kPitch_px;
        for (std::size_t i = 0; i < places.size(); ++i) {
            TrackedDot dot;
            dot.rest_px = places[i] + Eigen::Vector2d(0.6, -0.5); // about
            dot.metric = Eigen::Matrix2d::Identity() / (window_px * window_px);
            dot.tolerance = Eigen::Matrix2d::Identity() / 8.0;
            for (std::size_t k = 0; k < places.size(); ++k) {
                if (i != k && (places[i] - places[k]).norm() < 1.5 * kPitch_px)
                    dot.neighbours.push_back(k);
            }
            dots.push_back(dot);
        }
        return DotTracker(std::move(dots), cv::Mat1b(kSide_px, kSide_px, std::uint8_t{255}),
                          kDiameter_px / window_px, cores);
    }
};

void expectAt(const DotTracker& tracker, const Grid& grid, const Eigen::Vector2d& shift_px,
              double tolerance_px) {
    for (std::size_t i = 0; i < grid.places.size(); ++i) {
        EXPECT_TRUE(tracker.dots()[i].found);
        EXPECT_LT((tracker.dots()[i].now_px - grid.places[i] - shift_px).norm(), tolerance_px) << i;
    }
}

} // namespace

TEST(DetectDots, findsEachDotOnceWithinHalfAPixel) {
    const Grid grid;
    cv::Mat1f image;
    grid.draw({0.0, 0.0}).convertTo(image, CV_32F);
    const auto dots = detectDots(image, {}, kDiameter_px);
    ASSERT_EQ(dots.size(), grid.places.size());
    for (const Eigen::Vector2d& place : grid.places) {
        const cv::Point2f nearest = std::ranges::min(dots, {}, [&](const cv::Point2f& dot) {
            return std::hypot(static_cast<double>(dot.x) - place.x(), static_cast<double>(dot.y) - place.y());
        });
        EXPECT_NEAR(static_cast<double>(nearest.x), place.x(), 0.5);
        EXPECT_NEAR(static_cast<double>(nearest.y), place.y(), 0.5);
    }
}

TEST(DetectDots, findsNothingInImagesWithoutTextureOrThatAreTiny) {
    EXPECT_TRUE(detectDots(cv::Mat1f(100, 100, 128.0F), {}, 9.0).empty());
    EXPECT_TRUE(detectDots(cv::Mat1f(100, 100, 0.0F), {}, 9.0).empty());
    EXPECT_TRUE(detectDots(cv::Mat1f(10, 10, 50.0F), {}, 9.0).empty());
    EXPECT_TRUE(detectDots(cv::Mat1f(2, 1, 50.0F), {}, 9.0).empty());
    EXPECT_TRUE(detectDots(cv::Mat1f(), {}, 9.0).empty());
}

TEST(DotTracker, followsFractionsOfAPixel) {
    const Grid grid;
    DotTracker tracker = grid.tracker();
    ASSERT_EQ(tracker.setReference(grid.draw({0.0, 0.0})), grid.places.size());
    expectAt(tracker, grid, {0.0, 0.0}, 0.05);
    for (const Eigen::Vector2d& shift_px : {Eigen::Vector2d(0.25, 0.1), Eigen::Vector2d(1.5, -0.7)}) {
        EXPECT_EQ(tracker.track(grid.draw(shift_px)), grid.places.size());
        expectAt(tracker, grid, shift_px, 0.05);
    }
}

TEST(DotTracker, followsFurtherThanTheDistanceOfTheDotsWhenEachStepIsSmall) {
    const Grid grid;
    DotTracker tracker = grid.tracker();
    ASSERT_EQ(tracker.setReference(grid.draw({0.0, 0.0})), grid.places.size());
    // 20 px to the left would be outside the image.
    for (double shift_px = 0.0; shift_px <= 18.0; shift_px += 3.0)
        (void)tracker.track(grid.draw({shift_px, 0.0}));
    expectAt(tracker, grid, {18.0, 0.0}, 0.05);
}

TEST(DotTracker, isNotMisledByAFlickeringLamp) {
    const Grid grid;
    DotTracker tracker = grid.tracker();
    ASSERT_EQ(tracker.setReference(grid.draw({0.0, 0.0})), grid.places.size());
    for (const double brightness : {0.6, 1.3, 0.8, 1.0}) {
        EXPECT_EQ(tracker.track(grid.draw({0.5, 0.5}, brightness)), grid.places.size()) << brightness;
        expectAt(tracker, grid, {0.5, 0.5}, 0.1);
    }
}

TEST(DotTracker, findsTheSameWithTwoCoresToTheLastBit) {
    const Grid grid;
    DotTracker one = grid.tracker();
    DotTracker two = grid.tracker(2);
    (void)one.setReference(grid.draw({0.0, 0.0}));
    (void)two.setReference(grid.draw({0.0, 0.0}));
    // Slowly, with a jump, and with a blank frame in between.
    for (const double shift_px : {0.3, 1.7, 9.0, 9.4, -1.0, 0.2}) {
        const cv::Mat1b frame = shift_px < 0.0 ? cv::Mat1b(kSide_px, kSide_px, std::uint8_t{180})
                                               : grid.draw({shift_px, 0.5 * shift_px});
        EXPECT_EQ(one.track(frame), two.track(frame)) << shift_px;
        for (std::size_t i = 0; i < one.dots().size(); ++i) {
            EXPECT_EQ(one.dots()[i].found, two.dots()[i].found) << i;
            EXPECT_EQ(one.dots()[i].now_px, two.dots()[i].now_px) << i;
        }
    }
}

TEST(DotTracker, losesAllDotsOfABlankFrameAndFindsThemAgainAfterwards) {
    const Grid grid;
    DotTracker tracker = grid.tracker();
    ASSERT_EQ(tracker.setReference(grid.draw({0.0, 0.0})), grid.places.size());
    EXPECT_EQ(tracker.track(cv::Mat1b(kSide_px, kSide_px, std::uint8_t{180})), 0U);
    EXPECT_EQ(tracker.track(grid.draw({0.4, 0.0})), grid.places.size());
    expectAt(tracker, grid, {0.4, 0.0}, 0.05);
}

TEST(DotTracker, saysThatADotIsLostWhenItIsCovered) {
    const Grid grid;
    DotTracker tracker = grid.tracker();
    ASSERT_EQ(tracker.setReference(grid.draw({0.0, 0.0})), grid.places.size());
    cv::Mat1b frame = grid.draw({0.0, 0.0});
    const Eigen::Vector2d place = grid.places[20];
    frame(cv::Rect(static_cast<int>(place.x()) - 8, static_cast<int>(place.y()) - 8, 17, 17)) = 180;
    EXPECT_EQ(tracker.track(frame), grid.places.size() - 1);
    EXPECT_FALSE(tracker.dots()[20].found);
}

} // namespace teleta::vision
