// SPDX-License-Identifier: GPL-3.0-or-later
// Described arrays against a board in Python, over a pseudo-terminal, TCP, UDP and a file.
#include "devices/taxels/taxels_device.h"
#include "devices/taxels/taxels_probe.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/taxels/board.h"
#include "tests/devices/taxels/taxel_files.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace teleta::taxels {
namespace {

using core::DeviceState;
using teleta::test::eventually;
using test::Board;

/// Times that never pass on a loaded machine.
TaxelsTimes longTimes() {
    return {.connect_ms = 20'000,
            .lineSilence_ms = 20'000,
            .stale_ms = 20'000,
            .noFrames_ms = 20'000,
            .firstRetry_ms = 5,
            .longestRetry_ms = 20};
}

class TaxelsDeviceTest : public testing::Test {
protected:
    void start(const std::string& text, const TaxelsTimes& times = longTimes()) {
        TaxelsFile file = test::parsed(text);
        file.times = times;
        auto device = TaxelsDevice::open(std::move(file));
        ASSERT_TRUE(device) << core::describe(device.error());
        m_device = std::move(*device);
        m_device->start(m_wakeup);
    }

    void drain() {
        core::SampleBlock block;
        while (m_device->blocks().pop(block)) {
            for (std::size_t i = 0; i < block.frames(); ++i) {
                const auto values = block.frame(i);
                m_frames.emplace_back(values.begin(), values.end());
                m_numbers.push_back(block.firstFrame + i);
                m_time_s.push_back(block.sourceTime_s[i]);
            }
        }
    }

    [[nodiscard]] bool receive(std::size_t frames) {
        return eventually(m_wakeup, [&] {
            drain();
            return m_frames.size() >= frames;
        });
    }

    [[nodiscard]] bool reaches(DeviceState state) {
        return eventually(m_wakeup, [&] { return m_device->status().state == state; });
    }

    void expectFrames(const std::vector<std::uint32_t>& numbers) {
        ASSERT_EQ(m_frames.size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            EXPECT_EQ(m_frames[i], test::valuesOf(numbers[i])) << "frame " << numbers[i];
    }

    [[nodiscard]] std::string onPort(const std::string& frame) const {
        return test::head() + test::serialLink(m_folder.path("port")) + test::kGrid + frame;
    }

    teleta::test::TemporaryFolder m_folder;
    core::Wakeup m_wakeup;
    std::unique_ptr<TaxelsDevice> m_device;
    std::vector<std::vector<float>> m_frames;
    std::vector<std::uint64_t> m_numbers;
    std::vector<double> m_time_s;
};

TEST_F(TaxelsDeviceTest, keepsWholeFramesBetweenCutDoubledAndNoisyOnes) {
    Board board("pty", "counted", m_folder.path("port"));
    start(onPort(test::kCounted));
    board.say("write 0-5 cut:6 7 flip:8 9 noise:AA55FFAAAA 10 noise:0D0A 11 twice:12 13");
    ASSERT_TRUE(receive(12));
    expectFrames({0, 1, 2, 3, 4, 5, 7, 9, 10, 11, 12, 13});
    EXPECT_EQ(m_numbers, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 7, 9, 10, 11, 12, 13}))
        << "what the counter misses is a gap";
    EXPECT_EQ(m_device->status().framesLost, 2U);
    EXPECT_EQ(m_device->counters().repeatedFrames, 1U);
    EXPECT_GE(m_device->counters().line.badChecksums, 2U);
    EXPECT_NEAR(m_time_s[6] - m_time_s[5], 2 * 2.5e-3, 1e-9) << "the sensor's own time";
    EXPECT_EQ(m_device->description().layout, (core::ArrayLayout{6, 14, 0.0034}));
    EXPECT_EQ(m_device->description().unit, "counts");
}

TEST_F(TaxelsDeviceTest, losesNothingOfALongStream) {
    constexpr std::uint32_t kFrames = 5000;
    Board board("pty", "counted", m_folder.path("port"));
    start(onPort(test::kCounted));
    board.say("write 0-" + std::to_string(kFrames - 1));
    ASSERT_TRUE(receive(kFrames));
    for (std::uint32_t i = 0; i < kFrames; ++i)
        ASSERT_EQ(m_frames[i], test::valuesOf(i));
    EXPECT_EQ(m_device->status().framesLost, 0U);
    EXPECT_EQ(m_device->counters().line.droppedBytes, 0U);
}

TEST_F(TaxelsDeviceTest, readsACrcOfZlibAndNumbersWithTheHighByteFirst) {
    Board board("pty", "crc32", m_folder.path("port"));
    start(onPort(test::kCrc32));
    board.say("write 0-3 flip:4 cut:5 6-9");
    ASSERT_TRUE(receive(8));
    expectFrames({0, 1, 2, 3, 6, 7, 8, 9});
}

TEST_F(TaxelsDeviceTest, readsLinesOfNumbersAndOfJson) {
    for (const auto& [format, frame] : {std::pair{"csv", test::kCsv}, std::pair{"json", test::kJson}}) {
        Board board("pty", format, m_folder.path("port"));
        start(onPort(frame));
        board.say("write 0-3 cut:4 noise:0A 5-7");
        ASSERT_TRUE(receive(7)) << format;
        expectFrames({0, 1, 2, 3, 5, 6, 7});
        EXPECT_NEAR(m_time_s[3] - m_time_s[0], 3 / 400.0, 1e-9);
        m_device.reset();
        m_frames.clear();
        m_time_s.clear();
        std::filesystem::remove(m_folder.path("port"));
    }
}

TEST_F(TaxelsDeviceTest, isLostWhenUnpluggedAndLiveAgainAfterItsReturn) {
    Board board("pty", "counted", m_folder.path("port"));
    start(onPort(test::kCounted));
    board.say("write 0-2");
    ASSERT_TRUE(receive(3));
    ASSERT_TRUE(board.done());
    ASSERT_TRUE(board.command("unplug"));
    ASSERT_TRUE(reaches(DeviceState::reconnecting));
    EXPECT_FALSE(m_device->status().message.empty());
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().failedAttempts >= 2; }));
    ASSERT_TRUE(board.command("plug"));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().connections == 2; }));
    board.say("write 40-42");
    ASSERT_TRUE(receive(6));
    expectFrames({0, 1, 2, 40, 41, 42});
    EXPECT_EQ(m_device->status().framesLost, 0U) << "what was sent meanwhile is not known";
    EXPECT_EQ(m_device->status().state, DeviceState::live);
}

TEST_F(TaxelsDeviceTest, isStaleThenLostWhenTheSensorFallsSilent) {
    Board board("pty", "counted", m_folder.path("port"));
    TaxelsTimes times = longTimes();
    times.stale_ms = 50;
    times.noFrames_ms = 300;
    start(onPort(test::kCounted), times);
    board.say("write 0-2");
    ASSERT_TRUE(receive(3));
    ASSERT_TRUE(reaches(DeviceState::stale));
    ASSERT_TRUE(eventually(
        m_wakeup, [&] { return m_device->status().message.find("no usable frame") != std::string::npos; }));
}

TEST_F(TaxelsDeviceTest, isStaleThenLostWhenTheSensorRepeatsOneFrame) {
    Board board("pty", "counted", m_folder.path("port"));
    TaxelsTimes times = longTimes();
    times.stale_ms = 100;
    times.noFrames_ms = 400;
    start(onPort(test::kCounted), times);
    ASSERT_TRUE(board.command("write 0-2"));
    ASSERT_TRUE(receive(3));
    const auto repeatsUntil = [&](const auto& condition) {
        return eventually(m_wakeup, [&] {
            (void)board.command("write 2");
            return condition(m_device->status());
        });
    };
    ASSERT_TRUE(
        repeatsUntil([](const core::DeviceStatus& status) { return status.state == DeviceState::stale; }));
    ASSERT_TRUE(repeatsUntil([](const core::DeviceStatus& status) {
        return status.message.find("no usable frame") != std::string::npos;
    }));
    EXPECT_GE(m_device->counters().repeatedFrames, 1U);
}

TEST_F(TaxelsDeviceTest, greetsTheSensorAndSaysGoodbye) {
    Board board("pty", "counted", m_folder.path("port"));
    start(test::head() + test::serialLink(m_folder.path("port")) +
          "greeting_bytes = 'AA 01'\ngoodbye = \"x\\n\"\n" + test::kGrid + test::kCounted);
    EXPECT_EQ(board.heard(), "aa01");
    m_device->stop();
    EXPECT_EQ(board.heard(), "aa01780a");
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}

TEST_F(TaxelsDeviceTest, readsATcpConnection) {
    Board board("tcp", "counted", "-");
    start(test::head() + "[link]\ntype = 'tcp'\nhost = '127.0.0.1'\nport = " + board.place() + "\n" +
          test::kGrid + test::kCounted);
    board.say("write 0-4 cut:5 6-9");
    ASSERT_TRUE(receive(9));
    expectFrames({0, 1, 2, 3, 4, 6, 7, 8, 9});
    ASSERT_TRUE(board.done());
    ASSERT_TRUE(board.command("unplug"));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().connections == 2; }));
    board.say("write 20-21");
    ASSERT_TRUE(receive(11));
}

/// A port that nobody uses.
std::string freePort() {
    Board board("tcp", "counted", "-");
    return board.place();
}

TEST_F(TaxelsDeviceTest, takesDatagramsOfThisComputerForOneFrameEach) {
    for (const auto& [format, frame] :
         {std::pair{"counted", test::kCounted}, std::pair{"json", test::kJson}}) {
        const std::string port = freePort();
        for (const char* from : {"", "from = '127.0.0.1'\n"}) {
            start(test::head() + "[link]\ntype = 'udp'\nport = " + port + "\n" + from + test::kGrid + frame);
            Board board("udp", format, port);
            board.say("write 0-2 noise:41 cut:3 4");
            ASSERT_TRUE(receive(4)) << format << from;
            expectFrames({0, 1, 2, 4});
            m_device.reset();
            m_frames.clear();
        }
    }
}

TEST_F(TaxelsDeviceTest, playsAFileToItsEndWithoutLosingAFrame) {
    constexpr std::uint32_t kFrames = 3000; // more than the queue takes at once
    const std::string path = m_folder.path("bytes.bin");
    {
        Board board("file", "counted", path);
        ASSERT_TRUE(board.command("write noise:00FF 0-" + std::to_string(kFrames - 1)));
    }
    start(test::head() + "[link]\ntype = 'file'\npath = '" + path + "'\n" + test::kGrid + test::kCounted);
    ASSERT_TRUE(receive(kFrames));
    for (std::uint32_t i = 0; i < kFrames; ++i)
        ASSERT_EQ(m_frames[i], test::valuesOf(i));
    ASSERT_TRUE(reaches(DeviceState::finished));
    EXPECT_EQ(m_device->status().framesLost, 0U);
    EXPECT_TRUE(m_device->description().recorded);
    EXPECT_EQ(m_device->counters().line.droppedBytes, 2U);
}

TEST_F(TaxelsDeviceTest, playsAFileWithoutTimesAtItsRate) {
    const std::string path = m_folder.path("bytes.csv");
    {
        Board board("file", "csv", path);
        ASSERT_TRUE(board.command("write 0-9"));
    }
    start("rate_Hz = 200.0\n" + test::head() + "[link]\ntype = 'file'\npath = '" + path + "'\n" +
          test::kGrid + "[frame]\nencoding = 'csv'\ncolumns = '2..85'\nskip = 0\n");
    ASSERT_TRUE(receive(10));
    for (std::size_t i = 1; i < m_time_s.size(); ++i)
        EXPECT_NEAR(m_time_s[i] - m_time_s[i - 1], 5e-3, 1e-9);
}

TEST_F(TaxelsDeviceTest, believesALineWithoutItsEndOnlyAtTheEndOfAFile) {
    const std::string text = "0,1,2\n0.1,3,4";
    const std::string layout = "[layout]\nrows = 1\ncolumns = 2\npitch_x_mm = 1.0\n";
    const std::string frame = "[frame]\nencoding = 'csv'\ncolumns = '2..3'\nskip = 0\n";
    start(test::head() + "[link]\ntype = 'file'\npath = '" + m_folder.write("bytes.csv", text) + "'\n" +
          layout + frame);
    ASSERT_TRUE(reaches(DeviceState::finished));
    drain();
    EXPECT_EQ(m_frames, (std::vector<std::vector<float>>{{1, 2}, {3, 4}}));
    m_frames.clear();

    Board board("pty", "csv", m_folder.path("port"));
    start(test::head() + test::serialLink(m_folder.path("port")) + layout + frame);
    // As noise: the text, which is cut, then an unplugged board.
    ASSERT_TRUE(board.command("write noise:302C312C320A302E312C332C34"));
    ASSERT_TRUE(receive(1));
    ASSERT_TRUE(board.command("unplug"));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().line.badValues == 1; }));
    drain();
    EXPECT_EQ(m_frames, (std::vector<std::vector<float>>{{1, 2}}));
}

TEST_F(TaxelsDeviceTest, probesWhatCameWhereItIsAndHowFast) {
    const std::string path = m_folder.path("bytes.bin");
    {
        Board board("file", "counted", path);
        ASSERT_TRUE(board.command("write noise:00FF 7 flip:8 9-11"));
    }
    const TaxelsFile file = test::parsed(test::head() + "[link]\ntype = 'file'\npath = '" + path + "'\n" +
                                         test::kGrid + test::kCounted);
    const auto probe = probeTaxels(file, {.bytes = 100});
    ASSERT_TRUE(probe) << core::describe(probe.error());
    constexpr std::size_t kFrame = 179;
    EXPECT_EQ(probe->bytes.size(), 100U);
    EXPECT_EQ(probe->bytes[0], 0x00);
    EXPECT_EQ(probe->bytes[2], 0xAA);
    ASSERT_EQ(probe->frames.size(), 4U);
    EXPECT_EQ(probe->frames[0].begin, 2U);
    EXPECT_EQ(probe->frames[0].bytes, kFrame);
    EXPECT_EQ(probe->frames[1].begin, 2 + 2 * kFrame);
    EXPECT_EQ(probe->counters.badChecksums, 1U);
    EXPECT_EQ(probe->first, test::valuesOf(7));
    EXPECT_FALSE(probe->rate_Hz) << "a file has no rate";
}

TEST_F(TaxelsDeviceTest, saysWhyALinkCannotBeOpened) {
    const auto missing = TaxelsDevice::open(test::parsed(onPort(test::kCounted)));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, core::ErrorKind::notFound);
    const auto folder =
        TaxelsDevice::open(test::parsed(test::head() + "[link]\ntype = 'file'\npath = '" +
                                        m_folder.path("..") + "'\n" + test::kGrid + test::kCounted));
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error().kind, core::ErrorKind::refused);
}

} // namespace
} // namespace teleta::taxels
