// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/recording/recording_marks.h"
#include "app/console/sources/source_manager.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/recording/recorder.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace teleta::console {

class BraceletSession;
class BraceletService;

/// Records all open sources and the bracelet into one file. Sources opened later join.
/// Thread: GUI; no call waits but completeNow() and the destructor, for the file to be completed.
class RecordingService : public QObject {
    Q_OBJECT

public:
    enum class State {
        idle,
        starting, ///< the file is being made
        recording,
        stopping, ///< the file is being completed
    };

    RecordingService(SourceManager& sources, BraceletService& bracelet, const core::StopSwitch& stop,
                     QObject* parent = nullptr);
    ~RecordingService() override;

    /// Starts a recording. Creates the folder if missing; a name that is taken gets a number.
    void start(const QString& path);
    void stop();
    /// Adds an event to the recording that runs; ignored otherwise.
    void add(recording::RecordingEvent event);
    /// Zero of the recording's clock, steady clock.
    [[nodiscard]] std::int64_t start_ns() const { return m_start_ns; }
    /// Ends the recording and waits until its file is complete. For the end of the program: nothing is told.
    void completeNow();
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool isRecording() const { return m_state == State::recording; }
    /// Of the current recording, or of the last one.
    [[nodiscard]] const recording::RecorderStatus& status() const { return m_status; }
    [[nodiscard]] const QString& path() const { return m_path; }
    /// File name for a recording that starts now: UTC time and the shown source.
    [[nodiscard]] QString suggestedName() const;

    [[nodiscard]] RecordingMarks& marks() { return m_marks; }

    /// Checks the file, STOP and the sources.
    void tick();

signals:
    void stateChanged();
    /// The recording could not be started, or ended by itself. What was written before can be read.
    void failed(const core::Error& error, bool begun);
    void finished(const QString& path);

private:
    using Started = core::Expected<std::shared_ptr<recording::Recorder>>;
    void enter(State state);
    void begin(std::shared_ptr<recording::Recorder> recorder);
    /// Stops the copying; another thread completes the file.
    void close();
    void join(SourceManager::Item& item);
    void joinBracelet();
    /// The clock of the site at which the source is.
    void joinSite(const SourceManager::Item& item);
    void leave(pipeline::ChannelKey key);
    void watch();
    void tell(const std::string& kind, const std::string& text);
    [[nodiscard]] std::string prefixFor(const QString& name);
    /// Not on the GUI's thread.
    [[nodiscard]] static Started startRecorder(const QString& path, recording::RecordingHead head,
                                               const std::string& sceneFile);

    SourceManager& m_sources;
    BraceletService& m_bracelet;
    const core::StopSwitch& m_stop;
    RecordingMarks m_marks; ///< changes the file after it was completed
    State m_state = State::idle;
    QString m_path;
    std::future<Started> m_starting;
    bool m_stopWanted = false; ///< while it is starting
    std::future<core::Expected<void>> m_stopping;
    std::shared_ptr<recording::Recorder> m_recorder;
    recording::RecorderStatus m_status;
    std::int64_t m_start_ns = 0;

    std::map<pipeline::ChannelKey, std::string> m_joined;       ///< names in the recording
    std::map<pipeline::ChannelKey, core::DeviceState> m_states; ///< as they were told
    std::vector<std::string> m_prefixes;
    std::weak_ptr<BraceletSession> m_braceletSession;          ///< that is recorded
    std::vector<std::weak_ptr<site_link::SiteClient>> m_sites; ///< whose clocks are recorded
    bool m_wasStopped = false;
};

} // namespace teleta::console
