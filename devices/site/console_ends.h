// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/site/control_arbiter.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/site/site_topics.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::site_link {

/// A site's ends of the topics of one console. Who writes is proven by the topic, which the permissions bind
/// to the console's certificate, not by a field.
struct ConsoleEnds {
    std::string name;
    dds::Reader<ros::ConsolePresence> presence;
    dds::Reader<ros::ControlRequest> request;
    dds::Reader<ros::SiteArmCommand> command;
    dds::Reader<ros::ClockProbe> probe;
    dds::Writer<ros::ClockAnswer> answer;
    /// Its last requests, for the state that answers them.
    struct Request {
        std::uint64_t id = 0;
        std::int64_t first_ns = 0;                   ///< when it came first
        std::int64_t seen_ns = 0;                    ///< when it came last
        std::optional<site::RequestAnswer> answer{}; ///< empty: the arbiter knows it
    };
    std::deque<Request> requests{};
    bool nameTaken = false; ///< that another program has its name was told

    /// Error: unavailable, a topic cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<ConsoleEnds>>
    open(const std::shared_ptr<const dds::Participant>& participant, const SiteTopics& topics,
         const std::string& name) {
        TELETA_TRY(auto presence,
                   dds::Reader<ros::ConsolePresence>::open(participant, topics.presence(name), kNewest));
        TELETA_TRY(auto request,
                   dds::Reader<ros::ControlRequest>::open(participant, topics.request(name), kRequests));
        TELETA_TRY(auto command,
                   dds::Reader<ros::SiteArmCommand>::open(participant, topics.command(name), kNewest));
        TELETA_TRY(auto probe,
                   dds::Reader<ros::ClockProbe>::open(participant, topics.clockProbe(name), kNewest));
        TELETA_TRY(auto answer,
                   dds::Writer<ros::ClockAnswer>::open(participant, topics.clockAnswer(name), kNewest));
        return std::unique_ptr<ConsoleEnds>(new ConsoleEnds{name, std::move(presence), std::move(request),
                                                            std::move(command), std::move(probe),
                                                            std::move(answer)});
    }
};

} // namespace teleta::site_link
