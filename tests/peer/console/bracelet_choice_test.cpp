// SPDX-License-Identifier: GPL-3.0-or-later
// The bracelet that the operator chooses, by a file or as it is plugged in, against the kernel's HID stack.
#include "app/console/bracelet/bracelet_service.h"
#include "devices/bracelet/hid_bracelet.h"
#include "tests/peer/bracelet/uhid_board.h"

#include <QCoreApplication>
#include <QObject>

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletService;
using core::DeviceState;
using peer::turns;
using peer::UhidBoard;

namespace {

constexpr std::uint16_t kOwnProductId = 0x0007;
constexpr auto kLongest = std::chrono::seconds(90); // the machine is emulated
/// For a machine that is emulated and busy.
const playback::PlayerConfig kPatient{.boardTimeout_ms = 5000, .longestSilence_ns = 30'000'000'000};
/// The example file: its ids are those that are looked for without a file.
const QString kExample = QStringLiteral("usb-bracelet.toml");

playback::Program steady() {
    return {[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; },
            std::numeric_limits<double>::infinity()};
}

class BraceletChoicePeer : public testing::Test {
protected:
    void SetUp() override {
        QObject::connect(&m_station, &BraceletService::failed,
                         [this](const core::Error& error) { m_failures.push_back(describe(error)); });
    }

    template <typename Condition>
    [[nodiscard]] bool eventually(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + kLongest;
        while (std::chrono::steady_clock::now() < end) {
            QCoreApplication::processEvents();
            m_station.tick();
            if (condition())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return condition();
    }

    void plugIn(UhidBoard& board, std::uint16_t productId) {
        board.plugIn();
        // The kernel lists a device a little before it lets it be opened.
        bracelet::HidBraceletConfig config;
        config.productId = productId;
        ASSERT_TRUE(eventually([&] { return bracelet::openHidBracelet(config, m_stop).has_value(); }));
        ASSERT_TRUE(board.waitFor([](const UhidBoard::State& state) { return !state.opened; }));
    }

    [[nodiscard]] DeviceState state() const {
        const auto reading = m_station.reading();
        return reading ? reading->state : DeviceState::closed;
    }
    [[nodiscard]] bool isPlayable() {
        return eventually([&] { return !m_failures.empty() || m_station.isAnswering(); }) &&
               m_failures.empty();
    }
    [[nodiscard]] std::string failure() const { return m_failures.empty() ? "none" : m_failures.front(); }

    core::StopSwitch m_stop;
    BraceletService m_station{m_stop, nullptr, kPatient};
    std::vector<std::string> m_failures;
};

} // namespace

TEST_F(BraceletChoicePeer, aFileWithIdsOfItsOwnPlaysOnItsBoardAndOnNoOther) {
    UhidBoard usual("TB-0001");
    UhidBoard own("TB-0700", kOwnProductId);
    ASSERT_NO_FATAL_FAILURE(plugIn(usual, 0x0001));
    ASSERT_NO_FATAL_FAILURE(plugIn(own, kOwnProductId));
    const int opened = usual.state().openings;
    const std::string path = "/tmp/own-bracelet.toml";
    std::ofstream(path) << "kind = 'hid_bracelet'\nname = 'Mine'\nvendor_id = 0x1209\nproduct_id = 0x0007\n";

    m_station.choose(BraceletChoice::file, QString::fromStdString(path));
    ASSERT_TRUE(isPlayable()) << failure();
    EXPECT_EQ(m_station.session()->source().description().serial, "TB-0700");
    EXPECT_FALSE(m_station.isSimulated());
    ASSERT_NE(m_station.play(steady(), true), 0U);
    ASSERT_TRUE(own.waitFor(turns));

    own.unplug();
    ASSERT_TRUE(
        eventually([&] { return state() == DeviceState::lost || state() == DeviceState::reconnecting; }));
    EXPECT_FALSE(m_station.isReady());
    EXPECT_FALSE(m_station.note().isEmpty());
    ASSERT_TRUE(own.forgetWhatWasWritten());
    own.plugIn();
    ASSERT_TRUE(isPlayable()) << failure();
    for (const UhidBoard::Frame& frame : own.state().frames)
        EXPECT_EQ(UhidBoard::Bytes(9, 0), UhidBoard::Bytes(frame.bytes.begin() + 3, frame.bytes.begin() + 12))
            << "nothing plays unless asked";

    ASSERT_NE(m_station.play(steady(), true), 0U);
    ASSERT_TRUE(own.waitFor(turns));
    m_stop.engage();
    ASSERT_TRUE(own.waitFor([](const UhidBoard::State& state) { return !turns(state); }));
    EXPECT_EQ(usual.state().openings, opened);
    EXPECT_FALSE(turns(usual.state()));
}

TEST_F(BraceletChoicePeer, aFileWhoseBoardIsNotPluggedInIsToldAndTheOtherBoardIsLeftAlone) {
    UhidBoard usual("TB-0001");
    ASSERT_NO_FATAL_FAILURE(plugIn(usual, 0x0001));
    const int opened = usual.state().openings;
    const std::string path = "/tmp/absent-bracelet.toml";
    std::ofstream(path) << "kind = 'hid_bracelet'\nname = 'Mine'\nvendor_id = 0x1209\nproduct_id = 0x0007\n";
    m_station.choose(BraceletChoice::file, QString::fromStdString(path));
    ASSERT_TRUE(eventually([&] { return !m_failures.empty(); }));
    EXPECT_EQ(m_station.choice(), BraceletChoice::none);
    EXPECT_EQ(usual.state().openings, opened);
}

// The example describes the very board that is found without a file: it is let go before it is opened again.
TEST_F(BraceletChoicePeer, aBraceletThatIsChosenAgainIsOpenedWhenTheOneBeforeHasLetItGo) {
    UhidBoard board("TB-0001");
    ASSERT_NO_FATAL_FAILURE(plugIn(board, 0x0001));
    const UhidBoard::State before = board.state();
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        if (round % 2 == 0)
            m_station.choose(BraceletChoice::file, kExample);
        else
            m_station.choose(BraceletChoice::hid);
        ASSERT_TRUE(isPlayable()) << round << ": " << failure();
        ASSERT_NE(m_station.play(steady(), true), 0U) << round;
        ASSERT_TRUE(board.waitFor(turns)) << round;
    }
    // Faster than any of them can be opened: the last one counts.
    for (int round = 0; round < kRounds; ++round)
        m_station.choose(round % 2 == 0 ? BraceletChoice::hid : BraceletChoice::file, kExample);
    ASSERT_TRUE(isPlayable()) << failure();
    EXPECT_EQ(m_station.choice(), BraceletChoice::file);
    ASSERT_NE(m_station.play(steady(), true), 0U);
    ASSERT_TRUE(board.waitFor(turns));

    m_station.choose(BraceletChoice::none);
    ASSERT_TRUE(board.waitFor([](const UhidBoard::State& state) { return !state.opened; }));
    const UhidBoard::State after = board.state();
    EXPECT_FALSE(turns(after));
    EXPECT_EQ(after.closings, after.openings);
    EXPECT_GT(after.closings - before.closings, kRounds) << "each is closed before the next one is opened";
    EXPECT_EQ(after.closedWhileTurning, 0);
    EXPECT_EQ(after.timeouts, 0) << "by a frame, not by the board's time-out";
    EXPECT_EQ(failure(), "none");
}
