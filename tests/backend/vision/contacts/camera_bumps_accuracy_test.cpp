// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/finders/contact_ladder.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numbers>
#include <optional>

namespace teleta::vision {
namespace {

constexpr int kSeeds = 10;
constexpr double kVisible_m = 0.0006; ///< a lighter touch falls between the dots
constexpr double kNearest_m = 0.01;
constexpr double kFurthest_m = 0.07; ///< beyond, a jump may lead from one ring of dots to the next
constexpr double kSoonest_s = 0.025;
constexpr int kFramesAfter = 2; ///< that a finger stays pressed

struct Poke {
    std::optional<int> touched; ///< first frame of the true touch
    std::optional<int> visible; ///< first frame in which it is deep enough to be seen anywhere
    std::optional<int> bumped;
    bool seen = false;
};

/// Fingers that press at constant speed anywhere on the tube, at various frame rates. Each seed has its own
/// print, noise, place and time.
class RenderedPokes : public testing::TestWithParam<double> {
protected:
    static void SetUpTestSuite() {
        for (int seed = 1; seed <= kSeeds; ++seed)
            s_tubes.push_back(std::move(
                *simulation::SimulatedTube::make(test::cameraScene(), static_cast<unsigned>(seed))));
        s_tracker = std::make_unique<CameraTracker>(
            std::move(*makeContactFinder(contactLadder().front(), s_tubes.front()->camera())),
            CameraTracker::Settings());
    }
    static void TearDownTestSuite() {
        s_tracker.reset();
        s_tubes.clear();
    }

    static Poke poke(int seed, double speed_mPerS, double depth_m, double rate_Hz) {
        simulation::SimulatedTube& tube = *s_tubes[static_cast<std::size_t>(seed)];
        CameraTracker& tracker = *s_tracker; // all tubes have the same lens
        tracker.renewReference();
        cv::Mat1b frame;
        tube.untouched(frame);
        EXPECT_TRUE(tracker.next(frame, 0.0));
        core::RandomStream random(static_cast<unsigned>(seed), "pokes");
        simulation::SkinPress press;
        press.centre = {2.0 * std::numbers::pi * random.uniform(),
                        kNearest_m + (kFurthest_m - kNearest_m) * random.uniform()};
        press.ballRadius_m = 0.006 + 0.008 * random.uniform();
        const double begin_s = (1.0 + random.uniform()) / rate_Hz;
        Poke result;
        const int frames = static_cast<int>((begin_s + depth_m / speed_mPerS) * rate_Hz) + kFramesAfter;
        for (int i = 1; i <= frames; ++i) {
            const double time_s = i / rate_Hz;
            press.depth_m = std::min(depth_m, (time_s - begin_s) * speed_mPerS);
            if (press.depth_m > 0.0)
                tube.pressed({press}, frame);
            else
                tube.untouched(frame);
            if (press.depth_m > 0.0 && !result.touched)
                result.touched = i;
            if (press.depth_m >= kVisible_m && !result.visible)
                result.visible = i;
            const auto contacts = tracker.next(frame, time_s);
            result.seen = result.seen || (contacts && !contacts->empty());
            if (tracker.bump() && !result.bumped)
                result.bumped = i;
        }
        return result;
    }

    static inline std::vector<std::unique_ptr<simulation::SimulatedTube>> s_tubes;
    static inline std::unique_ptr<CameraTracker> s_tracker;
};

} // namespace

TEST_P(RenderedPokes, thatAreSlowAreNoBump) {
    for (const double speed_mPerS : {0.006, 0.015}) {
        int bumps = 0;
        for (int seed = 0; seed < kSeeds; ++seed) {
            const Poke slow = poke(seed, speed_mPerS, 0.0012, GetParam());
            EXPECT_TRUE(slow.seen) << speed_mPerS << " m/s, seed " << seed;
            bumps += slow.bumped ? 1 : 0;
        }
        std::cout << GetParam() << " Hz, " << speed_mPerS * 1e3 << " mm/s: " << bumps << " of " << kSeeds
                  << " count as bumps\n";
        EXPECT_EQ(bumps, 0) << speed_mPerS << " m/s";
    }
}

TEST_P(RenderedPokes, thatAreFastAreABumpWithinTwoFramesOrAFortiethOfASecondOfBeingVisible) {
    for (const double speed_mPerS : {0.03, 0.05, 0.2}) {
        int latest = 0;
        int latestSinceTouch = 0;
        int missed = 0;
        for (int seed = 0; seed < kSeeds; ++seed) {
            const Poke fast = poke(seed, speed_mPerS, 0.0025, GetParam());
            if (!fast.bumped) {
                ++missed;
                continue;
            }
            EXPECT_GE(*fast.bumped, *fast.touched) << speed_mPerS << " m/s, seed " << seed;
            latest = std::max(latest, *fast.bumped - *fast.visible + 1);
            latestSinceTouch = std::max(latestSinceTouch, *fast.bumped - *fast.touched + 1);
        }
        std::cout << GetParam() << " Hz, " << speed_mPerS * 1e3 << " mm/s: at the latest in frame " << latest
                  << " of being visible, " << latestSinceTouch << " of touching, " << missed << " missed\n";
        // Half as fast again as the threshold is near it, where the dots are coarse: at the far end.
        EXPECT_LE(missed, speed_mPerS < 2.0 * BumpDetector::Settings().speed_mPerS ? 1 : 0)
            << speed_mPerS << " m/s";
        // A speed is not known sooner than the noise of the dots allows.
        EXPECT_LE(latest, std::max(2.0, kSoonest_s * GetParam())) << speed_mPerS << " m/s";
    }
}

INSTANTIATE_TEST_SUITE_P(FrameRates_Hz, RenderedPokes, testing::Values(30.0, 40.0, 120.0));

} // namespace teleta::vision
