// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/joint_vector.h"
#include "backend/core/interface.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/wakeup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::core {

/// One reading of all joints.
struct JointSample {
    std::int64_t time_ns = 0;   ///< steady clock at the read
    double sourceTime_s = 0.0;  ///< the arm's own time (recording or simulated time)
    JointVector angle_rad;      ///< at the motor's side of the joint
    JointVector torque_Nm;      ///< of the joint torque sensors, weight of the links taken off
    JointVector reference_rad;  ///< where the controller was told to go
    bool discontinuity = false; ///< the stream jumped before this sample
    /// Steady clock when it came from another computer, which read it; 0: it was read by this one.
    std::int64_t arrived_ns = 0;
};

/// What acts on an arm as a sensor of force and torque at its wrist measured it, at the arm's tip and along
/// the tip's axes: x, y, z.
struct WrenchSample {
    std::int64_t time_ns = 0;  ///< steady clock at the read
    double sourceTime_s = 0.0; ///< the sensor's own time
    std::array<double, 3> force_N{};
    std::array<double, 3> torque_Nm{}; ///< about the tip
};

/// How the sheet of the tactile skin lies around the forearm, a cylinder about its x axis. A taxel at (x, y)
/// of the sheet's frame {s}, z out of the skin, is at
///   distance from the elbow  centreDistance_m + x,   side  centreSide_rad - y / radius_m
/// with the side as in arm::Arm4Kinematics::p_Link_Skin. The minus keeps {s} right-handed.
struct SkinPlacement {
    double centreDistance_m = 0.0;
    double centreSide_rad = 0.0;
    double radius_m = 0.0; ///< > 0
    /// Standard error of a contact's centre that stays when the press is repeated, from a calibration run of
    /// this skin. What its threshold hides is known without, see pipeline::setPlaceErrors().
    double centreSe_m = 0.0;

    [[nodiscard]] double distance_m(double x_m) const { return centreDistance_m + x_m; }
    [[nodiscard]] double side_rad(double y_m) const { return centreSide_rad - y_m / radius_m; }
    [[nodiscard]] double x_m(double distance) const { return distance - centreDistance_m; }
    /// side: within pi of centreSide_rad.
    [[nodiscard]] double y_m(double side) const { return (centreSide_rad - side) * radius_m; }
};

/// From which torques the touches of an arm are told and evaluated.
struct TouchTorques {
    double windowLow_Nm = 0.02; ///< the stiffness is that between these two
    double windowHigh_Nm = 0.05;
    double threshold_Nm = 0.05;    ///< more is a touch
    double noiseFloor_Nm = 0.0025; ///< noise does not reach it; at most windowLow_Nm
};

/// A flat pad of taxels on a link of an arm that a URDF describes. A taxel at (x, y) of the pad's frame {s},
/// z out of the pad, is there in the link's frame too:
///   X_Link_Sensor = translation(position_m) Rz(yaw) Ry(pitch) Rx(roll)
struct PadPlacement {
    std::string link;
    std::array<double, 3> position_m{};
    std::array<double, 3> rollPitchYaw_rad{};
    /// Whose torque and angle give the stiffness, as the URDF names it; empty: the last joint before the pad
    /// that presses it.
    std::string joint = {};
    JointVector jointStiffness_NmPerRad = {}; ///< of each joint; 0, or none at all: taken as rigid
    double centreSe_m = 0.0;                  ///< as SkinPlacement::centreSe_m
    TouchTorques torques = {};
};

/// Something upright in a simulated world, for views: its outline in a plane z = z_m of the base.
struct WorldObject {
    std::string name;
    std::vector<std::array<double, 2>> outline_m; ///< x, y of at least three corners in order; closed
    double z_m = 0.0;
};

/// What a remote arm is; constant while it is open.
struct ArmDescription {
    std::string name;
    double nominalRate_Hz = 1000.0; ///< of the joint samples
    bool simulated = false;
    bool recorded = false;
    double upperArmLength_m = 0.0;
    double forearmLength_m = 0.0;
    double halfThickness_m = 0.0;
    double elbowStiffness_NmPerRad = 0.0; ///< of joint and link: k_ri P_C^2 at any distance P_C
    double elbowStiffnessSe_NmPerRad = 0.0;
    /// Of the three shoulder joints; 0: taken as rigid.
    std::array<double, 3> shoulderStiffness_NmPerRad{};
    SkinPlacement skin;
    std::optional<PadPlacement> pad; ///< in place of the skin and all lengths: the arm is known by its URDF
    JointVector lowest_rad;          ///< range of the joints
    JointVector highest_rad;
    JointVector fastest_radPerS; ///< limit of each joint's speed
    bool hasProgram = false;     ///< the arm can move by a program of its own (a simulated scene)
    /// Something at the robot ends a motion when no more commands come. Without it the arm goes on when this
    /// program ends or the network is cut: whoever looks at the arm has to know.
    bool guarded = true;
    /// Of a simulated world that is no secret; which of them are there now, presentObjects() says.
    std::vector<WorldObject> objects;

    [[nodiscard]] std::size_t joints() const { return lowest_rad.size(); }
};

/// What moves the arm.
enum class ArmDrive {
    stopped, ///< STOP is engaged
    held,    ///< stands still under control
    program, ///< its own program
    jog,     ///< the operator
};

/// Joint rates that the operator asks for. A command expires after kJogLifetime_ns, so that the arm stops
/// when the operator releases the dead-man switch, the program hangs or the link breaks.
struct ArmCommand {
    static constexpr std::int64_t kJogLifetime_ns = 100'000'000;

    JointVector rate_radPerS;
    std::int64_t time_ns = 0; ///< steady time at which it was given
};

/// A remote arm with joint torque sensors and a tactile skin: facade over a worker thread.
/// Thread: start and stop from one controlling thread; joints() is drained by one consumer; post(),
/// setProgramRunning() and restartProgram() from one commanding thread (the GUI's), they return at once;
/// the rest by any.
class ArmSource : public Interface {
public:
    [[nodiscard]] virtual const ArmDescription& description() const = 0;
    /// Starts the worker, which notifies the consumer after each batch of samples. The skin starts with it.
    virtual void start(Wakeup& consumer) = 0;
    /// Ends the worker and waits for it. Idempotent.
    virtual void stop() = 0;
    [[nodiscard]] virtual BoundedQueue<JointSample>& joints() = 0;
    /// The consumer waits for something that one of the next samples tells: it is to be notified of each one,
    /// instead of once a batch. A source whose batches are what it received at once ignores it. Thread: the
    /// consumer's.
    virtual void wakeAtEachSample(bool /*each*/) {}
    /// What the sensor of force and torque measures, for the same consumer; null: the arm has none. The
    /// consumer is not notified of them alone.
    [[nodiscard]] virtual BoundedQueue<WrenchSample>* wrenches() { return nullptr; }
    /// rate_Hz, framesRead and framesLost count joint samples.
    [[nodiscard]] virtual DeviceStatus status() const = 0;
    [[nodiscard]] virtual ArmDrive drive() const = 0;
    /// Why commands do not move it now, a translated sentence without a full stop; empty: nothing is in the
    /// way that it knows of.
    [[nodiscard]] virtual std::string hindrance() const { return {}; }
    /// Bit i: ArmDescription::objects[i] is there now.
    [[nodiscard]] virtual std::uint64_t presentObjects() const { return 0; }

    // An arm that takes no commands ignores them.
    /// The latest command wins. NaN counts as zero, speeds are limited to the description's, a joint at the
    /// end of its range moves back only. A rate other than zero takes the arm from its program.
    virtual void post(const ArmCommand& /*command*/) {}
    /// Resumes or holds the program. Ignored without a program.
    virtual void setProgramRunning(bool /*running*/) {}
    /// Restarts the program, and the world of a simulation.
    virtual void restartProgram() {}
};

/// What a simulated arm has to do in one step.
struct ArmDemand {
    ArmDrive drive = ArmDrive::held;
    JointVector rate_radPerS{}; ///< with jog
};

/// What a simulated arm at another site has sent and the link has delivered.
struct ArmArrival {
    JointSample sample;
    bool hasFrame = false;
    std::vector<float> frame; ///< of the skin, read with the sample
};

/// Losses on that link since the start.
struct ArmLinkCounters {
    std::uint64_t commandsLost = 0;
    std::uint64_t samplesLost = 0;
    std::uint64_t framesLost = 0; ///< of the skin
};

/// Makes the joint samples and skin frames of a simulated arm, one call a joint period. The device paces the
/// calls, stamps the samples and keeps the limits; the generator knows only simulated time. Deterministic:
/// same seed, same demands, same samples. Thread: one.
class ArmGenerator {
public:
    virtual ~ArmGenerator() = default;
    [[nodiscard]] virtual ArmDescription description() const = 0;
    [[nodiscard]] virtual SourceDescription skinDescription() const = 0;
    /// Advances by 1/nominalRate_Hz and writes angle, torque, reference and sourceTime_s.
    virtual void next(const ArmDemand& demand, JointSample& sample) = 0;
    /// The skin's frame if one was read in the last step: skinDescription().layout.taxels() values. False:
    /// none was due, values are untouched.
    virtual bool skinFrame(std::span<float> values) = 0;
    [[nodiscard]] virtual double time_s() const = 0;
    /// The program has ended; further program steps hold the arm.
    [[nodiscard]] virtual bool programDone() const = 0;
    virtual void restart() = 0;
    /// As ArmSource::presentObjects().
    [[nodiscard]] virtual std::uint64_t presentObjects() const { return 0; }

    /// The arm is at another site: takeArrival() gives what reaches the operator; ignore the samples and
    /// frames of next() and skinFrame().
    [[nodiscard]] virtual bool isRemote() const { return false; }
    /// Takes the next arrival, which is time_s() - sample.sourceTime_s old. False: there is none.
    virtual bool takeArrival(ArmArrival&) { return false; }
    [[nodiscard]] virtual ArmLinkCounters linkCounters() const { return {}; }
};

} // namespace teleta::core
