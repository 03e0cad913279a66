// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/servo/servo_run.h"

#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/scene_recording.h"
#include "backend/scene_run/servo/servo_measures.h"
#include "backend/servo/quaternion_order.h"
#include "backend/simulation/servo/servo_loop.h"
#include "backend/simulation/servo/servo_verdict.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::scene_run {

namespace {

constexpr std::uint64_t kCyclesBetweenReports = 1024;

constexpr std::string_view kServoColumns =
    "time_s,phase,contact,type,force_n,force_desired_n,force_true_n,rim_true_n,peak_n,cop_x_m,cop_y_m,"
    "coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,alpha_z_rad,cop_x_desired_m,cop_y_desired_m,alpha_z_desired_rad,"
    "cop_x_true_m,cop_y_true_m,dzmp_y_true_m,alpha_z_true_rad,x_m,y_m,z_m,qx,qy,qz,qw,x_commanded_m,"
    "y_commanded_m,z_commanded_m,vx_m_per_s,vy_m_per_s,vz_m_per_s,wx_rad_per_s,wy_rad_per_s,wz_rad_per_s,"
    "tray_rad,energy_j,limits,coc_x_desired_m,dzmp_y_desired_m,mass_x_true_m,qx_commanded,qy_commanded,"
    "qz_commanded,qw_commanded";

void addCycle(const simulation::ServoLoop& loop, const ServoMeasures& measures, RunCsv& csv) {
    const contact::TactileFeatures& felt = loop.features();
    const servo::ServoOutput& output = loop.output();
    const simulation::ServoTruth& truth = loop.world().truth();
    const simulation::ServoFrameTruth& frame = loop.world().frameTruth();
    const simulation::ImpedanceArm& arm = loop.world().arm();
    const bool loaded = frame.loads.force_N > 0.0;
    csv.row(truth.time_s, measures.phase(), servo::toString(output.contact), contact::toString(felt.type),
            felt.force_N, measures.desiredForce_N(), truth.force_N, frame.loads.rim_N, felt.peak_N,
            felt.copX_m, felt.copY_m, felt.cocX_m, felt.cocY_m, felt.dzmpX_m, felt.dzmpY_m, felt.alphaZ_rad,
            output.desired[servo::kX], output.desired[servo::kY], output.desired[servo::kWz],
            valueIf(loaded, frame.loads.copX_m), valueIf(loaded, frame.loads.copY_m),
            valueIf(loaded, frame.loads.copX_m - frame.loads.cocX_m), valueIf(loaded, frame.alphaZ_rad),
            arm.X_Base_Sensor().translation(), servo::quaternionXyzw(arm.X_Base_Sensor().linear()),
            arm.X_Base_Reference().translation(), output.twist_Sensor, truth.hinge_rad, arm.energy_J(),
            output.limits.names(), output.desiredCocX_m(), output.desiredDzmpY_m(),
            valueIf(arm.object().turns, truth.massPlace_m),
            servo::quaternionXyzw(arm.X_Base_Reference().linear()));
}

core::Expected<void> writePoints(const std::string& outFolder, const std::vector<Eigen::Vector3d>& points_m) {
    TELETA_TRY(RunCsv csv, RunCsv::open(outFolder, "points.csv", "x_m,y_m,z_m"));
    for (const Eigen::Vector3d& point_m : points_m)
        csv.row(point_m);
    return csv.finish();
}

/// The one contact of a servo's array; its object has the number 0.
class ServoLabels {
public:
    std::span<const ContactLabel> of(const simulation::SimulatedServoWorld& world) {
        const simulation::ServoFrameTruth& truth = world.frameTruth();
        const bool pressed = truth.loads.force_N > 0.0;
        if (pressed != std::exchange(m_pressed, pressed) && pressed)
            ++m_contact.identity;
        if (!pressed)
            return {};
        m_contact.x_m = truth.loads.copX_m;
        m_contact.y_m = truth.loads.copY_m;
        m_contact.force_N = truth.loads.force_N;
        const Eigen::Vector3d p_Base =
            truth.X_Base_Sensor * Eigen::Vector3d(truth.loads.copX_m, truth.loads.copY_m, 0.0);
        const Eigen::Vector3d normal_Sensor =
            truth.X_Base_Sensor.linear().transpose() * world.objectNormal_Base(p_Base);
        m_contact.normal = {normal_Sensor.x(), normal_Sensor.y(), normal_Sensor.z()};
        return {&m_contact, 1};
    }

private:
    ContactLabel m_contact;
    bool m_pressed = false;
};

/// What happens in a run that is worth a line in its summary.
class ServoEvents {
public:
    explicit ServoEvents(nlohmann::ordered_json& events)
        : m_events(events) {}

    void add(const simulation::ServoLoop& loop, bool newPhase, const std::string& phase) {
        const double time_s = loop.world().time_s();
        if (newPhase)
            m_events.push_back({{"time_s", time_s}, {"event", "phase"}, {"phase", phase}});
        const bool touching = loop.world().truth().touching;
        if (touching != std::exchange(m_touching, touching))
            m_events.push_back({{"time_s", time_s}, {"event", touching ? "contact_begins" : "contact_ends"}});
        if (!loop.servoed())
            return;
        if (loop.output().contact == servo::ContactState::lost && !std::exchange(m_lost, true))
            m_events.push_back({{"time_s", time_s}, {"event", "contact_lost"}});
        for (std::size_t i = 0; i < servo::kLimits; ++i) {
            const auto limit = static_cast<servo::Limit>(i);
            if (!loop.output().limits.has(limit) || m_limits[i])
                continue;
            m_limits.set(i);
            m_events.push_back({{"time_s", time_s}, {"event", "limit"}, {"limit", servo::toString(limit)}});
        }
    }

private:
    nlohmann::ordered_json& m_events;
    bool m_touching = false;
    bool m_lost = false;
    std::bitset<servo::kLimits> m_limits;
};

} // namespace

core::Expected<SceneSummary> runServoScene(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(auto made, simulation::ServoLoop::make(scene, options.seed));
    simulation::ServoLoop& loop = *made;
    TELETA_TRY(RunCsv frameLog, RunCsv::openFrames(options.outFolder, scene.taxels().taxels()));
    TELETA_TRY(RunCsv servoLog, RunCsv::open(options.outFolder, "servo.csv", kServoColumns));
    TELETA_TRY(SceneRecording recording, SceneRecording::open(options, scene));
    recording.beginArray(
        {.name = scene.name,
         .layout = scene.taxels(),
         .unit = "N",
         .nominalRate_Hz = std::min(scene.servo().sensor.acquisition_Hz, loop.world().rate_Hz()),
         .simulated = true},
        scene);

    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto cycles = static_cast<std::uint64_t>(std::llround(duration_s * scene.rate_Hz));
    SceneSummary summary;
    ServoMeasures measures(scene);
    simulation::ServoVerdict verdict(scene);
    ServoEvents events(summary.events);
    ServoLabels labels;
    std::uint64_t frames = 0;
    for (std::uint64_t i = 0; i < cycles && !frameLog.failed() && !servoLog.failed(); ++i) {
        summary.interrupted = options.endsAt(i, kCyclesBetweenReports, loop.world().time_s(), duration_s);
        if (summary.interrupted)
            break;
        loop.next();
        const bool newPhase = measures.add(loop);
        verdict.add(loop);
        events.add(loop, newPhase, measures.phase());
        if (loop.frameCame()) {
            ++frames;
            frameLog.row(loop.world().time_s(), loop.frame());
            recording.addFrame(loop.world().time_s(), loop.frame());
            if (options.onFrame)
                options.onFrame({loop.world().time_s(), loop.frame(), labels.of(loop.world())});
        }
        if (loop.servoed() && servoLog.isOpen())
            addCycle(loop, measures, servoLog);
    }
    for (const core::Expected<void>& written : {frameLog.finish(), servoLog.finish(), recording.finish()})
        TELETA_CHECK(written);
    TELETA_CHECK(writePoints(options.outFolder, measures.points_m()));

    summary.takeTimes(loop.world());
    const double cyclesPerTimed =
        static_cast<double>(loop.world().cycle()) / std::max(1.0, static_cast<double>(loop.times().cycles));
    for (std::size_t i = 0; i < servo::kCycleParts; ++i)
        summary.parts.push_back(
            {std::string(servo::kCyclePartNames[i]), loop.times().part_s[i] * cyclesPerTimed});
    measures.report(summary.measures);
    if (!summary.interrupted)
        summary.verdict = {verdict.verdict(),
                           scene.servo().task.expect == scene::ServoExpectation::notCompleted};
    summary.measures["frames"] = frames;
    summary.measures["frames_lost"] = 0;
    return summary;
}

} // namespace teleta::scene_run
