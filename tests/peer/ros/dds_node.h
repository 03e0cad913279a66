// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace teleta::peer {

/// The QoS of one end. History is keep last `depth`; deadline, liveliness and lifespan are infinite, as in
/// ROS 2.
struct EndQos {
    bool reliable = true;
    bool transientLocal = false;
    int depth = 1;
};

/// A participant of Fast DDS on 127.0.0.1 alone: no multicast, no shared memory. Functions throw
/// std::runtime_error. Thread: any, one at a time.
class DdsNode {
public:
    /// `domain`: 0 to 232.
    explicit DdsNode(int domain);
    ~DdsNode();
    DdsNode(const DdsNode&) = delete;
    DdsNode& operator=(const DdsNode&) = delete;

    /// The writer of a ROS topic ("/joint_states").
    eprosima::fastdds::dds::DataWriter* write(const std::string& topic,
                                              eprosima::fastdds::dds::TypeSupport type, const EndQos& qos,
                                              eprosima::fastdds::dds::DataWriterListener* listener = nullptr);
    eprosima::fastdds::dds::DataReader* read(const std::string& topic,
                                             eprosima::fastdds::dds::TypeSupport type, const EndQos& qos,
                                             eprosima::fastdds::dds::DataReaderListener* listener);
    void remove(eprosima::fastdds::dds::DataWriter* writer);

private:
    eprosima::fastdds::dds::Topic* topicOf(const std::string& name,
                                           const eprosima::fastdds::dds::TypeSupport& type);

    eprosima::fastdds::dds::DomainParticipant* m_participant = nullptr;
    eprosima::fastdds::dds::Publisher* m_publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* m_subscriber = nullptr;
};

/// Keeps what arrives until it is taken. It must outlive the node that reads into it.
/// Thread: take() any.
template <class Message>
class Inbox final : public eprosima::fastdds::dds::DataReaderListener {
public:
    void on_data_available(eprosima::fastdds::dds::DataReader* reader) override {
        Message message;
        eprosima::fastdds::dds::SampleInfo info;
        while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
            if (info.valid_data) {
                const std::lock_guard lock(m_mutex);
                m_messages.push_back(std::move(message));
            }
            message = Message();
        }
    }
    void on_subscription_matched(eprosima::fastdds::dds::DataReader*,
                                 const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override {
        m_writers = status.current_count;
    }
    void on_requested_incompatible_qos(
        eprosima::fastdds::dds::DataReader*,
        const eprosima::fastdds::dds::RequestedIncompatibleQosStatus& status) override {
        m_incompatible = status.total_count;
    }

    [[nodiscard]] std::vector<Message> take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_messages, {});
    }
    [[nodiscard]] int writers() const { return m_writers; }
    [[nodiscard]] int incompatible() const { return m_incompatible; }

private:
    std::mutex m_mutex;
    std::vector<Message> m_messages;
    std::atomic<int> m_writers{0};
    std::atomic<int> m_incompatible{0};
};

} // namespace teleta::peer
