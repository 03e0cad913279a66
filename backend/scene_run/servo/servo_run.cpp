// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/servo/servo_run.h"

#include "backend/core/data/csv_writer.h"
#include "backend/scene_run/base/frame_log.h"
#include "backend/scene_run/base/scene_recording.h"
#include "backend/scene_run/servo/servo_log.h"
#include "backend/scene_run/servo/servo_measures.h"
#include "backend/simulation/servo/servo_loop.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace teleta::scene_run {

namespace {

constexpr std::uint64_t kCyclesBetweenReports = 1024;

core::Expected<void> writePoints(const std::string& path, const std::vector<Eigen::Vector3d>& points_m) {
    constexpr std::array<std::string_view, 3> kPointColumns{"x_m", "y_m", "z_m"};
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kPointColumns));
    for (const Eigen::Vector3d& point_m : points_m) {
        for (const double value : point_m)
            csv.number(value);
        csv.endRow();
    }
    return csv.finish();
}

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
    TELETA_TRY(FrameLog frameLog, FrameLog::open(options.outFolder, scene.taxels().taxels()));
    TELETA_TRY(ServoLog servoLog, ServoLog::open(options.outFolder));
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
    ServoEvents events(summary.events);
    std::uint64_t frames = 0;
    for (std::uint64_t i = 0; i < cycles && !frameLog.failed() && !servoLog.failed(); ++i) {
        summary.interrupted = options.endsAt(i, kCyclesBetweenReports, loop.world().time_s(), duration_s);
        if (summary.interrupted)
            break;
        loop.next();
        const bool newPhase = measures.add(loop);
        events.add(loop, newPhase, measures.phase());
        if (loop.frameCame()) {
            ++frames;
            frameLog.add(loop.world().time_s(), loop.frame());
            recording.addFrame(loop.world().time_s(), loop.frame());
        }
        if (loop.servoed())
            servoLog.add(loop, measures.phase(), measures.desiredForce_N());
    }
    for (const core::Expected<void>& written : {frameLog.finish(), servoLog.finish(), recording.finish()})
        TELETA_CHECK(written);
    if (!options.outFolder.empty()) {
        const core::Expected<void> written =
            writePoints(options.outFolder + "/points.csv", measures.points_m());
        TELETA_CHECK(written);
    }

    summary.takeTimes(loop.world());
    const double cyclesPerTimed =
        static_cast<double>(loop.world().cycle()) / std::max(1.0, static_cast<double>(loop.times().cycles));
    for (std::size_t i = 0; i < servo::kCycleParts; ++i)
        summary.parts.push_back(
            {std::string(servo::kCyclePartNames[i]), loop.times().part_s[i] * cyclesPerTimed});
    measures.report(summary.measures);
    summary.measures["frames"] = frames;
    summary.measures["frames_lost"] = 0;
    return summary;
}

} // namespace teleta::scene_run
