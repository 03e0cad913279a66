// SPDX-License-Identifier: GPL-3.0-or-later
// The HID bracelet against the kernel's own HID stack. Runs in the virtual machine of tests/peer/vm, beside
// play_until_killed.
#include "backend/playback/player.h"
#include "devices/bracelet/hid_bracelet.h"
#include "tests/peer/bracelet/uhid_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

using namespace teleta;
using core::Drive;
using core::isOff;
using core::WriteOutcome;
using peer::turns;
using peer::UhidBoard;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Drive kSome{0x001, 0x002, 0xFFF, 0x800, 0xABC, 0x123};

/// For a machine that is emulated and busy.
const playback::PlayerConfig kPatient{.boardTimeout_ms = 2000, .longestSilence_ns = 4'000'000'000};

bool isZero(const UhidBoard::Frame& frame) {
    return std::all_of(frame.bytes.begin() + 3, frame.bytes.begin() + 12, [](int byte) { return byte == 0; });
}

playback::Program steady() {
    return {[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity};
}

class HidBraceletPeer : public testing::Test {
protected:
    void SetUp() override {
        m_board.plugIn();
        ASSERT_TRUE(eventually([&] { return !bracelet::listHidBracelets().empty(); }));
    }

    void open() {
        // The kernel lists a device a little before it lets it be opened.
        ASSERT_TRUE(eventually([&] {
            auto opened = bracelet::openHidBracelet({}, m_stop);
            if (opened)
                m_bracelet = std::move(*opened);
            return opened.has_value();
        }));
        m_bracelet->start(m_wakeup);
        ASSERT_TRUE(eventually([&] { return m_bracelet->status().state == core::DeviceState::live; }));
    }

    template <typename Condition>
    [[nodiscard]] bool eventually(const Condition& condition) {
        for (int i = 0; i < 3000; ++i) {
            if (condition())
                return true;
            m_wakeup.waitFor(std::chrono::milliseconds(10));
        }
        return condition();
    }

    core::WriteResult write(const Drive& drive, std::uint16_t timeout_ms = 1000) {
        return m_bracelet->write({drive, timeout_ms, m_bracelet->connection()});
    }

    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    UhidBoard m_board{"TB-0042"};
    std::unique_ptr<core::BraceletLink> m_bracelet;
};

} // namespace

TEST_F(HidBraceletPeer, findsTheBoardAndAsksItWhoItIs) {
    const auto listed = bracelet::listHidBracelets();
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].serial, "TB-0042");
    EXPECT_EQ(listed[0].product, "Bracelet of tactors");
    open();
    EXPECT_EQ(m_bracelet->description().serial, "TB-0042");
    EXPECT_EQ(m_bracelet->description().model, "42");
    EXPECT_EQ(m_bracelet->description().firmware, "1.9");
    EXPECT_EQ(m_bracelet->description().maximumRate_Hz, 500.0);
    EXPECT_EQ(m_bracelet->description().longestTimeout_ms, 10'000);
}

TEST_F(HidBraceletPeer, takesOnlyTheBoardWithTheSerialNumberThatWasAsked) {
    const bracelet::HidBraceletConfig other{.serial = "TB-0043"};
    EXPECT_FALSE(bracelet::openHidBracelet(other, m_stop));
}

TEST_F(HidBraceletPeer, isOneProgramsAtATime) {
    open();
    const auto second = bracelet::openHidBracelet({}, m_stop);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("Another program uses the bracelet"), std::string::npos)
        << second.error().message;
    m_bracelet.reset();
    EXPECT_TRUE(eventually([&] { return bracelet::openHidBracelet({}, m_stop).has_value(); }));
}

TEST_F(HidBraceletPeer, bringsEveryByteOfAFrameToTheBoardAndItsAnswerBack) {
    open();
    m_board.forgetFrames();
    ASSERT_EQ(write(kSome, 300).outcome, WriteOutcome::written);
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return !state.frames.empty(); }));
    UhidBoard::Bytes bytes = m_board.state().frames[0].bytes;
    ASSERT_EQ(bytes.size(), 14U);
    bytes[1] = bytes[2] = 0;
    EXPECT_EQ(bytes, (UhidBoard::Bytes{0x01, 0, 0, 0x01, 0x20, 0x00, 0xFF, 0x0F, 0x80, 0xBC, 0x3A, 0x12, 0x2C,
                                       0x01}));
    EXPECT_EQ(m_board.state().motors, (std::array<int, 6>{0x001, 0x002, 0xFFF, 0x800, 0xABC, 0x123}));
    ASSERT_TRUE(eventually([&] { return m_bracelet->telemetry().board.driving; }));
    EXPECT_DOUBLE_EQ(m_bracelet->telemetry().board.supply_V, 4.9);
    EXPECT_DOUBLE_EQ(m_bracelet->telemetry().board.temperature_degC, 31.1);
}

TEST_F(HidBraceletPeer, losesNothingWhileTheBoardKeepsUp) {
    open();
    for (int i = 0; i < 500; ++i) {
        ASSERT_EQ(write(kSome).outcome, WriteOutcome::written);
        const std::uint64_t written = m_bracelet->telemetry().framesWritten;
        ASSERT_TRUE(eventually([&] { return m_bracelet->telemetry().framesEchoed >= written; }));
    }
    const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
    EXPECT_EQ(telemetry.framesLost, 0U);
    EXPECT_EQ(telemetry.strayEchoes, 0U);
    EXPECT_EQ(telemetry.damagedReports, 0U);
}

// The kernel's queue to a uhid device holds 31 events and drops what comes on top, and yet says "written".
TEST_F(HidBraceletPeer, countsWhatTheKernelDropsInSilence) {
    open();
    m_board.setAwake(false);
    for (int i = 0; i < 100; ++i)
        ASSERT_EQ(write(kSome).outcome, WriteOutcome::written);
    m_board.setAwake(true);
    ASSERT_TRUE(eventually([&] {
        (void)write(kSome);
        return m_bracelet->telemetry().framesLost > 0;
    }));
    const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
    EXPECT_GE(telemetry.framesLost, 60U);
    EXPECT_LE(telemetry.framesLost, 100U);
}

TEST_F(HidBraceletPeer, zeroesTheBoardWhenItIsClosed) {
    open();
    write(kSome);
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
    m_bracelet->stop();
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return !state.opened; }));
    EXPECT_FALSE(turns(m_board.state()));
    EXPECT_TRUE(isZero(m_board.state().frames.back()));
    EXPECT_EQ(m_board.state().timeouts, 0);
}

TEST_F(HidBraceletPeer, isLostWhenItIsUnpluggedWhilePlayingAndZeroWhenItComesBack) {
    open();
    playback::Player player(*m_bracelet, m_stop, kPatient);
    player.play(steady());
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
    m_board.unplug();
    ASSERT_TRUE(eventually([&] { return player.status().ending == playback::PlayerEnding::deviceLost; }));
    ASSERT_TRUE(eventually([&] { return m_bracelet->status().state == core::DeviceState::reconnecting; }));
    EXPECT_FALSE(m_bracelet->status().message.empty());
    ASSERT_TRUE(m_board.forgetWhatWasWritten());
    m_board.plugIn();
    ASSERT_TRUE(eventually([&] { return m_bracelet->status().state == core::DeviceState::live; }));
    EXPECT_EQ(m_bracelet->connection(), 2U);
    for (const UhidBoard::Frame& frame : m_board.state().frames)
        EXPECT_TRUE(isZero(frame)) << "nothing plays unless asked";
    player.play(steady());
    EXPECT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
}

// What was written while the board slept waits in the kernel: it may play for as long as the time-outs of
// those frames last, and no longer.
TEST_F(HidBraceletPeer, playsOnlyWhenAskedAfterTheBoardSleptAndWoke) {
    open();
    playback::Player player(*m_bracelet, m_stop, kPatient);
    player.play(steady());
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
    m_board.setAwake(false);
    ASSERT_TRUE(eventually([&] { return player.status().ending == playback::PlayerEnding::deviceLost; }));
    m_board.setAwake(true);
    ASSERT_TRUE(eventually([&] { return m_bracelet->status().state == core::DeviceState::live; }));
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return !turns(state); }));
    m_board.forgetFrames();
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return state.frames.size() > 5; }));
    for (const UhidBoard::Frame& frame : m_board.state().frames)
        EXPECT_TRUE(isZero(frame));
    EXPECT_EQ(player.status().mode, playback::PlayerMode::idle);
    player.play(steady());
    EXPECT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
}

TEST_F(HidBraceletPeer, writesAProgramInOneFramePerCycleAndZeroAtItsEnd) {
    open();
    playback::Player player(*m_bracelet, m_stop, kPatient);
    player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, 1.0});
    ASSERT_TRUE(eventually([&] { return player.status().ending == playback::PlayerEnding::finished; }));
    const playback::PlayerCounters counters = player.counters();
    std::printf("1 s at 200 Hz: %llu frames, %llu deadlines missed, %llu lost, write %lld us median, %lld us "
                "longest\n",
                static_cast<unsigned long long>(counters.framesWritten),
                static_cast<unsigned long long>(counters.deadlineMisses),
                static_cast<unsigned long long>(counters.framesLost),
                static_cast<long long>(counters.writeMedian_ns / 1000),
                static_cast<long long>(counters.writeLongest_ns / 1000));
    // Deadlines of 1 s at 200 Hz; the last ones can be later than its end.
    EXPECT_GT(counters.framesWritten, 0U);
    EXPECT_LE(counters.framesWritten + counters.deadlineMisses, 200U);
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return !turns(state); }));
    EXPECT_EQ(m_board.state().timeouts, 0) << "by a frame, not by its time-out";
}

TEST_F(HidBraceletPeer, stopsByItselfWhenTheProgramThatPlaysIsKilled) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        execl("./play_until_killed", "play_until_killed", nullptr);
        _exit(127);
    }
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return turns(state); }));
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return state.frames.size() > 50; }));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    ASSERT_TRUE(m_board.waitFor([](const UhidBoard::State& state) { return !turns(state); }));
    const UhidBoard::State state = m_board.state();
    EXPECT_EQ(state.timeouts, 1) << "by its time-out: no zero frame came";
    EXPECT_FALSE(isZero(state.frames.back()));
    EXPECT_EQ(state.frames.back().bytes[12] + 256 * state.frames.back().bytes[13], 500);
    EXPECT_GE(state.timedOutAt_ns - state.frames.back().time_ns, 500'000'000);
}
