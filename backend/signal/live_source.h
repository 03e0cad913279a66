// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/recording/stream_sink.h"
#include "backend/signal/series.h"
#include "backend/signal/signal_name.h"
#include "backend/signal/stream_clock.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace teleta::signal {

/// The signals of one open source: its streams leave copies of their frames in taps, and take() puts them
/// into the series of the columns. Thread: the viewer's, except for what StreamSink promises.
class LiveSource : public recording::StreamSink {
public:
    /// Memory for the samples of a stream that nobody plots.
    static constexpr std::size_t kBytesOfAStream = std::size_t{32} << 20U;
    /// A stream with more columns is too wide to keep them all: it keeps those that somebody plots.
    static constexpr std::size_t kWide = 128;

    /// name: with which its streams begin. origin_ns: steady clock at the zero of the time axis.
    LiveSource(std::string name, std::int64_t origin_ns);

    struct Signal {
        recording::Column column;
        std::shared_ptr<Series> series;
        double newest = 0.0; ///< NaN: none
        bool isPlotted = false;
    };
    struct Stream {
        std::string name; ///< without that of the source
        recording::StreamInfo info;
        std::vector<Signal> columns;
        std::size_t capacity = 0; ///< samples of a signal that nobody plots
    };

    [[nodiscard]] std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override;
    /// Events are no signals.
    void add(recording::RecordingEvent event) override;

    /// Keeps so many samples of the signals that are plotted, and of the others what their streams grant.
    void keep(const std::function<bool(const std::string& stream, const std::string& column)>& isPlotted,
              std::size_t samples);

    /// Takes what has come. True: there are streams that were not there before.
    bool take();
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// They keep their places.
    [[nodiscard]] const std::deque<Stream>& streams() const { return m_streams; }
    /// Frames that came faster than they were taken.
    [[nodiscard]] std::uint64_t lost() const;

private:
    struct Feed {
        std::shared_ptr<core::StreamTap> tap;
        StreamClock clock;
    };
    struct Added {
        recording::StreamInfo info;
        std::shared_ptr<core::StreamTap> tap;
    };
    void append(const core::TappedFrames& frames, Stream& stream, StreamClock& clock);

    std::string m_name;
    std::int64_t m_origin_ns;
    std::deque<Stream> m_streams;
    std::vector<Feed> m_feeds; ///< one a stream
    std::mutex m_mutex;
    std::vector<Added> m_added; ///< guarded by m_mutex
};

} // namespace teleta::signal
