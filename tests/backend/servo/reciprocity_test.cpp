// SPDX-License-Identifier: GPL-3.0-or-later
// Table C.3: for each contact type, a commanded motion does no work against the wrench that the contact can
// bear, and a commanded force moves only in directions in which the contact allows no motion.
#include "tests/backend/servo/servo_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace teleta::servo;
using namespace teleta::servo::test;
using teleta::contact::ContactType;

namespace {

class Numbers {
public:
    double within(double bound) { return m_one(m_random) * bound; }
    Eigen::Isometry3d pose() {
        Twist xi;
        for (double& value : xi)
            value = within(1.0);
        return expSE3(xi);
    }

private:
    std::mt19937_64 m_random{5};
    std::uniform_real_distribution<double> m_one{-1.0, 1.0};
};

/// Table C.3, for a contact frame with z along the normal and, for an edge, x along it: for each component
/// either no force (the motion is free) or no motion (the force can be commanded). The row "mu_z = w_z = 0"
/// of a point is both at once.
struct NaturalConstraints {
    std::array<bool, 6> noForce{};
    std::array<bool, 6> noMotion{};
};

NaturalConstraints naturalConstraints(ContactType type) {
    if (type == ContactType::point)
        return {{true, true, false, true, true, true}, {false, false, true, false, false, true}};
    return {{true, true, false, true, false, true}, {false, false, true, false, true, false}};
}

/// The wrench that a contact can bear, in its frame: forces and moments where the table says no motion.
Wrench contactWrench(ContactType type, Numbers& numbers) {
    Wrench wrench = Wrench::Zero();
    const NaturalConstraints constraints = naturalConstraints(type);
    for (std::size_t i = 0; i < 6; ++i)
        if (constraints.noMotion[i] && !constraints.noForce[i])
            wrench[static_cast<Eigen::Index>(i)] = numbers.within(10.0);
    return wrench;
}

void expectReciprocal(ServoTask task, ContactType type, const teleta::contact::TactileFeatures& features,
                      Numbers& numbers) {
    task.limits.toolSpeed_mPerS = 10.0;
    task.limits.turnRate_radPerS = 10.0;
    const Eigen::Isometry3d X_Base_Sensor = numbers.pose();
    ServoController controller = controllerOf(task);
    const ServoOutput out = controller.step(inputOf(features, 0.01, X_Base_Sensor));
    ASSERT_GT(out.twist_Sensor.norm(), 0.0);
    const Eigen::Isometry3d X_Sensor_Contact(Eigen::Translation3d(*features.cocX_m, *features.cocY_m, 0.0));
    for (int round = 0; round < 10; ++round) {
        const Wrench wrench_Contact = contactWrench(type, numbers);
        const Wrench wrench_Sensor = wrenchTo(X_Sensor_Contact, wrench_Contact);
        const double scale = out.twist_Sensor.norm() * wrench_Contact.norm();
        EXPECT_NEAR(out.twist_Sensor.dot(wrench_Sensor), 0.0, 1e-14 * scale) << toString(task.kind);
        // The same in the base, by the adjoint and its dual.
        EXPECT_NEAR(out.twist_Base.dot(wrenchTo(X_Base_Sensor, wrench_Sensor)), 0.0, 1e-13 * scale);
    }
}

/// The twist at the contact caused by a single error.
Twist atContact(const ServoTask& task, const teleta::contact::TactileFeatures& features) {
    ServoController controller = controllerOf(task);
    const Twist twist = controller.step(inputOf(features)).twist_Sensor;
    return twistTo(Eigen::Isometry3d(Eigen::Translation3d(-*features.cocX_m, -*features.cocY_m, 0.0)), twist);
}

} // namespace

TEST(Reciprocity, motionsAtAPointDoNoWorkAgainstItsForce) {
    Numbers numbers;
    ServoTask turning = pointFollowingTask(3.0);
    turning.projection.wx = true;
    turning.projection.wy = true;
    turning.gains.proportional[kWx] = 3.0;
    turning.gains.proportional[kWy] = -3.0;
    for (int round = 0; round < 50; ++round) {
        const double x = numbers.within(0.02);
        const double y = numbers.within(0.008);
        const auto f = feel(ContactType::point, 3.0, x, y, x, y);
        expectReciprocal(turning, ContactType::point, f, numbers);
        expectReciprocal(rollTask(3.0, 0.3, 8.0), ContactType::point, f, numbers);
    }
}

TEST(Reciprocity, motionsAlongAnEdgeDoNoWorkAgainstItsForceAndMoment) {
    Numbers numbers;
    for (int round = 0; round < 50; ++round) {
        // Evenly loaded: DZMP is zero, so that the turn about y, which is force control, does not act.
        const double x = numbers.within(0.01);
        const double y = numbers.within(0.008);
        const auto f = feel(ContactType::edge, 5.0, x, y, x, y, numbers.within(0.5));
        expectReciprocal(exploreTask(5.0, 0.005), ContactType::edge, f, numbers);
        expectReciprocal(edgeControlTask(5.0), ContactType::edge, f, numbers);
    }
}

TEST(Reciprocity, anErrorOfForceMovesOnlyAlongTheNormal) {
    const Twist point = atContact(pointFollowingTask(3.0), feel(ContactType::point, 2.0, 0.0, 0.0, 0.0, 0.0));
    EXPECT_GT(point[kZ], 0.0);
    EXPECT_EQ((point - Twist::Unit(kZ) * point[kZ]).norm(), 0.0);
    const Twist edge = atContact(edgeControlTask(5.0), feel(ContactType::edge, 6.0, 0.0, 0.0, 0.0, 0.0));
    EXPECT_LT(edge[kZ], 0.0);
    EXPECT_EQ((edge - Twist::Unit(kZ) * edge[kZ]).norm(), 0.0);
}

TEST(Reciprocity, anErrorOfMomentTurnsOnlyAboutTheContactsY) {
    const Twist edge = atContact(edgeControlTask(5.0), feel(ContactType::edge, 5.0, 0.007, 0.0, 0.005, 0.0));
    EXPECT_GT(edge[kWy], 0.0);
    EXPECT_LE((edge - Twist::Unit(kWy) * edge[kWy]).norm(), 1e-18);
}
