// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/foxglove/live_view.h"

#include "backend/core/steady_time.h"
#include "backend/mcap/recorded/ros_names.h"
#include "backend/mcap/recorded/stream_encoder.h"
#include "devices/foxglove/live_server.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace teleta::foxglove {

namespace {

/// Far below the 20 ms that a person notices.
constexpr int kPoll_ms = 4;
/// Blocks of a stream that may wait: a second of an array at 200 Hz, frame by frame.
constexpr std::size_t kQueueBlocks = 256;
constexpr std::size_t kQueuePictures = 4;
constexpr std::size_t kMostEvents = 1024;
/// Of pictures, 1 to 9: what is sent at once is not compressed again.
constexpr int kPictureLevel = 1;

std::int64_t utcOffsetNow_ns() {
    const auto utc = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(utc).count() - core::steadyNow_ns();
}

} // namespace

/// The part that lives on the thread.
class LiveView::Worker {
public:
    explicit Worker(LiveView& view)
        : m_view(view)
        , m_offset_ns(utcOffsetNow_ns()) {}
    ~Worker() {
        for (const Stream& stream : m_streams)
            stream.tap->close();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// False when nobody can listen.
    bool begin() {
        const core::Expected<void> listening =
            m_server.listen(m_view.m_options.address, m_view.m_options.port);
        if (!listening) {
            m_view.m_status.set(
                {.state = LiveViewStatus::State::failed, .error = core::describe(listening.error())});
            return false;
        }
        m_eventChannel = m_server.advertise(mcap::eventTopic());
        return true;
    }

    void poll() {
        takeNew();
        for (Stream& stream : m_streams)
            send(stream);
        sendEvents();
        std::erase_if(m_streams, [this](const Stream& stream) {
            if (stream.tap.use_count() > 1)
                return false;
            for (const std::uint32_t channel : stream.channels)
                m_server.unadvertise(channel);
            m_lost += stream.tap->dropped();
            return true;
        });
        publishStatus();
    }

private:
    struct Stream {
        mcap::StreamEncoder encoder;
        std::shared_ptr<core::StreamTap> tap;
        std::vector<std::uint32_t> channels;
    };

    void takeNew() {
        std::vector<Added> added;
        {
            const std::scoped_lock lock(m_view.m_mutex);
            added.swap(m_view.m_added);
            m_events.swap(m_view.m_events);
            m_lostEvents = m_view.m_eventsDropped;
        }
        for (Added& each : added) {
            const std::string wanted = each.info.name;
            for (int number = 2; isTaken(each.info.name); ++number)
                each.info.name = wanted + "-" + std::to_string(number);
            std::vector<recording::StreamInfo> all;
            for (const Stream& stream : m_streams)
                all.push_back(stream.encoder.stream());
            all.push_back(each.info);
            Stream stream{
                mcap::StreamEncoder(each.info, mcap::rosNames(all).back(), kPictureLevel), each.tap, {}};
            for (const mcap::TopicType& topic : stream.encoder.topics())
                stream.channels.push_back(m_server.advertise(topic));
            m_streams.push_back(std::move(stream));
        }
    }

    [[nodiscard]] bool isTaken(const std::string& name) const {
        return std::ranges::any_of(m_streams, [&name](const Stream& stream) {
            return mcap::topicPart(stream.encoder.stream().name) == mcap::topicPart(name);
        });
    }

    void send(Stream& stream) {
        core::TappedFrames block;
        for (std::size_t left = stream.tap->capacity(); left > 0 && stream.tap->pop(block); --left) {
            for (std::size_t topic = 0; topic < stream.channels.size(); ++topic) {
                if (m_server.isWanted(stream.channels[topic]))
                    send(stream, topic, block);
            }
        }
    }

    void send(const Stream& stream, std::size_t topic, const core::TappedFrames& block) {
        for (std::size_t frame = 0; frame < block.frames();) {
            const std::size_t frames = stream.encoder.framesOfMessage(block, frame);
            const std::int64_t utc_ns = block.time_ns[frame] + m_offset_ns;
            m_message.clear();
            stream.encoder.encode(topic, block, frame, frames, utc_ns, m_message);
            m_server.publish(stream.channels[topic], utc_ns, m_message);
            frame += frames;
        }
    }

    void sendEvents() {
        for (const recording::RecordingEvent& event : m_events) {
            const std::int64_t utc_ns = event.time_ns + m_offset_ns;
            m_message.clear();
            mcap::encodeEvent(event, utc_ns, m_message);
            m_server.publish(m_eventChannel, utc_ns, m_message);
        }
        m_events.clear();
    }

    void publishStatus() {
        LiveViewStatus status{.state = LiveViewStatus::State::listening,
                              .error = {},
                              .port = m_server.port(),
                              .clients = m_server.clients(),
                              .sent = m_server.sent(),
                              .dropped = m_server.dropped() + m_lost + m_lostEvents};
        for (const Stream& stream : m_streams)
            status.dropped += stream.tap->dropped();
        m_view.m_status.set(std::move(status));
    }

    LiveView& m_view;
    LiveServer m_server;
    std::int64_t m_offset_ns;
    std::vector<Stream> m_streams;
    std::vector<recording::RecordingEvent> m_events;
    std::uint32_t m_eventChannel = 0;
    std::uint64_t m_lost = 0; ///< frames of streams that are over
    std::uint64_t m_lostEvents = 0;
    std::string m_message;
};

LiveView::LiveView(LiveViewOptions options)
    : m_options(std::move(options)) {
    m_thread = std::thread([this] { run(); });
}

LiveView::~LiveView() {
    m_stopping = true;
    m_thread.join();
    const std::scoped_lock lock(m_mutex);
    for (const Added& added : m_added)
        added.tap->close();
}

void LiveView::run() {
    // First of all: sockets need what it makes.
    QEventLoop loop;
    Worker worker(*this);
    if (!worker.begin())
        return;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        worker.poll();
        if (m_stopping)
            loop.quit();
    });
    timer.start(kPoll_ms);
    loop.exec();
}

std::shared_ptr<core::StreamTap> LiveView::addStream(recording::StreamInfo info) {
    const bool isPicture = info.type == recording::ValueType::grey8;
    auto tap = std::make_shared<core::StreamTap>(isPicture ? kQueuePictures : kQueueBlocks);
    const std::scoped_lock lock(m_mutex);
    m_added.push_back({std::move(info), tap});
    return tap;
}

void LiveView::add(recording::RecordingEvent event) {
    const std::scoped_lock lock(m_mutex);
    if (m_events.size() < kMostEvents)
        m_events.push_back(std::move(event));
    else
        ++m_eventsDropped;
}

} // namespace teleta::foxglove
