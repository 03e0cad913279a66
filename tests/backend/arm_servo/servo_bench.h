// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/motion_limits.h"
#include "backend/arm_servo/arm_servo.h"
#include "backend/arm_servo/pad_arm.h"
#include "tests/backend/pipeline/pad_on_arm.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace teleta::arm_servo::test {

using core::JointVector;

/// The arm with seven joints, bent, its last link and the pad on it looking down.
inline const JointVector kLookingDown_rad{0.2, 0.6, 0.1, -1.2, -0.1, 1.3416, 0.3};

inline core::ArmDescription armWithPad(const arm_model::SerialChain& chain) {
    core::ArmDescription arm;
    arm.name = "robot";
    arm.nominalRate_Hz = 100.0;
    arm.lowest_rad = chain.lowest();
    arm.highest_rad = chain.highest();
    arm.fastest_radPerS = chain.fastest();
    arm.pad = core::PadPlacement{.link = "tool0", .position_m = {0.01, -0.02, 0.03}};
    return arm;
}

/// A simulated arm that follows rates as a robot does: within the usual limits, for 100 ms after a command,
/// and 50 ms late. It presses its pad on something of which force and place are known in closed form.
class ServoBench {
public:
    static constexpr std::int64_t kTick_ns = 33'000'000;
    static constexpr double kLag_s = 0.05;

    /// What touches the pad at a pose.
    using World = std::function<contact::TactileFeatures(const Eigen::Isometry3d& X_Base_Sensor)>;

    ServoBench() { governor.reset(q_rad); }

    /// A contact of so many springs of a taxel with the resultant force at a place of the pad.
    static contact::TactileFeatures touch(double force_N, double x_m, double y_m, int taxels,
                                          contact::ContactType type) {
        contact::TactileFeatures f;
        if (!(force_N > 0.0))
            return f;
        f.type = type;
        f.force_N = force_N;
        f.active = taxels;
        f.peak_N = force_N / taxels;
        f.copX_m = f.cocX_m = x_m;
        f.copY_m = f.cocY_m = y_m;
        f.dzmpX_m = f.dzmpY_m = 0.0;
        f.alphaZ_rad = 0.0;
        return f;
    }

    /// A ball on a rigid table at a place of the base; the pad yields below it: F = k depth.
    static World ball(const Eigen::Vector3d& top_Base, double stiffness_NPerM, int taxels) {
        return [=](const Eigen::Isometry3d& X_Base_Sensor) {
            const Eigen::Vector3d p_Sensor = X_Base_Sensor.inverse() * top_Base;
            return touch(-stiffness_NPerM * p_Sensor.z(), p_Sensor.x(), p_Sensor.y(), taxels,
                         contact::ContactType::point);
        };
    }

    ArmServoInput input() {
        ArmServoInput in;
        in.now_ns = now_ns;
        in.held = held;
        in.stopped = stopped;
        in.jointsOld = jointsOld;
        in.hindered = hindered;
        in.q_rad = q_rad;
        if (!padSilent) {
            ++frame;
            frame_ns = now_ns;
            feels = world(pad->X_Base_Sensor(q_rad));
        }
        in.frame = frame;
        in.frame_ns = frame_ns;
        in.pad = feels;
        return in;
    }

    /// One tick of 33 ms: the servo, then the arm.
    ArmServoStep tick() {
        now_ns += kTick_ns;
        const ArmServoStep step = servo.step(input());
        if (step.rate) {
            command = *step.rate;
            command_ns = now_ns;
            ++posts;
        }
        if (step.rate && std::ranges::any_of(*step.rate, [](double rate) { return rate != 0.0; }))
            ++motions;
        followFor(1e-9 * kTick_ns);
        return step;
    }
    void run(double seconds) {
        for (int i = static_cast<int>(seconds / (1e-9 * kTick_ns)); i > 0; --i)
            newest = tick();
    }
    /// Nothing is asked of the servo for so long.
    void hang(double seconds) { now_ns += static_cast<std::int64_t>(1e9 * seconds); }
    void press() { held = true; }
    void release() { held = false; }
    /// A rehearsal of this length that counts.
    void rehearse(double seconds = 2.0) {
        press();
        run(seconds);
        release();
        run(0.1);
    }

    std::shared_ptr<const arm_model::SerialChain> chain =
        teleta::test::chainOf("resources/arms/seven-joints.urdf");
    core::ArmDescription description = armWithPad(*chain);
    std::shared_ptr<const PadArm> pad = *PadArm::create(chain, description, *description.pad);
    ArmServo servo{chain, pad, core::ArrayLayout{}, contact::FeatureSettings{}};
    JointVector q_rad = kLookingDown_rad;
    World world = [](const Eigen::Isometry3d&) { return contact::TactileFeatures{}; };
    contact::TactileFeatures feels;
    ArmServoStep newest;
    bool held = false;
    bool stopped = false;
    bool jointsOld = false;
    bool hindered = false;
    bool padSilent = false;
    int posts = 0;
    int motions = 0; ///< posts that are not zero

private:
    void followFor(double seconds) {
        constexpr double kStep_s = 0.001;
        for (double t = 0.0; t < seconds; t += kStep_s) {
            sinceCommand_s = 1e-9 * static_cast<double>(now_ns - command_ns) + t;
            arm_model::MotionDemand demand;
            if (!command.empty() && sinceCommand_s < 0.1)
                demand.rate = command;
            demand.stop = stopped;
            const auto step =
                governor.step(demand, {.position = q_rad, .effort = {}, .force_Base_N = {}}, kStep_s);
            for (std::size_t i = 0; i < q_rad.size(); ++i)
                q_rad[i] += kStep_s / kLag_s * (step.commanded[i] - q_rad[i]);
        }
    }

    arm_model::MotionGovernor governor{chain, {}, 0.04};
    JointVector command;
    std::int64_t command_ns = 0;
    double sinceCommand_s = 0.0;
    std::int64_t now_ns = 1'000'000'000;
    std::uint64_t frame = 0;
    std::int64_t frame_ns = 0;
};

} // namespace teleta::arm_servo::test
