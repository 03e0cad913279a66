// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recorder.h"

#include "backend/core/steady_time.h"
#include "backend/recording/recording_writer.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace teleta::recording {

namespace {

/// Often enough that no queue fills up and data never waits long for its transaction.
constexpr std::chrono::milliseconds kDrainPeriod{50};
constexpr std::int64_t kCommitPeriod_ns = 200'000'000;
/// Most bytes that may wait for a commit, so that a slow disk does not fill the memory.
constexpr std::size_t kMostWaitingBytes = 16U << 20U;

} // namespace

core::Expected<std::unique_ptr<Recorder>> Recorder::start(const std::string& path, RecordingHead head,
                                                          RecorderOptions options) {
    std::unique_ptr<Recorder> recorder(new Recorder(path, std::move(options)));
    recorder->m_start_ns = head.start_ns;
    std::promise<core::Expected<void>> begun;
    std::future<core::Expected<void>> result = begun.get_future();
    recorder->m_thread = std::jthread([&recorder = *recorder, head = std::move(head),
                                       begun = std::move(begun)](const std::stop_token& stop) mutable {
        recorder.run(std::move(head), std::move(begun), stop);
    });
    TELETA_CHECK(result.get());
    return recorder;
}

Recorder::Recorder(std::string path, RecorderOptions options)
    : m_path(std::move(path))
    , m_options(std::move(options)) {
}

Recorder::~Recorder() {
    (void)stop();
}

std::shared_ptr<core::StreamTap> Recorder::addStream(StreamInfo info) {
    auto tap = std::make_shared<core::StreamTap>(info.type == ValueType::grey8 ? m_options.queuePictures
                                                                               : m_options.queueBlocks);
    const std::scoped_lock lock(m_mutex);
    const std::string wanted = info.name;
    for (int number = 2; std::ranges::find(m_names, info.name) != m_names.end(); ++number)
        info.name = wanted + "-" + std::to_string(number);
    m_names.push_back(info.name);
    if (m_ended)
        tap->close();
    else
        m_addedStreams.push_back({std::move(info), tap});
    return tap;
}

void Recorder::add(RecordingEvent event) {
    const std::scoped_lock lock(m_mutex);
    if (!m_ended)
        m_addedEvents.push_back(std::move(event));
}

std::uint64_t Recorder::mark(std::string note) {
    return mark(std::move(note), core::steadyNow_ns());
}

std::uint64_t Recorder::mark(std::string note, std::int64_t time_ns) {
    const std::scoped_lock lock(m_mutex);
    const std::uint64_t number = ++m_marks;
    m_addedEvents.push_back(
        {.time_ns = time_ns, .kind = kMark, .text = std::move(note), .value = static_cast<double>(number)});
    return number;
}

void Recorder::renameMark(std::uint64_t number, std::string note) {
    const std::scoped_lock lock(m_mutex);
    m_markChanges.push_back({number, std::move(note)});
}

void Recorder::removeMark(std::uint64_t number) {
    const std::scoped_lock lock(m_mutex);
    m_markChanges.push_back({number, {}});
}

core::Expected<void> Recorder::stop() {
    {
        const std::scoped_lock lock(m_stopMutex);
        if (m_thread.joinable()) {
            m_thread.request_stop();
            m_thread.join();
        }
    }
    const RecorderStatus status = m_status.get();
    if (status.state == RecorderStatus::State::failed)
        return core::Unexpected(status.error);
    return {};
}

void Recorder::restoreMark(std::uint64_t number, std::string note, std::int64_t time_ns) {
    const std::scoped_lock lock(m_mutex);
    m_markChanges.push_back({number, std::move(note), time_ns});
}

void Recorder::run(RecordingHead head, std::promise<core::Expected<void>> begun,
                   const std::stop_token& stop) {
    RecordingWriter writer(m_path, m_options.utcNow, m_options.simulatedTime);
    const core::Expected<void> done = writer.begin(head);
    if (done) {
        RecorderStatus status;
        status.bytes = writer.bytes();
        m_status.set(status);
    } else {
        end();
        m_status.set({.state = RecorderStatus::State::failed, .error = done.error()});
    }
    begun.set_value(done);
    if (done)
        write(writer, stop);
}

void Recorder::write(RecordingWriter& writer, const std::stop_token& stop) {
    std::int64_t committed_ns = core::steadyNow_ns();
    for (;;) {
        const bool last = stop.stop_requested();
        core::Expected<void> done = takeNew(writer);
        if (last) {
            for (const auto& tap : m_taps)
                tap->close();
        }
        for (std::size_t i = 0; done && i < m_taps.size(); ++i)
            done = drain(i, writer);
        const std::int64_t now_ns = core::steadyNow_ns();
        const std::int64_t end_ns = m_options.simulatedTime ? writer.newest_ns() : now_ns;
        if (last)
            writer.take({.time_ns = end_ns, .kind = kStopped, .text = {}});
        const bool due = now_ns - committed_ns >= kCommitPeriod_ns;
        if (done && (last || due)) {
            committed_ns = now_ns;
            done = writer.commit();
        }
        if (done && last)
            done = writer.finish();
        if (!done || last)
            end();
        RecorderStatus status = m_status.get();
        status.duration_s = core::elapsed_s(m_start_ns, end_ns);
        status.bytes = writer.bytes();
        status.frames = writer.frames();
        status.marks = writer.marks();
        status.dropped = writer.dropped();
        if (!done) {
            status.state = RecorderStatus::State::failed;
            status.error = done.error();
        } else if (last) {
            status.state = RecorderStatus::State::stopped;
        }
        m_status.set(std::move(status));
        if (!done || last)
            return;
        std::unique_lock lock(m_mutex);
        m_condition.wait_for(lock, stop, kDrainPeriod, [] { return false; });
    }
}

/// Takes what is queued in a tap, at most its capacity: a producer that waits for room could otherwise keep
/// the writer busy with its stream forever.
core::Expected<void> Recorder::drain(std::size_t stream, RecordingWriter& writer) {
    core::TappedFrames frames;
    for (std::size_t left = m_taps[stream]->capacity(); left > 0 && m_taps[stream]->pop(frames); --left) {
        writer.take(stream, std::move(frames));
        if (writer.waitingBytes() < kMostWaitingBytes)
            continue;
        if (core::Expected<void> done = writer.commit(); !done)
            return done;
    }
    writer.setDropped(stream, m_taps[stream]->dropped());
    return {};
}

/// From now on nothing is taken.
void Recorder::end() {
    const std::scoped_lock lock(m_mutex);
    m_ended = true;
    for (const Added& added : m_addedStreams)
        added.tap->close();
    m_addedStreams.clear();
    m_addedEvents.clear();
    m_markChanges.clear();
    for (const auto& tap : m_taps)
        tap->close();
}

core::Expected<void> Recorder::takeNew(RecordingWriter& writer) {
    std::vector<Added> streams;
    std::vector<RecordingEvent> events;
    std::vector<MarkChange> changes;
    {
        const std::scoped_lock lock(m_mutex);
        streams.swap(m_addedStreams);
        events.swap(m_addedEvents);
        changes.swap(m_markChanges);
    }
    for (Added& stream : streams) {
        TELETA_CHECK(writer.addStream(stream.info));
        m_taps.push_back(std::move(stream.tap));
    }
    for (RecordingEvent& event : events)
        writer.take(std::move(event));
    for (MarkChange& change : changes)
        writer.take(std::move(change));
    return {};
}

} // namespace teleta::recording
