// SPDX-License-Identifier: GPL-3.0-or-later
// Touches of an arm that measures no torques, by its pad. Where the pad is follows from the arm's chain.
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/touch/skin_touches.h"
#include "tests/backend/pipeline/pad_on_arm.h"
#include "tests/backend/pipeline/scripted_arm_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace teleta::pipeline {
namespace {

using core::JointVector;

constexpr double kX_m = 0.012;
constexpr double kY_m = -0.02;

class PadWithoutTorques {
public:
    /// Goes on for so long while the pad feels this, or tells nothing (NaN).
    void run(int duration_ms, double force_N) {
        for (int i = 0; i < duration_ms; ++i) {
            ++m_ms;
            core::JointSample sample;
            sample.time_ns = 1'000'000'000 + std::llround(1e6 * m_ms / speed);
            sample.sourceTime_s = 1e-3 * m_ms;
            sample.angle_rad = sample.reference_rad = q;
            keep(touches.update(sample, settings));
            if (m_ms % 10 == 0 && !std::isnan(force_N))
                keep(touches.update(SkinContact{.time_ns = sample.time_ns,
                                                .sourceTime_s = sample.sourceTime_s,
                                                .touching = force_N > 0.0,
                                                .x_m = kX_m,
                                                .y_m = kY_m,
                                                .force_N = force_N,
                                                .type = contact::ContactType::point},
                                    settings));
        }
    }
    [[nodiscard]] Eigen::Vector3d point_m() const {
        const std::size_t link = *chain->model().findLink(pad.link);
        return chain->linkPoses(q)[link] * X_Link_Sensor(pad) * Eigen::Vector3d(kX_m, kY_m, 0.0);
    }

    std::shared_ptr<const arm_model::SerialChain> chain = test::chainOf("resources/arms/seven-joints.urdf");
    core::PadPlacement pad = test::padOnLinkFive();
    TouchEstimatorSettings settings;
    double speed = 1.0; ///< at which a recording is played
    JointVector q{0.3, -0.7, 0.2, 1.1, -0.4, 0.8, 0.5};
    SkinTouches touches{7, *padOnLink(chain, pad)};
    std::vector<TouchRecord> records;

private:
    void keep(const std::optional<TouchRecord>& record) {
        if (record)
            records.push_back(*record);
    }
    int m_ms = 0;
};

TEST(SkinTouches, aTouchHasItsPlaceAndNoStiffness) {
    PadWithoutTorques arm;
    arm.run(200, 0.0);
    EXPECT_FALSE(arm.touches.liveContact());
    arm.run(90, 1.0);
    EXPECT_TRUE(arm.records.empty()) << "it has not settled";
    const auto live = arm.touches.liveContact();
    ASSERT_TRUE(live);
    EXPECT_TRUE(live->p_Base_Contact_m.isApprox(arm.point_m(), 1e-9));
    EXPECT_FALSE(live->force);
    arm.run(500, 1.0);
    ASSERT_EQ(arm.records.size(), 1U) << "one record a touch, however long it lasts";
    const TouchRecord& touch = arm.records.front();
    EXPECT_EQ(touch.number, 1U);
    EXPECT_TRUE(touch.located);
    EXPECT_TRUE(touch.p_Base_Contact_m.isApprox(arm.point_m(), 1e-9));
    EXPECT_EQ(touch.contactType, contact::ContactType::point);
    EXPECT_EQ(touch.refusal, stiffness::Refusal::noTorques);
    EXPECT_FALSE(touch.stiffness);
    EXPECT_FALSE(touch.force);
    EXPECT_NEAR(touch.ready_s - touch.start_s, SkinTouches::kSettle_s, 0.002);
    arm.run(100, 0.0);
    arm.q[0] += 0.5;
    arm.run(200, 1.0);
    ASSERT_EQ(arm.records.size(), 2U);
    EXPECT_EQ(arm.records[1].number, 2U);
    EXPECT_TRUE(arm.records[1].p_Base_Contact_m.isApprox(arm.point_m(), 1e-9));
}

TEST(SkinTouches, aShortTouchIsRecordedAtItsEndAndOneFrameIsNone) {
    PadWithoutTorques arm;
    arm.run(100, 0.0);
    arm.run(40, 1.0);
    arm.run(40, 0.0);
    EXPECT_EQ(arm.records.size(), 1U);
    arm.run(100, 0.0);
    arm.run(10, 1.0);
    arm.run(200, 0.0);
    EXPECT_EQ(arm.records.size(), 1U);
    arm.run(200, 0.01);
    EXPECT_EQ(arm.records.size(), 1U) << "less than the skin's noise";
    EXPECT_FALSE(arm.touches.liveContact());
}

TEST(SkinTouches, anEmptyFrameInATouchDoesNotEndIt) {
    PadWithoutTorques arm;
    for (int i = 0; i < 20; ++i) {
        arm.run(40, 1.0);
        arm.run(10, 0.0);
    }
    EXPECT_EQ(arm.records.size(), 1U);
}

TEST(SkinTouches, aRecordingHasTheSameTouchesAtEachSpeed) {
    for (const double speed : {0.05, 1.0, 100.0}) {
        PadWithoutTorques arm;
        arm.speed = speed;
        for (int i = 0; i < 3; ++i) {
            arm.run(150, 0.0);
            arm.run(50 + 100 * i, 1.0);
        }
        arm.run(150, 0.0);
        EXPECT_EQ(arm.records.size(), 3U) << speed;
    }
}

TEST(SkinTouches, aSkinThatFallsSilentEndsTheTouch) {
    PadWithoutTorques arm;
    arm.run(50, 1.0);
    arm.run(400, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(arm.records.size(), 1U);
    EXPECT_FALSE(arm.touches.liveContact());
    arm.run(200, 1.0);
    EXPECT_EQ(arm.records.size(), 2U);
}

TEST(SkinTouches, whatIsNotUsableIsLeftOutAndAJumpEndsATouch) {
    PadWithoutTorques arm;
    core::JointSample bad;
    bad.angle_rad = JointVector::zeros(7);
    bad.angle_rad[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(arm.touches.update(bad, arm.settings));
    bad.angle_rad = JointVector::zeros(3);
    EXPECT_FALSE(arm.touches.update(bad, arm.settings));
    const SkinContact early{.time_ns = 1, .touching = true, .force_N = 1.0};
    EXPECT_FALSE(arm.touches.update(early, arm.settings)) << "nobody knows where the arm is";
    arm.run(50, 1.0);
    core::JointSample jump;
    jump.time_ns = 2'000'000'000;
    jump.sourceTime_s = 5.0;
    jump.angle_rad = arm.q;
    jump.discontinuity = true;
    EXPECT_FALSE(arm.touches.update(jump, arm.settings));
    EXPECT_FALSE(arm.touches.liveContact());
    SkinTouches nowhere(7, nullptr);
    EXPECT_FALSE(nowhere.update(jump, arm.settings));
    EXPECT_FALSE(nowhere.update(early, arm.settings));
    EXPECT_FALSE(nowhere.liveContact());
}

TEST(SkinTouches, torquesAreThoseThatAreNumbers) {
    core::JointSample sample;
    EXPECT_FALSE(tellsTorques(sample));
    sample.torque_Nm =
        JointVector::of(std::vector<double>(7, std::numeric_limits<double>::quiet_NaN())).value();
    EXPECT_FALSE(tellsTorques(sample));
    sample.torque_Nm[4] = 0.0;
    EXPECT_TRUE(tellsTorques(sample));
}

} // namespace
} // namespace teleta::pipeline
