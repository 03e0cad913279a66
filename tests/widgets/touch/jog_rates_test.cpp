// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"
#include "backend/arm/jog_rates.h"
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_arm.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta;
using arm::tipRates;

namespace {

/// Velocity of the tip by a difference of two poses, not by the Jacobian.
Eigen::Vector3d tipVelocity(const core::ArmDescription& arm, const core::JointVector& angle,
                            const core::JointVector& rate) {
    const arm::Arm4Kinematics kinematics({arm.upperArmLength_m, arm.forearmLength_m, arm.halfThickness_m});
    constexpr double kStep_s = 1e-5;
    const auto tip = [&](double t) {
        arm::JointVector q;
        for (int i = 0; i < 4; ++i)
            q[i] = angle[static_cast<std::size_t>(i)] + t * rate[static_cast<std::size_t>(i)];
        return kinematics.p_Base_Point(arm::Link::forearm, q, {arm.forearmLength_m, 0.0, 0.0});
    };
    return (tip(kStep_s) - tip(-kStep_s)) / (2.0 * kStep_s);
}

} // namespace

/// Joint rates that move the tip.
class JogRatesTest : public QObject {
    Q_OBJECT

    static constexpr core::JointVector kBent{0.1, -0.2, 0.3, std::numbers::pi / 2.0};

private slots:
    void theTipMovesAlongTheAskedAxis() {
        const core::ArmDescription arm = test::sampleArm();
        for (const Eigen::Vector3d axis :
             {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}) {
            const Eigen::Vector3d asked = 0.05 * axis;
            const Eigen::Vector3d got = tipVelocity(arm, kBent, tipRates(arm, kBent, asked));
            // The damping of 0.02 m costs (0.02 / lever)^2 of the speed; the shortest lever is over 0.1 m.
            QVERIFY2((got - asked).norm() < 0.05 * asked.norm(),
                     qPrintable(QString::number((got - asked).norm())));
        }
    }

    void noJointIsFasterThanItMayAndTheDirectionStays() {
        const core::ArmDescription arm = test::sampleArm();
        const Eigen::Vector3d asked(2.0, 0.0, 1.0);
        const core::JointVector rate = tipRates(arm, kBent, asked);
        double share = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(std::abs(rate[i]) <= arm.fastest_radPerS[i] * (1.0 + 1e-12));
            share = std::max(share, std::abs(rate[i]) / arm.fastest_radPerS[i]);
        }
        QVERIFY(std::abs(share - 1.0) < 1e-9);
        const Eigen::Vector3d got = tipVelocity(arm, kBent, rate);
        QVERIFY(got.normalized().dot(asked.normalized()) > 0.995);
    }

    void aStretchedArmDoesNotRaceAlongItself() {
        const core::ArmDescription arm = test::sampleArm();
        const core::JointVector rate = tipRates(arm, {}, Eigen::Vector3d(0.2, 0.0, 0.0));
        for (const double joint : rate)
            QVERIFY(std::abs(joint) < 1e-9);
    }

    void whatIsNotANumberMovesNothing() {
        const core::ArmDescription arm = test::sampleArm();
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(tipRates(arm, {0.0, nan, 0.0, 1.0}, Eigen::Vector3d::UnitX()), core::JointVector::zeros(4));
        QCOMPARE(tipRates(arm, kBent, Eigen::Vector3d(nan, 0.0, 0.0)), core::JointVector::zeros(4));
        QCOMPARE(tipRates({}, kBent, Eigen::Vector3d::UnitX()), core::JointVector());
    }
};

namespace {
const test::Registration<JogRatesTest> registration;
}
#include "jog_rates_test.moc"
