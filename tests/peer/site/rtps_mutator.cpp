// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody on the network without keys: keeps the RTPS packets that go through the loopback interface in a
// DDS domain, and sends changed copies of them to one that takes part. Needs the right to listen to an
// interface (root).
//   rtps_mutator DOMAIN PACKETS SEED
// Says "listening", collects until it gets a line with the id of a process, sends to the ports of that one,
// and says "sent N of SEEDS to PORTS dropped D"; D: those that did not fit into the buffers of the sockets.
#include "backend/core/file_descriptor.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <poll.h>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <sys/socket.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using Packet = std::vector<std::uint8_t>;
using teleta::core::FileDescriptor;

constexpr std::size_t kMostSeeds = 4000;
constexpr std::size_t kLongest = 9000;
/// Of a domain, with its multicast ports.
constexpr int kFirstPort = 7400;
constexpr int kPortsPerDomain = 250;
/// The kernel sends them in turns, so that a busy receiver gets most of them.
constexpr int kBatch = 40;
constexpr std::chrono::milliseconds kBetween{4};

void take(std::vector<Packet>& seeds, int domain, const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kUdp = 8;
    if (size < 20 || data[0] >> 4 != 4 || data[9] != IPPROTO_UDP)
        return;
    const std::size_t header = 4U * (data[0] & 0x0fU);
    if (size < header + kUdp + 20 || std::memcmp(data + header + kUdp, "RTPS", 4) != 0)
        return;
    const auto port = static_cast<std::uint16_t>(data[header + 2] << 8 | data[header + 3]);
    const int first = kFirstPort + domain * kPortsPerDomain;
    if (port < first || port >= first + kPortsPerDomain)
        return;
    if (seeds.size() < kMostSeeds)
        seeds.emplace_back(data + header + kUdp, data + size);
}

/// Until a line comes.
std::vector<Packet> collect(int domain) {
    std::vector<Packet> seeds;
    const FileDescriptor socket(::socket(AF_PACKET, SOCK_DGRAM, htons(ETH_P_IP)));
    sockaddr_ll place{};
    place.sll_family = AF_PACKET;
    place.sll_protocol = htons(ETH_P_IP);
    place.sll_ifindex = static_cast<int>(if_nametoindex("lo"));
    if (!socket.isOpen() ||
        bind(socket.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) {
        std::cout << "no right to listen" << std::endl;
        std::exit(77);
    }
    std::cout << "listening" << std::endl;
    std::array<std::uint8_t, 65536> data{};
    for (;;) {
        std::array<pollfd, 2> wait{{{socket.get(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
        (void)poll(wait.data(), wait.size(), -1);
        if (wait[1].revents != 0)
            return seeds;
        sockaddr_ll from{};
        socklen_t length = sizeof from;
        const ssize_t size =
            recvfrom(socket.get(), data.data(), data.size(), 0, reinterpret_cast<sockaddr*>(&from), &length);
        // Each one is there twice: as it goes and as it comes.
        if (size > 0 && from.sll_pkttype != PACKET_OUTGOING)
            take(seeds, domain, data.data(), static_cast<std::size_t>(size));
    }
}

/// Changes some seeds at random, in the ways that parsers are weak against.
class Mutator {
public:
    Mutator(const std::vector<Packet>& seeds, std::uint64_t seed)
        : m_seeds(seeds)
        , m_random(seed) {}

    Packet next() {
        Packet packet = seed();
        for (std::size_t changes = 1 + below(6); changes > 0 && !packet.empty(); --changes)
            change(packet);
        packet.resize(std::min(packet.size(), kLongest));
        return packet;
    }

private:
    std::size_t below(std::size_t end) { return m_random() % end; }
    const Packet& seed() { return m_seeds[below(m_seeds.size())]; }

    void change(Packet& packet) {
        constexpr std::array<std::uint8_t, 6> kBytes{0x00, 0x01, 0x7f, 0x80, 0xfe, 0xff};
        const std::size_t at = below(packet.size());
        switch (below(8)) {
        case 0:
            packet[at] ^= static_cast<std::uint8_t>(1U << below(8));
            break;
        case 1:
            packet[at] = kBytes[below(kBytes.size())];
            break;
        case 2: // cut off
            packet.resize(at);
            break;
        case 3: { // a length, a count or a number of four bytes
            const std::uint8_t byte = kBytes[below(kBytes.size())];
            for (std::size_t i = at; i < std::min(packet.size(), at + 4); ++i)
                packet[i] = byte;
            break;
        }
        case 4: { // a submessage of another packet
            const Packet& other = seed();
            const std::size_t from = std::min<std::size_t>(20, other.size());
            packet.insert(packet.end(), other.begin() + static_cast<std::ptrdiff_t>(from), other.end());
            break;
        }
        case 5: // the end of another packet
        {
            const Packet& other = seed();
            packet.resize(at);
            if (at < other.size())
                packet.insert(packet.end(), other.begin() + static_cast<std::ptrdiff_t>(at), other.end());
            break;
        }
        case 6: // the length of the first submessage
            if (packet.size() > 23) {
                packet[22] = static_cast<std::uint8_t>(below(256));
                packet[23] = static_cast<std::uint8_t>(below(256));
            }
            break;
        default: { // something is left out
            const std::size_t end = std::min(packet.size(), at + 1 + below(16));
            packet.erase(packet.begin() + static_cast<std::ptrdiff_t>(at),
                         packet.begin() + static_cast<std::ptrdiff_t>(end));
        }
        }
    }

    const std::vector<Packet>& m_seeds;
    std::mt19937_64 m_random;
};

/// The sockets of a process, by the number that the kernel has for each.
std::set<unsigned long> socketsOf(const std::string& process) {
    std::set<unsigned long> sockets;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/" + process + "/fd", none)) {
        const std::string target = std::filesystem::read_symlink(entry.path(), none).string();
        if (target.starts_with("socket:["))
            sockets.insert(std::strtoul(target.c_str() + 8, nullptr, 10));
    }
    return sockets;
}

struct Ports {
    std::vector<std::uint16_t> numbers;
    std::uint64_t dropped = 0; ///< packets that the kernel dropped there since they were opened
};

/// The ports of a domain that a process listens at.
Ports portsOf(const std::string& process, int domain) {
    const std::set<unsigned long> sockets = socketsOf(process);
    const int first = kFirstPort + domain * kPortsPerDomain;
    Ports ports;
    std::ifstream table("/proc/net/udp");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream words(line);
        std::vector<std::string> fields;
        for (std::string word; words >> word;)
            fields.push_back(word);
        constexpr std::size_t kAddress = 1;
        constexpr std::size_t kInode = 9;
        constexpr std::size_t kDrops = 12;
        if (fields.size() <= kDrops || !sockets.contains(std::strtoul(fields[kInode].c_str(), nullptr, 10)))
            continue;
        const auto port = static_cast<std::uint16_t>(
            std::strtoul(fields[kAddress].substr(fields[kAddress].find(':') + 1).c_str(), nullptr, 16));
        if (port < first || port >= first + kPortsPerDomain)
            continue;
        ports.numbers.push_back(port);
        ports.dropped += std::strtoull(fields[kDrops].c_str(), nullptr, 10);
    }
    return ports;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 4)
        return 2;
    const int domain = std::atoi(arguments[1]);
    const int packets = std::atoi(arguments[2]);
    const std::vector<Packet> seeds = collect(domain);
    std::string process;
    std::getline(std::cin, process);
    const Ports ports = portsOf(process, domain);
    if (seeds.empty() || ports.numbers.empty())
        return 3;
    const FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM, 0));
    Mutator mutator(seeds, std::strtoull(arguments[3], nullptr, 10));
    int sent = 0;
    for (int i = 0; i < packets; ++i) {
        const Packet packet = mutator.next();
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        to.sin_port = htons(ports.numbers[static_cast<std::size_t>(i) % ports.numbers.size()]);
        if (sendto(socket.get(), packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                   sizeof to) >= 0)
            ++sent;
        if (i % kBatch == 0)
            std::this_thread::sleep_for(kBetween);
    }
    std::cout << "sent " << sent << " of " << seeds.size() << " to " << ports.numbers.size() << " dropped "
              << portsOf(process, domain).dropped - ports.dropped << std::endl;
    return 0;
}
