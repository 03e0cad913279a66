// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/dds/domain_config.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"

#include <functional>
#include <memory>
#include <string>

namespace teleta::ros_topic {

/// A topic that one worker reads. Thread: wake() from any; the rest from the worker's.
class TopicFeed {
public:
    /// Joins the domain. depth: so many messages are kept until they are taken. Error: as
    /// dds::Participant::open() and dds::AnyReader::open().
    [[nodiscard]] static core::Expected<std::unique_ptr<TopicFeed>>
    open(const dds::DomainConfig& domain, std::string topic, const dds_topic_descriptor_t& type, int depth);

    /// Returns when a message has come, after wake(), or after a moment.
    void wait();
    void wake() { m_waitSet.wake(); }
    /// Hands over all messages that have come since the last call, in their order. A message is valid during
    /// the call.
    void take(const std::function<void(const void* message)>& take);

    /// Why nothing comes that can be used. misfit: what is wrong with the newest message; empty: nothing is.
    [[nodiscard]] std::string silence(const std::string& misfit) const;

private:
    TopicFeed(std::string topic, std::shared_ptr<const dds::Participant> participant, dds::AnyReader reader);

    std::string m_topic;
    std::shared_ptr<const dds::Participant> m_participant;
    dds::AnyReader m_reader;
    dds::WaitSet m_waitSet;
};

} // namespace teleta::ros_topic
