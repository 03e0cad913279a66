// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/finders/contact_ladder.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <numbers>

namespace teleta::vision {
namespace {

constexpr int kContacts = 60;
constexpr int kFramesToDepth = 6; ///< 0.25 mm a frame and less
constexpr double kFarEnd_m = 0.075;

double cpu_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Result {
    std::vector<double> errors_m, farErrors_m;
    std::vector<double> inOrder_m;   ///< NaN where it was missed
    std::vector<double> depthShares; ///< depth that was seen, of the true one
    int missed = 0;
    int extra = 0; ///< contacts beyond the one that is there
    double time_s = 0.0;
    int frames = 0;
};

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return values.empty() ? std::nan("") : sum / static_cast<double>(values.size());
}

/// Fingers of 6 to 14 mm radius, 0.6 to 1.6 mm deep, anywhere from 5 mm to 95 mm, that drag the skin a
/// little.
class RenderedContacts : public testing::Test {
protected:
    static std::vector<Result> measure(const std::vector<std::string_view>& names, int contacts) {
        auto tube = simulation::SimulatedTube::make(test::cameraScene(), 1);
        cv::Mat1b frame;
        (*tube)->untouched(frame);
        std::vector<std::unique_ptr<ContactFinder>> finders;
        for (const std::string_view name : names) {
            auto finder = makeContactFinder(*contactRung(name), (*tube)->camera());
            EXPECT_TRUE(finder && (*finder)->setReference(frame)) << name;
            finders.push_back(std::move(*finder));
        }
        std::vector<Result> results(names.size());
        core::RandomStream random(3, "contacts");
        for (int i = 0; i < contacts; ++i) {
            simulation::SkinPress press;
            press.centre = {2.0 * std::numbers::pi * random.uniform(), 0.005 + 0.09 * random.uniform()};
            press.ballRadius_m = 0.006 + 0.008 * random.uniform();
            const double depth_m = 0.0006 + 0.001 * random.uniform();
            const double drag_m = 0.0002;
            const double dragAround = random.normal();
            const double dragAlong = random.normal();
            const Eigen::Vector3d truth_m(0.025 * std::cos(press.centre.angle_rad),
                                          0.025 * std::sin(press.centre.angle_rad), press.centre.z_m);
            for (const auto& finder : finders)
                finder->forget();
            for (int step = 1; step <= kFramesToDepth; ++step) {
                const double share = static_cast<double>(step) / kFramesToDepth;
                press.depth_m = share * depth_m;
                press.dragAround_m = share * drag_m * dragAround;
                press.dragAlong_m = share * drag_m * dragAlong;
                (*tube)->pressed({press}, frame);
                for (std::size_t k = 0; k < finders.size(); ++k) {
                    const ContactRung& rung = *contactRung(names[k]);
                    if (step < kFramesToDepth && rung.method != FlowMethod::dots && !rung.warmStart)
                        continue; // the previous frame is unknown
                    const double start_s = cpu_s();
                    const auto found = finders[k]->find(frame);
                    results[k].time_s += cpu_s() - start_s;
                    ++results[k].frames;
                    if (step < kFramesToDepth)
                        continue;
                    if (!found || found->empty()) {
                        ++results[k].missed;
                        results[k].inOrder_m.push_back(std::nan(""));
                        continue;
                    }
                    results[k].extra += static_cast<int>(found->size()) - 1;
                    results[k].depthShares.push_back(found->front().depth_m / depth_m);
                    const double error_m = (found->front().p_Sensor_Centre_m - truth_m).norm();
                    results[k].errors_m.push_back(error_m);
                    results[k].inOrder_m.push_back(error_m);
                    if (press.centre.z_m > kFarEnd_m)
                        results[k].farErrors_m.push_back(error_m);
                }
            }
        }
        for (std::size_t k = 0; k < names.size(); ++k) {
            Result& result = results[k];
            std::ranges::sort(result.errors_m);
            std::cout << names[k] << ": mean " << mean(result.errors_m) * 1e3 << " mm, 95 % "
                      << result.errors_m[result.errors_m.size() * 95 / 100] * 1e3 << " mm, worst "
                      << result.errors_m.back() * 1e3 << " mm; far end mean "
                      << mean(result.farErrors_m) * 1e3 << " mm; missed " << result.missed << ", extra "
                      << result.extra << "; depth seen " << mean(result.depthShares) * 1e2 << " %; "
                      << result.time_s / result.frames * 1e3 << " ms a frame\n";
        }
        return results;
    }
};

} // namespace

TEST_F(RenderedContacts, areFoundWithinAMillimetreOnAverageAndWithinTwoAndAHalfAtTheFarEnd) {
    const Result dots = measure({"dots"}, kContacts).front();
    EXPECT_LT(mean(dots.errors_m), 0.001);
    EXPECT_LT(mean(dots.farErrors_m), 0.0025);
    EXPECT_EQ(dots.missed, 0);
    EXPECT_LE(dots.extra, kContacts / 20);
}

TEST_F(RenderedContacts, areFoundMoreExactlyByTheDotsThanByThePapersPipeline) {
    const std::vector<Result> both = measure({"dots", "paper"}, 40);
    std::vector<double> dots_m, paper_m; // of contacts that both have found
    for (std::size_t i = 0; i < both[0].inOrder_m.size(); ++i) {
        if (std::isnan(both[0].inOrder_m[i]) || std::isnan(both[1].inOrder_m[i]))
            continue;
        dots_m.push_back(both[0].inOrder_m[i]);
        paper_m.push_back(both[1].inOrder_m[i]);
    }
    ASSERT_GT(paper_m.size(), 10U);
    std::cout << "contacts that both have found: " << paper_m.size() << ", dots " << mean(dots_m) * 1e3
              << " mm, paper " << mean(paper_m) * 1e3 << " mm\n";
    EXPECT_LE(mean(dots_m), mean(paper_m));
    EXPECT_LE(both[0].missed, both[1].missed);
}

TEST_F(RenderedContacts, areNowhereButWhereTheyPressOnRungsOfTheWholeImage) {
    for (const Result& rung : measure({"ultrafast-1", "medium-1"}, 20)) {
        EXPECT_LE(rung.missed, 4);
        EXPECT_LE(rung.extra, 2);
        ASSERT_FALSE(rung.errors_m.empty());
        EXPECT_LT(rung.errors_m.back(), 0.01) << "the other end of the tube is no place for it";
    }
}

/// A bump must exceed the noise of the depth, so the noise that a contact states must not be smaller than
/// that of its depth.
TEST_F(RenderedContacts, ofASkinThatRestsHaveADepthThatWavesNoMoreThanTheNoiseTheyState) {
    auto tube = simulation::SimulatedTube::make(test::cameraScene(), 5);
    cv::Mat1b frame;
    int judged = 0;
    cv::Mat1b untouched;
    (*tube)->untouched(untouched);
    for (const ContactRung& rung : contactLadder()) {
        const bool isDots = &rung == &contactLadder().front();
        if (!isDots && rung.name != "medium-1")
            continue;
        auto finder = makeContactFinder(rung, (*tube)->camera());
        ASSERT_TRUE(finder && (*finder)->setReference(untouched));
        for (const double z_m : {0.02, 0.05, 0.08}) {
            const simulation::SkinPress press{.centre = {1.0, z_m}, .ballRadius_m = 0.01, .depth_m = 0.0012};
            (*finder)->forget();
            std::vector<double> depths_m;
            double stated_m = 0.0;
            for (int i = 0; i < 12; ++i) {
                (*tube)->pressed({press}, frame);
                const auto found = (*finder)->find(frame);
                if (!isDots && found && found->empty())
                    break; // it finds fewer contacts than the dots
                ASSERT_TRUE(found && !found->empty()) << rung.name << " at " << z_m;
                depths_m.push_back(found->front().depth_m);
                stated_m = found->front().depthNoise_m;
            }
            if (depths_m.size() < 12)
                continue;
            double squares_m2 = 0.0;
            for (const double depth_m : depths_m)
                squares_m2 += std::pow(depth_m - mean(depths_m), 2);
            const double waves_m = std::sqrt(squares_m2 / static_cast<double>(depths_m.size() - 1));
            std::cout << rung.name << ", z " << 1e3 * z_m << " mm: depth waves by " << 1e6 * waves_m
                      << " um, " << 1e6 * stated_m << " um stated\n";
            EXPECT_LT(waves_m, stated_m) << rung.name << " at " << z_m;
            ++judged;
        }
    }
    EXPECT_GE(judged, 4) << "all three of the dots, and one of the dense rung at the least";
}

TEST_F(RenderedContacts, showNoContactInTwentyFramesOfTheUntouchedSkin) {
    auto tube = simulation::SimulatedTube::make(test::cameraScene(), 2);
    cv::Mat1b frame;
    (*tube)->untouched(frame);
    auto finder = makeContactFinder(contactLadder().front(), (*tube)->camera());
    ASSERT_TRUE(finder && (*finder)->setReference(frame));
    for (int i = 0; i < 20; ++i) {
        (*tube)->untouched(frame);
        const auto found = (*finder)->find(frame);
        ASSERT_TRUE(found) << describe(found.error());
        EXPECT_TRUE(found->empty()) << "frame " << i << " at z " << found->front().p_Sensor_Centre_m.z();
    }
}

} // namespace teleta::vision
