// SPDX-License-Identifier: GPL-3.0-or-later
#include "delay_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <arpa/inet.h>
#include <chrono>
#include <cmath>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

using namespace teleta::peer;

namespace {

constexpr std::uint16_t kPort = 9000;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

sockaddr_in placeOf(DelayLine::End end) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(kPort);
    inet_pton(AF_INET, DelayLine::addressOf(end).c_str(), &place.sin_addr);
    return place;
}

/// A UDP socket in one namespace that sends numbers to the other end.
class Station {
public:
    Station(const DelayLine& line, DelayLine::End end)
        : m_other(placeOf(end == DelayLine::A ? DelayLine::B : DelayLine::A)) {
        line.inside(end, [&] { m_socket = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0); });
        const sockaddr_in own = placeOf(end);
        EXPECT_EQ(bind(m_socket, reinterpret_cast<const sockaddr*>(&own), sizeof(own)), 0);
        const int bytes = 4 << 20;
        setsockopt(m_socket, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof(bytes));
    }
    ~Station() { close(m_socket); }
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    void send(int number, std::size_t bytes = sizeof(int)) const {
        std::vector<char> packet(bytes);
        std::copy_n(reinterpret_cast<const char*>(&number), sizeof(number), packet.begin());
        EXPECT_EQ(sendto(m_socket, packet.data(), bytes, 0, reinterpret_cast<const sockaddr*>(&m_other),
                         sizeof(m_other)),
                  static_cast<ssize_t>(bytes));
    }
    /// The next number, or -1 when none comes within the time.
    [[nodiscard]] int receive(int patience_ms = 10'000) const {
        pollfd waiting{m_socket, POLLIN, 0};
        int number = -1;
        char packet[2000];
        if (poll(&waiting, 1, patience_ms) == 1 && recv(m_socket, packet, sizeof(packet), 0) > 0)
            std::copy_n(packet, sizeof(number), reinterpret_cast<char*>(&number));
        return number;
    }

private:
    sockaddr_in m_other;
    int m_socket = -1;
};

class DelayLineTest : public ::testing::Test {
protected:
    void SetUp() override {
        try {
            m_line = std::make_unique<DelayLine>();
        } catch (const std::system_error& error) {
            if (error.code() == std::errc::operation_not_permitted ||
                error.code() == std::errc::permission_denied ||
                error.code() == std::errc::no_such_file_or_directory)
                GTEST_SKIP() << "needs root and /dev/net/tun: " << error.what();
            throw;
        }
        m_a = std::make_unique<Station>(*m_line, DelayLine::A);
        m_b = std::make_unique<Station>(*m_line, DelayLine::B);
    }

    void setBoth(const LinkConditions& conditions) {
        m_line->set(DelayLine::A, conditions);
        m_line->set(DelayLine::B, conditions);
    }

    /// Waits until this many packets of A came in at the line.
    void waitForEntered(std::uint64_t packets) {
        for (int i = 0; i < 10'000 && m_line->counts(DelayLine::A).entered < packets; ++i)
            usleep(1000);
        ASSERT_EQ(m_line->counts(DelayLine::A).entered, packets);
    }

    std::vector<double> roundTrips_s(int count) {
        std::vector<double> times;
        for (int i = 0; i < count; ++i) {
            const double sent_s = now_s();
            m_a->send(i);
            EXPECT_EQ(m_b->receive(), i);
            m_b->send(i);
            EXPECT_EQ(m_a->receive(), i);
            times.push_back(now_s() - sent_s);
        }
        return times;
    }

    std::unique_ptr<DelayLine> m_line;
    std::unique_ptr<Station> m_a;
    std::unique_ptr<Station> m_b;
};

} // namespace

TEST_F(DelayLineTest, makesRoundTripsOfTwiceTheDelay) {
    setBoth({.delay_s = 0.02});
    const std::vector<double> times_s = roundTrips_s(50);
    // None can be quicker. The quickest of many has met no other program.
    const double quickest_s = *std::min_element(times_s.begin(), times_s.end());
    EXPECT_GE(quickest_s, 0.04);
    EXPECT_LT(quickest_s, 0.045);
}

TEST_F(DelayLineTest, spreadsDelaysByTheJitter) {
    m_line->set(DelayLine::A, {.delay_s = 0.02, .jitter_s = 0.01});
    const std::vector<double> times_s = roundTrips_s(50);
    const auto [quickest, slowest] = std::minmax_element(times_s.begin(), times_s.end());
    EXPECT_GE(*quickest, 0.01);
    EXPECT_LT(*quickest, 0.02); // all 50 above the mean: probability 2^-50
    EXPECT_GT(*slowest, 0.02);
}

TEST_F(DelayLineTest, losesItsShareAndRepeatsItsShare) {
    constexpr int kPackets = 2000;
    const LinkConditions conditions{.loss = 0.2, .repeat = 0.1};
    m_line->set(DelayLine::A, conditions);
    for (int i = 0; i < kPackets; ++i) {
        m_a->send(i);
        if (i % 100 == 99)
            waitForEntered(static_cast<std::uint64_t>(i) + 1);
    }
    m_line->set(DelayLine::A, {});
    m_a->send(kPackets);
    std::vector<int> seen(kPackets + 1, 0);
    for (int number = 0; number != kPackets;)
        ++seen.at(static_cast<std::size_t>(number = m_b->receive()));
    // Four standard deviations of the binomial distribution; the seed is fixed.
    const auto near = [](auto count, double n, double p) {
        return std::abs(static_cast<double>(count) - n * p) < 4 * std::sqrt(n * p * (1 - p));
    };
    const auto lost = std::count(seen.begin(), seen.end(), 0);
    const auto twice = std::count(seen.begin(), seen.end(), 2);
    EXPECT_TRUE(near(lost, kPackets, 0.2)) << lost;
    EXPECT_TRUE(near(twice, kPackets * 0.8, 0.1)) << twice;
    const LinkCounts counts = m_line->counts(DelayLine::A);
    EXPECT_EQ(counts.lost, static_cast<std::uint64_t>(lost));
    EXPECT_EQ(counts.repeated, static_cast<std::uint64_t>(twice));
    EXPECT_EQ(counts.entered, kPackets + 1U);
}

TEST_F(DelayLineTest, keepsToItsRate) {
    m_line->set(DelayLine::A, {.rate_bitPerS = 1e6});
    const double start_s = now_s();
    for (int i = 0; i < 30; ++i)
        m_a->send(i, 1000);
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(m_b->receive(), i);
    EXPECT_GE(now_s() - start_s, 30 * (1000 + 28) * 8 / 1e6); // with the headers of UDP and IP
}

TEST_F(DelayLineTest, isCutInOneDirection) {
    m_line->set(DelayLine::A, {.cut = true});
    for (int i = 0; i < 10; ++i)
        m_a->send(i);
    waitForEntered(10);
    m_b->send(77);
    EXPECT_EQ(m_a->receive(), 77);
    m_line->set(DelayLine::A, {});
    m_a->send(10);
    EXPECT_EQ(m_b->receive(), 10);
    EXPECT_EQ(m_line->counts(DelayLine::A).lost, 10U);
}

TEST_F(DelayLineTest, letsWhatItHeldGoInOneBurst) {
    m_line->set(DelayLine::A, {.holds = true});
    for (int i = 0; i < 10; ++i)
        m_a->send(i);
    waitForEntered(10);
    EXPECT_EQ(m_b->receive(0), -1);
    EXPECT_EQ(m_line->counts(DelayLine::A).waiting, 10U);
    m_line->set(DelayLine::A, {});
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(m_b->receive(), i);
}

TEST_F(DelayLineTest, hasNamespacesOfItsOwnThatGoWithIt) {
    struct stat own {};
    struct stat ends[2]{};
    ASSERT_EQ(stat("/proc/self/ns/net", &own), 0);
    for (const DelayLine::End end : {DelayLine::A, DelayLine::B})
        ASSERT_EQ(fstat(m_line->networkOf(end), &ends[end]), 0);
    EXPECT_NE(ends[0].st_ino, own.st_ino);
    EXPECT_NE(ends[0].st_ino, ends[1].st_ino);
    // The thread of the test is where it was.
    struct stat after {};
    ASSERT_EQ(stat("/proc/thread-self/ns/net", &after), 0);
    EXPECT_EQ(after.st_ino, own.st_ino);
    const int file = m_line->networkOf(DelayLine::A);
    m_a.reset();
    m_b.reset();
    m_line.reset();
    EXPECT_EQ(fcntl(file, F_GETFD), -1);
}
