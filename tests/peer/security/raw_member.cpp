// SPDX-License-Identifier: GPL-3.0-or-later
// A member that may be an attacker: it does not check its keys and asks Cyclone DDS directly.
#include "backend/ros/messages.h"
#include "devices/dds/dds_qos.h"
#include "devices/dds/domain_config.h"
#include "devices/dds/security.h"
#include "tests/peer/security/member_options.h"

#include <chrono>
#include <dds/dds.h>
#include <iostream>
#include <thread>

using namespace teleta;

namespace {

/// The entity, or the end of the program.
dds_entity_t checked(dds_entity_t entity, const char* what) {
    if (entity < 0) {
        std::cout << "error no " << what << ": " << dds_strretcode(entity) << std::endl;
        std::exit(1);
    }
    return entity;
}

void take(dds_entity_t reader) {
    void* sample = nullptr;
    dds_sample_info_t info{};
    while (dds_take(reader, &sample, &info, 1, 1) == 1) {
        if (info.valid_data)
            std::cout << "received " << static_cast<const ros::String*>(sample)->data << std::endl;
        (void)dds_return_loan(reader, &sample, 1);
    }
}

} // namespace

int main(int count, char** arguments) {
    peer::MemberOptions options(count, arguments);
    const auto domain = static_cast<dds_domainid_t>(options.domain);
    const std::string configuration =
        dds::configurationOf({.domain = options.domain, .interface = "lo", .peers = {}});
    checked(dds_create_domain(domain, configuration.c_str()), "domain");
    const dds::Qos qos(dds_create_qos());
    if (options.secured()) {
        for (const auto& [name, value] : dds::propertiesOf({options.keys}))
            dds_qset_prop(qos.get(), name.c_str(), value.c_str());
    }
    const dds_entity_t participant =
        checked(dds_create_participant(domain, qos.get(), nullptr), "participant");
    std::cout << "joined" << std::endl;
    const dds_entity_t topic = checked(dds_create_topic(participant, &ros::descriptorOf<ros::String>(),
                                                        options.ddsTopic.c_str(), nullptr, nullptr),
                                       "topic");
    const dds_entity_t end = options.publishes
                                 ? checked(dds_create_writer(participant, topic, nullptr, nullptr), "writer")
                                 : checked(dds_create_reader(participant, topic, nullptr, nullptr), "reader");
    std::cout << "started" << std::endl;
    const ros::String message{options.keys.data()};
    dds_return_t matched = 0;
    const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(options.seconds);
    while (std::chrono::steady_clock::now() < last) {
        const dds_return_t now = options.publishes ? dds_get_matched_subscriptions(end, nullptr, 0)
                                                   : dds_get_matched_publications(end, nullptr, 0);
        if (now != matched)
            std::cout << "matched " << (matched = now) << std::endl;
        if (options.publishes)
            (void)dds_write(end, &message);
        else
            take(end);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    std::cout << "end" << std::endl;
    return 0;
}
