// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/recording/recording_types.h"
#include "backend/recording/stream_sink.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace teleta::recording {

class RecordingWriter;

/// Progress of a recorder.
struct RecorderStatus {
    enum class State {
        recording,
        stopped, ///< by stop(), and the file is complete
        failed,  ///< by error: what was written before can be read
    };
    State state = State::recording;
    core::Error error;         ///< with failed
    double duration_s = 0.0;   ///< since the start
    std::uint64_t bytes = 0;   ///< of the file
    std::uint64_t frames = 0;  ///< of all streams, that are safe in the file
    std::uint64_t dropped = 0; ///< frames that the writer could not take in time, or not at all
    std::uint64_t marks = 0;   ///< that are in the file
};

struct RecorderOptions {
    std::function<QDateTime()> utcNow = [] { return QDateTime::currentDateTimeUtc(); };
    /// The frames' times are a simulation's, not the steady clock's.
    bool simulatedTime = false;
    /// Blocks of a stream that may wait for the writer: 20 s of an array at 200 Hz, frame by frame. A
    /// producer of large blocks that can wait needs fewer.
    std::size_t queueBlocks = 4096;
    /// Pictures that may wait, which are large: 1.6 s at 40 Hz.
    std::size_t queuePictures = 64;
};

/// Writes streams into one file, from a thread of its own.
///   data thread -> StreamTap -> writer thread -> a transaction every 0.2 s, or when 16 MB wait
/// A killed program loses what came after the last transaction. If a write fails (disk full), the recording
/// ends with an error, what was written stays readable, and the data threads are not disturbed.
/// Thread: any.
class Recorder : public StreamSink {
public:
    /// Creates the file and starts the writer. Waits for the disk: not on the GUI's thread.
    /// Error: as RecordingDatabase::create.
    [[nodiscard]] static core::Expected<std::unique_ptr<Recorder>>
    start(const std::string& path, RecordingHead head, RecorderOptions options = {});
    /// As stop().
    ~Recorder() override;

    [[nodiscard]] std::shared_ptr<core::StreamTap> addStream(StreamInfo info) override;
    /// Ignored after the end.
    void add(RecordingEvent event) override;
    /// Adds a mark for now, or for another time; returns its number. Returns at once, as the next two.
    std::uint64_t mark(std::string note);
    std::uint64_t mark(std::string note, std::int64_t time_ns);
    /// Changes the note of a mark; its time stays.
    void renameMark(std::uint64_t number, std::string note);
    /// Removes a mark.
    void removeMark(std::uint64_t number);
    /// Restores a removed mark under its number.
    void restoreMark(std::uint64_t number, std::string note, std::int64_t time_ns);

    [[nodiscard]] RecorderStatus status() const { return m_status.get(); }
    [[nodiscard]] const std::string& path() const { return m_path; }

    /// Writes what is queued, completes the file and waits for it. Idempotent. Error: why the file is not
    /// complete.
    core::Expected<void> stop();

private:
    struct Added {
        StreamInfo info;
        std::shared_ptr<core::StreamTap> tap;
    };

    Recorder(std::string path, RecorderOptions options);
    void run(RecordingHead head, std::promise<core::Expected<void>> begun, const std::stop_token& stop);
    void write(RecordingWriter& writer, const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> takeNew(RecordingWriter& writer);
    [[nodiscard]] core::Expected<void> drain(std::size_t stream, RecordingWriter& writer);
    void end();

    std::string m_path;
    RecorderOptions m_options;
    std::int64_t m_start_ns = 0;
    core::LatestCopy<RecorderStatus> m_status;

    std::mutex m_stopMutex; ///< of stop()
    std::mutex m_mutex;
    std::condition_variable_any m_condition;
    std::vector<Added> m_addedStreams;         ///< guarded by m_mutex
    std::vector<RecordingEvent> m_addedEvents; ///< guarded by m_mutex
    std::vector<MarkChange> m_markChanges;     ///< guarded by m_mutex; all of marks that were added before
    std::uint64_t m_marks = 0;                 ///< guarded by m_mutex
    std::vector<std::string> m_names;          ///< guarded by m_mutex
    bool m_ended = false;                      ///< guarded by m_mutex

    std::vector<std::shared_ptr<core::StreamTap>> m_taps; ///< of the writer's thread
    std::jthread m_thread;
};

} // namespace teleta::recording
