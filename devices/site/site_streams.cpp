// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/site_streams.h"

#include "backend/core/steady_time.h"
#include "backend/recording/stream_columns.h"
#include "devices/site/stream_descriptions.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace teleta::site_link {

namespace {

/// Blocks of a stream that may wait: a second of an array at 200 Hz, frame by frame.
constexpr std::size_t kTapBlocks = 256;
/// Header, boot name, numbers and lengths of a message.
constexpr std::size_t kOverhead_bytes = 90;
constexpr std::size_t kTimes_bytes = 16; ///< of one sample or frame

constexpr std::string_view kJointsEnd = "-joints";
constexpr std::string_view kFramesEnd = "-frames";
constexpr std::string_view kWrenchEnd = "-wrench";
constexpr std::string_view kTemperaturesEnd = "-temperatures";
constexpr std::string_view kPicturesEnd = "-scene";
constexpr std::string_view kGelEnd = "-camera";
constexpr std::string_view kRestEnd = "-reference";

std::size_t fitting(std::size_t bytesEach) {
    return std::max<std::size_t>(1, (SiteStreams::kMessage_bytes - kOverhead_bytes) / bytesEach);
}

template <typename Number>
std::span<Number> numbersOf(core::TappedFrames& block) {
    return {reinterpret_cast<Number*>(block.values.data()), block.values.size() / sizeof(Number)};
}

/// A message of some frames of the block, with their times.
template <typename Message>
Message messageOf(const site::BootName& boot, core::TappedFrames& block, std::size_t first,
                  std::size_t count) {
    Message message{};
    std::ranges::copy(boot, std::begin(message.site_boot));
    ros::lend(message.read_site_ns, std::span(block.time_ns).subspan(first, count));
    ros::lend(message.source_s, std::span(block.sourceTime_s).subspan(first, count));
    message.discontinuity = first == 0 && block.discontinuity ? 1 : 0;
    return message;
}

} // namespace

std::string deviceOf(const recording::StreamInfo& stream) {
    const std::string_view end = stream.kind == recording::StreamKind::joints    ? kJointsEnd
                                 : stream.kind == recording::StreamKind::array   ? kFramesEnd
                                 : stream.kind == recording::StreamKind::wrench  ? kWrenchEnd
                                 : stream.kind == recording::StreamKind::numbers ? kTemperaturesEnd
                                 : recording::isColour(stream)                   ? kPicturesEnd
                                 : isGel(stream)                                 ? kGelEnd
                                 : isGelAtRest(stream)                           ? kRestEnd
                                                                                 : std::string_view();
    std::string_view name = stream.name;
    if (end.empty() || !name.ends_with(end))
        return {};
    name.remove_suffix(end.size());
    return isSiteName(name) ? std::string(name) : std::string();
}

StreamTopic topicOf(const recording::StreamInfo& stream, const SiteTopics& topics) {
    const std::string device = deviceOf(stream);
    switch (stream.kind) {
    case recording::StreamKind::joints:
        return {"joints", topics.joints(device), &ros::descriptorOf<ros::JointBlock>(), kStreamed};
    case recording::StreamKind::camera:
        if (isGelAtRest(stream))
            return {"rest", topics.rest(device), &ros::descriptorOf<ros::ImageFrame>(), kLatched};
        // Markers are followed from picture to picture, so none is overtaken.
        return {"image", topics.image(device), &ros::descriptorOf<ros::ImageFrame>(),
                isGel(stream) ? kStreamed : kNewest};
    case recording::StreamKind::wrench:
        return {"wrench", topics.wrench(device), &ros::descriptorOf<ros::TactileBlock>(), kStreamed};
    case recording::StreamKind::numbers:
        return {"temperatures", topics.temperatures(device), &ros::descriptorOf<ros::TactileBlock>(),
                kStreamed};
    default:
        return {"tactile", topics.tactile(device), &ros::descriptorOf<ros::TactileBlock>(), kStreamed};
    }
}

core::Expected<std::shared_ptr<SiteStreams>>
SiteStreams::open(std::shared_ptr<const dds::Participant> participant, const SiteTopics& topics,
                  const site::BootName& boot, Pictures pictures) {
    TELETA_TRY(auto descriptions, dds::Writer<ros::String>::open(participant, topics.streams(), kLatched));
    return std::shared_ptr<SiteStreams>(
        new SiteStreams(std::move(participant), topics, boot, std::move(pictures), std::move(descriptions)));
}

SiteStreams::SiteStreams(std::shared_ptr<const dds::Participant> participant, const SiteTopics& topics,
                         const site::BootName& boot, Pictures pictures, dds::Writer<ros::String> descriptions)
    : m_participant(std::move(participant))
    , m_topics(topics)
    , m_boot(boot)
    , m_pictures(std::move(pictures))
    , m_descriptions(std::move(descriptions))
    , m_pictureSender(boot)
    , m_thread([this] { run(); }) {
}

SiteStreams::~SiteStreams() {
    m_stopping = true;
    m_thread.join();
    for (const auto& stream : m_streams)
        stream->tap->close();
}

std::shared_ptr<core::StreamTap> SiteStreams::addStream(recording::StreamInfo info) {
    auto tap = std::make_shared<core::StreamTap>(kTapBlocks);
    const std::string device = deviceOf(info);
    if (device.empty()) {
        tap->close();
        return tap;
    }
    const StreamTopic topic = topicOf(info, m_topics);
    auto writer = dds::AnyWriter::open(m_participant, topic.name, *topic.type, topic.profile);
    const std::scoped_lock lock(m_mutex);
    if (!writer) {
        m_failure = writer.error();
        tap->close();
        return tap;
    }
    m_infos.push_back(info);
    if (info.kind == recording::StreamKind::camera) {
        const auto settings = m_pictures.find(device);
        tap = m_pictureSender.add(std::move(*writer),
                                  settings == m_pictures.end() ? PictureSettings() : settings->second,
                                  isGel(info)         ? SentPicture::grey
                                  : isGelAtRest(info) ? SentPicture::rest
                                                      : SentPicture::colour);
    } else {
        m_streams.push_back(std::make_unique<Stream>(Stream{std::move(info), tap, std::move(*writer)}));
    }
    std::string text = describeStreams(m_infos);
    ros::String message{};
    message.data = text.data();
    (void)m_descriptions.write(message);
    return tap;
}

core::Expected<std::vector<recording::StreamInfo>> SiteStreams::streams() const {
    const std::scoped_lock lock(m_mutex);
    if (m_failure)
        return core::Unexpected(*m_failure);
    return m_infos;
}

void SiteStreams::run() {
    std::vector<Stream*> known;
    while (!m_stopping) {
        {
            const std::scoped_lock lock(m_mutex);
            for (std::size_t i = known.size(); i < m_streams.size(); ++i)
                known.push_back(m_streams[i].get());
        }
        for (Stream* stream : known)
            send(*stream);
        std::this_thread::sleep_for(std::chrono::nanoseconds(kPoll_ns));
    }
}

void SiteStreams::send(Stream& stream) {
    core::TappedFrames joined;
    // What waits is sent together; a jump of the stream begins a message of its own.
    const auto flush = [&] {
        if (joined.frames() == 0)
            return;
        if (stream.info.kind == recording::StreamKind::joints)
            sendJoints(stream, joined);
        else
            sendFrames(stream, joined);
        joined = {};
    };
    core::TappedFrames block;
    for (std::size_t left = stream.tap->capacity(); left > 0 && stream.tap->pop(block); --left) {
        if (block.discontinuity || joined.frames() == 0) {
            flush();
            joined = std::move(block);
            block = {};
            continue;
        }
        joined.time_ns.insert(joined.time_ns.end(), block.time_ns.begin(), block.time_ns.end());
        joined.sourceTime_s.insert(joined.sourceTime_s.end(), block.sourceTime_s.begin(),
                                   block.sourceTime_s.end());
        joined.values.insert(joined.values.end(), block.values.begin(), block.values.end());
    }
    flush();
    const std::uint64_t lost = stream.tap->lost() + stream.tap->dropped();
    stream.next += lost - stream.lost;
    stream.lost = lost;
}

void SiteStreams::sendJoints(Stream& stream, core::TappedFrames& block) {
    const std::size_t joints = recording::jointsOf(stream.info).value_or(0);
    const std::span<const double> values = numbersOf<double>(block);
    const std::size_t most = fitting(kTimes_bytes + joints * (sizeof(double) + 3 * sizeof(float)));
    for (std::size_t first = 0; first < block.frames(); first += most) {
        const std::size_t count = std::min(most, block.frames() - first);
        std::vector<double> position;
        std::vector<float> effort;
        std::vector<float> offset;
        for (std::size_t i = first; i < first + count; ++i) {
            const std::span<const double> one =
                values.subspan(i * recording::kJointKinds * joints, recording::kJointKinds * joints);
            for (std::size_t joint = 0; joint < joints; ++joint) {
                position.push_back(one[joint]);
                effort.push_back(static_cast<float>(one[joints + joint]));
                offset.push_back(static_cast<float>(one[2 * joints + joint] - one[joint]));
            }
        }
        // Devices tell no velocities.
        std::vector<float> velocity(position.size(), std::numeric_limits<float>::quiet_NaN());
        auto message = messageOf<ros::JointBlock>(m_boot, block, first, count);
        message.first = stream.next;
        message.lost = static_cast<std::uint32_t>(stream.lost);
        ros::lend(message.position, std::span(position));
        ros::lend(message.velocity, std::span(velocity));
        ros::lend(message.effort, std::span(effort));
        ros::lend(message.reference_offset, std::span(offset));
        (void)stream.writer.writeAny(&message);
        stream.next += count;
    }
}

void SiteStreams::sendFrames(Stream& stream, core::TappedFrames& block) {
    const std::size_t taxels = stream.info.channels();
    std::vector<float> narrowed; // of forces and temperatures, which are recorded in double precision
    if (stream.info.type == recording::ValueType::float64) {
        const std::span<const double> wide = numbersOf<double>(block);
        narrowed.assign(wide.begin(), wide.end());
    }
    const std::span<float> values = narrowed.empty() ? numbersOf<float>(block) : std::span(narrowed);
    const std::size_t most = fitting(kTimes_bytes + taxels * sizeof(float));
    for (std::size_t first = 0; first < block.frames(); first += most) {
        const std::size_t count = std::min(most, block.frames() - first);
        auto message = messageOf<ros::TactileBlock>(m_boot, block, first, count);
        message.first = stream.next;
        message.lost = static_cast<std::uint32_t>(stream.lost);
        ros::lend(message.values, values.subspan(first * taxels, count * taxels));
        (void)stream.writer.writeAny(&message);
        stream.next += count;
    }
}

} // namespace teleta::site_link
