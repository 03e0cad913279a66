// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/source_manager.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/recording/recorder.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace teleta::console {

class BraceletSession;
class BraceletStation;

/// A moment that somebody marked while it was recorded.
struct RecordingMark {
    std::uint64_t number = 0;
    std::int64_t time_ns = 0; ///< steady clock
    double time_s = 0.0;      ///< since the start of the recording
    QString text;
};

/// Records what all open sources and the bracelet deliver into one file. Sources that open meanwhile join.
/// Thread: GUI; no call waits but the destructor, for the file to be completed.
class RecordingStation : public QObject {
    Q_OBJECT

public:
    enum class State {
        idle,
        starting, ///< the file is being made
        recording,
        stopping, ///< the file is being completed
    };

    RecordingStation(SourceManager& sources, BraceletStation& bracelet, const core::StopSwitch& stop,
                     QObject* parent = nullptr);
    ~RecordingStation() override;

    /// Begins a recording. The folder is made when it is missing; a name that is taken gets a number.
    void start(const QString& path);
    void stop();
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool isRecording() const { return m_state == State::recording; }
    /// Of the recording that runs, or of the last one.
    [[nodiscard]] const recording::RecorderStatus& status() const { return m_status; }
    [[nodiscard]] const QString& path() const { return m_path; }
    /// Name of a file for a recording that begins now: UTC time and the source that is shown.
    [[nodiscard]] QString suggestedName() const;

    /// Marks now, or an earlier moment of the recording; only while it is recorded. Can be undone.
    void mark();
    void mark(std::int64_t time_ns);
    /// Can be undone; in a recording that has ended too, whose file is changed on another thread.
    void renameMark(std::uint64_t number, const QString& text);
    void removeMark(std::uint64_t number);
    /// Of the recording that runs, or of the last one, in order of time.
    [[nodiscard]] const std::vector<RecordingMark>& marks() const { return m_marks; }
    [[nodiscard]] QUndoStack& undoStack() { return m_undo; }

    /// Looks what became of the file, of STOP and of the sources.
    void tick();

signals:
    void stateChanged();
    /// The recording could not be begun, or ended by itself. What was written before can be read.
    void failed(const core::Error& error, bool begun);
    void finished(const QString& path);
    /// Marks of a recording that has ended could not be changed in its file, which the error names. It is
    /// tried again with the next change, and at the end.
    void marksNotKept(const core::Error& error);
    void marksChanged();

private:
    friend class MarkCommand;
    using Started = core::Expected<std::shared_ptr<recording::Recorder>>;
    /// Changes of the marks of a file that is complete.
    struct FileChanges {
        std::string path;
        std::vector<recording::MarkChange> changes;
    };
    struct Kept {
        std::vector<FileChanges> left; ///< what the files could not take, in its order
        core::Error why;               ///< of the first of it
    };

    /// Settings as the recording has them.
    struct ToldSettings {
        std::uint64_t revision = 0;
        std::string text;
    };

    void enter(State state);
    void begin(std::shared_ptr<recording::Recorder> recorder);
    /// Ends the taps; the file is completed by a thread.
    void close();
    void join(SourceManager::Item& item);
    void joinArray(SourceManager::Item& item, const std::string& prefix);
    void joinCamera(SourceManager::Item& item, const std::string& prefix);
    void joinBracelet();
    void leave(pipeline::ChannelKey key);
    void watch();
    void watchSettings(const SourceManager::Item& item, const std::string& prefix);
    void tell(const std::string& kind, const std::string& text);
    [[nodiscard]] std::string prefixFor(const QString& name);
    /// Not on the GUI's thread.
    [[nodiscard]] static Started startRecorder(const QString& path, recording::RecordingHead head,
                                               const std::string& sceneFile);
    void addMark(RecordingMark& mark);
    /// To the recording that runs, or to the file of the last one.
    void keep(recording::MarkChange change);
    void keepInFile();
    /// What was left of these goes before all others.
    void giveBack(Kept& kept);
    /// Not on the GUI's thread.
    [[nodiscard]] static Kept keepInFiles(const std::vector<FileChanges>& all);
    void dropMark(std::uint64_t number);
    void setMarkText(std::uint64_t number, const QString& text);

    SourceManager& m_sources;
    BraceletStation& m_bracelet;
    const core::StopSwitch& m_stop;
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
    std::map<pipeline::ChannelKey, ToldSettings> m_settings;    ///< of the arrays
    std::vector<std::string> m_prefixes;
    std::weak_ptr<BraceletSession> m_braceletSession; ///< that is recorded
    bool m_wasStopped = false;

    std::vector<RecordingMark> m_marks;
    QUndoStack m_undo;
    std::vector<FileChanges> m_markChanges; ///< for files, once they are complete and can be written
    std::future<Kept> m_keeping;
};

} // namespace teleta::console
