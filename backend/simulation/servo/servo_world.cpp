// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/servo_world.h"

#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/effects/border_stiffening.h"
#include "backend/simulation/effects/housing_rim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace teleta::simulation {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kHingeGravity_mPerS2 = 9.81;

Isometry3d mount(const scene::ServoArm& arm) {
    Isometry3d X_Flange_Sensor = Isometry3d::Identity();
    X_Flange_Sensor.translation().z() = arm.mountLength_m;
    return X_Flange_Sensor;
}

servo::LwrVector startOf(const scene::ServoArm& arm) {
    return Eigen::Map<const servo::LwrVector>(arm.start_rad.data());
}

ElasticArray arrayOf(const scene::Scene& scene) {
    const scene::ArraySensor& sensor = scene.servo().sensor.array;
    std::vector<double> factors;
    if (const auto* stiffening = scene.listed<scene::BorderStiffeningSpec>())
        factors = borderStiffness(*stiffening, sensor.layout);
    std::vector<RimSide> rim;
    if (const auto* spec = scene.listed<scene::HousingRimSpec>())
        rim = housingRim(*spec, sensor.layout);
    return ElasticArray(sensor.layout, sensor.stiffness_NPerM, scene.servo().object.stiffness_NPerM, factors,
                        rim);
}

/// A number of an effect; 0 when the scene does not list it.
template <typename Spec>
double listedOr0(const scene::Scene& scene, double Spec::*number) {
    const Spec* spec = scene.listed<Spec>();
    return spec == nullptr ? 0.0 : spec->*number;
}

TouchedObject objectOf(const scene::ServoWorld& world, std::uint64_t seed) {
    const scene::ServoObject& spec = world.object;
    core::RandomStream random(seed, "object_pose");
    const auto within = [&random](double bound) { return bound * (2.0 * random.uniform() - 1.0); };
    const double y_m = spec.y_m + within(spec.spread.y_m);
    const double gap_m = spec.gap_m + within(spec.spread.gap_m);
    const double yaw_rad = spec.yaw_rad + within(spec.spread.yaw_rad);
    const double pitch_rad = spec.pitch_rad + within(spec.spread.pitch_rad);

    // The object's z looks at the array, against the array's own.
    Isometry3d X_Start_Object = Isometry3d::Identity();
    X_Start_Object.linear() =
        (Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch_rad, Vector3d::UnitY()) *
         Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()))
            .toRotationMatrix();
    X_Start_Object.translation() = Vector3d(spec.x_m, y_m, gap_m);
    TouchedObject object;
    object.shape = makeShape(spec.shape);
    object.X_Base_Object =
        servo::LwrKinematics(mount(world.arm)).X_Base_Tool(startOf(world.arm)) * X_Start_Object;
    if (spec.hinge) {
        object.turns = true;
        object.axis_Base = object.X_Base_Object.linear().col(1);
        object.p_Base_Hinge = object.X_Base_Object * Vector3d(0.0, 0.0, -spec.hinge->height_m);
        object.damping_NmsPerRad = spec.hinge->damping_NmsPerRad;
    }
    return object;
}

/// Where the mass is: smooth between keyframes, at rest at each.
double massPlace_m(const std::vector<scene::MassKeyframe>& motion, double time_s) {
    const auto next = std::ranges::upper_bound(motion, time_s, {}, &scene::MassKeyframe::time_s);
    if (next == motion.begin())
        return motion.front().x_m;
    const scene::MassKeyframe& from = *(next - 1);
    if (next == motion.end())
        return from.x_m;
    const double share = (time_s - from.time_s) / (next->time_s - from.time_s);
    return from.x_m + (next->x_m - from.x_m) * share * share * (3.0 - 2.0 * share);
}

double halfTurn(double angle_rad) {
    const double rest = std::remainder(angle_rad, std::numbers::pi);
    return rest <= -0.5 * std::numbers::pi ? rest + std::numbers::pi : rest;
}

} // namespace

core::Expected<std::unique_ptr<SimulatedServoWorld>> SimulatedServoWorld::make(const scene::Scene& scene,
                                                                               std::uint64_t seed) {
    TELETA_CHECK(checkServoScene(scene));
    return std::unique_ptr<SimulatedServoWorld>(new SimulatedServoWorld(scene, seed));
}

SimulatedServoWorld::SimulatedServoWorld(const scene::Scene& scene, std::uint64_t seed)
    : m_world(scene.servo())
    , m_step_s(1.0 / scene.rate_Hz)
    , m_acquisition(m_world.sensor.acquisition_Hz, scene.rate_Hz)
    , m_arm(mount(m_world.arm),
            {.stiffness_NPerM = m_world.arm.stiffness_NPerM,
             .rotationalStiffness_NmPerRad = m_world.arm.rotationalStiffness_NmPerRad,
             .dampingRatio = m_world.arm.dampingRatio,
             .contactDampingTime_s = listedOr0(scene, &scene::ContactDampingSpec::time_s),
             .friction = listedOr0(scene, &scene::FrictionSpec::coefficient)},
            arrayOf(scene), objectOf(m_world, seed))
    , m_effects(makeEffects<scene::ActsOn::taxels>(scene, seed, 1.0 / m_world.sensor.acquisition_Hz))
    , m_load_N(m_world.sensor.array.layout.taxels()) {
    for (const scene::Effect& effect : scene.effects) {
        if (rowOf(effect).actsOn == scene::ActsOn::carriedArray)
            m_contactEffects.push_back(scene::nameOf(effect));
    }
    restart();
}

void SimulatedServoWorld::restart() {
    m_cycle = 0;
    m_frameDue = false;
    ImpedanceState state;
    state.q_rad = startOf(m_world.arm);
    m_arm.setState(state);
    moveMass();
    updateTruth();
    m_effects.restart();
}

void SimulatedServoWorld::moveMass() {
    if (!m_world.object.hinge)
        return;
    const scene::TrayHinge& hinge = *m_world.object.hinge;
    m_truth.massPlace_m = massPlace_m(hinge.motion, time_s());
    const Vector3d arm_m = m_truth.massPlace_m * m_arm.X_Base_Object().linear().col(0);
    const Vector3d weight_N(0.0, 0.0, -hinge.mass_kg * kHingeGravity_mPerS2);
    m_arm.setHinge(hinge.inertia_kgm2 + hinge.mass_kg * m_truth.massPlace_m * m_truth.massPlace_m,
                   m_arm.object().axis_Base.dot(arm_m.cross(weight_N)));
}

void SimulatedServoWorld::next(servo::CycleTimes* times) {
    ++m_cycle;
    moveMass();
    m_arm.step(m_step_s, times);
    updateTruth();
    m_frameDue = m_acquisition.isDue(m_cycle);
    if (m_frameDue)
        readArray(times);
}

void SimulatedServoWorld::updateTruth() {
    m_truth.time_s = time_s();
    m_truth.force_N = -m_arm.contact().wrench_Sensor.z();
    m_truth.touching = m_arm.contact().springs > 0;
    m_truth.hinge_rad = m_arm.state().hinge_rad;
}

void SimulatedServoWorld::readArray(servo::CycleTimes* times) {
    const Isometry3d X_Sensor_Object = m_arm.X_Base_Sensor().inverse(Eigen::Isometry) * m_arm.X_Base_Object();
    {
        const servo::CycleTimer timer(times, servo::CyclePart::contact);
        m_frameTruth.loads = m_arm.array().readLoads(X_Sensor_Object, m_arm.object().shape, m_load_N);
    }
    m_frameTruth.X_Base_Sensor = m_arm.X_Base_Sensor();
    m_frameTruth.alphaZ_rad.reset();
    std::optional<Vector3d> along;
    if (const auto* bar = std::get_if<BarSurface>(&m_arm.object().shape)) {
        const Isometry3d X_Object_Sensor = X_Sensor_Object.inverse(Eigen::Isometry);
        const Vector3d p_Object_Contact =
            X_Object_Sensor * Vector3d(m_frameTruth.loads.copX_m, m_frameTruth.loads.copY_m, 0.0);
        along = X_Sensor_Object.linear() * bar->tangentAt(p_Object_Contact.x());
    } else if (std::holds_alternative<EdgeSurface>(m_arm.object().shape)) {
        along = X_Sensor_Object.linear().col(0);
    }
    if (along)
        m_frameTruth.alphaZ_rad = halfTurn(std::atan2(along->y(), along->x()));

    m_effects.read(m_load_N, m_world.sensor.array.firingThreshold_N);
}

bool SimulatedServoWorld::frame(std::span<float> load_N) const {
    if (!m_frameDue)
        return false;
    std::ranges::transform(m_load_N, load_N.begin(), [](double value) { return static_cast<float>(value); });
    return true;
}

double SimulatedServoWorld::contourDistance_m(const Vector3d& p_Base) const {
    const Vector3d p_Object = m_arm.X_Base_Object().inverse(Eigen::Isometry) * p_Base;
    if (const auto* bar = std::get_if<BarSurface>(&m_arm.object().shape))
        return bar->lineDistance_m(p_Object);
    if (std::holds_alternative<EdgeSurface>(m_arm.object().shape))
        return p_Object.tail<2>().norm();
    return std::abs(std::visit([&](const auto& shape) { return depthIn(shape, p_Object).depth_m; },
                               m_arm.object().shape));
}

Vector3d SimulatedServoWorld::objectNormal_Base(const Vector3d& p_Base) const {
    const Eigen::Isometry3d& X_Base_Object = m_arm.X_Base_Object();
    const Vector3d p_Object = X_Base_Object.inverse(Eigen::Isometry) * p_Base;
    return X_Base_Object.linear() *
           std::visit([&](const auto& shape) { return depthIn(shape, p_Object).normal; },
                      m_arm.object().shape);
}

std::vector<EffectTime> SimulatedServoWorld::effectTimes() const {
    std::vector<EffectTime> times;
    for (const std::string_view name : m_contactEffects)
        times.push_back({.name = name, .time_s = 0.0});
    times.insert(times.end(), m_effects.times().begin(), m_effects.times().end());
    return times;
}

} // namespace teleta::simulation
