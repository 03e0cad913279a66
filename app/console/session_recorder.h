// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/recording/recording_service.h"
#include "app/console/study/running/session_recording.h"

#include <QObject>

namespace teleta::console {

/// Records sessions of a study with the console's recorder. Thread: GUI.
class SessionRecorder : public QObject, public SessionRecording {
    Q_OBJECT

public:
    explicit SessionRecorder(RecordingService& service, QObject* parent = nullptr);

    void start(const QString& path) override;
    void stop() override;
    void add(recording::RecordingEvent event) override;
    [[nodiscard]] QString file() const override;
    [[nodiscard]] std::optional<std::int64_t> start_ns() const override;

private:
    RecordingService& m_service;
    bool m_isOurs = false; ///< the recording was begun by start()
};

} // namespace teleta::console
