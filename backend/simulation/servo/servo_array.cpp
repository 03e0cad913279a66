// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/servo_array.h"

#include "backend/simulation/servo/servo_loop.h"

#include <algorithm>
#include <utility>

namespace teleta::simulation {

namespace {

class ServoArray : public core::FrameGenerator {
public:
    ServoArray(const scene::Scene& scene, std::unique_ptr<ServoLoop> loop,
               std::shared_ptr<servo::ServoLink> link)
        : m_loop(std::move(loop))
        , m_link(std::move(link))
        , m_plan(m_loop->controller().plan())
        , m_tuning(servo::tuningOf(m_plan))
        , m_description{.name = scene.name,
                        .layout = m_loop->world().layout(),
                        .unit = "N",
                        .nominalRate_Hz =
                            std::min(scene.servo().sensor.acquisition_Hz, m_loop->world().rate_Hz()),
                        .simulated = true} {}

    [[nodiscard]] core::SourceDescription description() const override { return m_description; }

    void next(std::span<float> values, bool motionHeld) override {
        takeWishes(motionHeld);
        do {
            m_loop->next(motionHeld);
            if (m_loop->servoed())
                report(motionHeld);
        } while (!m_loop->frameCame());
        std::ranges::copy(m_loop->frame(), values.begin());
    }

    [[nodiscard]] double time_s() const override { return m_loop->world().time_s(); }

    void restart() override {
        m_loop->restart();
        ++m_restarts;
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
        const servo::ServoTuning tuning = servo::clamped(wish);
        const servo::ServoPlan plan = servo::tuned(m_plan, tuning);
        if (!servo::check(plan))
            return;
        for (std::size_t i = 0; i < plan.tasks.size(); ++i)
            static_cast<void>(m_loop->controller().setTask(i, plan.tasks[i]));
        m_tuning = tuning;
    }

    void report(bool stopped) {
        const servo::ServoOutput& output = m_loop->output();
        const Eigen::Isometry3d& X_Base_Sensor = m_loop->world().arm().X_Base_Sensor();
        const contact::TactileFeatures& features = m_loop->features();
        if (!stopped && output.kind == servo::TaskKind::explore && features.active > 0) {
            Eigen::Vector3d p_Base_Contact =
                X_Base_Sensor * Eigen::Vector3d(*features.cocX_m, *features.cocY_m, 0.0);
            m_link->contacts.push(std::move(p_Base_Contact));
        }
        servo::ServoReport& report = m_link->reports.back();
        report.time_s = m_loop->world().time_s();
        report.output = output;
        report.X_Base_Sensor = X_Base_Sensor;
        report.p_Base_Joint = m_loop->world().arm().posture().p_Base_Joint;
        report.normalCompliance_mPerN = m_plan.tasks[output.phase].normalCompliance_mPerN;
        report.tuning = m_tuning;
        report.stopped = stopped;
        report.tasks = std::min(m_plan.tasks.size(), report.plan.size());
        for (std::size_t i = 0; i < report.tasks; ++i)
            report.plan[i] = m_plan.tasks[i].kind;
        report.times = m_loop->times();
        report.rate_Hz = m_loop->world().rate_Hz();
        report.restarts = m_restarts;
        m_link->reports.publish();
    }

    std::unique_ptr<ServoLoop> m_loop;
    std::shared_ptr<servo::ServoLink> m_link;
    servo::ServoPlan m_plan; ///< as the scene has it
    servo::ServoTuning m_tuning;
    core::SourceDescription m_description;
    std::uint64_t m_restarts = 0;
};

} // namespace

core::Expected<std::unique_ptr<core::FrameGenerator>>
makeServoArray(const scene::Scene& scene, std::uint64_t seed, std::shared_ptr<servo::ServoLink> link) {
    auto loop = ServoLoop::make(scene, seed);
    if (!loop)
        return core::Unexpected(loop.error());
    return std::make_unique<ServoArray>(scene, std::move(*loop), std::move(link));
}

} // namespace teleta::simulation
