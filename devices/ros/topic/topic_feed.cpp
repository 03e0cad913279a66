// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/topic/topic_feed.h"

#include "backend/ros/topic_names.h"
#include "devices/dds/qos_text.h"

#include <QCoreApplication>

#include <cstdint>
#include <utility>

namespace teleta::ros_topic {

namespace {

struct TopicFeedText {
    Q_DECLARE_TR_FUNCTIONS(TopicFeedText)
};

constexpr std::int64_t kLook_ns = 50'000'000;

} // namespace

core::Expected<std::unique_ptr<TopicFeed>> TopicFeed::open(const dds::DomainConfig& domain, std::string topic,
                                                           const dds_topic_descriptor_t& type, int depth) {
    TELETA_TRY(std::shared_ptr<const dds::Participant> participant, dds::Participant::open(domain));
    TELETA_TRY(auto reader, dds::AnyReader::open(participant, ros::ddsTopicOf(topic), type,
                                                 ros::kSensorReader.withDepth(depth)));
    return std::unique_ptr<TopicFeed>(
        new TopicFeed(std::move(topic), std::move(participant), std::move(reader)));
}

TopicFeed::TopicFeed(std::string topic, std::shared_ptr<const dds::Participant> participant,
                     dds::AnyReader reader)
    : m_topic(std::move(topic))
    , m_participant(std::move(participant))
    , m_reader(std::move(reader))
    , m_waitSet(m_participant) {
    m_waitSet.attach(m_reader);
}

void TopicFeed::wait() {
    m_waitSet.wait(kLook_ns);
}

void TopicFeed::take(const std::function<void(const void* message)>& take) {
    (void)m_reader.takeAny([&take](const void* message, const dds::SampleInfo&) { take(message); });
}

std::string TopicFeed::silence(const std::string& misfit) const {
    const QString topic = QString::fromStdString(m_topic);
    if (!misfit.empty())
        return TopicFeedText::tr("%1: %2").arg(topic, QString::fromStdString(misfit)).toStdString();
    if (m_reader.matched() > 0)
        return TopicFeedText::tr("%1 is silent").arg(topic).toStdString();
    if (const auto mismatch = m_reader.incompatible())
        return dds::describe(*mismatch).toStdString();
    return TopicFeedText::tr("nobody publishes %1").arg(topic).toStdString();
}

} // namespace teleta::ros_topic
