// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/recording/stream_sink.h"
#include "backend/site/control_arbiter.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/site/image/picture_sender.h"
#include "devices/site/site_topics.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace teleta::site_link {

/// The device that a stream of the running system belongs to: "pad" of "pad-frames"; empty: it is not sent.
/// Of other numbers than those of a device's own sensors only temperatures are; of grey pictures only those
/// of gels with markers.
[[nodiscard]] std::string deviceOf(const recording::StreamInfo& stream);

/// Where such a stream is sent.
struct StreamTopic {
    const char* kind; ///< "joints", "tactile", "temperatures", "wrench", "image", "rest"
    std::string name;
    const dds_topic_descriptor_t* type;
    ros::QosProfile profile;
};
/// stream: of a device, deviceOf().
[[nodiscard]] StreamTopic topicOf(const recording::StreamInfo& stream, const SiteTopics& topics);

/// Sends joints, forces, frames, temperatures and pictures of a site's devices to its consoles, from threads
/// of its own. What is computed of them is not sent: the consoles compute it. Data threads leave copies in
/// taps and never wait; what comes too fast is counted and told. Thread: any; no call waits but the
/// destructor, for the threads to end.
class SiteStreams : public recording::StreamSink {
public:
    static constexpr std::int64_t kPoll_ns = 4'000'000;
    /// Of a message, so that the network does not take it apart; one frame may be larger.
    static constexpr std::size_t kMessage_bytes = 1150;

    /// How the pictures of each camera are sent, by the name of the device; of the others as usual.
    using Pictures = std::map<std::string, PictureSettings, std::less<>>;

    /// Error: unavailable, a topic cannot be opened.
    [[nodiscard]] static core::Expected<std::shared_ptr<SiteStreams>>
    open(std::shared_ptr<const dds::Participant> participant, const SiteTopics& topics,
         const site::BootName& boot, Pictures pictures = {});
    ~SiteStreams() override;

    [[nodiscard]] std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override;
    void add(recording::RecordingEvent) override {}

    /// What is sent, in the order in which it was added. Error: a stream's topic could not be opened.
    [[nodiscard]] core::Expected<std::vector<recording::StreamInfo>> streams() const;
    /// As PictureSender::problem().
    [[nodiscard]] std::optional<core::Error> pictureProblem() const { return m_pictureSender.problem(); }

private:
    struct Stream {
        recording::StreamInfo info;
        std::shared_ptr<core::StreamTap> tap;
        dds::AnyWriter writer;
        std::uint64_t next = 0; ///< number of the next sample or frame
        std::uint64_t lost = 0; ///< by the source and in the tap, as told; these have numbers, too
    };

    SiteStreams(std::shared_ptr<const dds::Participant> participant, const SiteTopics& topics,
                const site::BootName& boot, Pictures pictures, dds::Writer<ros::String> descriptions);

    void run();
    void send(Stream& stream);
    void sendJoints(Stream& stream, core::TappedFrames& block);
    void sendFrames(Stream& stream, core::TappedFrames& block);

    std::shared_ptr<const dds::Participant> m_participant;
    SiteTopics m_topics;
    site::BootName m_boot;
    Pictures m_pictures;
    dds::Writer<ros::String> m_descriptions;
    mutable std::mutex m_mutex;
    std::vector<std::unique_ptr<Stream>> m_streams; ///< grows only; guarded by m_mutex, as the next two
    std::vector<recording::StreamInfo> m_infos;     ///< of all streams, those of cameras as well
    std::optional<core::Error> m_failure;
    PictureSender m_pictureSender;
    std::atomic<bool> m_stopping{false};
    std::thread m_thread;
};

} // namespace teleta::site_link
