// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/live_source.h"

#include "backend/signal/recorded_signals.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace teleta::signal {

namespace {

/// Frames that wait for the viewer: one second at 1 kHz and more.
constexpr std::size_t kWaiting = 2048;

} // namespace

LiveSource::LiveSource(std::string name, std::int64_t origin_ns)
    : m_name(std::move(name))
    , m_origin_ns(origin_ns) {
}

std::shared_ptr<core::StreamTap> LiveSource::addStream(recording::StreamInfo info) {
    const bool hasSignals = info.channels() > 0 && info.type != recording::ValueType::grey8;
    auto tap = std::make_shared<core::StreamTap>(hasSignals ? kWaiting : 1);
    if (!hasSignals) {
        tap->close();
        return tap;
    }
    const std::scoped_lock lock(m_mutex);
    m_added.push_back({std::move(info), tap});
    return tap;
}

void LiveSource::add(recording::RecordingEvent /*event*/) {
}

bool LiveSource::take() {
    std::vector<Added> added;
    {
        const std::scoped_lock lock(m_mutex);
        added.swap(m_added);
    }
    for (Added& each : added) {
        Stream stream;
        const std::string prefix = m_name + "-";
        stream.name =
            each.info.name.starts_with(prefix) ? each.info.name.substr(prefix.size()) : each.info.name;
        const std::vector<recording::Column> columns = columnsOf(each.info);
        stream.capacity =
            columns.size() > kWide
                ? 0
                : std::max(2 * Series::kChunk, kBytesOfAStream / (sizeof(Sample) * columns.size()));
        for (const recording::Column& column : columns)
            stream.columns.push_back({column, std::make_shared<Series>(stream.capacity),
                                      std::numeric_limits<double>::quiet_NaN()});
        m_feeds.push_back(
            {std::move(each.tap), {m_origin_ns, isOfEvents(each.info) ? 0.0 : each.info.nominalRate_Hz}});
        stream.info = std::move(each.info);
        m_streams.push_back(std::move(stream));
    }
    core::TappedFrames frames;
    for (std::size_t i = 0; i < m_streams.size(); ++i) {
        while (m_feeds[i].tap->pop(frames))
            append(frames, m_streams[i], m_feeds[i].clock);
    }
    return !added.empty();
}

void LiveSource::append(const core::TappedFrames& frames, Stream& stream, StreamClock& clock) {
    const std::size_t channels = stream.columns.size();
    if (frames.values.size() != frames.frames() * channels * stream.info.bytesPerValue())
        return;
    for (std::size_t frame = 0; frame < frames.frames(); ++frame) {
        const StreamClock::Step step =
            clock.next(frames.time_ns[frame], frames.sourceTime_s[frame], frame == 0 && frames.discontinuity);
        for (std::size_t column = 0; column < channels; ++column) {
            Signal& signal = stream.columns[column];
            signal.newest = valueOf(frames, stream.info, frame, column);
            if (stream.capacity == 0 && !signal.isPlotted)
                continue;
            if (step.gap)
                signal.series->lift();
            signal.series->append(step.time_s, signal.newest);
        }
    }
}

void LiveSource::keep(const std::function<bool(const std::string&, const std::string&)>& isPlotted,
                      std::size_t samples) {
    for (Stream& stream : m_streams)
        for (Signal& signal : stream.columns) {
            const bool was = std::exchange(signal.isPlotted, isPlotted(stream.name, signal.column.name));
            // What comes later is not joined to what was kept before.
            if (was && !signal.isPlotted && stream.capacity == 0)
                signal.series->lift();
            signal.series->setCapacity(signal.isPlotted ? std::max(samples, stream.capacity)
                                                        : stream.capacity);
        }
}

std::uint64_t LiveSource::lost() const {
    return std::accumulate(m_feeds.begin(), m_feeds.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Feed& feed) { return sum + feed.tap->dropped(); });
}

} // namespace teleta::signal
