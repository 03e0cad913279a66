// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/bracelet_link.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <deque>
#include <mutex>
#include <vector>

using namespace teleta;
using core::BoardReport;
using core::BraceletFrame;
using core::BraceletPort;
using core::DeviceState;
using core::Drive;
using core::isOff;
using core::kFullDrive;
using core::WriteOutcome;
using test::eventually;
using test::ManualClock;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr Drive kSome{100, 200, 300, 400, 500, 600};

struct Taken {
    std::uint16_t sequence = 0;
    Drive drive{};
    std::uint16_t timeout_ms = 0;
    int connection = 0;
};

/// The board's side of all connections, played by the test.
class Board {
public:
    bool take(Taken frame) {
        const std::scoped_lock lock(m_mutex);
        if (!m_plugged || m_refusesFrames)
            return false;
        m_taken.push_back(frame);
        if (m_answers)
            m_reports.push_back({.sequence = frame.sequence,
                                 .driving = !isOff(frame.drive),
                                 .frameRefused = m_understandsNothing,
                                 .supply_V = 4.9});
        return true;
    }
    BraceletPort::Read read(BoardReport& report) {
        const std::scoped_lock lock(m_mutex);
        if (!m_plugged)
            return BraceletPort::Read::lost;
        if (m_damaged > 0) {
            --m_damaged;
            return BraceletPort::Read::damaged;
        }
        if (m_reports.empty())
            return BraceletPort::Read::nothing;
        report = m_reports.front();
        m_reports.pop_front();
        return BraceletPort::Read::report;
    }
    core::Expected<core::OpenedBracelet> open();

    template <typename Change>
    void change(const Change& change) {
        const std::scoped_lock lock(m_mutex);
        change(*this);
    }
    [[nodiscard]] std::vector<Taken> taken() const {
        const std::scoped_lock lock(m_mutex);
        return m_taken;
    }
    [[nodiscard]] int opened() const {
        const std::scoped_lock lock(m_mutex);
        return m_opened;
    }

    bool m_plugged = true;
    bool m_answers = true;
    bool m_refusesFrames = false;
    bool m_understandsNothing = false; ///< and says so
    int m_ports = 0;                   ///< that are open
    int m_damaged = 0;
    std::string m_serial = "A1";
    std::deque<BoardReport> m_reports;
    std::vector<Taken> m_taken;

private:
    mutable std::mutex m_mutex;
    int m_opened = 0;
};

class Port : public BraceletPort {
public:
    Port(Board& board, int connection)
        : m_board(board)
        , m_connection(connection) {
        ++m_board.m_ports; // in Board::open(), which has the lock
    }
    ~Port() override {
        m_board.change([](Board& board) { --board.m_ports; });
    }
    bool write(std::uint16_t sequence, const Drive& drive, std::uint16_t timeout_ms) override {
        return m_board.take({sequence, drive, timeout_ms, m_connection});
    }
    Read read(BoardReport& report) override { return m_board.read(report); }

private:
    Board& m_board;
    int m_connection;
};

core::Expected<core::OpenedBracelet> Board::open() {
    const std::scoped_lock lock(m_mutex);
    ++m_opened;
    if (!m_plugged)
        return core::Unexpected(core::Error{core::ErrorKind::unavailable, "not there", {}, {}});
    if (m_ports > 0)
        return core::Unexpected(core::Error{core::ErrorKind::unavailable, "one at a time", {}, {}});
    core::BraceletDescription description;
    description.serial = m_serial;
    description.highestDrive = 4000;
    description.longestTimeout_ms = 5000;
    return core::OpenedBracelet{std::make_unique<Port>(*this, m_opened), description};
}

class BraceletLinkTest : public testing::Test {
protected:
    BraceletLinkTest() {
        m_link = std::make_unique<core::BraceletLink>(
            *m_board.open(), [this] { return m_board.open(); }, m_stop,
            core::BraceletLinkConfig{.clock = m_clock});
    }

    void start() {
        m_link->start(m_wakeup);
        m_clock->settle();
    }
    void advance_ms(int duration_ms) {
        for (int i = 0; i < duration_ms; i += 5)
            m_clock->advance(5 * kMs_ns);
    }
    core::WriteResult write(const Drive& drive, std::uint16_t timeout_ms = 100) {
        return m_link->write({drive, timeout_ms, m_link->connection()});
    }
    void unplug() {
        m_board.change([](Board& board) { board.m_plugged = false; });
    }
    void plugIn() {
        m_board.change([](Board& board) { board.m_plugged = true; });
    }
    [[nodiscard]] DeviceState state() const { return m_link->status().state; }
    [[nodiscard]] bool becomes(DeviceState state) {
        return eventually(m_wakeup, [&] { return m_link->status().state == state; });
    }

    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    Board m_board;
    std::unique_ptr<core::BraceletLink> m_link;
};

} // namespace

TEST_F(BraceletLinkTest, writesAZeroFrameFirstAndLast) {
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::lost) << "it was not started";
    start();
    EXPECT_EQ(m_link->connection(), 1U);
    ASSERT_EQ(m_board.taken().size(), 1U);
    EXPECT_TRUE(isOff(m_board.taken()[0].drive));
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
    EXPECT_EQ(m_board.taken().back().drive, kSome);
    m_link->stop();
    EXPECT_TRUE(isOff(m_board.taken().back().drive));
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_EQ(m_link->connection(), 0U);
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::lost);
    m_link->stop();
}

TEST_F(BraceletLinkTest, isLiveWhenTheBoardAnswersAndTellsWhatItSays) {
    start();
    write(kSome);
    write(kSome);
    EXPECT_EQ(state(), DeviceState::live);
    const core::BraceletTelemetry telemetry = m_link->telemetry();
    EXPECT_EQ(telemetry.board.sequence, 3);
    EXPECT_TRUE(telemetry.board.driving);
    EXPECT_EQ(telemetry.board.supply_V, 4.9);
    EXPECT_EQ(telemetry.reported_ns, m_clock->now_ns());
    EXPECT_EQ(telemetry.written, kSome);
    EXPECT_EQ(telemetry.framesWritten, 3U);
    EXPECT_EQ(telemetry.framesEchoed, 3U);
    EXPECT_EQ(telemetry.framesLost, 0U);
    EXPECT_EQ(m_link->status().framesRead, 3U);
    EXPECT_EQ(m_link->status().lastData_ns, m_clock->now_ns());
}

TEST_F(BraceletLinkTest, keepsTheBoardsOwnLimits) {
    start();
    write({kFullDrive, 65535, 4000, 3999, 1, 0}, 60'000);
    EXPECT_EQ(m_board.taken().back().drive, (Drive{4000, 4000, 4000, 3999, 1, 0}));
    EXPECT_EQ(m_board.taken().back().timeout_ms, 5000);
    write(kSome, 0);
    EXPECT_EQ(m_board.taken().back().timeout_ms, 1);
}

TEST_F(BraceletLinkTest, zeroesTheMotorsWhenNoFrameWasWrittenFor100ms) {
    start();
    write(kSome);
    m_clock->advance(99 * kMs_ns);
    EXPECT_FALSE(isOff(m_board.taken().back().drive));
    m_clock->advance(1 * kMs_ns);
    EXPECT_TRUE(isOff(m_board.taken().back().drive));
    EXPECT_EQ(m_link->telemetry().zeroedByDevice, 1U);
    const std::size_t before = m_board.taken().size();
    advance_ms(1000);
    EXPECT_EQ(m_board.taken().size(), before + 10) << "while idle, so that telemetry stays fresh";
    EXPECT_EQ(m_link->telemetry().zeroedByDevice, 1U);
    EXPECT_EQ(state(), DeviceState::live);
}

TEST_F(BraceletLinkTest, writesZeroWhateverIsWantedWhileSTOPIsEngaged) {
    start();
    write(kSome);
    m_stop.engage();
    m_clock->advance(10 * kMs_ns);
    EXPECT_TRUE(isOff(m_board.taken().back().drive)) << "unasked, at the next look";
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
    EXPECT_TRUE(isOff(m_board.taken().back().drive));
    m_stop.release();
    write(kSome);
    EXPECT_EQ(m_board.taken().back().drive, kSome);
}

TEST_F(BraceletLinkTest, isLostInAWriteToAnUnpluggedBoardAndConnectsAgain) {
    start();
    write(kSome);
    const std::uint64_t old = m_link->connection();
    unplug();
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::lost);
    EXPECT_EQ(state(), DeviceState::lost);
    EXPECT_FALSE(m_link->status().message.empty());
    EXPECT_EQ(m_link->connection(), 0U);
    EXPECT_EQ(m_link->telemetry().framesLost, 1U) << "it was in flight";
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        m_clock->advance(100 * kMs_ns);
        return state() == DeviceState::reconnecting;
    }));
    EXPECT_FALSE(m_link->status().message.empty());
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::lost);

    plugIn();
    const std::size_t before = m_board.taken().size();
    m_clock->advance(2000 * kMs_ns);
    ASSERT_NE(m_link->connection(), 0U) << "within the longest time between two attempts";
    EXPECT_NE(m_link->connection(), old);
    const std::vector<Taken> taken = m_board.taken();
    ASSERT_GT(taken.size(), before);
    EXPECT_TRUE(isOff(taken[before].drive)) << "before anything else";
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_TRUE(m_link->status().message.empty());
}

TEST_F(BraceletLinkTest, noticesAtIdleThatTheBoardIsGone) {
    start();
    unplug();
    m_clock->advance(10 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::lost);
}

TEST_F(BraceletLinkTest, refusesFramesThatWereMadeForAnEarlierConnection) {
    start();
    const std::uint64_t old = m_link->connection();
    unplug();
    m_clock->advance(10 * kMs_ns);
    plugIn();
    m_clock->advance(100 * kMs_ns);
    ASSERT_EQ(m_link->connection(), 2U);
    const std::size_t before = m_board.taken().size();
    EXPECT_EQ(m_link->write({kSome, 100, old}).outcome, WriteOutcome::refused);
    EXPECT_EQ(m_board.taken().size(), before);
    EXPECT_EQ(m_link->write({{}, 100, old}).outcome, WriteOutcome::written) << "zero is always taken";
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
}

TEST_F(BraceletLinkTest, waitsLongerFromAttemptToAttempt) {
    start();
    unplug();
    m_clock->advance(10 * kMs_ns);
    ASSERT_EQ(state(), DeviceState::lost);
    std::vector<int> attemptsAt_ms;
    int attempts = m_board.opened();
    for (int time_ms = 10; time_ms <= 8000; time_ms += 10) {
        m_clock->advance(10 * kMs_ns);
        if (m_board.opened() != attempts) {
            attempts = m_board.opened();
            attemptsAt_ms.push_back(time_ms);
        }
    }
    EXPECT_EQ(attemptsAt_ms, (std::vector{100, 300, 700, 1500, 3100, 5100, 7100}));
}

TEST_F(BraceletLinkTest, connectsAgainToABoardOfOneConnectionThatTookNoFirstFrame) {
    start();
    unplug();
    m_clock->advance(10 * kMs_ns);
    m_board.change([](Board& board) { board.m_refusesFrames = board.m_plugged = true; });
    m_clock->advance(100 * kMs_ns);
    ASSERT_EQ(m_board.opened(), 2);
    ASSERT_EQ(m_link->connection(), 0U);
    m_board.change([](Board& board) { board.m_refusesFrames = false; });
    advance_ms(5000);
    EXPECT_EQ(m_link->connection(), 2U);
    EXPECT_EQ(state(), DeviceState::live);
}

TEST_F(BraceletLinkTest, takesNoOtherBoardForItsOwn) {
    start();
    unplug();
    m_clock->advance(10 * kMs_ns);
    m_board.change([](Board& board) {
        board.m_serial = "B2";
        board.m_plugged = true;
    });
    const std::size_t before = m_board.taken().size();
    advance_ms(10'000);
    EXPECT_EQ(state(), DeviceState::reconnecting);
    EXPECT_EQ(m_board.taken().size(), before);
    m_board.change([](Board& board) { board.m_serial = "A1"; });
    advance_ms(2000);
    EXPECT_EQ(state(), DeviceState::live);
}

TEST_F(BraceletLinkTest, isStaleWhenTheBoardAnswersNoMore) {
    start();
    write(kSome);
    m_board.change([](Board& board) { board.m_answers = false; });
    advance_ms(500);
    EXPECT_EQ(state(), DeviceState::live);
    advance_ms(20);
    EXPECT_EQ(state(), DeviceState::stale);
    m_board.change([](Board& board) { board.m_answers = true; });
    advance_ms(200);
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_GE(m_link->telemetry().framesLost, 4U) << "the frames that were not answered meanwhile";
}

TEST_F(BraceletLinkTest, staysConnectingWhileTheBoardNeverAnswered) {
    m_board.change([](Board& board) { board.m_answers = false; });
    start();
    advance_ms(5000);
    EXPECT_EQ(state(), DeviceState::connecting);
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
}

TEST_F(BraceletLinkTest, countsReportsThatItDoesNotUnderstand) {
    start();
    m_board.change([](Board& board) { board.m_damaged = 3; });
    m_clock->advance(10 * kMs_ns);
    EXPECT_EQ(m_link->telemetry().damagedReports, 3U);
    EXPECT_EQ(state(), DeviceState::live);
}

TEST_F(BraceletLinkTest, takesNoFrameForConfirmedThatTheBoardRefused) {
    start();
    m_board.change([](Board& board) { board.m_understandsNothing = true; });
    write(kSome);
    write(kSome);
    const core::BraceletTelemetry telemetry = m_link->telemetry();
    EXPECT_EQ(telemetry.framesRefused, 2U);
    EXPECT_EQ(telemetry.framesLost, 2U);
    EXPECT_EQ(telemetry.framesEchoed, 1U) << "the zero frame of the connection";
    EXPECT_EQ(telemetry.newestEchoed, 1U);
    EXPECT_EQ(telemetry.newestSent, 3U);
    EXPECT_EQ(state(), DeviceState::live) << "it answers";
}

TEST_F(BraceletLinkTest, survivesABoardThatSendsWithoutEnd) {
    start();
    m_board.change([](Board& board) { board.m_reports.resize(100'000); });
    m_clock->advance(10 * kMs_ns);
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
    EXPECT_GT(m_link->telemetry().strayEchoes, 0U);
    m_link->stop();
    EXPECT_TRUE(isOff(m_board.taken().back().drive));
}

TEST_F(BraceletLinkTest, startsAnewAfterStop) {
    start();
    write(kSome);
    m_link->stop();
    start();
    EXPECT_EQ(m_board.opened(), 2);
    EXPECT_EQ(m_link->telemetry().framesWritten, 1U);
    EXPECT_TRUE(isOff(m_board.taken().back().drive));
    EXPECT_EQ(m_board.taken().back().connection, 2);
    EXPECT_EQ(write(kSome).outcome, WriteOutcome::written);
}

TEST_F(BraceletLinkTest, stopsAtOnceWhileItLooksForTheBoard) {
    start();
    unplug();
    ASSERT_EQ(write(kSome).outcome, WriteOutcome::lost);
    m_link->stop();
    EXPECT_EQ(state(), DeviceState::closed);
    start();
    EXPECT_TRUE(becomes(DeviceState::reconnecting));
    m_link.reset(); // the destructor stops
}
