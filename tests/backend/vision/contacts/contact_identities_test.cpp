// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/contact_identities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace teleta::vision {
namespace {

constexpr double kPeriod_s = 0.025;

CameraContact at(double angle_rad, double z_m, double depth_m = 0.001) {
    CameraContact contact;
    contact.located = true;
    contact.p_Sensor_Centre_m = {0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad), z_m};
    contact.depth_m = depth_m;
    return contact;
}

int idAt(const std::vector<FollowedContact>& followed, const CameraContact& place) {
    for (const FollowedContact& contact : followed) {
        if (contact.seen && (contact.contact.p_Sensor_Centre_m - place.p_Sensor_Centre_m).norm() < 1e-12)
            return contact.contact.id;
    }
    return 0;
}

} // namespace

TEST(ContactIdentities, stayWhenTheOrderChangesAndAcrossTheSeamOfTheAngle) {
    ContactIdentities identities;
    (void)identities.update({at(3.10, 0.02), at(0.0, 0.05)}, 0.0, kPeriod_s);
    const auto& followed = identities.update({at(0.05, 0.05), at(-3.10, 0.021)}, kPeriod_s, kPeriod_s);
    EXPECT_EQ(idAt(followed, at(-3.10, 0.021)), 1);
    EXPECT_EQ(idAt(followed, at(0.05, 0.05)), 2);
}

TEST(ContactIdentities, giveTheDisplacementFromTheStart) {
    ContactIdentities identities;
    (void)identities.update({at(0.0, 0.02)}, 0.0, kPeriod_s);
    const auto& followed = identities.update({at(0.1, 0.025)}, kPeriod_s, kPeriod_s);
    EXPECT_NEAR(followed.front().displacement_m().z(), 0.005, 1e-12);
    EXPECT_NEAR(followed.front().displacement_m().y(), 0.025 * std::sin(0.1), 1e-12);
}

TEST(ContactIdentities, surviveAShortAbsenceAndEndAfterALongOne) {
    ContactIdentities identities({.gate_m = 0.012, .memory_s = 0.06});
    (void)identities.update({at(0.0, 0.02)}, 0.0, kPeriod_s);
    EXPECT_FALSE(identities.update({}, 0.025, kPeriod_s).front().seen);
    EXPECT_EQ(identities.update({at(0.0, 0.02)}, 0.05, kPeriod_s).front().contact.id, 1);
    (void)identities.update({}, 0.075, kPeriod_s);
    (void)identities.update({}, 0.100, kPeriod_s);
    EXPECT_EQ(identities.update({}, 0.125, kPeriod_s).front().event, ContactEvent::ends);
    EXPECT_TRUE(identities.update({}, 0.150, kPeriod_s).empty());
    EXPECT_EQ(identities.update({at(0.0, 0.02)}, 0.175, kPeriod_s).front().contact.id, 2);
}

TEST(ContactIdentities, countAJumpBeyondTheGateAsAnotherContact) {
    ContactIdentities identities;
    (void)identities.update({at(0.0, 0.02)}, 0.0, kPeriod_s);
    const auto& followed = identities.update({at(0.0, 0.05)}, kPeriod_s, kPeriod_s);
    EXPECT_EQ(idAt(followed, at(0.0, 0.05)), 2);
}

TEST(ContactIdentities, passOverContactsWithoutAPlace) {
    ContactIdentities identities;
    EXPECT_TRUE(identities.update({CameraContact()}, 0.0, kPeriod_s).empty());
}

TEST(ContactIdentities, giveTheSpeedAtWhichTheSkinOfAContactDeepens) {
    ContactIdentities identities;
    CameraContact first = at(0.0, 0.02, 0.001);
    first.deepened_m = 0.0002; // it was there before, but too light to be seen
    EXPECT_NEAR(identities.update({first}, kPeriod_s, kPeriod_s).front().depthRate.atLeast_mPerS(), 0.008,
                1e-12);
    EXPECT_NEAR(identities.update({at(0.0, 0.02, 0.0012)}, 2 * kPeriod_s, kPeriod_s)
                    .front()
                    .depthRate.atLeast_mPerS(),
                0.008, 1e-12);
}

} // namespace teleta::vision
