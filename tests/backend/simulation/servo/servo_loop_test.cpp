// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/servo/servo_loop.h"
#include "tests/backend/contact/allocation_count.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace teleta::simulation {
namespace {

std::unique_ptr<ServoLoop> loopOf(const std::string& name) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
    EXPECT_TRUE(scene) << describe(scene.error());
    auto loop = ServoLoop::make(*scene, 2);
    EXPECT_TRUE(loop) << describe(loop.error());
    return std::move(*loop);
}

} // namespace

TEST(ServoLoop, servoesAtItsRateOnFramesOfTheirs) {
    const auto loop = loopOf("servo-straight-bar");
    int frames = 0;
    int servo = 0;
    for (int i = 0; i < 2000; ++i) {
        loop->next();
        frames += loop->frameCame() ? 1 : 0;
        servo += loop->servoed() ? 1 : 0;
    }
    EXPECT_EQ(frames, 400);
    EXPECT_EQ(servo, 200);
}

TEST(ServoLoop, theComplianceOfItsTasksIsThatOfTheScenesArmAndARowOfItsArray) {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/servo-straight-bar.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    auto& world = scene->servo();
    world.arm.stiffness_NPerM = 4000.0;
    world.sensor.array.stiffness_NPerM = 2000.0;
    for (const servo::ServoTask& task : servoPlan(*scene).tasks)
        EXPECT_DOUBLE_EQ(task.normalCompliance_mPerN, 1.0 / 4000.0 + 1.0 / (14 * 2000.0));
}

TEST(ServoLoop, allocatesNothingWhileItRuns) {
    for (const char* name : {"servo-straight-bar", "servo-bent-bar", "servo-comanipulation", "servo-roll"}) {
        const auto loop = loopOf(name);
        for (int i = 0; i < 3000; ++i)
            loop->next();
        const std::size_t before = contact::test::allocationCount();
        for (int i = 0; i < 3000; ++i)
            loop->next();
        EXPECT_EQ(contact::test::allocationCount(), before) << name;
    }
}

TEST(ServoLoop, timesEveryPartInOneOfSeventeenCycles) {
    const auto loop = loopOf("servo-straight-bar");
    for (int i = 0; i < 1700; ++i)
        loop->next();
    EXPECT_GT(loop->times().cycles, 0U);
    EXPECT_LE(loop->times().cycles, 100U);
    for (const double part_s : loop->times().part_s)
        EXPECT_GT(part_s, 0.0);
    loop->restart();
    EXPECT_EQ(loop->times().cycles, 0U);
}

TEST(CycleTimes, aCycleThatWasInterruptedSaysNothing) {
    servo::CycleTimes times;
    servo::CycleTimes cycle;
    cycle.of(servo::CyclePart::contact) = 4e-6;
    cycle.of(servo::CyclePart::dynamics) = 6e-6;
    times.add(cycle);
    times.add(cycle);
    cycle.of(servo::CyclePart::features) = 2e-3;
    times.add(cycle);
    EXPECT_EQ(times.cycles, 2U);
    EXPECT_DOUBLE_EQ(times.sum_s(), 20e-6);
}

/// The arm's spring of 1 N/mm presses with the distance of its reference; on metal, which gives way by less
/// than a tenth of that, nearly nothing is left of it.
TEST(ServoLoop, stopLetsGoOfWhatIsPressedAndHoldsTheReferenceThere) {
    const auto loop = loopOf("servo-straight-bar");
    for (int i = 0; i < 5000; ++i)
        loop->next();
    const double pressed_N = loop->world().truth().force_N;
    ASSERT_GT(pressed_N, 3.0);
    for (int i = 0; i < 10; ++i)
        loop->next(true);
    const Eigen::Isometry3d held = loop->world().arm().X_Base_Reference();
    for (int i = 0; i < 1000; ++i)
        loop->next(true);
    EXPECT_TRUE(loop->world().arm().X_Base_Reference().isApprox(held, 0.0));
    EXPECT_LT(loop->world().truth().force_N, 0.1 * pressed_N);
}

TEST(ServoLoop, startsAnewAsItDidAtFirst) {
    const auto loop = loopOf("servo-point");
    for (int i = 0; i < 2500; ++i)
        loop->next();
    const Eigen::Isometry3d first = loop->world().arm().X_Base_Sensor();
    loop->restart();
    for (int i = 0; i < 2500; ++i)
        loop->next();
    EXPECT_TRUE(loop->world().arm().X_Base_Sensor().isApprox(first, 0.0));
}

} // namespace teleta::simulation
