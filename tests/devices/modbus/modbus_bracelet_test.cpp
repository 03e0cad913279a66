// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/bracelet_link.h"
#include "devices/modbus/modbus_bracelet.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/modbus/played_server.h"

#include <gtest/gtest.h>

using namespace teleta;
using namespace teleta::modbus;
using core::DeviceState;
using core::WriteOutcome;
using test::eventually;
using test::ManualClock;
using test::PlayedServer;
using Words = std::vector<std::uint16_t>;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr Answer kTimedOut{Answer::Kind::timedOut};
constexpr Answer kException{Answer::Kind::exception, 4};
const Words kZero(6, 0);
const Words kFull(6, 4095);
constexpr core::Drive kDriven = {4095, 4095, 4095, 4095, 4095, 4095};

/// Motors in 10..15, from 0 to 4095; watchdog in 20.
RegisterMap motorMap() {
    RegisterMap map;
    map.name = "motors";
    map.link = TcpLink{.host = "h"};
    map.tactors = TactorRegisters{.address = 10, .format = {}, .unit = "1", .full = 4095.0};
    map.watchdogAddress = 20;
    return map;
}

/// Words of the writes to the motors, in their order.
std::vector<Words> motorWords(const std::vector<PlayedServer::Write>& writes) {
    std::vector<Words> words;
    for (const PlayedServer::Write& write : writes) {
        if (write.address == 10)
            words.push_back(write.words);
    }
    return words;
}

class ModbusBraceletTest : public testing::Test {
protected:
    void start(const RegisterMap& map = motorMap()) {
        core::BraceletOpener opener = modbusBraceletOpener(map, m_server.opener(), m_clock);
        auto opened = opener();
        ASSERT_TRUE(opened) << describe(opened.error());
        core::BraceletLinkConfig config;
        config.clock = m_clock;
        m_bracelet =
            std::make_unique<core::BraceletLink>(std::move(*opened), std::move(opener), m_stop, config);
        m_bracelet->start(m_wakeup);
        m_clock->settle();
    }
    core::WriteResult write(const core::Drive& drive) {
        return m_bracelet->write({.drive = drive, .connection = m_bracelet->connection()});
    }

    PlayedServer m_server;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<core::BraceletLink> m_bracelet;
};

/// A clock that only a server's requests move.
class RequestClock : public core::PacingClock {
public:
    [[nodiscard]] std::int64_t now_ns() const override { return m_now_ns; }
    std::int64_t m_now_ns = 0;
};

} // namespace

TEST_F(ModbusBraceletTest, writesAllMotorsInOneRequestAndCountsTheWatchdogUp) {
    start();
    m_server.takeWrites();
    EXPECT_EQ(write({0, 1, 2, 2048, 4094, 4095}).outcome, WriteOutcome::written);
    auto writes = m_server.takeWrites();
    ASSERT_EQ(writes.size(), 2U);
    EXPECT_EQ(writes[0].address, 10);
    EXPECT_EQ(writes[0].words, (Words{0, 1, 2, 2048, 4094, 4095}));
    EXPECT_EQ(writes[1].address, 20);
    const std::uint16_t count = writes[1].words.at(0);
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::written);
    writes = m_server.takeWrites();
    ASSERT_EQ(writes.size(), 2U);
    EXPECT_EQ(writes[1].words, Words{static_cast<std::uint16_t>(count + 1)});
    const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
    EXPECT_EQ(telemetry.framesEchoed, telemetry.framesWritten) << "the server's answer is the echo";
    EXPECT_EQ(telemetry.framesLost, 0U);
    EXPECT_TRUE(telemetry.board.driving);
    EXPECT_EQ(m_bracelet->status().state, DeviceState::live);
}

TEST_F(ModbusBraceletTest, isZeroFirstAndLast) {
    m_server.set(10, 4095);
    start();
    const auto opening = motorWords(m_server.takeWrites());
    ASSERT_FALSE(opening.empty());
    for (const Words& words : opening)
        EXPECT_EQ(words, kZero);
    (void)write(kDriven);
    m_bracelet->stop();
    EXPECT_EQ(motorWords(m_server.takeWrites()), (std::vector<Words>{kFull, kZero}));
}

TEST_F(ModbusBraceletTest, zeroesTheMotorsWhenTheServerAnswersWithAnException) {
    start();
    (void)write(kDriven);
    m_server.takeWrites();
    m_server.answerNext({kException});
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    EXPECT_EQ(m_server.takeWrites(), (std::vector<PlayedServer::Write>{{10, kZero, true}}));
    EXPECT_EQ(m_bracelet->status().state, DeviceState::lost);
    EXPECT_EQ(m_bracelet->status().message, describe(kException));
    EXPECT_EQ(m_bracelet->connection(), 0U);
}

TEST_F(ModbusBraceletTest, zeroesTheMotorsBlindlyWhenTheServerDoesNotAnswer) {
    start();
    (void)write(kDriven);
    m_server.takeWrites();
    m_server.answerNext({kTimedOut});
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    EXPECT_EQ(m_server.takeWrites(), (std::vector<PlayedServer::Write>{{10, kZero, false}}));
    EXPECT_EQ(m_bracelet->status().message, describe(kTimedOut));
}

TEST_F(ModbusBraceletTest, zeroesTheMotorsWhenOnlyTheWatchdogFails) {
    start();
    m_server.takeWrites();
    m_server.answerNext({Answer{}, kTimedOut});
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    EXPECT_EQ(motorWords(m_server.takeWrites()), (std::vector<Words>{kFull, kZero}));
}

TEST_F(ModbusBraceletTest, isZeroAfterAReconnectionAndGoesOnOnlyWhenAsked) {
    start();
    (void)write(kDriven);
    const std::uint64_t connection = m_bracelet->connection();
    m_server.answerNext({kTimedOut});
    (void)write(kDriven);
    m_server.takeWrites();
    // The worker may first have to wake up and see the loss.
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        m_clock->advance(100 * kMs_ns);
        return m_bracelet->connection() == 2;
    }));
    EXPECT_EQ(m_server.connections(), 2);
    EXPECT_EQ(m_bracelet->status().state, DeviceState::live);
    EXPECT_EQ(m_bracelet->write({.drive = kDriven, .connection = connection}).outcome, WriteOutcome::refused);
    m_clock->advance(500 * kMs_ns);
    for (const Words& words : motorWords(m_server.takeWrites()))
        EXPECT_EQ(words, kZero);
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::written);
    EXPECT_EQ(motorWords(m_server.takeWrites()), std::vector<Words>{kFull});
}

TEST_F(ModbusBraceletTest, keepsTheWatchdogGoingWhileNobodyPlays) {
    start();
    m_server.takeWrites();
    for (int i = 0; i < 10; ++i)
        m_clock->advance(100 * kMs_ns);
    const auto writes = m_server.takeWrites();
    EXPECT_EQ(motorWords(writes), std::vector<Words>(10, kZero));
    EXPECT_EQ(writes.size(), 20U);
}

TEST_F(ModbusBraceletTest, tellsStatusSupplyAndTemperature) {
    RegisterMap map = motorMap();
    map.status = StatusRegister{.input = {.name = "status", .address = 30, .format = {}, .unit = "1"},
                                .timedOutBit = 0,
                                .tooHotBit = 15,
                                .supplyLowBit = std::nullopt};
    map.inputs = {{.name = "supply", .address = 31, .format = {.scale = 0.01}, .unit = "V"},
                  {.name = "heat",
                   .address = 32,
                   .format = {.type = RegisterType::int16, .scale = 0.1},
                   .unit = "degC"}};
    map.supply = 0;
    map.temperature = 1;
    m_server.set(30, 0x8002);
    m_server.set(31, 502);
    m_server.set(32, static_cast<std::uint16_t>(-55));
    start(map);
    core::BoardReport board = m_bracelet->telemetry().board;
    EXPECT_FALSE(board.timedOut);
    EXPECT_TRUE(board.tooHot);
    EXPECT_FALSE(board.supplyLow);
    EXPECT_DOUBLE_EQ(board.supply_V, 5.02);
    EXPECT_DOUBLE_EQ(board.temperature_degC, -5.5);
    EXPECT_EQ(m_server.reads(), 1) << "not with every frame";
    m_server.set(30, 0x0001);
    m_clock->advance(100 * kMs_ns);
    board = m_bracelet->telemetry().board;
    EXPECT_TRUE(board.timedOut);
    EXPECT_FALSE(board.tooHot);
    EXPECT_EQ(m_server.reads(), 2);
}

TEST_F(ModbusBraceletTest, staysZeroWhileStopIsEngaged) {
    start();
    (void)write(kDriven);
    m_server.takeWrites();
    m_stop.engage();
    (void)write(kDriven);
    EXPECT_EQ(motorWords(m_server.takeWrites()), std::vector<Words>{kZero});
}

// One connection takes one request after the other: STOP cannot overtake the one that is under way, but
// nothing else comes before it.
TEST_F(ModbusBraceletTest, zeroesTheMotorsRightBehindTheFrameThatWasUnderWayWhenStopCame) {
    start();
    m_server.takeWrites();
    m_server.onRequest([this] { m_stop.engage(); });
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::written);
    EXPECT_EQ(motorWords(m_server.takeWrites()), (std::vector<Words>{kFull, kZero}))
        << "in the same call, not in the next cycle of somebody";
}

TEST_F(ModbusBraceletTest, zeroesTheMotorsBlindlyWhenStopCameWhileTheServerFellSilent) {
    start();
    m_server.takeWrites();
    m_server.onRequest([this] { m_stop.engage(); });
    m_server.answerNext({kTimedOut});
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    EXPECT_EQ(m_server.takeWrites(), (std::vector<PlayedServer::Write>{{10, kZero, false}}))
        << "after one time-out, which a map limits to 0.2 s";
}

TEST(ModbusBraceletPort, doesNotReadItsStatusBehindASlowFrameOfMotorsThatTurn) {
    RegisterMap map = motorMap();
    map.status = StatusRegister{.input = {.name = "status", .address = 30, .format = {}, .unit = "1"},
                                .timedOutBit = 0,
                                .tooHotBit = std::nullopt,
                                .supplyLowBit = std::nullopt};
    PlayedServer server;
    const auto clock = std::make_shared<RequestClock>();
    auto opened = modbusBraceletOpener(map, server.opener(), clock)();
    ASSERT_TRUE(opened);
    clock->m_now_ns += 200 * kMs_ns;
    const int before = server.reads();
    server.onRequest([&] { clock->m_now_ns += 90 * kMs_ns; });
    ASSERT_TRUE(opened->port->write(1, kDriven, 100));
    EXPECT_EQ(server.reads(), before);
    ASSERT_TRUE(opened->port->write(2, {}, 100));
    EXPECT_EQ(server.reads(), before + 1);
}

TEST(ModbusBraceletOpener, takesItsRateFromTheTimeOfAFrame) {
    const auto rateWith = [](std::int64_t request_ns) {
        PlayedServer server;
        const auto clock = std::make_shared<RequestClock>();
        server.onRequest([&] { clock->m_now_ns += request_ns; });
        const auto opened = modbusBraceletOpener(motorMap(), server.opener(), clock)();
        return opened ? opened->description.maximumRate_Hz : 0.0;
    };
    // A frame is two requests, motors and watchdog: 0.8 / 20 ms.
    EXPECT_NEAR(rateWith(10 * kMs_ns), 40.0, 1e-9);
    EXPECT_EQ(rateWith(kMs_ns), 200.0) << "400 Hz are possible, but no more than 200 are needed";
    EXPECT_EQ(rateWith(0), 200.0);
}

TEST(ModbusBraceletOpener, saysWhyItCannotOpen) {
    PlayedServer server;
    const auto clock = std::make_shared<core::PacingClock>();
    const auto errorOf = [&](const RegisterMap& map) {
        const auto opened = modbusBraceletOpener(map, server.opener(), clock)();
        return opened ? std::string() : opened.error().message;
    };
    server.answerNext({kException});
    EXPECT_EQ(errorOf(motorMap()), describe(kException));
    server.setReachable(false);
    EXPECT_EQ(errorOf(motorMap()), "nobody listens");
    RegisterMap map = motorMap();
    map.tactors.reset();
    EXPECT_EQ(errorOf(map), "The device has no motors.");
}
