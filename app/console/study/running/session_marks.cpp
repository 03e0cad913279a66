// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/session_marks.h"

#include "devices/trigger/trigger_opener.h"

#include <QDir>

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

using Kind = core::TriggerEvent::Kind;

constexpr char kOnset[] = "study.onset";
constexpr char kAnswer[] = "study.answer";
constexpr char kEnd[] = "study.end";

} // namespace

void SessionMarks::setRecording(SessionRecording* recording) {
    if (std::exchange(m_isRecorded, false))
        m_recording->stop();
    m_recording = recording;
}

void SessionMarks::setTrigger(const core::TriggerSettings& settings) {
    if (settings == m_settings)
        return;
    m_settings = settings;
    m_sender.reset();
    if (settings.kind != core::TriggerSettings::Kind::none)
        m_sender =
            std::make_unique<study::TriggerSender>([settings] { return trigger::openTrigger(settings); });
}

std::optional<study::TriggerStatus> SessionMarks::trigger() const {
    return m_sender ? std::optional(m_sender->status()) : std::nullopt;
}

core::TriggerEvent SessionMarks::event(Kind kind, std::int64_t time_ns) const {
    core::TriggerEvent made;
    made.kind = kind;
    made.session = m_session.value_or(std::string());
    made.time_ns = time_ns;
    return made;
}

void SessionMarks::post(core::TriggerEvent event) {
    if (m_sender)
        m_sender->post(std::move(event));
}

void SessionMarks::begin(const std::string& session, const QString& folder, const QString& recordingPath,
                         std::int64_t now_ns) {
    m_session = session;
    m_folder = folder;
    m_isPaused = false;
    m_isRecorded = m_recording != nullptr && !recordingPath.isEmpty();
    if (m_isRecorded)
        m_recording->start(recordingPath);
    post(event(Kind::session, now_ns));
}

void SessionMarks::end(bool fault, std::int64_t now_ns) {
    if (!m_session)
        return;
    if (m_sender)
        m_sender->forget();
    if (fault)
        post(event(Kind::fault, now_ns));
    post(event(Kind::sessionEnd, now_ns));
    if (std::exchange(m_isRecorded, false))
        m_recording->stop();
    m_session.reset();
}

void SessionMarks::setPaused(bool paused, std::int64_t now_ns) {
    if (m_session && std::exchange(m_isPaused, paused) != paused)
        post(event(paused ? Kind::pause : Kind::goOn, now_ns));
}

void SessionMarks::stimulusRequested(const study::PlannedTrial& trial, std::function<std::int64_t()> onset) {
    if (!m_sender || !m_session)
        return;
    core::TriggerEvent awaited = event(Kind::stimulus, 0);
    awaited.index = trial.stimulus + 1;
    awaited.trial = trial.trial;
    if (trial.level)
        awaited.level = static_cast<float>(*trial.level);
    m_sender->await(std::move(awaited), std::move(onset));
}

void SessionMarks::trialEnded(study::TrialResult& result, std::int64_t onset_ns, std::int64_t end_ns) {
    if (!m_session)
        return;
    if (m_sender) {
        m_sender->forget();
        result.trigger_ms = m_sender->onsetToWritten_ms();
        core::TriggerEvent ended = event(Kind::noAnswer, end_ns);
        if (!result.isComplete())
            ended.kind = Kind::fault;
        else if (result.response)
            ended.kind = Kind::answer;
        if (result.response)
            ended.index = *result.response + 1;
        if (result.responseTime_s && onset_ns != 0)
            ended.time_ns = onset_ns + std::llround(1e9 * *result.responseTime_s);
        ended.trial = result.planned.trial;
        if (result.planned.level)
            ended.level = static_cast<float>(*result.planned.level);
        post(std::move(ended));
    }
    if (!m_isRecorded || m_recording->file().isEmpty())
        return;
    result.recording = QDir(m_folder).relativeFilePath(m_recording->file()).toStdString();
    if (onset_ns != 0) {
        result.recording_s =
            1e-9 * static_cast<double>(onset_ns - m_recording->start_ns().value_or(onset_ns));
        record(kOnset, result, onset_ns);
        if (result.responseTime_s)
            record(kAnswer, result, onset_ns + std::llround(1e9 * *result.responseTime_s));
    }
    record(kEnd, result, end_ns);
}

/// Part of the data: not translated.
void SessionMarks::record(const char* kind, const study::TrialResult& result, std::int64_t time_ns) {
    nlohmann::ordered_json text{{"session", *m_session},
                                {"phase", study::toString(result.planned.phase)},
                                {"trial", result.planned.trial},
                                {"attempt", result.planned.attempt}};
    if (!result.planned.track.empty())
        text["track"] = result.planned.track;
    if (result.planned.level)
        text["level"] = *result.planned.level;
    text["stimulus"] = result.planned.stimulus + 1;
    if (result.response)
        text["response"] = *result.response + 1;
    text["outcome"] = study::toString(result.outcome);
    text["steady_ns"] = time_ns;
    m_recording->add({.time_ns = time_ns,
                      .kind = kind,
                      .text = text.dump(),
                      .value = static_cast<double>(result.planned.trial)});
}

} // namespace teleta::console
