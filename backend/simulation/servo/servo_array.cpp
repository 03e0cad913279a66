// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/servo_array.h"

#include "backend/simulation/servo/servo_loop.h"
#include "backend/simulation/servo/servo_verdict.h"
#include "backend/simulation/servo/touched_shape.h"

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::simulation {

namespace {

constexpr double kRecent_s = 1.0;

class ServoArray : public core::FrameGenerator {
public:
    ServoArray(const scene::Scene& scene, std::unique_ptr<ServoLoop> loop,
               std::shared_ptr<servo::ServoLink> link)
        : m_loop(std::move(loop))
        , m_newVerdict(scene)
        , m_verdict(m_newVerdict)
        , m_link(std::move(link))
        , m_plan(m_loop->controller().plan())
        , m_bounds(servo::boundsOf(m_plan))
        , m_tuning(servo::tuningOf(m_plan))
        , m_description{.name = scene.name,
                        .layout = m_loop->world().layout(),
                        .unit = "N",
                        .nominalRate_Hz =
                            std::min(scene.servo().sensor.acquisition_Hz, m_loop->world().rate_Hz()),
                        .simulated = true} {
        m_lastActed_s.fill(-kRecent_s - 1.0);
        m_link->body = bodyOf(scene.servo().object);
    }

    [[nodiscard]] core::SourceDescription description() const override { return m_description; }

    void next(std::span<float> values, bool motionHeld) override {
        takeWishes(motionHeld);
        do {
            m_loop->next(motionHeld);
            if (!motionHeld)
                m_verdict.add(*m_loop);
            if (m_loop->servoed())
                report(motionHeld);
        } while (!m_loop->frameCame());
        std::ranges::copy(m_loop->frame(), values.begin());
    }

    [[nodiscard]] double time_s() const override { return m_loop->world().time_s(); }

    void restart() override {
        m_loop->restart();
        ++m_restarts;
        m_verdict = m_newVerdict;
        m_lastActed_s.fill(-kRecent_s - 1.0);
    }

private:
    void takeWishes(bool motionHeld) {
        if (const auto tuning = m_link->tuning.take())
            tune(*tuning);
        const auto task = m_link->task.take();
        if (task && !motionHeld)
            static_cast<void>(m_loop->controller().enter(*task));
    }

    void tune(const servo::ServoTuning& wish) {
        const servo::ServoTuning tuning = servo::clamped(wish, m_bounds);
        const servo::ServoPlan plan = servo::tuned(m_plan, tuning);
        if (!servo::check(plan))
            return;
        for (std::size_t i = 0; i < plan.tasks.size(); ++i)
            static_cast<void>(m_loop->controller().setTask(i, plan.tasks[i]));
        m_tuning = tuning;
        m_newVerdict.setSlidingSpeed(tuning.slide_mPerS);
        m_verdict.setSlidingSpeed(tuning.slide_mPerS);
    }

    void report(bool stopped) {
        const servo::ServoOutput& output = m_loop->output();
        const Eigen::Isometry3d& X_Base_Sensor = m_loop->world().arm().X_Base_Sensor();
        m_link->steps.push(step(stopped));
        servo::ServoReport& report = m_link->reports.back();
        report.time_s = m_loop->world().time_s();
        report.output = output;
        report.recentLimits = recentLimits();
        report.X_Base_Sensor = X_Base_Sensor;
        report.X_Base_Object = m_loop->world().arm().X_Base_Object();
        report.angle_rad = m_loop->world().arm().state().q_rad;
        report.p_Base_Joint = m_loop->world().arm().posture().p_Base_Joint;
        report.normalCompliance_mPerN = m_plan.tasks[output.phase].normalCompliance_mPerN;
        report.tuning = m_tuning;
        report.planned = servo::tuningOf(m_plan);
        report.bounds = m_bounds;
        report.stopped = stopped;
        report.tasks = std::min(m_plan.tasks.size(), report.plan.size());
        for (std::size_t i = 0; i < report.tasks; ++i)
            report.plan[i] = m_plan.tasks[i].kind;
        report.times = m_loop->times();
        report.rate_Hz = m_loop->world().rate_Hz();
        report.restarts = m_restarts;
        report.verdict = m_verdict.verdict();
        m_link->reports.publish();
    }

    servo::ActiveLimits recentLimits() {
        const double now_s = m_loop->world().time_s();
        servo::ActiveLimits recent;
        for (std::size_t i = 0; i < servo::kLimits; ++i) {
            const auto limit = static_cast<servo::Limit>(i);
            if (m_loop->output().limits.has(limit))
                m_lastActed_s[i] = now_s;
            if (now_s - m_lastActed_s[i] <= kRecent_s)
                recent.set(limit);
        }
        return recent;
    }

    [[nodiscard]] servo::ServoStep step(bool stopped) const {
        constexpr double kNotMeasured = servo::ServoStep::kNone;
        const servo::ServoOutput& output = m_loop->output();
        const Eigen::Isometry3d& X_Base_Sensor = m_loop->world().arm().X_Base_Sensor();
        const contact::TactileFeatures& features = m_loop->features();
        const ArrayLoads& loads = m_loop->world().frameTruth().loads;
        servo::ServoStep step;
        step.run = m_restarts;
        step.time_s = m_loop->world().time_s();
        step.task = output.kind;
        step.touching = output.contact == servo::ContactState::touching;
        step.moment = m_tuning.moment;
        step.force_N = m_loop->world().truth().force_N;
        step.desired_N = m_tuning.force_N;
        step.copY_m = features.copY_m.value_or(kNotMeasured);
        step.copYDesired_m = output.desired[servo::kY];
        step.cocX_m = features.cocX_m.value_or(kNotMeasured);
        step.cocXDesired_m = output.desiredCocX_m().value_or(kNotMeasured);
        step.dzmpYDesired_m = output.desiredDzmpY_m().value_or(kNotMeasured);
        if (m_loop->world().arm().object().turns)
            step.massX_m = m_loop->world().truth().massPlace_m;
        step.dzmpY_m = features.dzmpY_m.value_or(kNotMeasured);
        step.dzmpYTrue_m = loads.force_N > 0.0 ? loads.copX_m - loads.cocX_m : kNotMeasured;
        step.alphaZ_rad = features.alphaZ_rad.value_or(kNotMeasured);
        step.alphaZDesired_rad = output.desired[servo::kWz];
        step.limits = output.limits;
        step.p_Base_Sensor = X_Base_Sensor.translation();
        step.q_Base_Sensor = X_Base_Sensor.linear();
        step.q_Base_Reference = m_loop->world().arm().X_Base_Reference().linear();
        if (!stopped && output.kind == servo::TaskKind::explore && features.active > 0)
            step.p_Base_Contact = X_Base_Sensor * Eigen::Vector3d(*features.cocX_m, *features.cocY_m, 0.0);
        return step;
    }

    std::unique_ptr<ServoLoop> m_loop;
    ServoVerdict m_newVerdict; ///< of a run that has not begun
    ServoVerdict m_verdict;
    std::shared_ptr<servo::ServoLink> m_link;
    servo::ServoPlan m_plan; ///< as the scene has it
    servo::TuningBounds m_bounds;
    servo::ServoTuning m_tuning;
    core::SourceDescription m_description;
    std::uint64_t m_restarts = 0;
    std::array<double, servo::kLimits> m_lastActed_s{};
};

} // namespace

core::Expected<std::unique_ptr<core::FrameGenerator>>
makeServoArray(const scene::Scene& scene, std::uint64_t seed, std::shared_ptr<servo::ServoLink> link) {
    TELETA_TRY(auto loop, ServoLoop::make(scene, seed));
    return std::make_unique<ServoArray>(scene, std::move(loop), std::move(link));
}

} // namespace teleta::simulation
