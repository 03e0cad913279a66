// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/number_text.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/simulation/arm/flexible_arm.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace teleta::cost {

namespace {

constexpr double kSegment_s = 0.01;
constexpr std::size_t kSegments = 50;
constexpr double kElbowBent_rad = 2.0;

scene::ArmBody touchingBody() {
    scene::ArmBody body;
    body.start_rad = {0.5 * std::numbers::pi, 0.0, 0.0, kElbowBent_rad};
    return body;
}

/// The paper's rubber in the way of the forearm, half a millimetre from it.
std::vector<simulation::TouchedBody> rubberPost(const scene::ArmBody& body) {
    constexpr double kDistance_m = 0.17;
    constexpr double kRadius_m = 0.02;
    constexpr double kRubber_NPerM = 7223.9;
    const Eigen::Vector2d along(std::cos(kElbowBent_rad), std::sin(kElbowBent_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d centre_m = Eigen::Vector2d(body.upperArmLength_m, 0.0) + kDistance_m * along +
                                     (body.halfThickness_m + kRadius_m + 0.0005) * across;
    scene::ArmObject object;
    object.name = "post";
    object.outline = scene::RoundOutline{kRadius_m};
    object.x_m = centre_m.x();
    object.y_m = centre_m.y();
    object.stiffness_NPerM = kRubber_NPerM;
    return {{.outline = simulation::OutlineGeometry(object),
             .stiffness_NPerM = kRubber_NPerM,
             .doublingDepth_m = {}}};
}

simulation::FlexibleArm touchingArm() {
    const scene::ArmBody body = touchingBody();
    return {body, scene::PositionControl{60.0}, rubberPost(body)};
}

/// The elbow closes by 0.03 rad within 0.3 s, starting and ending at rest, and presses on the post.
arm::JointVector elbowReference_rad(double time_s) {
    const double share = std::clamp(time_s / 0.3, 0.0, 1.0);
    arm::JointVector reference(0.5 * std::numbers::pi, 0.0, 0.0, kElbowBent_rad);
    reference[3] += 0.03 * share * share * (3.0 - 2.0 * share);
    return reference;
}

/// Moves on by one segment in steps as near to step_s as divide it.
void advance(simulation::FlexibleArm& arm, std::size_t segment, double step_s, bool implicit) {
    const auto steps = std::max(1L, std::lround(kSegment_s / step_s));
    const double h_s = kSegment_s / static_cast<double>(steps);
    for (long i = 1; i <= steps; ++i) {
        const arm::JointVector reference_rad =
            elbowReference_rad(kSegment_s * static_cast<double>(segment) + h_s * static_cast<double>(i));
        if (implicit)
            arm.step(h_s, reference_rad);
        else
            arm.stepExplicitly(h_s, reference_rad);
    }
}

using TorqueTruth = std::vector<arm::JointVector>;

/// Joint torques at the end of each segment: explicit steps of 4 and 2 us, and what is left of the error of
/// first order taken off (Richardson).
TorqueTruth fineSolution() {
    TorqueTruth truth;
    simulation::FlexibleArm coarse = touchingArm();
    simulation::FlexibleArm fine = touchingArm();
    for (std::size_t segment = 0; segment < kSegments; ++segment) {
        advance(coarse, segment, 4e-6, false);
        advance(fine, segment, 2e-6, false);
        truth.push_back(2.0 * fine.torque_Nm() - coarse.torque_Nm());
    }
    return truth;
}

Rung stepRung(double step_ms, bool implicit, const std::shared_ptr<const TorqueTruth>& truth) {
    // A trial that is timed again begins where it began the first time.
    const auto starts = std::make_shared<std::vector<simulation::FlexibleArm>>();
    for (simulation::FlexibleArm arm = touchingArm(); starts->size() < kSegments;) {
        starts->push_back(arm);
        advance(arm, starts->size() - 1, 1e-3 * step_ms, implicit);
    }
    auto run = [=](Trial& trial) {
        const std::size_t segment = trial.index() % kSegments;
        simulation::FlexibleArm arm = (*starts)[segment];
        trial.timed(1, [&] { advance(arm, segment, 1e-3 * step_ms, implicit); });
        trial.error((arm.torque_Nm() - (*truth)[segment]).lpNorm<Eigen::Infinity>());
    };
    const std::string step(core::NumberText(step_ms).view());
    return {(implicit ? "implicit-" : "explicit-") + step + "ms", "step " + step + " ms", std::move(run)};
}

} // namespace

Ladder simulationStepLadder() {
    Ladder ladder;
    ladder.name = "simulation-step";
    ladder.topic = Topic::simulation;
    ladder.title = LadderText::tr("10 ms of an arm that touches rubber").toStdString();
    ladder.truth = LadderText::tr("largest difference of a joint's torque from a solution with steps of 2 us")
                       .toStdString();
    ladder.errorUnit = "Nm";
    ladder.trials = kSegments;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const auto truth = std::make_shared<const TorqueTruth>(fineSolution());
        std::vector<Rung> rungs;
        // Longer explicit steps are not stable: a joint's damping over its inertia is 1/33 us.
        for (const double step_ms : {0.01, 0.02, 0.05})
            rungs.push_back(stepRung(step_ms, false, truth));
        for (const double step_ms : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0})
            rungs.push_back(stepRung(step_ms, true, truth));
        // Where the forearm is: no step can be taken without it, and 10 ms need one at least.
        const auto arm = std::make_shared<const simulation::FlexibleArm>(touchingArm());
        constexpr std::size_t kCalls = 64;
        rungs.push_back(limitRung("place of the forearm once", kCalls, [=](std::size_t index) {
            arm::JointVector angles_rad = arm->state().link_rad;
            angles_rad[3] += 1e-6 * static_cast<double>(index);
            return arm->kinematics().X_Base_Link(arm::Link::forearm, angles_rad).translation().x();
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
