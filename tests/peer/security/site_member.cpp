// SPDX-License-Identifier: GPL-3.0-or-later
// A member as the programs of the project are one. It also says "refused TEXT" when another one is kept out.
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "tests/peer/security/member_options.h"

#include <chrono>
#include <iostream>
#include <thread>

using namespace teleta;

namespace {

/// Tells what changes, and lets `step` send or take until the time is over.
template <class End, class Step>
void run(const dds::Participant& participant, const End& end, int seconds, const Step& step) {
    std::cout << "started" << std::endl;
    std::size_t matched = 0;
    std::string reason;
    const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (std::chrono::steady_clock::now() < last) {
        if (end.matched() != matched)
            std::cout << "matched " << (matched = end.matched()) << std::endl;
        if (const dds::Refusals refusals = participant.refusals(); refusals.reason != reason)
            std::cout << "refused " << (reason = refusals.reason) << std::endl;
        step();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    std::cout << "end" << std::endl;
}

core::Expected<void> takePart(peer::MemberOptions& options) {
    const std::optional<dds::Security> security =
        options.secured() ? std::optional(dds::Security{options.keys}) : std::nullopt;
    TELETA_TRY(
        const auto participant,
        dds::Participant::open({.domain = options.domain, .interface = "lo", .peers = {}}, {}, security));
    std::cout << "joined" << std::endl;
    if (options.publishes) {
        TELETA_TRY(auto writer,
                   dds::Writer<ros::String>::open(participant, options.ddsTopic, ros::kCommandWriter));
        const ros::String message{options.keys.data()};
        run(*participant, writer, options.seconds, [&] { (void)writer.write(message); });
        return {};
    }
    TELETA_TRY(auto reader,
               dds::Reader<ros::String>::open(participant, options.ddsTopic, ros::kSensorReader));
    run(*participant, reader, options.seconds, [&] {
        reader.take([](const ros::String& message, const dds::SampleInfo&) {
            std::cout << "received " << message.data << std::endl;
        });
    });
    return {};
}

} // namespace

int main(int count, char** arguments) {
    peer::MemberOptions options(count, arguments);
    const auto result = takePart(options);
    if (!result)
        std::cout << "error " << core::describe(result.error()) << std::endl;
    return result ? 0 : 1;
}
