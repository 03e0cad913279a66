// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/simulated_arm.h"

#include "backend/simulation/arm/unknown_places.h"
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::simulation {

namespace {

using arm::JointVector;

JointVector toVector(const core::JointVector& values) {
    return Eigen::Map<const JointVector>(values.data());
}

core::JointVector toJoints(const JointVector& vector) {
    return {vector[0], vector[1], vector[2], vector[3]};
}

std::vector<TouchedBody> bodiesOf(const scene::Scene& scene) {
    const auto* nonlinear = scene.listed<scene::NonlinearObjectSpec>();
    std::vector<TouchedBody> bodies;
    for (const scene::ArmObject& object : scene.arm().objects) {
        TouchedBody body{.outline = OutlineGeometry(object),
                         .stiffness_NPerM = object.stiffness_NPerM,
                         .doublingDepth_m = {}};
        if (nonlinear != nullptr)
            body.doublingDepth_m = nonlinear->doublingDepth_m;
        bodies.push_back(std::move(body));
    }
    return bodies;
}

core::SkinPlacement placementOf(const scene::ArmWorld& world) {
    return {.centreDistance_m = world.skin.centreDistance_m,
            .centreSide_rad = world.skin.centreSide_rad,
            .radius_m = world.body.halfThickness_m,
            .centreSe_m = world.skin.centreSe_m};
}

core::ArmDescription describeArm(const scene::Scene& scene) {
    const scene::ArmBody& body = scene.arm().body;
    core::ArmDescription description;
    description.name = scene.name;
    description.nominalRate_Hz = scene.rate_Hz;
    description.simulated = true;
    description.upperArmLength_m = body.upperArmLength_m;
    description.forearmLength_m = body.forearmLength_m;
    description.halfThickness_m = body.halfThickness_m;
    description.elbowStiffness_NmPerRad = body.jointStiffness_NmPerRad[3];
    description.elbowStiffnessSe_NmPerRad = body.elbowStiffnessSe_NmPerRad;
    std::copy_n(body.jointStiffness_NmPerRad.begin(), description.shoulderStiffness_NmPerRad.size(),
                description.shoulderStiffness_NmPerRad.begin());
    description.skin = placementOf(scene.arm());
    description.lowest_rad = body.lowest_rad;
    description.highest_rad = body.highest_rad;
    description.fastest_radPerS = body.fastest_radPerS;
    description.hasProgram = true;
    // An object whose place is to be found is not shown.
    if (scene.arm().unknown.spread_m > 0.0)
        return description;
    for (const scene::ArmObject& object : scene.arm().objects) {
        core::WorldObject& told = description.objects.emplace_back();
        told.name = object.name;
        told.z_m = object.z_m;
        for (const Eigen::Vector2d& corner : OutlineGeometry(object).drawnCorners_m())
            told.outline_m.push_back({corner.x(), corner.y()});
    }
    return description;
}

std::uint64_t samplesPerFrame(const scene::Scene& scene) {
    return static_cast<std::uint64_t>(std::max(1.0, std::round(scene.rate_Hz / scene.arm().skin.rate_Hz)));
}

} // namespace

core::Expected<std::unique_ptr<SimulatedArm>> SimulatedArm::make(const scene::Scene& scene,
                                                                 std::uint64_t seed) {
    TELETA_CHECK(checkArmScene(scene));
    scene::Scene drawn = scene;
    drawn.arm().objects = drawPlaces(scene.arm(), seed);
    return std::unique_ptr<SimulatedArm>(new SimulatedArm(drawn, seed));
}

SimulatedArm::SimulatedArm(const scene::Scene& scene, std::uint64_t seed)
    : m_body(scene.arm().body)
    , m_description(describeArm(scene))
    , m_skinDescription{.name = scene.name,
                        .layout = scene.arm().skin.layout,
                        .unit = "N",
                        .nominalRate_Hz = scene.rate_Hz / static_cast<double>(samplesPerFrame(scene)),
                        .simulated = true}
    , m_step_s(1.0 / scene.rate_Hz)
    , m_firingThreshold_N(scene.arm().skin.firingThreshold_N)
    , m_samplesPerFrame(samplesPerFrame(scene))
    , m_arm(scene.arm().body, scene.arm().control, bodiesOf(scene))
    , m_program(makeProgram(scene.arm(), m_arm))
    , m_sheet(scene.arm().skin.layout, m_description.skin)
    , m_jointEffects(makeEffects<scene::ActsOn::joints>(scene, seed))
    , m_skinEffects(makeEffects<scene::ActsOn::taxels>(scene, seed, 1.0 / m_skinDescription.nominalRate_Hz))
    , m_nonlinearObjects(scene.listed<scene::NonlinearObjectSpec>() != nullptr)
    , m_load_N(scene.arm().skin.layout.taxels()) {
    for (const scene::ArmObject& object : scene.arm().objects)
        m_objects.push_back({.name = object.name,
                             .stiffness_NPerM = object.stiffness_NPerM,
                             .shape = object.outline,
                             .outline = OutlineGeometry(object)});
    restart();
}

void SimulatedArm::restart() {
    m_sample = 0;
    m_frameDue = false;
    m_programLeft = false;
    m_program->restart();
    m_reference_rad = toVector(m_body.start_rad);
    m_reading_Nm.setZero();
    m_openTouch.assign(m_objects.size(), -1);
    m_truth = {};
    m_truth.present.assign(m_objects.size(), true);
    updatePresence();
    m_arm.rest(m_reference_rad);
    updateTruth();
    m_jointEffects.restart();
    m_skinEffects.restart();
}

double SimulatedArm::time_s() const {
    return static_cast<double>(m_sample) * m_step_s;
}

void SimulatedArm::next(const core::ArmDemand& demand, core::JointSample& sample) {
    ++m_sample;
    moveReference(demand);
    updatePresence();
    m_arm.step(m_step_s, m_reference_rad,
               m_program->pushTorque_Nm(m_arm.kinematics(), m_arm.state().link_rad));
    updateTruth();

    JointReading reading{.angle_rad = m_arm.state().motor_rad, .torque_Nm = m_arm.torque_Nm()};
    m_jointEffects.apply(
        [&](JointEffect& effect) { effect.apply(m_arm.state().link_rad, m_arm.state().motor_rad, reading); });
    m_reading_Nm = reading.torque_Nm;
    sample.sourceTime_s = time_s();
    sample.angle_rad = toJoints(reading.angle_rad);
    sample.torque_Nm = toJoints(reading.torque_Nm);
    sample.reference_rad = toJoints(m_reference_rad);

    m_frameDue = m_sample % m_samplesPerFrame == 0;
    if (m_frameDue)
        readSkin();
}

void SimulatedArm::moveReference(const core::ArmDemand& demand) {
    switch (demand.drive) {
    case core::ArmDrive::stopped:
    case core::ArmDrive::held:
        return;
    case core::ArmDrive::jog:
        jog(demand.rate_radPerS);
        m_programLeft = true;
        return;
    case core::ArmDrive::program:
        if (std::exchange(m_programLeft, false))
            m_program->takeOver(m_reference_rad);
        m_program->advance(m_step_s, m_reading_Nm, m_reference_rad);
        return;
    }
}

void SimulatedArm::jog(const core::JointVector& rate_radPerS) {
    for (std::size_t j = 0; j < scene::ArmBody::kJoints; ++j) {
        const auto row = static_cast<Eigen::Index>(j);
        const double rate =
            std::isnan(rate_radPerS[j])
                ? 0.0
                : std::clamp(rate_radPerS[j], -m_body.fastest_radPerS[j], m_body.fastest_radPerS[j]);
        const double torque_Nm = m_reading_Nm[row];
        if (std::abs(torque_Nm) > m_body.highestTorque_Nm && rate * torque_Nm > 0.0)
            continue;
        m_reference_rad[row] =
            std::clamp(m_reference_rad[row] + rate * m_step_s, m_body.lowest_rad[j], m_body.highest_rad[j]);
    }
}

void SimulatedArm::updatePresence() {
    const std::optional<std::size_t> only = m_program->onlyObject();
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        m_truth.present[i] = !only || *only == i;
        m_arm.setPresent(i, m_truth.present[i]);
    }
}

std::uint64_t SimulatedArm::presentObjects() const {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(m_truth.present.size(), 64); ++i)
        bits |= static_cast<std::uint64_t>(m_truth.present[i]) << i;
    return bits;
}

void SimulatedArm::updateTruth() {
    m_truth.link_rad = m_arm.state().link_rad;
    m_truth.torque_Nm = m_arm.torque_Nm();
    m_truth.contacts.clear();
    const Eigen::Isometry3d X_Base_Forearm =
        m_arm.kinematics().X_Base_Link(arm::Link::forearm, m_truth.link_rad);
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const BodyContact& contact = m_arm.contacts()[i];
        if (!m_truth.present[i] || !(contact.force_N > 0.0)) {
            if (m_openTouch[i] >= 0)
                m_truth.touches[static_cast<std::size_t>(m_openTouch[i])].end_s = time_s();
            m_openTouch[i] = -1;
            continue;
        }
        const Eigen::Vector3d p_Forearm_Contact =
            Eigen::Vector3d(contact.along_m, 0.0, 0.0) -
            m_body.halfThickness_m * (X_Base_Forearm.linear().transpose() * contact.normal);
        m_truth.contacts.push_back({.object = i,
                                    .force_N = contact.force_N,
                                    .depth_m = contact.depth_m,
                                    .contactDistance_m = p_Forearm_Contact.x(),
                                    .side_rad = std::atan2(-p_Forearm_Contact.y(), p_Forearm_Contact.z()),
                                    .p_Base_Contact_m = X_Base_Forearm * p_Forearm_Contact,
                                    .normal = contact.normal});
        if (m_openTouch[i] < 0) {
            m_openTouch[i] = static_cast<std::ptrdiff_t>(m_truth.touches.size());
            m_truth.touches.push_back({.object = i, .begin_s = time_s(), .end_s = {}, .strongest = {}});
        }
        ArmContactTruth& strongest = m_truth.touches[static_cast<std::size_t>(m_openTouch[i])].strongest;
        if (contact.force_N > strongest.force_N)
            strongest = m_truth.contacts.back();
    }
}

void SimulatedArm::readSkin() {
    std::ranges::fill(m_load_N, 0.0);
    for (const ArmContactTruth& contact : m_truth.contacts)
        m_sheet.press(contact.contactDistance_m, contact.side_rad, contact.force_N, m_load_N);
    m_skinEffects.read(m_load_N, m_firingThreshold_N);
}

bool SimulatedArm::skinFrame(std::span<float> values) {
    if (!m_frameDue)
        return false;
    std::ranges::transform(m_load_N, values.begin(),
                           [](double load_N) { return static_cast<float>(load_N); });
    return true;
}

double SimulatedArm::outlineDistance_m(std::size_t object, const Eigen::Vector2d& p_Base_Point_m) const {
    return m_objects[object].outline.distance(p_Base_Point_m).distance_m;
}

std::vector<EffectTime> SimulatedArm::effectTimes() const {
    std::vector<EffectTime> times;
    // Part of the contact itself, which is not timed apart.
    if (m_nonlinearObjects)
        times.push_back({.name = scene::NonlinearObjectSpec::kRow.name, .time_s = 0.0});
    times.insert(times.end(), m_jointEffects.times().begin(), m_jointEffects.times().end());
    times.insert(times.end(), m_skinEffects.times().begin(), m_skinEffects.times().end());
    return times;
}

} // namespace teleta::simulation
