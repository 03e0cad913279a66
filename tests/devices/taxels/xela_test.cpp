// SPDX-License-Identifier: GPL-3.0-or-later
// XELA sensors against a server of the package "ws", which the peers of MCAP bring along.
#include "devices/taxels/taxels_device.h"
#include "devices/taxels/taxels_probe.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/taxels/taxel_files.h"
#include "tests/support/peer_process.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <utility>

namespace teleta::taxels {
namespace {

using core::DeviceState;
using teleta::test::eventually;

constexpr char kPeers[] = TELETA_SOURCE_DIR "/build/mcap-peers";

class Xela : public testing::Test {
protected:
    void SetUp() override {
        static int argc = 1;
        static std::array<char*, 2> argv{const_cast<char*>("xela_test"), nullptr};
        static const QCoreApplication kApplication(argc, argv.data()); // for the sockets of Qt
        if (!std::filesystem::exists(std::string(kPeers) + "/node_modules/ws"))
            GTEST_SKIP() << "tests/peer/mcap/install.sh installs the peers";
        qputenv("TELETA_MCAP_PEERS", kPeers);
        m_server.start(QStringLiteral("node"),
                       {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/taxels/xela_server.mjs")});
        const auto ready = m_server.waitFor("ready ");
        ASSERT_TRUE(ready) << m_server.errors();
        m_port = ready->substr(6);
    }

    [[nodiscard]] std::string fileFor(const std::string& values) const {
        return "kind = 'xela'\nname = 'palm'\nurl = 'ws://127.0.0.1:" + m_port + "'\n" + values +
               "axes = ['+x', '+y', '-z']\n[layout]\nrows = 4\ncolumns = 4\npitch_x_mm = 4.7\n";
    }

    void start(const std::string& values) {
        TaxelsFile file = test::parsed(fileFor(values));
        file.times.connect_ms = 20'000;
        file.times.stale_ms = 20'000;
        EXPECT_EQ(file.times.unusable_ms, 1000);
        EXPECT_EQ(file.times.noFrames_ms, 3000);
        file.times.noFrames_ms = 20'000;
        file.times.unusable_ms = m_unusable_ms;
        file.times.firstRetry_ms = 5;
        file.times.longestRetry_ms = 20;
        auto device = TaxelsDevice::open(std::move(file));
        ASSERT_TRUE(device) << core::describe(device.error());
        m_device = std::move(*device);
        m_device->start(m_wakeup);
        ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().line.otherFrames == 1; }))
            << "the welcome";
    }

    [[nodiscard]] bool receive(std::size_t frames) {
        return eventually(m_wakeup, [&] {
            core::SampleBlock block;
            while (m_device->blocks().pop(block))
                for (std::size_t i = 0; i < block.frames(); ++i) {
                    const auto values = block.frame(i);
                    m_frames.emplace_back(values.begin(), values.end());
                    m_numbers.push_back(block.firstFrame + i);
                    m_time_s.push_back(block.sourceTime_s[i]);
                }
            return m_frames.size() >= frames;
        });
    }

    int m_unusable_ms = 20'000;
    teleta::test::PeerProcess m_server;
    std::string m_port;
    core::Wakeup m_wakeup;
    std::unique_ptr<TaxelsDevice> m_device;
    std::vector<std::vector<float>> m_frames;
    std::vector<std::uint64_t> m_numbers;
    std::vector<double> m_time_s;
};

constexpr const char* kForces = "values = 'calibrated'\n";
constexpr const char* kRaw = "values = 'raw'\nthreshold = 100.0\n";

TEST_F(Xela, givesTheForcesOfEachTaxelInNewtons) {
    start(kForces);
    EXPECT_EQ(m_device->description().unit, "N");
    EXPECT_EQ(m_device->description().layout, core::TaxelLayout(core::ArrayLayout{4, 4, 0.0047}, 3));
    ASSERT_TRUE(m_server.command("forces 786 789"));
    ASSERT_TRUE(m_server.command("forces 792 793"));
    ASSERT_TRUE(receive(6));
    ASSERT_EQ(m_frames[0].size(), 48U);
    for (std::size_t i = 0; i < 48; ++i) {
        const float told = 786.0F / 8 + static_cast<float>(i) / 16;
        EXPECT_EQ(m_frames[0][i], i % 3 == 2 ? -told : told)
            << "the sensor's z points into the surface: " << i;
    }
    EXPECT_EQ(m_numbers, (std::vector<std::uint64_t>{0, 1, 2, 3, 6, 7})) << "two messages are missing";
    EXPECT_EQ(m_device->status().framesLost, 2U);
    EXPECT_NEAR(m_time_s[3] - m_time_s[0], 0.03, 1e-6);
    ASSERT_TRUE(m_server.command("forces 1 2"));
    ASSERT_TRUE(receive(8));
    EXPECT_EQ(m_device->counters().sensorRestarts, 1U) << "a new server counts from the begin";
    EXPECT_EQ(m_device->status().framesLost, 2U);
}

TEST_F(Xela, givesRawNumbersAsADescribedArrayDoes) {
    start(kRaw);
    EXPECT_EQ(m_device->description().unit, "counts");
    m_server.say("raw 0 999"); // which is read while it is sent
    ASSERT_TRUE(receive(1000));
    for (std::size_t n = 0; n < 1000; ++n)
        for (std::size_t i = 0; i < 48; ++i) {
            const auto told = static_cast<float>((n * 131 + i) & 0xFFFFU);
            ASSERT_EQ(m_frames[n][i], i % 3 == 2 ? -told : told);
        }
    EXPECT_EQ(m_device->status().framesLost, 0U);
    const auto driver = std::exchange(m_frames, {});
    m_device.reset();
    TaxelsFile file =
        test::parsed(test::head() + "[link]\ntype = 'websocket'\nurl = 'ws://127.0.0.1:" + m_port +
                     "'\n[layout]\ncomponents = 3\naxes = ['+x', '+y', '-z']\nrows = 4\ncolumns = "
                     "4\npitch_x_mm = 4.7\n[frame]\nencoding = 'json'\nvalues = '/1/data'\nhex = "
                     "true\ncount = 48\ncounter = '/message'\n");
    file.times.noFrames_ms = 20'000;
    auto device = TaxelsDevice::open(std::move(file));
    ASSERT_TRUE(device) << core::describe(device.error());
    m_device = std::move(*device);
    m_device->start(m_wakeup);
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->counters().line.otherFrames == 1; }));
    m_server.say("raw 0 999"); // which is read while it is sent
    ASSERT_TRUE(receive(1000));
    EXPECT_EQ(m_frames, driver);
}

TEST_F(Xela, dropsAndCountsWhatIsNoFrameOfTheSensor) {
    start(kForces);
    for (const char* line : {"forces 1 2", "null 3", "other 4", "say {\"message\": 5, \"1\": ", "bytes",
                             "say {\"message\": 6, \"2\": {\"calibrated\": [1, 2]}}",
                             "say {\"message\": 7, \"1\": {\"calibrated\": [NaN]}}", "model 8", "forces 9 9"})
        ASSERT_TRUE(m_server.command(line)) << line;
    ASSERT_TRUE(receive(3));
    EXPECT_EQ(m_frames[2][2], -(9.0F / 8 + 2.0F / 16));
    EXPECT_EQ(m_device->counters().line.badValues, 5U) << "null, other, say, say, model";
    EXPECT_EQ(m_device->counters().binaryMessages, 1U);
    EXPECT_EQ(m_device->counters().line.otherFrames, 2U) << "the welcome, and a message without this sensor";
    EXPECT_EQ(m_device->status().framesLost, 6U);
}

TEST_F(Xela, oneBadSensorDoesNotSpoilTheOthers) {
    start(kForces);
    ASSERT_TRUE(m_server.command("spoilt 1 2"));
    ASSERT_TRUE(receive(2));
    EXPECT_EQ(m_frames[1][2], -(2.0F / 8 + 2.0F / 16));
    EXPECT_EQ(m_device->counters().line.badValues, 0U);
}

TEST_F(Xela, takesTheSensorsTimeWhereTheServerTellsNone) {
    start(kForces);
    ASSERT_TRUE(m_server.command("timed 1 4"));
    ASSERT_TRUE(receive(4));
    EXPECT_NEAR(m_time_s[3] - m_time_s[0], 3.0 * 0.25, 1e-6);
}

TEST_F(Xela, isLostWhenItsForcesEndAndSaysWhy) {
    m_unusable_ms = 50; // of 20 s without any frame
    start(kForces);
    ASSERT_TRUE(m_server.command("forces 1 2"));
    ASSERT_TRUE(receive(2));
    for (const auto& [command, cause] : {std::pair{"null 3", "no values"},
                                         {"model 4", "uSPa46 instead of uSPa44"},
                                         {"other 5", "24 taxels"}}) {
        std::string message;
        ASSERT_TRUE(eventually(m_wakeup,
                               [&] {
                                   (void)m_server.command(command);
                                   const core::DeviceStatus status = m_device->status();
                                   if (status.state == DeviceState::lost ||
                                       status.state == DeviceState::reconnecting)
                                       message = status.message;
                                   return message.find(cause) != std::string::npos;
                               }))
            << command << ": " << message;
        // It connects again, and a good frame makes it live.
        ASSERT_TRUE(eventually(m_wakeup, [&] {
            (void)m_server.command("forces 6 6");
            return m_device->status().state == DeviceState::live;
        }));
    }
    EXPECT_GE(m_device->counters().line.badValues, 3U);
}

TEST_F(Xela, connectsAgainWhenTheServerClosesOrSendsTooMuch) {
    start(kForces);
    ASSERT_TRUE(m_server.command("forces 1 2"));
    ASSERT_TRUE(receive(2));
    for (const char* line : {"close 1001", "long"}) {
        const std::uint64_t before = m_device->counters().connections;
        ASSERT_TRUE(m_server.command(line));
        ASSERT_TRUE(eventually(m_wakeup, [&] {
            return m_device->counters().connections > before &&
                   m_device->counters().line.otherFrames > before;
        })) << line;
    }
    ASSERT_TRUE(m_server.command("forces 10 11"));
    ASSERT_TRUE(receive(4));
    EXPECT_EQ(m_device->status().state, DeviceState::live);
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}

TEST_F(Xela, sensorsOfOneServerShareAConnection) {
    start(kForces);
    TaxelsFile file = test::parsed(
        "kind = 'xela'\nname = 'thumb'\nurl = 'ws://127.0.0.1:" + m_port +
        "'\nsensor = 2\nvalues = 'raw'\nthreshold = 100.0\nrest_frames = 0\n[layout]\nrows = 4\ncolumns = "
        "6\npitch_x_mm = 4.7\n");
    file.times.noFrames_ms = 20'000;
    auto other = TaxelsDevice::open(std::move(file));
    ASSERT_TRUE(other) << core::describe(other.error());
    core::Wakeup wakeup;
    (*other)->start(wakeup);
    ASSERT_TRUE(m_server.command("forces 8 17"));
    ASSERT_TRUE(receive(10));
    EXPECT_EQ(m_frames.front().front(), 1.0F);
    std::vector<float> first;
    std::size_t frames = 0;
    ASSERT_TRUE(eventually(wakeup, [&] {
        core::SampleBlock block;
        while ((*other)->blocks().pop(block)) {
            if (first.empty())
                first.assign(block.frame(0).begin(), block.frame(0).end());
            frames += block.frames();
        }
        return frames >= 10;
    }));
    ASSERT_EQ(first.size(), 72U);
    for (std::size_t i = 0; i < 72; ++i)
        EXPECT_EQ(first[i], static_cast<float>(9U * 131 + i));
    m_server.say("clients");
    EXPECT_EQ(m_server.waitFor("clients "), "clients 1");
    // One of them goes, the other stays; when the server closes, it connects again.
    m_device->stop();
    m_device.reset();
    ASSERT_TRUE(m_server.command("forces 18 19"));
    ASSERT_TRUE(eventually(wakeup, [&] {
        core::SampleBlock block;
        while ((*other)->blocks().pop(block))
            frames += block.frames();
        return frames >= 12;
    }));
    ASSERT_TRUE(m_server.command("close 1001"));
    ASSERT_TRUE(eventually(wakeup, [&] { return (*other)->counters().connections == 2; }));
}

TEST_F(Xela, isWaitedForUntilSomebodyCancels) {
    const TaxelsFile file = test::parsed(fileFor(kRaw));
    EXPECT_EQ(file.restFrames, 50);
    int asked = 0;
    const auto rest = measureRest(file, [&] { return ++asked > 3; });
    ASSERT_FALSE(rest);
    EXPECT_EQ(rest.error().kind, core::ErrorKind::cancelled);
}

TEST_F(Xela, saysThatNoServerAnswers) {
    m_server.kill();
    const auto device = TaxelsDevice::open(test::parsed(fileFor(kForces)));
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(device.error().message.find(m_port), std::string::npos) << device.error().message;
}

TEST(XelaFile, saysWhatIsWrongWhere) {
    const auto errorOf = [](const std::string& text) {
        const auto file = parseTaxels(text, "palm.toml");
        EXPECT_FALSE(file);
        return file ? core::Error() : file.error();
    };
    const std::string layout = "[layout]\nrows = 4\ncolumns = 4\npitch_x_mm = 4.7\n";
    EXPECT_EQ(errorOf("kind = 'xela'\nname = 'palm'\nurl = 'http://a'\nvalues = 'calibrated'\n" + layout)
                  .where.line,
              3);
    EXPECT_EQ(errorOf("kind = 'xela'\nname = 'palm'\nvalues = 'forces'\n" + layout).where.line, 3);
    EXPECT_NE(errorOf("kind = 'xela'\nname = 'palm'\nvalues = 'raw'\n" + layout).message.find("threshold"),
              std::string::npos);
    EXPECT_NE(errorOf("kind = 'xela'\nname = 'palm'\nvalues = 'calibrated'\n").message.find("layout"),
              std::string::npos);
}

} // namespace
} // namespace teleta::taxels
