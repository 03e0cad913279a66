// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/base/long_work.h"
#include "app/python/core/core_bindings.h"
#include "backend/mcap/chunk_compression.h"
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

using recording::Recording;
using recording::StreamInfo;
using recording::StreamReader;
using recording::ValueType;

constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

/// Frames of one stream, one after another in memory.
struct CollectedFrames {
    std::vector<std::int64_t> time_ns;
    std::vector<double> sourceTime_s;
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<std::uint8_t> pixels;
    int width_px = 0;
    int height_px = 0;
};

/// Which frames of a stream are read: those in [begin, end), and of these every step-th.
struct FrameRange {
    std::int64_t begin_ns = std::numeric_limits<std::int64_t>::min();
    std::int64_t end_ns = kNever_ns;
    std::uint64_t step = 1;
};

/// Reads frames of one stream, block by block of the file.
class FrameCollector {
public:
    FrameCollector(const Recording& recording, std::size_t stream, const FrameRange& range)
        : m_reader(recording.reader(stream))
        , m_stream(recording.streams()[stream])
        , m_path(recording.path())
        , m_range(range) {}

    /// Goes to the first block of the range.
    [[nodiscard]] core::Expected<void> begin() {
        if (m_range.begin_ns == std::numeric_limits<std::int64_t>::min())
            return {};
        return m_reader.seek(m_range.begin_ns);
    }

    /// Appends frames until there are at least so many new ones, or the range ends. False at the end.
    [[nodiscard]] core::Expected<bool> collect(CollectedFrames& frames, std::size_t atLeast, LongWork& work) {
        const std::size_t before = frames.time_ns.size();
        while (work.goOn() && frames.time_ns.size() - before < atLeast) {
            const core::Expected<bool> any = m_reader.next(m_block);
            if (!any && any.error().kind != core::ErrorKind::badInput)
                return core::Unexpected(any.error());
            if (!any) {
                ++m_damaged;
                if (!m_reader.canGoOn())
                    return false;
                continue;
            }
            if (!*any || m_block.time_ns.front() >= m_range.end_ns)
                return false;
            TELETA_CHECK(append(frames));
        }
        return true;
    }

    [[nodiscard]] std::uint64_t damaged() const { return m_damaged; }

private:
    [[nodiscard]] core::Expected<void> append(CollectedFrames& frames) {
        const auto first = std::ranges::lower_bound(m_block.time_ns, m_range.begin_ns);
        const auto last = std::ranges::lower_bound(m_block.time_ns, m_range.end_ns);
        const auto begin = static_cast<std::size_t>(first - m_block.time_ns.begin());
        const auto end = static_cast<std::size_t>(last - m_block.time_ns.begin());
        if (end <= begin)
            return {};
        if (m_stream.type == ValueType::grey8)
            TELETA_CHECK(checkSize(frames));
        if (m_range.step == 1) {
            take(frames, begin, end);
            return {};
        }
        for (std::size_t i = begin; i < end; ++i) {
            if (m_seen++ % m_range.step == 0)
                take(frames, i, i + 1);
        }
        return {};
    }

    void take(CollectedFrames& frames, std::size_t begin, std::size_t end) const {
        const auto append = [&](auto& to, const auto* from, std::size_t channels) {
            to.insert(to.end(), from + begin * channels, from + end * channels);
        };
        append(frames.time_ns, m_block.time_ns.data(), 1);
        append(frames.sourceTime_s, m_block.sourceTime_s.data(), 1);
        if (m_stream.type == ValueType::grey8) {
            const std::uint8_t* const pixels = m_block.image.pixels.get();
            frames.pixels.insert(frames.pixels.end(), pixels,
                                 pixels + std::size_t(frames.width_px) * std::size_t(frames.height_px));
        } else if (m_stream.type == ValueType::float32) {
            append(frames.floats, reinterpret_cast<const float*>(m_block.values.data()), m_stream.channels());
        } else {
            append(frames.doubles, reinterpret_cast<const double*>(m_block.values.data()),
                   m_stream.channels());
        }
    }

    [[nodiscard]] core::Expected<void> checkSize(CollectedFrames& frames) const {
        if (frames.time_ns.empty()) {
            frames.width_px = m_block.image.width_px;
            frames.height_px = m_block.image.height_px;
        }
        if (frames.width_px != m_block.image.width_px || frames.height_px != m_block.image.height_px)
            return core::Unexpected(
                core::Error{core::ErrorKind::refused,
                            "the pictures of stream \"" + m_stream.name + "\" differ in size",
                            "a range of time in which they do not",
                            {m_path}});
        return {};
    }

    StreamReader m_reader;
    StreamInfo m_stream;
    std::string m_path;
    FrameRange m_range;
    core::TappedFrames m_block;
    std::uint64_t m_seen = 0;
    std::uint64_t m_damaged = 0;
};

/// What Recording.read() returns, as a tuple: time_s, time_ns, source_time_s, values, damaged.
py::tuple toTuple(const Recording& recording, std::size_t index, CollectedFrames&& frames,
                  std::uint64_t damaged) {
    const StreamInfo& stream = recording.streams()[index];
    const auto count = static_cast<py::ssize_t>(frames.time_ns.size());
    std::vector<double> times_s(frames.time_ns.size());
    std::ranges::transform(frames.time_ns, times_s.begin(),
                           [&](std::int64_t time_ns) { return recording.time_s(time_ns); });
    std::vector<py::ssize_t> shape{count};
    py::array values;
    if (stream.type == ValueType::grey8) {
        shape.insert(shape.end(), {frames.height_px, frames.width_px});
        if (recording::isColour(stream) && frames.width_px % 3 == 0) {
            shape.back() /= 3;
            shape.push_back(3);
        }
        values = arrayOf(std::move(frames.pixels), shape);
    } else {
        for (const std::size_t side : stream.shape)
            shape.push_back(static_cast<py::ssize_t>(side));
        values = stream.type == ValueType::float32 ? arrayOf(std::move(frames.floats), shape)
                                                   : arrayOf(std::move(frames.doubles), shape);
    }
    return py::make_tuple(arrayOf(std::move(times_s)), arrayOf(std::move(frames.time_ns)),
                          arrayOf(std::move(frames.sourceTime_s)), values, damaged);
}

class RecordingFile;

/// Iterates over the frames of a stream in pieces.
class BlockIterator {
public:
    BlockIterator(std::shared_ptr<const Recording> recording, std::size_t stream, const FrameRange& range,
                  std::size_t frames)
        : m_recording(std::move(recording))
        , m_stream(stream)
        , m_frames(frames)
        , m_collector(*m_recording, stream, range)
        , m_thread(std::this_thread::get_id()) {}

    [[nodiscard]] py::tuple next() {
        if (std::this_thread::get_id() != m_thread)
            throw std::runtime_error("the recording belongs to the thread that opened it");
        CollectedFrames frames;
        LongWork work;
        core::Expected<bool> more = false;
        const std::uint64_t damagedBefore = m_collector.damaged();
        if (!m_ended) {
            const py::gil_scoped_release released;
            core::Expected<void> begun;
            if (!std::exchange(m_begun, true))
                begun = m_collector.begin();
            more = begun.and_then([&] { return m_collector.collect(frames, m_frames, work); });
        }
        m_ended = !work.valueOf(std::move(more));
        warnOfDamage(m_collector.damaged() - damagedBefore, m_recording->path());
        if (frames.time_ns.empty())
            throw py::stop_iteration();
        return toTuple(*m_recording, m_stream, std::move(frames), m_collector.damaged() - damagedBefore);
    }

private:
    std::shared_ptr<const Recording> m_recording;
    std::size_t m_stream;
    std::size_t m_frames;
    FrameCollector m_collector;
    std::thread::id m_thread;
    bool m_begun = false;
    bool m_ended = false;
};

/// An open recording. Qt lets only the thread that opened a database use it.
class RecordingFile {
public:
    explicit RecordingFile(const py::object& path)
        : m_thread(std::this_thread::get_id()) {
        const std::string file = pathOf(path);
        std::optional<core::Expected<Recording>> opened;
        {
            const py::gil_scoped_release released;
            opened.emplace(Recording::open(file));
        }
        m_recording = std::make_shared<const Recording>(valueOf(std::move(*opened)));
    }

    void close() { m_recording.reset(); }
    [[nodiscard]] bool isOpen() const { return m_recording != nullptr; }

    /// Everything that is known of it without its frames.
    [[nodiscard]] py::dict describe() const {
        const Recording& recording = opened();
        py::dict all;
        all["scene"] = recording.head().scene;
        all["scene_text"] = recording.head().sceneText;
        all["app_version"] = recording.head().appVersion;
        all["start_ns"] = recording.head().start_ns;
        all["complete"] = recording.isComplete();
        py::list streams;
        for (const StreamInfo& stream : recording.streams())
            streams.append(describeStream(stream));
        all["streams"] = streams;
        std::vector<std::int64_t> steady_ns;
        std::vector<std::int64_t> utc_ms;
        for (const recording::TimeAnchor& anchor : recording.anchors()) {
            steady_ns.push_back(anchor.time_ns);
            utc_ms.push_back(anchor.utc.toMSecsSinceEpoch());
        }
        all["anchor_time_ns"] = arrayOf(std::move(steady_ns));
        all["anchor_utc_ms"] = arrayOf(std::move(utc_ms));
        std::vector<std::int64_t> times_ns;
        std::vector<double> times_s;
        std::vector<double> values;
        py::list kinds;
        py::list texts;
        for (const recording::RecordingEvent& event : recording.events()) {
            times_ns.push_back(event.time_ns);
            times_s.push_back(recording.time_s(event.time_ns));
            values.push_back(event.value);
            kinds.append(event.kind);
            texts.append(event.text);
        }
        all["event_time_ns"] = arrayOf(std::move(times_ns));
        all["event_time_s"] = arrayOf(std::move(times_s));
        all["event_value"] = arrayOf(std::move(values));
        all["event_kind"] = kinds;
        all["event_text"] = texts;
        return all;
    }

    [[nodiscard]] py::tuple read(std::size_t stream, const std::optional<double>& start_s,
                                 const std::optional<double>& stop_s, long long step) const {
        const Recording& recording = opened();
        const FrameRange range = rangeOf(stream, start_s, stop_s, step);
        CollectedFrames frames;
        LongWork work;
        FrameCollector collector(recording, stream, range);
        core::Expected<bool> done = false;
        {
            const py::gil_scoped_release released;
            if (!start_s && !stop_s && step == 1)
                reserve(stream, frames);
            done = collector.begin().and_then(
                [&] { return collector.collect(frames, std::numeric_limits<std::size_t>::max(), work); });
        }
        (void)work.valueOf(std::move(done));
        warnOfDamage(collector.damaged(), recording.path());
        return toTuple(recording, stream, std::move(frames), collector.damaged());
    }

    [[nodiscard]] BlockIterator blocks(std::size_t stream, long long frames,
                                       const std::optional<double>& start_s,
                                       const std::optional<double>& stop_s) const {
        (void)opened();
        if (frames < 1)
            throw wrongValue("frames", "1 or more", std::to_string(frames));
        return {m_recording, stream, rangeOf(stream, start_s, stop_s, 1), static_cast<std::size_t>(frames)};
    }

    [[nodiscard]] py::list toCsv(const py::object& folder, bool overwrite, const py::object& progress) const {
        const Recording& recording = opened();
        LongWork work(progress);
        recording::ExportOptions options;
        options.overwrite = overwrite;
        options.goOn = [&work](double done, double all) { return work.goOn(done, all); };
        const std::string path = pathOf(folder);
        core::Expected<std::vector<recording::ExportedFile>> files;
        {
            const py::gil_scoped_release released;
            files = recording::exportCsv(recording, path, options);
        }
        py::list paths;
        std::uint64_t damaged = 0;
        for (const recording::ExportedFile& file : work.valueOf(std::move(files))) {
            paths.append(file.path);
            damaged += file.damagedBlocks;
        }
        warnOfDamage(damaged, recording.path());
        return paths;
    }

    /// The fields of teleta.McapFile.
    [[nodiscard]] py::dict toMcap(const py::object& path, const std::vector<std::string>& streams,
                                  const std::string& compression, double chunk_MB, bool overwrite,
                                  const py::object& progress) const {
        const Recording& recording = opened();
        LongWork work(progress);
        mcap::McapExportOptions options;
        options.streams = streams;
        const auto known = mcap::compressionOf(compression == "none" ? "" : compression);
        if (!known || compression.empty())
            throw wrongValue("compression", "'zstd', 'lz4' or 'none'", "'" + compression + "'");
        options.compression = *known;
        if (!(chunk_MB >= 0.01 && chunk_MB <= 64.0))
            throw wrongValue("chunk_mb", "0.01 to 64", py::str(py::float_(chunk_MB)));
        options.chunkBytes = static_cast<std::size_t>(chunk_MB * (1U << 20U));
        options.overwrite = overwrite;
        options.goOn = [&work](double done, double all) { return work.goOn(done, all); };
        const std::string file = pathOf(path);
        core::Expected<mcap::McapExport> exported;
        {
            const py::gil_scoped_release released;
            exported = mcap::exportMcap(recording, file, options);
        }
        const mcap::McapExport written = work.valueOf(std::move(exported));
        warnOfDamage(written.damagedBlocks, recording.path());
        std::vector<std::int64_t> messages;
        py::list topics;
        py::list types;
        for (const mcap::McapExport::Topic& topic : written.topics) {
            topics.append(topic.name);
            types.append(topic.type);
            messages.push_back(static_cast<std::int64_t>(topic.messages));
        }
        py::dict all;
        all["path"] = written.path;
        all["bytes"] = written.bytes;
        all["damaged_blocks"] = written.damagedBlocks;
        all["topic"] = topics;
        all["type"] = types;
        all["messages"] = arrayOf(std::move(messages));
        all["left_out"] = py::tuple(py::cast(written.leftOut));
        all["y_turned"] = py::tuple(py::cast(written.turned));
        return all;
    }

private:
    static py::dict describeStream(const StreamInfo& stream) {
        py::dict all;
        all["name"] = stream.name;
        all["kind"] = recording::toString(stream.kind);
        all["type"] = recording::toString(stream.type);
        all["shape"] = py::tuple(py::cast(stream.shape));
        all["unit"] = stream.unit;
        py::list columns;
        py::list units;
        for (const recording::Column& column : stream.columns) {
            columns.append(column.name);
            units.append(column.unit);
        }
        all["columns"] = py::tuple(columns);
        all["column_units"] = py::tuple(units);
        all["rate_hz"] = stream.nominalRate_Hz;
        all["source"] = stream.source;
        all["details"] = stream.details;
        return all;
    }

    [[nodiscard]] const Recording& opened() const {
        if (!m_recording)
            throw py::value_error("the recording is closed");
        if (std::this_thread::get_id() != m_thread)
            throw std::runtime_error("the recording belongs to the thread that opened it");
        return *m_recording;
    }

    [[nodiscard]] FrameRange rangeOf(std::size_t stream, const std::optional<double>& start_s,
                                     const std::optional<double>& stop_s, long long step) const {
        if (stream >= m_recording->streams().size())
            throw py::index_error("there is no such stream");
        if (step < 1)
            throw wrongValue("step", "1 or more", std::to_string(step));
        const auto toNs = [&](double time_s, const char* name) {
            if (std::isnan(time_s))
                throw wrongValue(name, "a time in s or None", "nan");
            // Beyond any recording; keeps the sum within its type.
            const double within_s = std::clamp(time_s, -4e9, 4e9);
            return m_recording->head().start_ns + static_cast<std::int64_t>(std::ceil(within_s * 1e9));
        };
        FrameRange range;
        if (start_s)
            range.begin_ns = toNs(*start_s, "start_s");
        if (stop_s)
            range.end_ns = toNs(*stop_s, "stop_s");
        range.step = static_cast<std::uint64_t>(step);
        return range;
    }

    /// Room for all frames of a stream, so that none is moved.
    void reserve(std::size_t stream, CollectedFrames& frames) const {
        const auto extent = m_recording->extent(stream);
        if (!extent || !*extent)
            return;
        const StreamInfo& info = m_recording->streams()[stream];
        const std::size_t count = (*extent)->frames;
        frames.time_ns.reserve(count);
        frames.sourceTime_s.reserve(count);
        if (info.type == ValueType::float32)
            frames.floats.reserve(count * info.channels());
        else if (info.type == ValueType::float64)
            frames.doubles.reserve(count * info.channels());
    }

    std::shared_ptr<const Recording> m_recording;
    std::thread::id m_thread;
};

} // namespace

void bindRecordings(py::module_& module) {
    py::class_<BlockIterator>(module, "BlockIterator", py::module_local())
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &BlockIterator::next);
    py::class_<RecordingFile>(module, "RecordingFile", py::module_local())
        .def(py::init<const py::object&>())
        .def("close", &RecordingFile::close)
        .def("is_open", &RecordingFile::isOpen)
        .def("describe", &RecordingFile::describe)
        .def("read", &RecordingFile::read)
        .def("blocks", &RecordingFile::blocks)
        .def("to_csv", &RecordingFile::toCsv)
        .def("to_mcap", &RecordingFile::toMcap);
    module.def("is_recording", [](const py::object& path) { return Recording::looksLikeOne(pathOf(path)); });
}

} // namespace teleta::python
