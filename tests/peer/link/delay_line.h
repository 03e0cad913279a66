// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::peer {

/// What a link does to the packets of one direction.
struct LinkConditions {
    double delay_s = 0; ///< one way
    double jitter_s =
        0;             ///< each delay is uniform in delay -+ jitter, not below 0; packets overtake each other
    double loss = 0;   ///< probability, each packet by itself
    double repeat = 0; ///< probability that a packet comes twice
    double rate_bitPerS = std::numeric_limits<double>::infinity(); ///< of IP packets, before the delay
    bool cut = false;   ///< nothing enters; what is on the way arrives
    bool holds = false; ///< everything is kept back, and comes in one burst when this ends
};

/// Packets of one direction since the start.
struct LinkCounts {
    std::uint64_t entered = 0;
    std::uint64_t bytes = 0; ///< of those, with their IP headers
    std::uint64_t delivered = 0;
    std::uint64_t lost = 0; ///< by loss, a cut, or more than kMostPackets on the way
    std::uint64_t repeated = 0;
    std::uint64_t waiting = 0; ///< now on the way or held
};

/// Two network namespaces with nothing in them but a TUN device each, and the line between the two. They have
/// no names: the kernel removes them with this object and the programs in them, also when the test is killed.
/// IPv4 only, MTU 1500. A program enters one by setns(networkOf(end), CLONE_NEWNET) before exec, for example
/// in a QProcess::setChildProcessModifier. The line's thread asks for a real-time priority. Needs root and
/// /dev/net/tun: the constructor throws std::system_error without. Thread: any.
class DelayLine {
public:
    enum End { A, B };
    static constexpr std::size_t kMostPackets = 20'000;

    explicit DelayLine(std::uint64_t seed = 1);
    ~DelayLine();
    DelayLine(const DelayLine&) = delete;
    DelayLine& operator=(const DelayLine&) = delete;

    /// From now on, for packets that `from` sends; both start with a perfect link.
    void set(End from, const LinkConditions& conditions);
    [[nodiscard]] LinkCounts counts(End from) const;

    /// The namespace as a file; closed when a program is executed.
    [[nodiscard]] int networkOf(End end) const { return m_ends[end].network; }
    /// "10.199.0.1" and "10.199.0.2", on the device "tun0".
    [[nodiscard]] static std::string addressOf(End end);
    /// Does `work` in the namespace of `end`, on a thread of its own, and waits for it. Sockets stay there.
    void inside(End end, const std::function<void()>& work) const;

private:
    struct Packet {
        double due_s = 0;
        std::uint64_t number = 0;
        std::vector<std::uint8_t> bytes;
    };
    struct Way {
        LinkConditions conditions;
        LinkCounts counts;
        std::vector<Packet> onTheWay; ///< a heap, the earliest on top
        std::vector<Packet> held;
        double free_s = 0; ///< when the rate lets the next packet in
    };
    struct Ends {
        int network = -1;
        int device = -1;
        Way way; ///< of what this end sends
    };

    void run();
    void enter(Way& way, std::vector<std::uint8_t> bytes);
    void put(Way& way, Packet packet, double after_s);
    /// Delivers what is due; the time of the next, or infinity.
    double deliver(Way& way, int device);
    void close();

    mutable std::mutex m_mutex;
    std::array<Ends, 2> m_ends;
    std::mt19937_64 m_random;
    std::uint64_t m_number = 0;
    int m_wake = -1;
    std::atomic<bool> m_stops{false};
    std::thread m_thread;
};

} // namespace teleta::peer
