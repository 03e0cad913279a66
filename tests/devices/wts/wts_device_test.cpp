// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"
#include "devices/wts/wts_device.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/wts/emulated_wts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace teleta::wts {
namespace {

using core::DeviceState;
using teleta::test::eventually;
using test::append;
using test::Bytes;
using test::EmulatedWts;

constexpr std::size_t kCells = 84;
constexpr std::uint32_t kPeriod_ms = 10;

/// The cells of a frame with this number: all different, and different from those of its neighbours.
std::vector<unsigned> cellsOf(std::uint32_t number) {
    std::vector<unsigned> cells(kCells);
    for (std::size_t i = 0; i < kCells; ++i)
        cells[i] = (number * 131 + static_cast<unsigned>(i)) & 0xFFFF;
    return cells;
}

Bytes frameOf(std::uint32_t number) {
    return test::frame(number * kPeriod_ms, false, cellsOf(number));
}

/// Times that let a test see what happens when they pass.
WtsTimes shortTimes() {
    return {.connect_ms = 2000,
            .answer_ms = 400,
            .tare_ms = 300,
            .lineSilence_ms = 50,
            .noFrames_ms = 300,
            .firstRetry_ms = 5,
            .longestRetry_ms = 20};
}

/// Times that never pass on a loaded machine.
WtsTimes longTimes() {
    return {.connect_ms = 20000,
            .answer_ms = 20000,
            .tare_ms = 20000,
            .lineSilence_ms = 20000,
            .stale_ms = 20000,
            .noFrames_ms = 20000,
            .firstRetry_ms = 5,
            .longestRetry_ms = 20};
}

class WtsDeviceTest : public testing::Test {
protected:
    struct Received {
        std::vector<std::vector<float>> frames;
        std::vector<std::uint64_t> numbers;
        std::vector<std::int64_t> time_ns;
        std::vector<double> sourceTime_s;
        std::vector<bool> discontinuity;
    };

    void emulate(EmulatedWts::Link link, EmulatedWts::Behaviour behaviour = {}) {
        m_sensor = std::make_unique<EmulatedWts>(link, std::move(behaviour));
    }

    [[nodiscard]] WtsConfig config(const WtsTimes& times) const {
        WtsConfig config;
        config.address = *parseWtsAddress(m_sensor->address());
        config.times = times;
        config.queueBlocks = 1 << 15;
        return config;
    }

    void open(const WtsConfig& config) {
        auto device = WtsDevice::open(config);
        ASSERT_TRUE(device) << core::describe(device.error());
        m_device = std::move(*device);
    }

    void startStreaming(const WtsConfig& config) {
        open(config);
        ASSERT_TRUE(m_device);
        m_device->start(m_wakeup);
        ASSERT_TRUE(m_sensor->waitForRequests(Command::startFrames, 1));
    }

    void drain() {
        core::SampleBlock block;
        while (m_device->blocks().pop(block)) {
            ASSERT_EQ(block.channels, m_device->description().layout.taxels());
            for (std::size_t i = 0; i < block.frames(); ++i) {
                const auto values = block.frame(i);
                m_received.frames.emplace_back(values.begin(), values.end());
                m_received.numbers.push_back(block.firstFrame + i);
                m_received.time_ns.push_back(block.time_ns[i]);
                m_received.sourceTime_s.push_back(block.sourceTime_s[i]);
                m_received.discontinuity.push_back(i == 0 && block.discontinuity);
            }
        }
    }

    [[nodiscard]] bool receive(std::size_t frames) {
        return eventually(m_wakeup, [&] {
            drain();
            return m_received.frames.size() >= frames;
        });
    }

    /// Sends frames, whenever the device asked for them, until a condition holds.
    template <typename Condition>
    [[nodiscard]] bool sendUntil(const Condition& condition) {
        return eventually(m_wakeup, [&] {
            if (m_sensor->streaming())
                (void)m_sensor->send(frameOf(m_next++));
            drain();
            return condition();
        });
    }

    void expectFrame(std::size_t index, std::uint32_t number) {
        const std::vector<unsigned> cells = cellsOf(number);
        ASSERT_LT(index, m_received.frames.size());
        ASSERT_EQ(m_received.frames[index], std::vector<float>(cells.begin(), cells.end())) << number;
    }

    [[nodiscard]] DeviceState state() const { return m_device->status().state; }
    [[nodiscard]] bool messageSays(const char* words) const {
        return m_device->status().message.find(words) != std::string::npos;
    }

    core::Wakeup m_wakeup;
    std::unique_ptr<EmulatedWts> m_sensor;
    std::unique_ptr<WtsDevice> m_device;
    Received m_received;
    std::uint32_t m_next = 0;
};

class WtsDeviceOnAnyLink : public WtsDeviceTest, public testing::WithParamInterface<EmulatedWts::Link> {};

TEST_P(WtsDeviceOnAnyLink, knowsTheArrayBeforeItStarts) {
    emulate(GetParam());
    open(config(longTimes()));
    const core::SourceDescription& description = m_device->description();
    EXPECT_EQ(description.layout.grid().rows, 6);
    EXPECT_EQ(description.layout.grid().columns, 14);
    EXPECT_EQ(description.layout.grid().pitchX_m, 0.0034); // exactly: layouts are compared
    EXPECT_EQ(description.unit, "counts");
    EXPECT_FALSE(description.simulated);
    EXPECT_EQ(m_device->matrix().fullScale, 4095);
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_FALSE(m_sensor->streaming());
}

TEST_P(WtsDeviceOnAnyLink, deliversFramesWithTheTimeOfTheReadAndOfTheSensor) {
    emulate(GetParam());
    const std::int64_t before_ns = core::steadyNow_ns();
    startStreaming(config(longTimes()));
    EXPECT_EQ(state(), DeviceState::connecting);
    for (std::uint32_t number = 0; number < 5; ++number)
        ASSERT_TRUE(m_sensor->send(frameOf(number)));
    ASSERT_TRUE(receive(5));
    EXPECT_EQ(state(), DeviceState::live);
    for (std::size_t i = 0; i < 5; ++i) {
        expectFrame(i, static_cast<std::uint32_t>(i));
        EXPECT_EQ(m_received.numbers[i], i);
        EXPECT_GE(m_received.time_ns[i], i == 0 ? before_ns : m_received.time_ns[i - 1]);
        EXPECT_LE(m_received.time_ns[i], core::steadyNow_ns());
        EXPECT_NEAR(m_received.sourceTime_s[i] - m_received.sourceTime_s[0], 0.010 * static_cast<double>(i),
                    1e-9);
    }
    EXPECT_EQ(m_device->status().framesRead, 5U);
    EXPECT_EQ(m_device->status().framesLost, 0U);
}

TEST_P(WtsDeviceOnAnyLink, losesNoFrameAtTheFullRateOfTheLink) {
    constexpr std::uint32_t kFrames = 20000;
    emulate(GetParam());
    startStreaming(config(longTimes()));
    std::jthread sender([this] {
        Bytes burst;
        for (std::uint32_t number = 0; number < kFrames; ++number) {
            append(burst, frameOf(number));
            if (burst.size() > 3000 || number + 1 == kFrames) {
                EXPECT_TRUE(m_sensor->send(burst));
                burst.clear();
            }
        }
    });
    ASSERT_TRUE(receive(kFrames));
    sender.join();
    ASSERT_EQ(m_received.frames.size(), kFrames);
    for (std::uint32_t number = 0; number < kFrames; ++number)
        expectFrame(number, number);
    EXPECT_EQ(m_device->status().framesLost, 0U);
    EXPECT_EQ(m_device->counters().line.droppedBytes, 0U);
    const double time_s = static_cast<double>(m_received.time_ns.back() - m_received.time_ns.front()) * 1e-9;
    RecordProperty("frames_per_s", std::to_string(kFrames / time_s));
}

TEST_P(WtsDeviceOnAnyLink, tellsTheSensorToStopAndCanStartAgain) {
    emulate(GetParam());
    startStreaming(config(longTimes()));
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; }));
    const int stops = m_sensor->requests(Command::stopFrames);
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_FALSE(m_sensor->streaming());
    EXPECT_TRUE(m_sensor->waitForRequests(Command::stopFrames, stops + 1));

    drain();
    m_received = {};
    m_device->start(m_wakeup);
    ASSERT_TRUE(m_sensor->waitForRequests(Command::startFrames, 2));
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; }));
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_EQ(m_received.numbers[0], 0U);
    EXPECT_TRUE(m_received.discontinuity[0]);
}

TEST_P(WtsDeviceOnAnyLink, isLostWhenUnpluggedAndLiveAgainAfterItsReturn) {
    emulate(GetParam());
    startStreaming(config(longTimes()));
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 3; }));
    m_sensor->unplug();
    ASSERT_TRUE(eventually(m_wakeup, [&] { return state() == DeviceState::reconnecting; }));
    EXPECT_FALSE(m_device->status().message.empty());
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().failedAttempts >= 2; }));
    drain();

    m_received = {};
    m_sensor->plug();
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 3; }));
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_TRUE(m_device->status().message.empty());
    EXPECT_TRUE(m_received.discontinuity[0]);
    EXPECT_FALSE(m_received.discontinuity[1]);
    EXPECT_EQ(m_device->counters().connections, 2U);
}

INSTANTIATE_TEST_SUITE_P(Links, WtsDeviceOnAnyLink,
                         testing::Values(EmulatedWts::Link::pty, EmulatedWts::Link::tcp),
                         [](const auto& link) {
                             return link.param == EmulatedWts::Link::pty ? "pty" : "tcp";
                         });

TEST_F(WtsDeviceTest, asksForFramesAsItWasToldTo) {
    emulate(EmulatedWts::Link::pty);
    WtsConfig config = this->config(longTimes());
    config.runLength = true;
    config.delay_ms = 0x0203;
    startStreaming(config);
    EXPECT_EQ(m_sensor->params(Command::startFrames), (Bytes{0x01, 0x03, 0x02}));
    EXPECT_NEAR(m_device->description().nominalRate_Hz, 1.0 / 0.515, 1e-9);
    ASSERT_TRUE(m_sensor->send(test::frame(7, true, {0xF00A, 0xF00B, 0xF00C, 0xF00D, 0xF00E, 0x9FFF})));
    ASSERT_TRUE(receive(1));
    EXPECT_EQ(m_received.frames[0][14], 10.0F);
    EXPECT_EQ(m_received.frames[0][15], 11.0F);
    EXPECT_EQ(m_received.frames[0][83], 4095.0F);
}

TEST_F(WtsDeviceTest, countsTheRateOfAFullFrameOnTheLineAsNominal) {
    emulate(EmulatedWts::Link::pty);
    open(config(longTimes()));
    // 3 + 1 + 2 + 4 + 1 + 168 + 2 bytes of 10 bits.
    EXPECT_NEAR(m_device->description().nominalRate_Hz, 115200.0 / 1810.0, 1e-9);
}

TEST_F(WtsDeviceTest, keepsEveryWholeFrameOnANoisyLineAndCountsTheOthersAsLost) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    std::mt19937 random(20);
    std::vector<std::uint32_t> whole;
    std::uint64_t lost = 0;
    Bytes stream;
    constexpr std::uint32_t kFrames = 2000;
    for (std::uint32_t number = 0; number < kFrames; ++number) {
        Bytes bytes = frameOf(number);
        const auto anywhere = [&] { return static_cast<std::ptrdiff_t>(random() % bytes.size()); };
        const unsigned fate = number < 3 || number + 1 == kFrames ? 9 : random() % 10;
        if (fate == 0)
            bytes[static_cast<std::size_t>(anywhere())] ^= 0x40; // noise
        else if (fate == 1)
            bytes.resize(static_cast<std::size_t>(anywhere())); // cut
        else if (fate == 2)
            bytes.back() ^= 0x01; // wrong checksum
        else if (fate == 3)
            bytes.erase(bytes.begin() + anywhere()); // a lost byte
        if (fate <= 3) {
            ++lost;
        } else {
            whole.push_back(number);
            if (fate == 4) {
                const Bytes noise{'\r', '\n', 0xAA, 0xAA, 'x', 0xAA};
                bytes.insert(bytes.begin(), noise.begin(), noise.end());
            }
        }
        append(stream, bytes);
    }
    std::jthread sender([&] { EXPECT_TRUE(m_sensor->send(stream)); });
    ASSERT_TRUE(receive(whole.size()));
    ASSERT_EQ(m_received.frames.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        expectFrame(i, whole[i]);
        EXPECT_EQ(m_received.numbers[i], whole[i]); // the gaps are those of the lost frames
    }
    EXPECT_EQ(m_device->status().framesLost, lost);
    EXPECT_EQ(state(), DeviceState::live);
    const WtsCounters counters = m_device->counters();
    EXPECT_GT(counters.line.badChecksums, lost / 2);
    const MessageDecoder::Counters& line = counters.line;
    EXPECT_EQ(line.messageBytes - (frameOf(0).size() * whole.size()), 10U + 20U + 10U)
        << "the answers to stop, matrix info and start";
    EXPECT_EQ(line.messageBytes + line.droppedBytes, stream.size() + 40U);
}

TEST_F(WtsDeviceTest, countsFramesOfAnotherSizeAndGoesOn) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    ASSERT_TRUE(m_sensor->send(frameOf(0)));
    ASSERT_TRUE(m_sensor->send(test::frame(10, false, std::vector<unsigned>(83))));
    ASSERT_TRUE(m_sensor->send(test::frame(20, true, {0x0123})));
    ASSERT_TRUE(m_sensor->send(test::frame(30, true, {0xF123, 0xF123, 0xF123, 0xF123, 0xF123, 0xF123})));
    ASSERT_TRUE(m_sensor->send(test::answer(Command::temperature, 0, {0x0F, 0x01})));
    ASSERT_TRUE(m_sensor->send(frameOf(4)));
    ASSERT_TRUE(receive(2));
    expectFrame(0, 0);
    expectFrame(1, 4);
    EXPECT_EQ(m_device->counters().faultyFrames, 3U);
    EXPECT_EQ(m_device->counters().otherMessages, 1U);
    EXPECT_EQ(m_device->counters().line.badChecksums, 0U);
}

TEST_F(WtsDeviceTest, findsAFrameBehindACutOneOnceTheLineIsSilent) {
    emulate(EmulatedWts::Link::pty);
    WtsTimes times = longTimes();
    times.lineSilence_ms = 20;
    startStreaming(config(times));
    Bytes bytes{0xAA, 0xAA, 0xAA, 0x00, 0x00, 0x01}; // announces more than the frame that follows
    append(bytes, frameOf(1));
    ASSERT_TRUE(m_sensor->send(bytes));
    ASSERT_TRUE(receive(1));
    expectFrame(0, 1);
}

TEST_F(WtsDeviceTest, beginsAnewWhenTheSensorDoes) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    for (const std::uint32_t number : {1000U, 1001U, 1002U, 1U, 2U})
        ASSERT_TRUE(m_sensor->send(frameOf(number)));
    ASSERT_TRUE(receive(5));
    EXPECT_EQ(m_received.discontinuity, (std::vector<bool>{false, false, false, true, false}));
    EXPECT_GE(m_received.sourceTime_s[3], m_received.sourceTime_s[2]);
    EXPECT_EQ(m_device->counters().sensorRestarts, 1U);
    EXPECT_EQ(m_device->status().framesLost, 0U);
}

TEST_F(WtsDeviceTest, isStaleThenLostWhenTheSensorFallsSilentAndLiveAgainWhenItSpeaks) {
    emulate(EmulatedWts::Link::pty);
    WtsTimes times = longTimes();
    times.stale_ms = 0;
    times.noFrames_ms = 1500;
    times.firstRetry_ms = 200;
    startStreaming(config(times));
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; }));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return state() == DeviceState::stale; }));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return messageSays("no usable frame"); }));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_sensor->requests(Command::startFrames) >= 2; }));
    drain();
    m_received = {};
    ASSERT_TRUE(sendUntil([&] { return state() == DeviceState::live && !m_received.frames.empty(); }));
    EXPECT_TRUE(m_received.discontinuity[0]);
    EXPECT_GE(m_device->counters().connections, 2U);
}

TEST_F(WtsDeviceTest, refusesAnotherArrayInPlaceOfTheFirst) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; }));
    m_sensor->unplug();
    m_sensor->change([](auto& behaviour) { behaviour.rows = 7; });
    m_sensor->plug();
    ASSERT_TRUE(eventually(m_wakeup, [&] { return messageSays("Another array"); }));
    EXPECT_EQ(state(), DeviceState::reconnecting);
    EXPECT_TRUE(messageSays("7 x 14"));
    EXPECT_FALSE(m_sensor->streaming());

    m_sensor->change([](auto& behaviour) { behaviour.rows = 6; });
    ASSERT_TRUE(sendUntil([&] { return state() == DeviceState::live; }));
}

TEST_F(WtsDeviceTest, aPortOfAnotherProgramIsNotOpenedUntilItIsFree) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    // This one locks as another program would.
    const auto second = WtsDevice::open(config(longTimes()));
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(second.error().message.find("another program uses " + m_sensor->address()), std::string::npos)
        << second.error().message;
    EXPECT_FALSE(second.error().expected.empty()) << "what to do";
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; })) << "the first one goes on";
    m_device.reset();
    open(config(longTimes()));
}

TEST_F(WtsDeviceTest, goesOnWhenTheProgramThatTookItsPortLetsItGo) {
    emulate(EmulatedWts::Link::pty);
    const teleta::test::TemporaryFolder folder;
    const std::string port = folder.path("port");
    std::filesystem::create_symlink(m_sensor->address(), port);
    WtsConfig config = this->config(longTimes());
    config.address = *parseWtsAddress(port);
    startStreaming(config);
    ASSERT_TRUE(sendUntil([&] { return m_received.frames.size() >= 2; }));
    std::filesystem::remove(port);
    m_sensor->unplug();
    m_sensor->plug();
    {
        const auto other = core::NodeClaim::take(m_sensor->address());
        ASSERT_TRUE(other && *other);
        std::filesystem::create_symlink(m_sensor->address(), port);
        ASSERT_TRUE(eventually(m_wakeup, [&] { return messageSays("another program uses"); }));
        EXPECT_FALSE(m_sensor->streaming());
    }
    ASSERT_TRUE(sendUntil([&] { return state() == DeviceState::live; }));
}

TEST_F(WtsDeviceTest, taresWhenItStartsAndNotWhenItReconnects) {
    emulate(EmulatedWts::Link::pty);
    WtsConfig config = this->config(longTimes());
    config.tare = true;
    startStreaming(config);
    EXPECT_EQ(m_sensor->requests(Command::tare), 1);
    EXPECT_EQ(m_sensor->params(Command::tare), Bytes{0x01});
    m_sensor->unplug();
    m_sensor->plug();
    ASSERT_TRUE(m_sensor->waitForRequests(Command::startFrames, 2));
    EXPECT_EQ(m_sensor->requests(Command::tare), 1);
}

TEST_F(WtsDeviceTest, doesNotTareUnasked) {
    emulate(EmulatedWts::Link::pty);
    startStreaming(config(longTimes()));
    EXPECT_EQ(m_sensor->requests(Command::tare), 0);
}

TEST_F(WtsDeviceTest, saysWhyTheSensorSendsNoFrames) {
    emulate(EmulatedWts::Link::pty, {.status = {{Command::startFrames, 2}}});
    startStreaming(config(longTimes()));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return messageSays("no sensor connected"); }));
    m_sensor->change([](auto& behaviour) { behaviour.status = {{Command::startFrames, 4}}; });
    ASSERT_TRUE(sendUntil([&] { return state() == DeviceState::live; })) << "already running is as good";
}

TEST_F(WtsDeviceTest, saysWhyTheSensorDoesNotTare) {
    emulate(EmulatedWts::Link::pty, {.status = {{Command::tare, 99}}});
    WtsConfig config = this->config(longTimes());
    config.tare = true;
    open(config);
    m_device->start(m_wakeup);
    ASSERT_TRUE(eventually(m_wakeup, [&] { return messageSays("status 99"); }));
    EXPECT_EQ(m_sensor->requests(Command::startFrames), 0);
}

TEST_F(WtsDeviceTest, asksAgainWhenAnAnswerDoesNotCome) {
    emulate(EmulatedWts::Link::pty, {.deafTo = 2});
    open(config(shortTimes()));
    EXPECT_EQ(m_sensor->requests(Command::stopFrames), 3);
}

TEST_F(WtsDeviceTest, opensWhileTheSensorBoots) {
    Bytes noise{'\r', '\n', 'W', 'T', 'S', 0xAA, 0xAA, 0xAA, 0xAA};
    append(noise, {0xAA, 0xAA, 0xAA, 0x00, 0xC8, 0x00}); // a frame that was cut off and swallows the answer
    emulate(EmulatedWts::Link::pty, {.beforeAnswer = noise});
    open(config(shortTimes()));
    EXPECT_EQ(m_device->description().layout.grid().columns, 14);
}

TEST_F(WtsDeviceTest, givesUpOnASensorThatDoesNotAnswer) {
    emulate(EmulatedWts::Link::pty, {.deafTo = 1000});
    const auto device = WtsDevice::open(config(shortTimes()));
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(device.error().message.find("does not answer"), std::string::npos);
}

TEST_F(WtsDeviceTest, givesUpOnASensorThatSendsFramesAndDoesNotAnswer) {
    emulate(EmulatedWts::Link::pty, {.deafTo = 1000, .flood = true});
    const auto device = WtsDevice::open(config(shortTimes()));
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, core::ErrorKind::unavailable);
}

TEST_F(WtsDeviceTest, refusesArraysThatItCannotShow) {
    struct Case {
        EmulatedWts::Behaviour behaviour;
        const char* words;
    };
    const std::vector<Case> cases{{{.columns = 0}, "0 columns"},
                                  {{.rows = 1025}, "1025 rows"},
                                  {{.columns = 400, .rows = 400}, "400 rows"},
                                  {{.cellWidth_10um = 340, .cellHeight_10um = 0}, "0 mm high"},
                                  {{.cellWidth_10um = 0, .cellHeight_10um = 0}, "0 mm wide"},
                                  {{.matrixParams = 9}, "9 bytes"},
                                  {{.status = {{Command::matrixInfo, 3}}}, "not initialised"}};
    for (const Case& wrong : cases) {
        emulate(EmulatedWts::Link::pty, wrong.behaviour);
        const auto device = WtsDevice::open(config(longTimes()));
        ASSERT_FALSE(device) << wrong.words;
        EXPECT_NE(device.error().message.find(wrong.words), std::string::npos) << device.error().message;
    }
}

TEST_F(WtsDeviceTest, saysWhatIsWrongWithAPort) {
    emulate(EmulatedWts::Link::pty);
    const auto errorOf = [this](const WtsAddress& address) {
        WtsConfig wrong = config(longTimes());
        wrong.address = address;
        const auto device = WtsDevice::open(wrong);
        EXPECT_FALSE(device);
        return device ? core::Error{} : device.error();
    };
    const std::string folder = std::filesystem::path(m_sensor->address()).parent_path();
    EXPECT_EQ(errorOf(SerialAddress{folder + "/nothing"}).kind, core::ErrorKind::notFound);
    const std::string file = folder + "/file";
    std::ofstream(file) << "no port";
    EXPECT_EQ(errorOf(SerialAddress{file}).kind, core::ErrorKind::refused);
    const core::Error baud = errorOf(SerialAddress{m_sensor->address(), 115201});
    EXPECT_EQ(baud.kind, core::ErrorKind::refused);
    EXPECT_NE(baud.expected.find("115200"), std::string::npos);

    emulate(EmulatedWts::Link::tcp);
    const WtsAddress closed = *parseWtsAddress(m_sensor->address());
    m_sensor->unplug();
    EXPECT_EQ(errorOf(closed).kind, core::ErrorKind::unavailable);
}

TEST_F(WtsDeviceTest, stopsAtOnceWhileItTriesToConnect) {
    emulate(EmulatedWts::Link::pty);
    WtsTimes times = longTimes();
    times.firstRetry_ms = 3'600'000;
    times.longestRetry_ms = 3'600'000;
    startStreaming(config(times));
    m_sensor->unplug();
    ASSERT_TRUE(eventually(m_wakeup, [&] { return state() == DeviceState::lost; }));
    m_device->stop(); // without an end to its wait the test would run into its time-out
    EXPECT_EQ(state(), DeviceState::closed);
}

} // namespace
} // namespace teleta::wts
