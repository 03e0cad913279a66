// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <mujoco/mujoco.h>
#include <span>
#include <string>
#include <vector>

namespace teleta::peer {

/// Where a link is in another one: metres; quaternion x, y, z, w.
struct LinkFrame {
    std::string parent;
    std::string child;
    std::array<double, 3> position_m{};
    std::array<double, 4> rotation_xyzw{};
};

/// A ball that stands in the world on a vertical slide with a spring: its force on what presses it down by d
/// is stiffness d. Beside that it is damped a tenth of critically, and nothing weighs it down.
struct SoftObject {
    std::array<double, 3> position_m{}; ///< of its centre at rest
    double stiffness_NPerM = 0;         ///< > 0
};

/// An arm in MuJoCo, which reads the URDF itself. Each joint has a velocity servo of 120 Nm s/rad that gives
/// at most 90 Nm, damping 1 Nm s/rad and armature 0.1 kg m2 (N, m and kg for sliding joints); gravity is
/// taken off exactly. Links do not collide. A moving link without mass weighs 0.1 kg. Functions throw
/// std::runtime_error. Thread: one at a time.
class ArmPhysics {
public:
    static constexpr double kStep_s = 0.001;
    static constexpr int kRows = 14;
    static constexpr int kColumns = 6;
    static constexpr double kPitch_m = 0.0034;
    static constexpr double kObjectRadius_m = 0.012;

    /// `tip`: the link of the force sensor and of the pad; empty: the last link of the file.
    /// `withPad`: 84 touch sensors in the plane z = 0 of the tip, columns along x, rows along y, and a ball
    /// on a slide that presses on them along -z. With objects the pad is one hard plate instead, and no ball
    /// presses on it: an object touches it in a point, which one taxel feels, or two. Objects need a pad.
    ArmPhysics(const std::string& urdf, const std::string& tip, bool withPad,
               const std::vector<SoftObject>& objects = {});
    ~ArmPhysics();
    ArmPhysics(const ArmPhysics&) = delete;
    ArmPhysics& operator=(const ArmPhysics&) = delete;

    /// The movable joints in the order of the file.
    [[nodiscard]] const std::vector<std::string>& joints() const { return m_joints; }
    [[nodiscard]] const std::vector<LinkFrame>& fixedFrames() const { return m_fixedFrames; }
    /// Where the links are that joints move, in the root of the tree, which stands in the world's origin.
    [[nodiscard]] std::vector<LinkFrame> movingFrames();
    [[nodiscard]] const std::string& tip() const { return m_tip; }

    /// Puts the arm there, at rest.
    void place(std::span<const double> position_rad);
    /// Goes on by kStep_s with these set velocities of the servos.
    void step(std::span<const double> velocity_radPerS);
    [[nodiscard]] std::vector<double> position_rad() const;
    [[nodiscard]] std::vector<double> velocity_radPerS() const;
    /// The torque of the servos. With gravity: and that which carries the arm.
    [[nodiscard]] std::vector<double> effort_Nm(bool withGravity) const;
    /// What torque sensors between the gears and the links feel in the last step, without what carries the
    /// arm: the torque of the servos, less what the joints' damping and armature take of it.
    [[nodiscard]] const std::vector<double>& sensorTorque_Nm() const { return m_sensorTorque_Nm; }
    /// Force (N) and torque (Nm) that act on the tip from outside (its weight too), in its frame, about its
    /// origin.
    [[nodiscard]] std::array<double, 6> wrench() const;
    /// Normal force of each taxel in N, row by row; empty without a pad.
    [[nodiscard]] std::vector<double> taxels_N() const;
    /// How far each object is pressed down.
    [[nodiscard]] std::vector<double> depth_m() const;

    /// A force on the tip's origin, in the world's axes, until it is set again.
    void push(const std::array<double, 3>& force_N) { m_push_N = force_N; }
    /// The force with which the ball presses on the pad, 0 or more.
    void press(double force_N) { m_press_N = force_N; }

private:
    void load(const std::string& urdf, bool withPad, const std::vector<SoftObject>& objects);
    [[nodiscard]] std::vector<double> ofJoints(const mjtNum* values) const;

    struct DeleteModel {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
    };
    struct DeleteData {
        void operator()(mjData* data) const { mj_deleteData(data); }
    };
    std::unique_ptr<mjModel, DeleteModel> m_model;
    std::unique_ptr<mjData, DeleteData> m_data;
    std::vector<std::string> m_joints;
    std::vector<LinkFrame> m_fixedFrames;
    std::vector<std::string> m_movingLinks;
    std::string m_root;
    std::string m_tip;
    std::vector<int> m_positions;  ///< of each joint in qpos
    std::vector<int> m_velocities; ///< in qvel
    std::vector<int> m_servos;     ///< in ctrl
    std::vector<int> m_touches;    ///< in sensordata
    std::vector<int> m_objects;    ///< of each slide in qpos
    int m_site = -1;
    int m_force = -1;
    int m_torque = -1;
    int m_ball = -1;
    std::vector<double> m_sensorTorque_Nm;
    std::array<double, 3> m_push_N{};
    double m_press_N = 0;
};

} // namespace teleta::peer
