// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"
#include "backend/simulation/arm/delayed_line.h"
#include "backend/simulation/arm/teleoperated_arm.h"
#include "backend/simulation/arm/unknown_places.h"
#include "tests/backend/simulation/arm/arm_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::simulation::test {

namespace {

using core::ArmDrive;

LinkDelay linkOf(const scene::LinkDelaySpec& spec, std::uint64_t seed = 1) {
    return {spec, core::RandomStream(seed, "link_delay")};
}

/// Share of the values that are at most the limit.
double shareUpTo(const std::vector<double>& values, double limit) {
    return static_cast<double>(std::ranges::count_if(values, [&](double v) { return v <= limit; })) /
           static_cast<double>(values.size());
}

/// Half width of the interval that holds a share of n draws but once in 15 000 times.
double fourSigma(double share, double n) {
    return 4.0 * std::sqrt(share * (1.0 - share) / n);
}

scene::Scene teleoperation(const std::vector<scene::Effect>& effects = {}) {
    scene::Scene scene = shippedArm("teleoperation.toml");
    scene.effects = effects;
    return scene;
}

/// The elbow's distance from the place that the scripted operator explores first.
double elbowDistance_m(const scene::ArmWorld& world, const core::JointSample& sample) {
    const arm::Arm4Kinematics kinematics({.upperArmLength_m = world.body.upperArmLength_m,
                                          .forearmLength_m = world.body.forearmLength_m,
                                          .halfThickness_m = world.body.halfThickness_m});
    const auto& place = std::get<scene::OperatorProgram>(world.program).explorations.front();
    const Eigen::Vector2d elbow_m =
        kinematics
            .p_Base_Point(arm::Link::upperArm, arm::JointVector(sample.reference_rad.data()),
                          {world.body.upperArmLength_m, 0.0, 0.0})
            .head<2>();
    return (elbow_m - Eigen::Vector2d(place.x_m, place.y_m)).norm();
}

/// When the scripted operator first touches something over such a link; empty: not within the time.
std::optional<double> firstTouch_s(const scene::LinkDelaySpec& link, double duration_s) {
    const auto made = TeleoperatedArm::make(teleoperation({{.why = "w", .parameters = link}}), 1);
    core::JointSample atArm;
    core::ArmArrival arrival;
    while ((*made)->time_s() < duration_s) {
        (*made)->next({.drive = ArmDrive::program}, atArm);
        while ((*made)->takeArrival(arrival)) {
        }
        if (!(*made)->arm().truth().touches.empty())
            return (*made)->arm().truth().touches.front().begin_s;
    }
    return {};
}

core::ArmDemand jog(double elbow_radPerS) {
    return {ArmDrive::jog, {0.0, 0.0, 0.0, elbow_radPerS}};
}

} // namespace

TEST(LinkDelay, hasTheQuantilesOfAShiftedExponentialAndItsShareOfLosses) {
    const scene::LinkDelaySpec spec{.delay_s = 0.03, .jitter_s = 0.01, .lossShare = 0.1};
    LinkDelay link = linkOf(spec);
    std::vector<double> delays_s;
    constexpr int kMessages = 200'000;
    for (int i = 0; i < kMessages; ++i)
        if (const auto delay_s = link.next_s(0.0))
            delays_s.push_back(*delay_s);
    const auto arrived = static_cast<double>(delays_s.size());
    EXPECT_NEAR(1.0 - arrived / kMessages, 0.1, fourSigma(0.1, kMessages));
    EXPECT_GE(*std::ranges::min_element(delays_s), 0.03);
    for (const double p : {0.1, 0.5, 0.9, 0.99})
        EXPECT_NEAR(shareUpTo(delays_s, 0.03 - 0.01 * std::log(1.0 - p)), p, fourSigma(p, arrived)) << p;
}

TEST(LinkDelay, losesEverythingDuringAnOutageAndDelaysTheOthersAsWithoutIt) {
    LinkDelay link = linkOf({.delay_s = 0.01, .jitter_s = 0.01, .outageAt_s = 1.0, .outage_s = 0.5});
    LinkDelay whole = linkOf({.delay_s = 0.01, .jitter_s = 0.01});
    for (int i = 0; i < 2000; ++i) {
        const double now_s = 0.001 * i;
        const auto delay_s = link.next_s(now_s);
        const auto without_s = whole.next_s(now_s);
        EXPECT_EQ(delay_s.has_value(), i < 1000 || i >= 1500) << i;
        EXPECT_EQ(delay_s.value_or(*without_s), *without_s);
    }
}

TEST(DelayedLine, inOrderIsAsLateAsTheLatestOfThoseBefore) {
    // P(D <= d + x) = product over k of P(E <= x + k T): of messages every T, each waits for all before it.
    constexpr double kPeriod_s = 0.001;
    constexpr double kJitter_s = 0.002;
    DelayedLine<int> line(LineOrder::inOrder, linkOf({.delay_s = 0.02, .jitter_s = kJitter_s}));
    constexpr int kMessages = 60'000;
    std::vector<double> delays_s;
    int expected = 0;
    for (int i = 0; i < 20 * kMessages; ++i) { // looks 20 times a period
        const double now_s = kPeriod_s / 20.0 * i;
        if (i % 20 == 0)
            line.send(now_s, i / 20);
        for (int message = 0; line.receive(now_s, message); ++expected) {
            ASSERT_EQ(message, expected);
            delays_s.push_back(now_s - kPeriod_s * message);
        }
    }
    EXPECT_EQ(line.lost(), 0U);
    for (const double x : {0.002, 0.004, 0.008}) {
        double product = 1.0;
        for (int k = 0; k < 100; ++k)
            product *= 1.0 - std::exp(-(x + k * kPeriod_s) / kJitter_s);
        // Neighbours are not independent: about jitter / period of them share a delay. Seen up to a look
        // late.
        const double tolerance = fourSigma(product, kMessages / 8.0);
        EXPECT_GE(shareUpTo(delays_s, 0.02 + x + kPeriod_s / 20.0), product - tolerance) << x;
        EXPECT_LE(shareUpTo(delays_s, 0.02 + x - 1e-9), product + tolerance) << x;
    }
}

TEST(DelayedLine, newestWinsGivesUpWhatWasOvertaken) {
    // Two messages T apart: the second one overtakes with P = exp(-T / jitter) / 2.
    constexpr double kApart_s = 0.001;
    constexpr double kJitter_s = 0.002;
    DelayedLine<int> line(LineOrder::newestWins, linkOf({.delay_s = 0.02, .jitter_s = kJitter_s}));
    constexpr int kPairs = 20'000;
    for (int pair = 0; pair < kPairs; ++pair) {
        const double start_s = 1.0 * pair;
        line.send(start_s, 0);
        line.send(start_s + kApart_s, 1);
        int newest = -1;
        for (int look = 0; look < 3000; ++look) {
            int message = -1;
            if (line.receive(start_s + kApart_s + 1e-4 * look, message)) {
                ASSERT_GT(message, newest);
                newest = message;
            }
            if (newest == 1)
                break;
        }
        ASSERT_EQ(newest, 1);
    }
    const double overtaken = static_cast<double>(line.overtaken()) / kPairs;
    const double expected = 0.5 * std::exp(-kApart_s / kJitter_s);
    // Both within one look count as overtaken, too.
    EXPECT_GE(overtaken, expected - fourSigma(expected, kPairs));
    EXPECT_LE(overtaken, expected + 1e-4 / kJitter_s + fourSigma(expected, kPairs));
}

TEST(DelayedLine, withoutALinkIsThereAtOnce) {
    DelayedLine<int> line(LineOrder::newestWins, std::nullopt);
    int message = 0;
    EXPECT_FALSE(line.receive(0.0, message));
    EXPECT_TRUE(line.send(1.0, 7));
    ASSERT_TRUE(line.receive(1.0, message));
    EXPECT_EQ(message, 7);
    EXPECT_FALSE(line.receive(1.0, message));
}

TEST(UnknownPlaces, swapAndDisplaceTheObjectsWithinTheirRanges) {
    const scene::ArmWorld world = teleoperation().arm();
    std::set<std::vector<std::size_t>> orders;
    double furthest_m = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const auto objects = drawPlaces(world, seed);
        ASSERT_EQ(objects.size(), world.objects.size());
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            EXPECT_EQ(objects[i].name, world.objects[i].name);
            EXPECT_EQ(objects[i].stiffness_NPerM, world.objects[i].stiffness_NPerM);
            EXPECT_LE(std::abs(objects[i].angle_rad - world.objects[i].angle_rad), world.unknown.turn_rad);
            for (std::size_t place = 0; place < world.objects.size(); ++place) {
                const double away_m = std::max(std::abs(objects[i].x_m - world.objects[place].x_m),
                                               std::abs(objects[i].y_m - world.objects[place].y_m));
                if (away_m > world.unknown.spread_m)
                    continue;
                order.push_back(place);
                furthest_m = std::max(furthest_m, away_m);
            }
        }
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 3U);
        orders.insert(order);
    }
    EXPECT_EQ(orders.size(), 6U); // all orders of three
    EXPECT_GT(furthest_m, 0.95 * world.unknown.spread_m);
}

TEST(UnknownPlaces, areTheFilesOwnWhenNothingIsUnknown) {
    scene::ArmWorld world = teleoperation().arm();
    world.unknown = {};
    const auto objects = drawPlaces(world, 5);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        EXPECT_EQ(objects[i].x_m, world.objects[i].x_m);
        EXPECT_EQ(objects[i].angle_rad, world.objects[i].angle_rad);
    }
}

TEST(TeleoperatedArm, obeysAndAnswersAsLateAsTheLink) {
    const auto made = TeleoperatedArm::make(
        teleoperation({{.why = "w", .parameters = scene::LinkDelaySpec{.delay_s = 0.05}}}), 1);
    ASSERT_TRUE(made) << describe(made.error());
    TeleoperatedArm& arm = **made;
    core::JointSample atArm;
    core::ArmArrival arrival;
    std::optional<int> movedAt;
    std::optional<int> seenAt;
    double first_rad = 0.0;
    for (int step = 0; step < 200; ++step) {
        arm.next(jog(0.2), atArm);
        if (step == 0)
            first_rad = atArm.reference_rad[3];
        if (!movedAt && atArm.reference_rad[3] != first_rad)
            movedAt = step;
        while (arm.takeArrival(arrival)) {
            EXPECT_NEAR(arm.time_s() - arrival.sample.sourceTime_s, 0.05, 1.1e-3);
            if (!seenAt && arrival.sample.reference_rad[3] != first_rad)
                seenAt = step;
        }
    }
    ASSERT_TRUE(movedAt && seenAt);
    EXPECT_NEAR(*movedAt, 50, 1);
    EXPECT_NEAR(*seenAt - *movedAt, 50, 1);
}

TEST(TeleoperatedArm, standsStillATenthOfASecondAfterTheLinkIsLostAndGoesOnWhenItIsBack) {
    const auto made = TeleoperatedArm::make(
        teleoperation(
            {{.why = "w",
              .parameters = scene::LinkDelaySpec{.delay_s = 0.02, .outageAt_s = 0.5, .outage_s = 0.5}}}),
        1);
    ASSERT_TRUE(made);
    TeleoperatedArm& arm = **made;
    core::JointSample atArm;
    core::ArmArrival arrival;
    for (int step = 0; step < 1200; ++step) {
        arm.next(jog(0.1), atArm);
        while (arm.takeArrival(arrival)) {
        }
        const bool heard = step >= 21 && !(step > 500 + 20 + 101 && step < 1000 + 20);
        const bool sure = std::min({std::abs(step - 20), std::abs(step - 621), std::abs(step - 1020)}) > 2;
        if (sure) {
            EXPECT_EQ(arm.obeyed(), heard ? ArmDrive::jog : ArmDrive::held) << step;
        }
    }
    EXPECT_EQ(arm.linkCounters().commandsLost, 500U);
    EXPECT_EQ(arm.linkCounters().samplesLost, 500U);
    EXPECT_EQ(arm.linkCounters().framesLost, 100U);
}

TEST(TeleoperatedArm, stopsForStopEvenWhenHalfOfAllMessagesAreLost) {
    const auto made = TeleoperatedArm::make(
        teleoperation({{.why = "w", .parameters = scene::LinkDelaySpec{.delay_s = 0.02, .lossShare = 0.5}}}),
        3);
    ASSERT_TRUE(made);
    TeleoperatedArm& arm = **made;
    core::JointSample atArm;
    for (int step = 0; step < 300; ++step)
        arm.next(jog(0.1), atArm);
    EXPECT_EQ(arm.obeyed(), ArmDrive::jog);
    for (int step = 0; step < 60; ++step)
        arm.next({.drive = ArmDrive::stopped}, atArm);
    const double stood_rad = atArm.reference_rad[3];
    for (int step = 0; step < 100; ++step) {
        arm.next({.drive = ArmDrive::stopped}, atArm);
        EXPECT_EQ(arm.obeyed(), ArmDrive::stopped);
    }
    EXPECT_EQ(atArm.reference_rad[3], stood_rad);
}

TEST(TeleoperatedArm, itsOperatorWaitsWhileHeSeesNothingAndThenBeginsTheTouchAnew) {
    const auto touch_s = firstTouch_s({.delay_s = 0.02}, 60.0);
    ASSERT_TRUE(touch_s);
    // While he approaches, half a second before he would touch.
    const double outage_s = 5.0;
    const scene::LinkDelaySpec link{.delay_s = 0.02, .outageAt_s = *touch_s - 0.5, .outage_s = outage_s};
    const scene::Scene scene = teleoperation({{.why = "w", .parameters = link}});
    const auto made = TeleoperatedArm::make(scene, 1);
    ASSERT_TRUE(made);
    TeleoperatedArm& arm = **made;
    core::JointSample atArm;
    core::ArmArrival arrival;
    double stood_m = 0.0;
    double nearest_m = 1.0;
    double furthest_m = 0.0;
    while (arm.time_s() < link.outageAt_s + outage_s + 2.0) {
        arm.next({.drive = ArmDrive::program}, atArm);
        while (arm.takeArrival(arrival)) {
        }
        const double distance_m = elbowDistance_m(scene.arm(), atArm);
        if (arm.time_s() < link.outageAt_s + outage_s) {
            stood_m = distance_m;
        } else {
            nearest_m = std::min(nearest_m, distance_m);
            furthest_m = std::max(furthest_m, distance_m);
        }
    }
    EXPECT_GT(nearest_m, stood_m - 0.001) << "not on by all that he wished meanwhile";
    EXPECT_NEAR(furthest_m, 0.08, 0.002) << "but back to where the touch begins";
}

TEST(TeleoperatedArm, itsOperatorGoesOnWhenWhatComesIsLateButWhole) {
    const scene::LinkDelaySpec link{.delay_s = 0.02, .jitter_s = 0.03};
    const auto made = TeleoperatedArm::make(teleoperation({{.why = "w", .parameters = link}}), 1);
    ASSERT_TRUE(made);
    TeleoperatedArm& arm = **made;
    core::JointSample atArm;
    core::ArmArrival arrival;
    int pauses = 0;
    double last_s = 0.0;
    while (arm.time_s() < 60.0) {
        arm.next({.drive = ArmDrive::program}, atArm);
        while (arm.takeArrival(arrival)) {
            pauses += arm.time_s() - last_s > 0.1 ? 1 : 0;
            last_s = arm.time_s();
        }
    }
    EXPECT_GT(pauses, 50) << "he waits more than once in a touch";
    EXPECT_GE(arm.arm().truth().touches.size(), 6U);
}

TEST(TeleoperatedArm, drawsNothingForALinkThatIsNotListedAndTellsTheSameAgain) {
    const auto samplesOf = [](const std::vector<scene::Effect>& effects) {
        const auto made = TeleoperatedArm::make(teleoperation(effects), 4);
        std::vector<double> torques_Nm;
        core::JointSample atArm;
        core::ArmArrival arrival;
        for (int step = 0; step < 500; ++step) {
            (*made)->next(jog(0.05), atArm);
            torques_Nm.push_back(atArm.torque_Nm[1]);
            while ((*made)->takeArrival(arrival)) {
            }
        }
        return torques_Nm;
    };
    const scene::Effect noise{.why = "w", .parameters = scene::TorqueNoiseSpec{.sd_Nm = 0.001}};
    const scene::Effect lossless{.why = "w", .parameters = scene::LinkDelaySpec{}};
    EXPECT_EQ(samplesOf({noise}), samplesOf({noise, lossless}));
    EXPECT_EQ(samplesOf({noise, lossless}), samplesOf({noise, lossless}));
}

TEST(TeleoperatedArm, refusesASceneWithoutAnOperator) {
    EXPECT_FALSE(TeleoperatedArm::make(shippedArm("teleta-touch.toml"), 1));
    EXPECT_TRUE(makeArm(shippedArm("teleta-touch.toml"), 1));
}

} // namespace teleta::simulation::test
