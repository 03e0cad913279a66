// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/vision/gel/marker_gel.h"
#include "tests/backend/vision/gel/simulated_motion.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

namespace teleta::vision {
namespace {

using simulation::SimulatedGel;
using test::FollowedGel;
using test::Places;

constexpr double kDegree = std::numbers::pi / 180.0;

Places turned(const Places& rest, const Eigen::Vector2d& about, double angle_rad, const Eigen::Vector2d& by) {
    Places places;
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
    for (const Eigen::Vector2d& place : rest)
        places.push_back(about + turn * (place - about) + by);
    return places;
}

/// Under one contact; the field's m are pixels here.
Places under(const Places& rest, const simulation::GelContact& contact) {
    Places places;
    for (const Eigen::Vector2d& place : rest)
        places.push_back(place + contact.displacement_m(place));
    return places;
}

} // namespace

TEST(MarkerGel, findsMarkersToATwentiethOfAPixel) {
    SimulatedGel gel;
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    ASSERT_EQ(followed.gel().markers().size(), 80U);
    core::RandomStream random(3);
    double sum = 0.0;
    constexpr int kFrames = 20;
    for (int i = 0; i < kFrames; ++i) {
        const Places places = turned(followed.renderer().rest_px(), {160.0, 120.0}, 0.02 * random.normal(),
                                     {2.0 * random.uniform(), 2.0 * random.uniform()});
        followed.follow(places);
        EXPECT_EQ(followed.gel().found(), 80U);
        sum += std::pow(followed.error_px(places), 2.0);
    }
    const double error_px = std::sqrt(sum / kFrames);
    RecordProperty("error_px", std::to_string(error_px));
    EXPECT_LT(error_px, 0.05);
}

TEST(MarkerGel, findsThemToATenthInUnevenLightBlurredAndMisprinted) {
    SimulatedGel gel{.unevenness = 0.5, .blur_px = 1.2, .printError_px = 1.5, .printScatter = 0.1};
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    ASSERT_EQ(followed.gel().markers().size(), 80U);
    double sum = 0.0;
    constexpr int kFrames = 20;
    for (int i = 0; i < kFrames; ++i) {
        const Places places =
            turned(followed.renderer().rest_px(), {160.0, 120.0}, 0.003 * i, {0.13 * i, -0.07 * i});
        followed.follow(places);
        sum += std::pow(followed.error_px(places), 2.0);
    }
    const double error_px = std::sqrt(sum / kFrames);
    RecordProperty("error_px", std::to_string(error_px));
    EXPECT_LT(error_px, 0.10);
}

TEST(MarkerGel, confusesNoneOf80In500FramesOfFastMotion) {
    SimulatedGel gel{.width_px = 400, .height_px = 320};
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    core::RandomStream random(5);
    Eigen::Vector2d at(0.0, 0.0);
    double angle_rad = 0.0;
    int confused = 0;
    std::size_t lost = 0;
    for (int i = 0; i < 500; ++i) {
        // Any direction, up to 0.4 pitches, but not far out of the picture.
        Eigen::Vector2d step;
        double turn_rad = 0.0;
        do {
            const double direction = 2.0 * std::numbers::pi * random.uniform();
            step = 0.35 * gel.pitch_px * random.uniform() *
                   Eigen::Vector2d(std::cos(direction), std::sin(direction));
            turn_rad = 0.01 * random.normal();
        } while ((at + step).norm() > 30.0 || std::abs(angle_rad + turn_rad) > 0.3);
        at += step;
        angle_rad += turn_rad;
        const Places places = turned(followed.renderer().rest_px(), {200.0, 160.0}, angle_rad, at);
        followed.follow(places);
        confused += followed.confused(places);
        lost += 80U - followed.gel().found();
    }
    EXPECT_EQ(confused, 0);
    EXPECT_LT(lost, 500U * 80U / 20U);
}

TEST(MarkerGel, followsAStrongTwistAndMarkersThatLeaveAndComeBack) {
    SimulatedGel gel{.width_px = 320, .height_px = 240, .rows = 7, .columns = 9};
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    std::size_t least = followed.gel().markers().size();
    for (int i = 0; i <= 120; ++i) {
        // A quarter turn and back, which takes the long side out of the picture.
        const double angle_rad = 90.0 * kDegree * std::sin(std::numbers::pi * i / 120.0);
        const Places places = turned(followed.renderer().rest_px(), {160.0, 120.0}, angle_rad, {0.0, 0.0});
        followed.follow(places);
        EXPECT_EQ(followed.confused(places), 0) << "frame " << i;
        least = std::min(least, followed.gel().found());
    }
    EXPECT_LT(least, followed.gel().markers().size());
    EXPECT_EQ(followed.gel().found(), followed.gel().markers().size());
}

TEST(MarkerGel, followsPressAndTwistUnderABall) {
    SimulatedGel gel;
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    for (int i = 0; i <= 60; ++i) {
        const simulation::GelContact contact{.centre_m = {150.0, 115.0},
                                             .radius_m = 60.0,
                                             .spread_m = 0.15 * i,
                                             .turn_rad = 0.6 * kDegree * i};
        const Places places = under(followed.renderer().rest_px(), contact);
        followed.follow(places);
        EXPECT_EQ(followed.confused(places), 0) << "frame " << i;
        EXPECT_LT(followed.error_px(places), 0.06) << "frame " << i;
    }
    EXPECT_EQ(followed.gel().found(), 80U);
}

TEST(MarkerGel, followsBrightPinsInAHexagonalGrid) {
    SimulatedGel gel{.width_px = 640,
                     .height_px = 480,
                     .rows = 11,
                     .columns = 12,
                     .hexagonal = true,
                     .pitch_px = 44.0,
                     .diameter_px = 14.0,
                     .ground = 30.0,
                     .contrast = -120.0,
                     .noise = 4.0,
                     .printError_px = 1.0};
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    EXPECT_EQ(followed.gel().markers().size(), 132U);
    EXPECT_NEAR(followed.gel().diameter_px(), 14.0, 1.5);
    for (std::size_t i = 0; i < followed.gel().markers().size(); ++i) {
        const GridPlace place = followed.gel().markers()[i].grid;
        EXPECT_EQ(static_cast<std::size_t>(place.row * gel.columns + place.column), followed.drawn(i));
    }
    for (int i = 0; i < 40; ++i) {
        const simulation::GelContact contact{
            .centre_m = {320.0, 240.0}, .radius_m = 120.0, .slip_m = {0.8 * i, 0.3 * i}, .stick = 0.5};
        const Places places = under(followed.renderer().rest_px(), contact);
        followed.follow(places);
        EXPECT_EQ(followed.confused(places), 0) << "frame " << i;
    }
    EXPECT_EQ(followed.gel().found(), 132U);
}

TEST(MarkerGel, findsTheDiameterOfMarkers) {
    for (const double diameter_px : {4.0, 6.0, 8.0, 12.0}) {
        SimulatedGel gel{.diameter_px = diameter_px, .unevenness = 0.4};
        FollowedGel followed(gel);
        ASSERT_TRUE(followed.isMade());
        EXPECT_NEAR(followed.gel().diameter_px(), diameter_px, 0.15 * diameter_px);
        EXPECT_EQ(followed.gel().markers().size(), 80U) << diameter_px;
    }
}

TEST(MarkerGel, takesTheFirstPicturesWithoutContactForTheReference) {
    SimulatedGel gel;
    simulation::GelRenderer renderer(gel);
    std::vector<cv::Mat1b> first(8);
    for (std::size_t i = 0; i < first.size(); ++i) {
        // The contact begins in the sixth picture.
        const double spread_px = i < 5 ? 0.0 : 2.0 * static_cast<double>(i - 4);
        renderer.draw(
            under(renderer.rest_px(), {.centre_m = {160.0, 120.0}, .radius_m = 40.0, .spread_m = spread_px}),
            first[i]);
    }
    const auto made = MarkerGel::make(test::fileOf(gel), first);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->referencePictures(), 5U);
    for (std::size_t i = 0; i < made->markers().size(); ++i)
        EXPECT_LT((made->markers()[i].rest_px - renderer.rest_px()[i]).norm(), 0.15) << i;
    EXPECT_NEAR(made->noise_px(), 0.03, 0.02);
}

TEST(MarkerGel, tellsAJumpOfLightADeadCameraAndATornGel) {
    SimulatedGel gel;
    FollowedGel followed(gel);
    ASSERT_TRUE(followed.isMade());
    const Places rest = followed.renderer().rest_px();
    followed.follow(rest);
    EXPECT_FALSE(followed.gel().faults().lightJumped);
    followed.renderer().setLight(0.6);
    followed.follow(rest);
    EXPECT_TRUE(followed.gel().faults().lightJumped);
    // The contrast falls with the light, but the markers are still there.
    EXPECT_EQ(followed.gel().found(), 80U);
    followed.follow(rest);
    EXPECT_FALSE(followed.gel().faults().lightJumped);
    followed.renderer().setLight(0.0);
    followed.follow(rest);
    EXPECT_TRUE(followed.gel().faults().dead);
    EXPECT_EQ(followed.gel().found(), 0U);
    followed.renderer().setLight(1.0);
    followed.follow(rest);
    EXPECT_FALSE(followed.gel().faults().dead);
    EXPECT_EQ(followed.gel().found(), 80U);
    // Half of the gel hangs in rags.
    const Places torn(rest.begin(), rest.begin() + 40);
    for (int i = 0; i < 24; ++i) {
        followed.follow(torn);
        EXPECT_FALSE(followed.gel().faults().torn) << i;
    }
    for (int i = 0; i < 3; ++i)
        followed.follow(torn);
    EXPECT_TRUE(followed.gel().faults().torn);
}

TEST(MarkerGel, refusesPicturesWithoutMarkers) {
    MarkerGelFile file;
    file.grid = MarkerGrid::free;
    file.plane.mmPerPx = 0.1;
    const std::vector<cv::Mat1b> black(8, cv::Mat1b(240, 320, std::uint8_t{0}));
    const auto refused = MarkerGel::make(file, black);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "The picture is black.");
    core::RandomStream random(1);
    cv::Mat1b noise(240, 320), slope(240, 320);
    for (int v = 0; v < noise.rows; ++v) {
        for (int u = 0; u < noise.cols; ++u) {
            noise(v, u) = static_cast<std::uint8_t>(std::clamp(128.0 + 8.0 * random.normal(), 0.0, 255.0));
            slope(v, u) =
                static_cast<std::uint8_t>(std::clamp(40.0 + 0.5 * u + 2.0 * random.normal(), 0.0, 255.0));
        }
    }
    for (const cv::Mat1b& picture : {noise, slope}) {
        for (const MarkerGrid grid : {MarkerGrid::free, MarkerGrid::rectangular, MarkerGrid::hexagonal}) {
            file.grid = grid;
            file.rows = 8;
            file.columns = 10;
            const auto made = MarkerGel::make(file, std::vector<cv::Mat1b>(8, picture));
            EXPECT_FALSE(made) << static_cast<int>(grid) << ": " << made->markers().size() << " markers";
        }
    }
}

TEST(MarkerGel, refusesAnotherGridAndAPictureOfAnotherSize) {
    SimulatedGel gel;
    simulation::GelRenderer renderer(gel);
    cv::Mat1b drawn;
    renderer.draw(renderer.rest_px(), drawn);
    MarkerGelFile file = test::fileOf(gel);
    file.rows = 20;
    file.columns = 20;
    EXPECT_FALSE(MarkerGel::make(file, std::vector<cv::Mat1b>(8, drawn)));
    auto made = MarkerGel::make(test::fileOf(gel), std::vector<cv::Mat1b>(8, drawn));
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->track(drawn(cv::Rect(0, 0, 300, 240)), 0.0));
}

} // namespace teleta::vision
