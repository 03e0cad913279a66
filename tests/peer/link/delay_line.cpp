// SPDX-License-Identifier: GPL-3.0-or-later
#include "delay_line.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace teleta::peer {

namespace {

int checked(int result, const char* what) {
    if (result < 0)
        throw std::system_error(errno, std::generic_category(), what);
    return result;
}

/// Runs on a new thread, whose namespace `work` may change, and passes on what it throws.
void onThread(const std::function<void()>& work) {
    std::exception_ptr failure;
    std::thread([&] {
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
    }).join();
    if (failure)
        std::rethrow_exception(failure);
}

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void setAddress(int socket, ifreq& request, unsigned long what, const std::string& address) {
    sockaddr_in value{};
    value.sin_family = AF_INET;
    inet_pton(AF_INET, address.c_str(), &value.sin_addr);
    std::memcpy(&request.ifr_addr, &value, sizeof(value));
    checked(ioctl(socket, what, &request), "address of the device");
}

void setUp(int socket, const char* device) {
    ifreq request{};
    std::strncpy(request.ifr_name, device, IFNAMSIZ - 1);
    checked(ioctl(socket, SIOCGIFFLAGS, &request), device);
    request.ifr_flags |= IFF_UP;
    checked(ioctl(socket, SIOCSIFFLAGS, &request), device);
}

/// In a new namespace of this thread: its file and its device.
void makeEnd(const std::string& address, int& network, int& device) {
    checked(unshare(CLONE_NEWNET), "a network namespace");
    network = checked(open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC), "/proc/thread-self/ns/net");
    device = checked(open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK), "/dev/net/tun");
    ifreq request{};
    std::strncpy(request.ifr_name, "tun0", IFNAMSIZ - 1);
    request.ifr_flags = IFF_TUN | IFF_NO_PI;
    checked(ioctl(device, TUNSETIFF, &request), "tun0");
    const int socket = checked(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0), "socket");
    try {
        setAddress(socket, request, SIOCSIFADDR, address);
        setAddress(socket, request, SIOCSIFNETMASK, "255.255.255.252");
        setUp(socket, "tun0");
        setUp(socket, "lo");
    } catch (...) {
        ::close(socket);
        throw;
    }
    ::close(socket);
}

/// For heaps: the earliest on top; those of one time in their order.
constexpr auto kLater = [](const auto& a, const auto& b) {
    return a.due_s != b.due_s ? a.due_s > b.due_s : a.number > b.number;
};

} // namespace

DelayLine::DelayLine(std::uint64_t seed)
    : m_random(seed) {
    try {
        for (const End end : {A, B})
            onThread([&] { makeEnd(addressOf(end), m_ends[end].network, m_ends[end].device); });
        m_wake = checked(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd");
        m_thread = std::thread([this] { run(); });
    } catch (...) {
        close();
        throw;
    }
}

DelayLine::~DelayLine() {
    m_stops = true;
    eventfd_write(m_wake, 1);
    m_thread.join();
    close();
}

void DelayLine::close() {
    for (Ends& end : m_ends)
        for (const int file : {end.network, end.device})
            if (file >= 0)
                ::close(file);
    if (m_wake >= 0)
        ::close(m_wake);
}

std::string DelayLine::addressOf(End end) {
    return end == A ? "10.199.0.1" : "10.199.0.2";
}

void DelayLine::inside(End end, const std::function<void()>& work) const {
    onThread([&] {
        checked(setns(networkOf(end), CLONE_NEWNET), "the namespace");
        work();
    });
}

void DelayLine::set(End from, const LinkConditions& conditions) {
    {
        const std::lock_guard lock(m_mutex);
        Way& way = m_ends[from].way;
        way.conditions = conditions;
        if (!conditions.holds)
            for (Packet& packet : std::exchange(way.held, {}))
                put(way, std::move(packet), 0);
    }
    eventfd_write(m_wake, 1);
}

LinkCounts DelayLine::counts(End from) const {
    const std::lock_guard lock(m_mutex);
    const Way& way = m_ends[from].way;
    LinkCounts counts = way.counts;
    counts.waiting = way.onTheWay.size() + way.held.size();
    return counts;
}

void DelayLine::put(Way& way, Packet packet, double after_s) {
    packet.due_s = now_s() + after_s;
    packet.number = m_number++;
    way.onTheWay.push_back(std::move(packet));
    std::push_heap(way.onTheWay.begin(), way.onTheWay.end(), kLater);
}

void DelayLine::enter(Way& way, std::vector<std::uint8_t> bytes) {
    const auto uniform = [this] { return std::uniform_real_distribution<double>(0, 1)(m_random); };
    const LinkConditions& conditions = way.conditions;
    ++way.counts.entered;
    way.counts.bytes += bytes.size();
    if (conditions.cut || uniform() < conditions.loss ||
        way.onTheWay.size() + way.held.size() >= kMostPackets) {
        ++way.counts.lost;
        return;
    }
    const double time_s = now_s();
    way.free_s =
        std::max(way.free_s, time_s) + 8 * static_cast<double>(bytes.size()) / conditions.rate_bitPerS;
    const int copies = uniform() < conditions.repeat ? 2 : 1;
    way.counts.repeated += copies == 2 ? 1 : 0;
    for (int copy = 0; copy < copies; ++copy) {
        Packet packet{.bytes = bytes};
        const double jitter_s = conditions.jitter_s * (2 * uniform() - 1);
        if (conditions.holds)
            way.held.push_back(std::move(packet));
        else
            put(way, std::move(packet), way.free_s - time_s + std::max(0.0, conditions.delay_s + jitter_s));
    }
}

double DelayLine::deliver(Way& way, int device) {
    while (!way.onTheWay.empty() && way.onTheWay.front().due_s <= now_s()) {
        std::pop_heap(way.onTheWay.begin(), way.onTheWay.end(), kLater);
        const std::vector<std::uint8_t> bytes = std::move(way.onTheWay.back().bytes);
        way.onTheWay.pop_back();
        if (write(device, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()))
            ++way.counts.delivered;
        else
            ++way.counts.lost;
    }
    return way.onTheWay.empty() ? std::numeric_limits<double>::infinity() : way.onTheWay.front().due_s;
}

void DelayLine::run() {
    sched_param priority{};
    priority.sched_priority = 30;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    std::array<pollfd, 3> files{
        {{m_ends[A].device, POLLIN, 0}, {m_ends[B].device, POLLIN, 0}, {m_wake, POLLIN, 0}}};
    double next_s = std::numeric_limits<double>::infinity();
    while (!m_stops) {
        const double wait_s = std::clamp(next_s - now_s(), 0.0, 1.0);
        const timespec timeout{static_cast<time_t>(wait_s),
                               static_cast<long>(1e9 * (wait_s - std::floor(wait_s)))};
        ppoll(files.data(), files.size(), &timeout, nullptr);
        eventfd_t ignored = 0;
        eventfd_read(m_wake, &ignored);
        const std::lock_guard lock(m_mutex);
        for (Ends& end : m_ends) {
            std::vector<std::uint8_t> bytes(2048);
            for (ssize_t size = 0; (size = read(end.device, bytes.data(), bytes.size())) > 0;)
                // What else the kernel sends into a new device (IPv6) stays out.
                if (bytes.front() >> 4 == 4)
                    enter(end.way, {bytes.begin(), bytes.begin() + size});
        }
        next_s = std::min(deliver(m_ends[A].way, m_ends[B].device), deliver(m_ends[B].way, m_ends[A].device));
    }
}

} // namespace teleta::peer
