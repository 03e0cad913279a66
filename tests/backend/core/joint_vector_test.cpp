// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/joint_vector.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

using teleta::core::JointVector;

TEST(JointVector, holdsAnyNumberOfJointsUpToItsCapacity) {
    for (const std::size_t count : {0U, 4U, 7U, 16U}) {
        std::vector<double> values(count);
        for (std::size_t joint = 0; joint < count; ++joint)
            values[joint] = 0.5 + static_cast<double>(joint);
        const auto joints = JointVector::of(values);
        ASSERT_TRUE(joints) << count;
        EXPECT_EQ(joints->size(), count);
        EXPECT_EQ(joints->empty(), count == 0);
        EXPECT_TRUE(std::ranges::equal(*joints, values)) << count;
        EXPECT_EQ(JointVector::zeros(count).size(), count);
    }
}

TEST(JointVector, refusesMoreJointsThanItsCapacity) {
    EXPECT_FALSE(JointVector::of(std::vector<double>(17, 1.0)));
    static_assert(std::is_constructible_v<JointVector, double, double, double, double>);
    static_assert(std::is_constructible_v<JointVector, int, int, int, int, int, int, int, int, int, int, int,
                                          int, int, int, int, int>);
    static_assert(!std::is_constructible_v<JointVector, int, int, int, int, int, int, int, int, int, int, int,
                                           int, int, int, int, int, int>);
}

TEST(JointVector, readsZeroPastItsCount) {
    const JointVector joints{1.0, 2.0, 3.0, 4.0};
    EXPECT_EQ(joints[3], 4.0);
    EXPECT_EQ(joints[4], 0.0);
    EXPECT_EQ(joints[15], 0.0);
}

TEST(JointVector, isEqualWhenCountAndNumbersAre) {
    EXPECT_EQ((JointVector{1.0, 2.0}), (JointVector{1.0, 2.0}));
    EXPECT_NE((JointVector{1.0, 2.0}), (JointVector{1.0, 2.5}));
    EXPECT_NE((JointVector{0.0, 0.0}), JointVector::zeros(3));
    EXPECT_NE(JointVector(), JointVector::zeros(4));
}

TEST(JointVector, needsNoHeap) {
    static_assert(std::is_trivially_copyable_v<JointVector>);
    static_assert(JointVector{1.0, 2.0}[1] == 2.0);
}
