// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/first_touch.h"

#include <gtest/gtest.h>

#include <array>

using teleta::contact::Contact;
using teleta::view3d::FirstTouch;

namespace {

Contact at(int id, double x_m, double y_m) {
    Contact contact;
    contact.id = id;
    contact.x_m = x_m;
    contact.y_m = y_m;
    return contact;
}

} // namespace

TEST(FirstTouch, theStartIsWhereAnIdentityWasFirstSeen) {
    FirstTouch touches;
    touches.update(std::array{at(1, 0.01, 0.02)}, 0.0);
    touches.update(std::array{at(2, -0.01, 0.0), at(1, 0.03, 0.02)}, 0.01);
    EXPECT_EQ(touches.startOf(1), Eigen::Vector2d(0.01, 0.02));
    EXPECT_EQ(touches.startOf(2), Eigen::Vector2d(-0.01, 0.0));
    EXPECT_EQ(touches.startOf(3), std::nullopt);
}

TEST(FirstTouch, aShortAbsenceIsTheSameTouchAndALongOneIsNot) {
    FirstTouch touches;
    touches.update(std::array{at(1, 0.01, 0.0)}, 1.0);
    touches.update({}, 1.0 + 0.5 * FirstTouch::kMemory_s);
    touches.update(std::array{at(1, 0.02, 0.0)}, 1.0 + 0.9 * FirstTouch::kMemory_s);
    EXPECT_EQ(touches.startOf(1), Eigen::Vector2d(0.01, 0.0));
    touches.update({}, 1.0 + 2.0 * FirstTouch::kMemory_s);
    EXPECT_EQ(touches.startOf(1), std::nullopt);
}

TEST(FirstTouch, aTimeThatGoesBackIsAnotherStretchOfTheRecording) {
    FirstTouch touches;
    touches.update(std::array{at(1, 0.01, 0.0)}, 5.0);
    touches.update(std::array{at(1, 0.04, 0.0)}, 4.0);
    EXPECT_EQ(touches.startOf(1), Eigen::Vector2d(0.04, 0.0));
}

TEST(FirstTouch, contactsWithoutIdentityHaveNoStart) {
    FirstTouch touches;
    touches.update(std::array{at(0, 0.01, 0.0)}, 0.0);
    EXPECT_EQ(touches.startOf(0), std::nullopt);
}
