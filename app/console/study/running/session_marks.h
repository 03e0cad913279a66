// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/session_recording.h"
#include "app/console/study/running/trial_observer.h"
#include "backend/core/device/trigger_port.h"
#include "backend/study/session/trigger_sender.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace teleta::console {

/// Marks the events of a session for other recorders: triggers, and events in the recording of its streams.
/// Adds trigger_ms, recording and recording_s to the results. Thread: GUI; no call waits but the destructor
/// and a change of the settings, for a write of the trigger's line.
class SessionMarks : public TrialObserver {
public:
    /// recording: may be null; must outlive it.
    explicit SessionMarks(SessionRecording* recording = nullptr)
        : m_recording(recording) {}

    /// Null: none. What is being recorded ends.
    void setRecording(SessionRecording* recording);
    /// Opens the line, so that a check knows of it before a session; the same settings change nothing.
    void setTrigger(const core::TriggerSettings& settings);
    /// Empty: no triggers.
    [[nodiscard]] std::optional<study::TriggerStatus> trigger() const;

    /// recordingPath: of the recording of this session; empty: none. folder: of the study.
    void begin(const std::string& session, const QString& folder, const QString& recordingPath,
               std::int64_t now_ns);
    /// fault: it was aborted.
    void end(bool fault, std::int64_t now_ns);
    void setPaused(bool paused, std::int64_t now_ns);
    [[nodiscard]] bool isActive() const { return m_session.has_value(); }

    void stimulusRequested(const study::PlannedTrial& trial, std::function<std::int64_t()> onset) override;
    void trialEnded(study::TrialResult& result, std::int64_t onset_ns, std::int64_t end_ns) override;

private:
    [[nodiscard]] core::TriggerEvent event(core::TriggerEvent::Kind kind, std::int64_t time_ns) const;
    void post(core::TriggerEvent event);
    void record(const char* kind, const study::TrialResult& result, std::int64_t time_ns);

    SessionRecording* m_recording;
    core::TriggerSettings m_settings;
    std::unique_ptr<study::TriggerSender> m_sender; ///< null: no triggers
    std::optional<std::string> m_session;           ///< id
    QString m_folder;
    bool m_isRecorded = false;
    bool m_isPaused = false;
};

} // namespace teleta::console
