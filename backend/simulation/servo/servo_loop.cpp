// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/servo_loop.h"

#include "backend/core/steady_time.h"
#include "backend/servo/arm/lwr_arm.h"

#include <algorithm>
#include <utility>

namespace teleta::simulation {

namespace {

constexpr double kBounce_s = 0.2;

} // namespace

servo::ServoPlan servoPlan(const scene::Scene& scene) {
    const scene::ServoTaskSettings& task = scene.servo().task;
    servo::ServoPlan plan;
    switch (task.kind) {
    case scene::ServoTaskKind::exploreEdge:
        plan = servo::explorePlan(task.force_N, task.slide_mPerS, task.moment);
        break;
    case scene::ServoTaskKind::point:
        plan = servo::pointPlan(task.force_N);
        break;
    case scene::ServoTaskKind::roll:
        plan = servo::rollPlan(task.force_N, task.rollAngle_rad, task.rollPeriod_s);
        break;
    case scene::ServoTaskKind::comanipulate:
        plan = servo::comanipulationPlan(task.force_N);
        break;
    }
    plan.tasks.front().feedForward.constant_Sensor[2] = task.approach_mPerS;
    // Where the arm arrives it may bounce once; that is no loss of contact, and to come back faster would
    // make it bounce again.
    plan.search.lostAfter_s = kBounce_s;
    plan.search.speed_mPerS = task.approach_mPerS;
    const scene::ArraySensor& array = scene.servo().sensor.array;
    const double compliance_mPerN =
        1.0 / scene.servo().arm.stiffness_NPerM + 1.0 / (array.layout.columns * array.stiffness_NPerM);
    for (servo::ServoTask& each : plan.tasks) {
        each.normalCompliance_mPerN = compliance_mPerN;
        each.desired.copY_m = task.copY_m;
        each.limits.saturation_N =
            each.limits.saturation_N ? std::optional(scene.fullScale_N()) : std::nullopt;
    }
    return plan;
}

contact::FeatureSettings servoFeatures(const scene::Scene& scene) {
    contact::FeatureSettings settings;
    settings.range = contact::MomentRange::active;
    if (scene.servo().sensor.array.firingThreshold_N > 0.0)
        settings.threshold_N = scene.servo().sensor.array.firingThreshold_N;
    return settings;
}

core::Expected<std::unique_ptr<ServoLoop>> ServoLoop::make(const scene::Scene& scene, std::uint64_t seed) {
    TELETA_TRY(std::unique_ptr<SimulatedServoWorld> world, SimulatedServoWorld::make(scene, seed));
    auto controller = servo::ServoController::create(
        servoPlan(scene), std::make_shared<servo::LwrArm>(world->arm().kinematics()));
    // checkServoScene keeps the task within the controller's range.
    return std::unique_ptr<ServoLoop>(new ServoLoop(scene, std::move(world), std::move(controller).value()));
}

ServoLoop::ServoLoop(const scene::Scene& scene, std::unique_ptr<SimulatedServoWorld> world,
                     servo::ServoController controller)
    : m_world(std::move(world))
    , m_images(scene.servo().sensor.images_Hz, scene.rate_Hz)
    , m_servo(scene.servo().sensor.servo_Hz, scene.rate_Hz)
    , m_servoStep_s(1.0 / scene.rate_Hz)
    , m_extractor(scene.taxels(), servoFeatures(scene))
    , m_controller(std::move(controller))
    , m_frame(scene.taxels().taxels())
    , m_load_N(scene.taxels().taxels()) {
}

void ServoLoop::restart() {
    m_world->restart();
    m_extractor.reset();
    m_controller.reset();
    m_features = {};
    m_output = {};
    m_times = {};
    m_lastServo = 0;
    m_frameCame = m_frameWaits = m_servoed = false;
}

void ServoLoop::next(bool hold) {
    if ((m_world->cycle() + 1) % servo::CycleTimes::kEvery != 0) {
        cycle(hold, nullptr);
        return;
    }
    servo::CycleTimes times;
    const std::int64_t start_ns = core::steadyNow_ns();
    cycle(hold, &times);
    const double whole_s = 1e-9 * static_cast<double>(core::steadyNow_ns() - start_ns);
    times.of(servo::CyclePart::dynamics) = std::max(0.0, whole_s - times.sum_s());
    m_times.add(times);
}

void ServoLoop::cycle(bool hold, servo::CycleTimes* times) {
    m_world->next(times);
    m_frameCame = m_world->frame(m_frame);
    m_frameWaits = m_frameWaits || m_frameCame;
    const std::uint64_t cycle = m_world->cycle();
    if (m_frameWaits && m_images.isDue(cycle)) {
        m_frameWaits = false;
        const servo::CycleTimer timer(times, servo::CyclePart::features);
        std::ranges::transform(m_frame, m_load_N.begin(), [](float value) { return std::max(value, 0.0F); });
        m_features = m_extractor.compute(m_load_N);
    }
    m_servoed = m_servo.isDue(cycle);
    if (!m_servoed)
        return;
    servo::ServoInput input;
    input.features = m_features;
    input.dt_s = static_cast<double>(cycle - m_lastServo) * m_servoStep_s;
    input.X_Base_Sensor = m_world->arm().X_Base_Sensor();
    input.q_rad = servo::jointVector(m_world->arm().state().q_rad);
    input.hold = hold;
    m_lastServo = cycle;
    {
        const servo::CycleTimer timer(times, servo::CyclePart::control);
        m_output = m_controller.step(input);
    }
    m_world->setReference(m_output.X_Base_Sensor);
}

} // namespace teleta::simulation
