// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/arm_program.h"

#include "backend/simulation/arm/hanging_posture.h"
#include "backend/simulation/arm/probing_program.h"
#include "backend/simulation/arm/smooth_move.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace teleta::simulation {

namespace {

using arm::JointVector;
using Eigen::Vector2d;

constexpr double kSearchStep_rad = 0.005;
constexpr double kSearchRange_m = 1.0;

/// Where a function that falls below zero somewhere in low .. high, above zero at low, does so. Bisection to
/// the last bit.
template <typename Function>
double crossing(double low, double high, const Function& above) {
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (above(middle) > 0.0 ? low : high) = middle;
    }
    return high;
}

class ElbowTouches : public ProbingProgram {
public:
    ElbowTouches(const scene::TouchProgram& program, const scene::ArmBody& body, const FlexibleArm& arm)
        : ProbingProgram({.approachSpeed = program.approach_radPerS,
                          .clearance = program.clearance_rad,
                          .retract = program.retract_rad,
                          .beyond = 0.2,
                          .torqueLimit_Nm = program.torqueLimit_Nm,
                          .hold_s = program.hold_s,
                          .travel_radPerS = program.travel_radPerS,
                          .travelSpeed = program.travel_radPerS},
                         arm.bodies().size())
        , m_start_rad(Eigen::Map<const JointVector>(body.start_rad.data())) {
        for (const TouchedBody& object : arm.bodies())
            m_contact_rad.push_back(contactAngle_rad(arm, object, body));
    }

    [[nodiscard]] std::optional<std::size_t> onlyObject() const override {
        return std::min(probe(), m_contact_rad.size() - 1);
    }

protected:
    [[nodiscard]] JointVector referenceAt(double position) const override {
        JointVector reference_rad = m_start_rad;
        reference_rad[3] = m_contact_rad[probe()] + position;
        return reference_rad;
    }

private:
    /// Angle of the elbow at which it first meets the object on its way up from where it starts; the end of
    /// its range when it meets nothing.
    [[nodiscard]] double contactAngle_rad(const FlexibleArm& arm, const TouchedBody& object,
                                          const scene::ArmBody& body) const {
        const auto gap_m = [&](double elbow_rad) {
            JointVector q_rad = m_start_rad;
            q_rad[3] = elbow_rad;
            return -arm.contactAt(q_rad, object).depth_m;
        };
        const double end_rad = body.highest_rad[3];
        for (double elbow_rad = m_start_rad[3]; elbow_rad < end_rad; elbow_rad += kSearchStep_rad) {
            const double next_rad = std::min(elbow_rad + kSearchStep_rad, end_rad);
            if (gap_m(next_rad) <= 0.0)
                return crossing(elbow_rad, next_rad, gap_m);
        }
        return end_rad;
    }

    JointVector m_start_rad;
    std::vector<double> m_contact_rad;
};

class ContourTouches : public ProbingProgram {
public:
    ContourTouches(const scene::ContourProgram& program, const scene::ArmBody& body, const FlexibleArm& arm)
        : ProbingProgram({.approachSpeed = program.approach_mPerS,
                          .clearance = program.clearance_m,
                          .retract = program.retract_m,
                          .beyond = 0.02,
                          .torqueLimit_Nm = program.torqueLimit_Nm,
                          .hold_s = program.hold_s,
                          // Around the object the joints turn about twice as fast as the elbow goes.
                          .travel_radPerS = 2.0 * program.travel_mPerS / body.upperArmLength_m,
                          .travelSpeed = program.travel_mPerS},
                         static_cast<std::size_t>(program.directions))
        , m_kinematics(arm.kinematics())
        , m_centre_m(arm.bodies().front().outline.centre_m()) {
        const OutlineGeometry& outline = arm.bodies().front().outline;
        for (int i = 0; i < program.directions; ++i) {
            const double angle_rad = program.startAngle_rad + 2.0 * std::numbers::pi * i / program.directions;
            const Vector2d outwards(std::cos(angle_rad), std::sin(angle_rad));
            const auto inside_m = [&](double distance_m) {
                return m_kinematics.dimensions().halfThickness_m -
                       outline.distance(m_centre_m + distance_m * outwards).distance_m;
            };
            m_ways.push_back({outwards, crossing(0.0, kSearchRange_m, inside_m)});
        }
    }

protected:
    [[nodiscard]] JointVector referenceAt(double position) const override {
        const Way& way = m_ways[std::min(probe(), m_ways.size() - 1)];
        return hangingPosture(m_kinematics.dimensions(),
                              m_centre_m + (way.contact_m - position) * way.outwards);
    }

    [[nodiscard]] JointVector travelAt(const JointVector& from_rad, double share) const override {
        const JointVector end_rad = ProbingProgram::travelAt(from_rad, 1.0);
        const Vector2d from_m = elbowAt_m(m_kinematics, from_rad);
        const JointVector hanging_rad = hangingPosture(m_kinematics.dimensions(), from_m);
        if ((hanging_rad - from_rad).lpNorm<Eigen::Infinity>() > 1e-6)
            return from_rad + share * (end_rad - from_rad);
        // The forearm keeps hanging, on a straight way: that stays outside of a convex object.
        const Vector2d to_m = elbowAt_m(m_kinematics, end_rad);
        return hangingPosture(m_kinematics.dimensions(), from_m + share * (to_m - from_m));
    }

private:
    struct Way {
        Vector2d outwards;
        double contact_m; ///< distance of the elbow from the centre when the forearm meets the outline
    };

    arm::Arm4Kinematics m_kinematics;
    Vector2d m_centre_m;
    std::vector<Way> m_ways;
};

class Yielding : public ArmProgram {
public:
    explicit Yielding(const scene::YieldProgram& program)
        : m_program(program) {
        for (const scene::Waypoint& waypoint : program.waypoints)
            m_end_s = std::max(m_end_s, waypoint.time_s);
        for (const scene::Push& push : program.pushes)
            m_end_s = std::max(m_end_s, push.time_s + push.duration_s);
    }

    void advance(double step_s, const JointVector&, JointVector& reference_rad) override {
        if (done())
            return;
        m_time_s += step_s;
        const auto next = std::ranges::find_if(m_program.waypoints, [this](const scene::Waypoint& waypoint) {
            return waypoint.time_s > m_time_s;
        });
        if (next == m_program.waypoints.end()) {
            if (!m_program.waypoints.empty() && m_leg >= 0)
                reference_rad =
                    Eigen::Map<const JointVector>(m_program.waypoints.back().reference_rad.data());
            return;
        }
        // From where the references are: a reference that somebody moved comes back without a jump.
        const std::ptrdiff_t leg = next - m_program.waypoints.begin();
        if (leg != m_leg) {
            m_leg = leg;
            m_from_rad = reference_rad;
            m_legStart_s = m_time_s - step_s;
        }
        const double share = SmoothMove::shareAt(m_time_s - m_legStart_s, next->time_s - m_legStart_s);
        reference_rad =
            m_from_rad + share * (Eigen::Map<const JointVector>(next->reference_rad.data()) - m_from_rad);
    }

    void takeOver(const JointVector&) override { m_leg = -1; }

    [[nodiscard]] bool done() const override { return m_time_s >= m_end_s; }

    void restart() override {
        m_time_s = 0.0;
        m_leg = -1;
    }

    [[nodiscard]] JointVector pushTorque_Nm(const arm::Arm4Kinematics& kinematics,
                                            const JointVector& q_rad) const override {
        JointVector torque_Nm = JointVector::Zero();
        for (const scene::Push& push : m_program.pushes) {
            const double share = (m_time_s - push.time_s) / push.duration_s;
            if (!(share > 0.0 && share < 1.0))
                continue;
            const Eigen::Vector3d force_N(push.forceX_N, push.forceY_N, push.forceZ_N);
            torque_Nm +=
                kinematics.pointJacobian(arm::Link::forearm, q_rad, {push.distance_m, 0.0, 0.0}).transpose() *
                force_N * std::sin(std::numbers::pi * share);
        }
        return torque_Nm;
    }

private:
    scene::YieldProgram m_program;
    double m_end_s = 0.0;
    double m_time_s = 0.0;
    double m_legStart_s = 0.0;
    JointVector m_from_rad = JointVector::Zero();
    std::ptrdiff_t m_leg = -1; ///< waypoint that is the aim; -1: none yet
};

} // namespace

std::unique_ptr<ArmProgram> makeProgram(const scene::ArmWorld& world, const FlexibleArm& arm) {
    if (const auto* touch = std::get_if<scene::TouchProgram>(&world.program))
        return std::make_unique<ElbowTouches>(*touch, world.body, arm);
    if (const auto* contour = std::get_if<scene::ContourProgram>(&world.program))
        return std::make_unique<ContourTouches>(*contour, world.body, arm);
    if (const auto* yields = std::get_if<scene::YieldProgram>(&world.program))
        return std::make_unique<Yielding>(*yields);
    // An operator leads the arm from elsewhere (TeleoperatedArm): it does nothing by itself.
    return std::make_unique<Yielding>(scene::YieldProgram{});
}

} // namespace teleta::simulation
