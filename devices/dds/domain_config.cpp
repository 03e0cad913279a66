// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/domain_config.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace teleta::dds {

namespace {

struct DomainText {
    Q_DECLARE_TR_FUNCTIONS(DdsDomain)
};

constexpr const char* kDomainVariable = "ROS_DOMAIN_ID";

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result + "\"";
}

bool isAddress(std::string_view interface) {
    return interface.find(':') != std::string_view::npos ||
           (!interface.empty() && interface.find_first_not_of("0123456789.") == std::string_view::npos);
}

} // namespace

bool isLoopback(std::string_view interface) {
    return interface == "lo" || interface == "::1" || interface.starts_with("127.");
}

std::string configurationOf(const DomainConfig& config, std::optional<int> priority) {
    std::string xml = "<CycloneDDS><Domain Id=" + quoted(std::to_string(config.domain)) + "><General>";
    if (!config.interface.empty())
        xml += "<Interfaces><NetworkInterface " +
               std::string(isAddress(config.interface) ? "address=" : "name=") + quoted(config.interface) +
               "/></Interfaces>";
    xml += "<AllowMulticast>false</AllowMulticast>";
    // So that the network does not take messages apart: one lost part of a packet would be all of it.
    if (!isLoopback(config.interface))
        xml += "<MaxMessageSize>1300B</MaxMessageSize><FragmentSize>1200B</FragmentSize>";
    xml += "</General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>" +
           std::to_string(kProgramsPerComputer - 1) + "</MaxAutoParticipantIndex><Peers>";
    std::vector<std::string> peers{isLoopback(config.interface) ? "127.0.0.1" : "localhost"};
    for (const std::string& peer : config.peers) {
        if (std::ranges::find(peers, peer) == peers.end())
            peers.push_back(peer);
    }
    for (const std::string& peer : peers)
        xml += "<Peer Address=" + quoted(peer) + "/>";
    // Packets of discovery are repeated within the lease; at the default a lost one costs seconds.
    xml += "</Peers><LeaseDuration>2s</LeaseDuration></Discovery>";
    // Each domain fills such buffers from one end to the other. Of 1 MiB, the default, a quiet domain goes on
    // to take new pages for a quarter of an hour.
    xml += "<Sizing><ReceiveBufferSize>256KiB</ReceiveBufferSize></Sizing>";
    if (priority) {
        // A second thread for unicast cannot be given a priority.
        xml += "<Internal><MultipleReceiveThreads>false</MultipleReceiveThreads></Internal><Threads>";
        for (const char* thread : {"recv", "tev", "dq.user"})
            xml += "<Thread Name=" + quoted(thread) + "><Scheduling><Class>realtime</Class><Priority>" +
                   std::to_string(*priority) + "</Priority></Scheduling></Thread>";
        xml += "</Threads>";
    }
    return xml + "</Domain></CycloneDDS>";
}

core::Expected<int> defaultDomain() {
    const char* variable = std::getenv(kDomainVariable);
    if (variable == nullptr || *variable == '\0')
        return 0;
    const std::string_view text(variable);
    int domain = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
    if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kHighestDomain)
        return core::failed(core::ErrorKind::badInput,
                            DomainText::tr("the environment variable %1 is \"%2\"")
                                .arg(QLatin1String(kDomainVariable), QString::fromLocal8Bit(variable)),
                            DomainText::tr("a whole number from 0 to %1").arg(kHighestDomain));
    return domain;
}

} // namespace teleta::dds
