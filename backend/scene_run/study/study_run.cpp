// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/study/study_run.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/scene_run/study/stimulus_bracelet.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/session/rehearsal.h"

#include <QCoreApplication>
#include <QString>
#include <QTemporaryDir>

#include <map>
#include <utility>
#include <vector>

namespace teleta::scene_run {

namespace {

using nlohmann::ordered_json;

struct StudyRunText {
    Q_DECLARE_TR_FUNCTIONS(SceneRun)
};

/// A fixed day: the same scene and seed give the same files.
QDateTime beginning() {
    return {QDate(2026, 1, 1), QTime(8, 0), Qt::UTC};
}

/// Measures of the stored trials.
core::Expected<ordered_json> measuresOf(const study::StudyStore& store) {
    TELETA_TRY(const auto participants, store.participants());
    int trials = 0;
    int right = 0;
    int timeouts = 0;
    std::vector<double> times_s;
    for (const study::Participant& participant : participants) {
        TELETA_TRY(const auto sessions, store.sessions(participant));
        for (const study::SessionRecord& session : sessions) {
            TELETA_TRY(const auto kept, store.trials(session));
            for (const study::StoredTrial& trial : kept) {
                if (trial.result.planned.phase != study::Phase::test)
                    continue;
                ++trials;
                timeouts += trial.result.outcome == study::Outcome::timeout ? 1 : 0;
                if (trial.result.outcome != study::Outcome::correct)
                    continue;
                ++right;
                times_s.push_back(trial.result.responseTime_s.value_or(0.0));
            }
        }
    }
    return ordered_json{{"trials", trials},
                        {"accuracy", trials == 0 ? ordered_json() : ordered_json(double(right) / trials)},
                        {"timeouts", timeouts},
                        {"response_time_median_s", orNull(study::median(times_s))}};
}

/// The simulated participants, with the computing time of each effect.
class TimedParticipants {
public:
    TimedParticipants(const study::StudyScene& scene, EffectTimes& times_ns)
        : m_scene(scene)
        , m_times_ns(times_ns) {}

    study::SimulatedParticipant::Answer answer(const study::StudyTask& task, const std::string& condition,
                                               std::size_t stimulus, std::uint64_t seed) {
        const std::pair key(task.id, condition);
        auto known = m_participants.find(key);
        if (known == m_participants.end())
            known = m_participants.emplace(key, m_scene.participantFor(task, condition)).first;
        const study::SimulatedParticipant& participant = known->second;
        study::SimulatedParticipant::Answer answer;
        const std::int64_t start_ns = core::steadyNow_ns();
        answer.time_s = participant.time_s(seed);
        const std::int64_t timed_ns = core::steadyNow_ns();
        const bool isLapse = participant.isLapse(seed);
        const std::int64_t lapsed_ns = core::steadyNow_ns();
        if (!isLapse)
            answer.response = participant.response(stimulus, seed);
        m_times_ns["reaction_time"] += timed_ns - start_ns;
        m_times_ns["lapses"] += lapsed_ns - timed_ns;
        m_times_ns["confusion"] += core::steadyNow_ns() - lapsed_ns;
        return answer;
    }

private:
    const study::StudyScene& m_scene;
    EffectTimes& m_times_ns;
    std::map<std::pair<std::string, std::string>, study::SimulatedParticipant> m_participants;
};

} // namespace

core::Expected<SceneSummary> runStudyScene(const study::StudyScene& scene, const RunOptions& options) {
    const std::int64_t start_ns = core::steadyNow_ns();
    const QTemporaryDir nowhere;
    study::StudyHead head;
    head.protocol = scene.protocol;
    head.seed = options.seed;
    head.mode = study::Mode::simulated;
    head.plannedParticipants = scene.participants;
    head.lapses = scene.lapses.value_or(0.0);
    head.created = beginning();
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    TELETA_TRY(study::StudyStore store,
               study::StudyStore::create(
                   options.outFolder.empty() ? nowhere.path().toStdString() : options.outFolder, head));

    EffectTimes times_ns;
    TimedParticipants participants(scene, times_ns);
    StimulusBracelet bracelet(scene, times_ns);
    std::size_t stimuli = 0;
    std::size_t frames = 0;
    std::size_t lost = 0;
    bool unknown = false;
    study::RehearsalCast cast;
    cast.answer = [&](const study::StudyTask& task, const std::string& condition, std::size_t stimulus,
                      std::uint64_t seed) { return participants.answer(task, condition, stimulus, seed); };
    cast.show = [&](const pattern::Pattern* pattern, double atMost_s, std::uint64_t seed) {
        study::RehearsalCast::Shown shown;
        unknown = unknown || pattern == nullptr;
        if (pattern == nullptr)
            return shown;
        const StimulusBracelet::Shown played = bracelet.show(*pattern, atMost_s, seed);
        ++stimuli;
        frames += played.frames;
        lost += played.lost;
        shown.latency_s = 1.0 / scene.frameRate_Hz;
        shown.framesMissed = played.lost;
        return shown;
    };
    const double duration_s = options.duration_s.value_or(scene.duration_s);
    bool stopped = false;
    cast.goOn = [&](const study::RehearsalProgress& now) {
        stopped = options.goOn && !options.goOn(now.simulated_s, duration_s);
        return !stopped && now.simulated_s < duration_s;
    };
    TELETA_TRY(const auto progress, study::rehearse(store, cast));
    if (unknown)
        return core::failed(core::ErrorKind::badInput,
                            StudyRunText::tr("the protocol has a stimulus that is not built in"),
                            StudyRunText::tr("tasks, letters and conditions whose patterns are built in"));
    TELETA_TRY(ordered_json measures, measuresOf(store));
    SceneSummary summary;
    summary.scene = options.name;
    summary.seed = options.seed;
    summary.simulated_s = progress.simulated_s;
    summary.interrupted = stopped;
    for (const study::StudyScene::Effect& effect : scene.effects)
        summary.effects.push_back({effect.name, core::elapsed_s(0, times_ns[effect.name])});
    summary.measures = std::move(measures);
    summary.measures["patterns_sent"] = stimuli;
    summary.measures["frames"] = frames;
    summary.measures["frames_lost"] = lost;
    summary.measures["felt_onset_p50_s"] = orNull(study::median(bracelet.onsets_s()));
    summary.measures["felt_rms_error"] = orNull(bracelet.rmsError());
    summary.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
    if (!options.outFolder.empty())
        TELETA_CHECK(writeJson(options.outFolder + "/summary.json", summary.toJson()));
    return summary;
}

} // namespace teleta::scene_run
