// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/backoff.h"
#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/device.h"
#include "backend/core/device/loss_counting.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/link/byte_link.h"
#include "devices/link/wake_pipe.h"
#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/stream_time.h"
#include "devices/taxels/taxels_file.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::taxels {

/// What came over the link since the source was started. Frames that the sensor's counter or time shows to be
/// lost are in core::DeviceStatus::framesLost.
struct TaxelsCounters {
    FrameDecoder::Counters line;      ///< over all connections
    std::uint64_t repeatedFrames = 0; ///< left out
    std::uint64_t sensorRestarts = 0; ///< counter or time jumped back
    std::uint64_t connections = 0;    ///< including the first one
    std::uint64_t failedAttempts = 0; ///< to connect again
    std::uint64_t binaryMessages = 0; ///< left out, of a WebSocket whose messages are texts

    bool operator==(const TaxelsCounters&) const = default;
};

/// A tactile array whose link and frames a file describes.
///   connecting -> live <-> stale; unplugged, closed or silent: lost -> reconnecting -> connecting; stop():
///   closed; the end of a file: finished
/// Values are in the file's unit; places without a taxel are NaN. A file is played at its rate, or as fast as
/// its frames are taken. Thread: open, start and stop from one controlling thread, counters from any;
/// otherwise as core::TactileSource.
class TaxelsDevice : public core::TactileSource, public core::ChipThermometers, public core::LossCounting {
public:
    /// Opens the link and sends the greeting. Error: as link::ByteLink::open.
    [[nodiscard]] static core::Expected<std::unique_ptr<TaxelsDevice>> open(TaxelsFile file);

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_outlet.blocks(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] std::size_t chips() const override { return m_file.temperatures; }
    [[nodiscard]] core::BoundedQueue<core::TemperatureSample>& temperatures() override {
        return m_temperatures;
    }

    [[nodiscard]] bool countsLosses() const override { return taxels::countsLosses(m_file.format); }

    [[nodiscard]] TaxelsCounters counters() const { return m_published.get(); }

private:
    TaxelsDevice(TaxelsFile file, bool isFile);

    friend core::DeviceThread<TaxelsDevice>;
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wake.wake(); }

    [[nodiscard]] core::Expected<void> connect();
    void adopt(link::ByteLink link);
    /// Reads frames until stop, a loss or the end; returns why it was lost.
    [[nodiscard]] std::string stream(const std::stop_token& stop);
    /// When the sensor is lost, if no good frame comes.
    [[nodiscard]] std::int64_t lostAt_ns() const;
    /// Until when to wait for bytes; enters the state stale when it is time.
    [[nodiscard]] std::int64_t deadline_ns(std::int64_t now_ns);
    void deliverFrames(FrameDecoder::Rest rest, const std::stop_token& stop);
    /// Of a file: waits until its time and until there is room.
    void deliverPaced(core::SampleBlock& block, const std::stop_token& stop);
    void appendFrame(const DecodedFrame& frame, core::SampleBlock& block);
    void deliver(core::SampleBlock& block);
    void prepare(core::SampleBlock& block);
    void reconnect(std::string reason, const std::stop_token& stop);
    void closeLink();
    void publish();

    TaxelsFile m_file;
    core::SourceDescription m_description;
    std::int64_t m_staleAfter_ns;
    std::int64_t m_lostAfter_ns;
    core::SourceOutlet m_outlet;
    core::BoundedQueue<core::TemperatureSample> m_temperatures;
    core::LatestCopy<TaxelsCounters> m_published;
    link::WakePipe m_wake;

    // The worker's own.
    std::unique_ptr<link::ByteLink> m_link;
    std::unique_ptr<FrameDecoder> m_decoder;
    StreamTime m_time;
    TaxelsCounters m_counters;
    FrameDecoder::Counters m_closedLines; ///< of the connections before this one
    std::uint64_t m_closedBinary = 0;     ///< likewise
    std::vector<float> m_values;          ///< of the frame at hand, as the layout has them
    std::vector<std::uint8_t> m_read;
    std::int64_t m_begin_ns = 0;       ///< of the stream
    std::int64_t m_read_ns = 0;        ///< of the newest bytes
    std::int64_t m_lastFrame_ns = 0;   ///< or the start of the connection
    std::int64_t m_due_ns = 0;         ///< of the next frame of a file
    core::Backoff m_retry;             ///< before the next attempt to connect
    bool m_ended = false;              ///< a file was played to its end
    bool m_discontinuity = false;      ///< of the next block
    bool m_temperatureDropped = false; ///< the last one

    core::DeviceThread<TaxelsDevice> m_thread{*this};
};

} // namespace teleta::taxels
