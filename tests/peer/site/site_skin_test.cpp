// SPDX-License-Identifier: GPL-3.0-or-later
// Skins at a site, played by the board in Python: the consoles have the loads of magnetometers in newtons and
// the temperatures of their chips, and what a sensor that counts its frames has lost.
#include "app/sources/site_request.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/peer/site/site_process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

namespace teleta {
namespace {

using test::PeerProcess;
using test::SiteProcess;
using test::TestConsole;

constexpr const char* kDevices = "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n"
                                 "[[device]]\nid = \"skin\"\nfile = \"skin.toml\"\n";
constexpr double kFallPerFrame_uT = 1.0 / 8.0; ///< of the field, as the board has it
constexpr double kWarmPerFrame_K = 1.0 / 64.0;

/// The board's chips warm up by 1 K in 64 frames, and the field at each falls by 1/8 uT a frame.
class SiteSkin : public testing::Test {
protected:
    SiteSkin()
        : m_site(132, kDevices) {}

    void SetUp() override {
        write("newtons.csv", "load,signal,gain,gain_se,rest,least,greatest,scatter\n"
                             "force_n,t4_z,-0.01,0.001,0,-30,30,0.05\n");
        write("skin.toml", "kind = 'magnetometers'\nname = 'skin'\npath = 'port'\nchips = 5\n"
                           "format = 'binary'\naxes = ['+x', '+y', '-z']\nthreshold_uT = 40.0\n"
                           "positions_mm = [[0, 0], [7, 0], [-7, 0], [0, 7], [0, -7]]\n"
                           "loads = 'newtons.csv'\n");
        m_board.start(QStringLiteral("/usr/bin/python3"),
                      {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/taxels/board.py"), QStringLiteral("pty"),
                       QStringLiteral("skin"), m_site.folder().filePath("port")});
        ASSERT_TRUE(m_board.waitFor("ready ")) << m_board.errors();
        send("0", 200);
        m_site.start();
    }
    void write(const char* name, const char* text) {
        std::ofstream(m_site.folder().filePath(name).toStdString()) << text;
    }
    /// The same frame again and again, 50 in a second.
    void send(const std::string& frame, int times) {
        std::string line = "write";
        for (int i = 0; i < times; ++i)
            line += " pause:20 " + frame;
        m_board.say(line);
    }

    SiteProcess m_site;
    PeerProcess m_board;
};

TEST_F(SiteSkin, itsConsolesHaveItsLoadsAndItsTemperaturesAndKnowThatItsLossesAreNotCounted) {
    TestConsole console(m_site, "a");
    const app::SiteRequest request{{}, "lab", "skin", console.sharedClient()};
    const auto opened = app::openRemote(console.sharedClient(), request);
    ASSERT_TRUE(opened) << core::describe(opened.error());
    const auto channel = std::dynamic_pointer_cast<pipeline::TouchChannel>(*opened);
    ASSERT_TRUE(channel);
    EXPECT_FALSE(channel->countsLosses());
    const std::string path = m_site.folder().filePath("console.teleta").toStdString();
    auto started = recording::Recorder::start(path, {});
    ASSERT_TRUE(started) << core::describe(started.error());
    const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
    channel->record(recorder, "skin");
    core::Wakeup data;
    channel->start(data);
    const auto comes = [&](const auto& holds) {
        return TestConsole::eventually([&] {
            channel->process();
            return holds();
        });
    };
    // The site took the rest of the skin with frame 0 when it opened it.
    ASSERT_TRUE(comes([&] { return channel->newestLoads().has_value(); }));
    EXPECT_NEAR(channel->newestLoads()->at.loads[0], 0.0, 1e-6);
    EXPECT_FALSE(channel->newestLoads()->at.extrapolated);
    EXPECT_FALSE(channel->temperatureDrift());

    send("400", 1000);
    ASSERT_TRUE(comes([&] { return channel->newestLoads()->at.extrapolated; }));
    EXPECT_NEAR(channel->newestLoads()->at.loads[0], 0.01 * 400 * kFallPerFrame_uT, 1e-5);
    EXPECT_NEAR(channel->newestLoads()->at.errors[0], std::hypot(0.05, 0.001 * 400 * kFallPerFrame_uT), 1e-5);
    ASSERT_TRUE(comes([&] { return channel->temperatureDrift().has_value(); }));
    EXPECT_NEAR(channel->temperatureDrift()->change_K, 400 * kWarmPerFrame_K, 1e-5);
    // A tare that is taken here holds here.
    channel->requestTare(0.05);
    ASSERT_TRUE(comes([&] { return !channel->newestLoads()->at.extrapolated; }));
    EXPECT_NEAR(channel->newestLoads()->at.loads[0], 0.0, 1e-5);
    ASSERT_TRUE(comes([&] { return !channel->temperatureDrift(); }));
    // A console that comes later knows the temperatures at which the site took the rest.
    TestConsole late(m_site, "b");
    const auto second = app::openRemote(late.sharedClient(), {{}, "lab", "skin", late.sharedClient()});
    ASSERT_TRUE(second) << core::describe(second.error());
    const auto other = std::dynamic_pointer_cast<pipeline::TouchChannel>(*second);
    ASSERT_TRUE(other);
    other->start(data);
    ASSERT_TRUE(comes([&] {
        other->process();
        return other->temperatureDrift().has_value();
    }));
    EXPECT_NEAR(other->temperatureDrift()->change_K, 400 * kWarmPerFrame_K, 1e-5);
    EXPECT_NEAR(other->newestLoads()->at.loads[0], 0.01 * 400 * kFallPerFrame_uT, 1e-5);
    other->stop();
    channel->stop();
    channel->record(nullptr, {});
    ASSERT_TRUE(recorder->stop());

    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    for (const char* name : {"skin-frames", "skin-temperatures", "skin-loads"}) {
        const auto& streams = recording->streams();
        const auto found = std::ranges::find(streams, name, &recording::StreamInfo::name);
        ASSERT_NE(found, streams.end()) << name;
        const auto extent = recording->extent(static_cast<std::size_t>(found - streams.begin()));
        ASSERT_TRUE(extent && *extent) << name;
        EXPECT_GT((*extent)->frames, 10U) << name;
    }
}

/// The glove that comes as an example: its board counts its frames.
class SiteGlove : public testing::Test {
protected:
    SiteGlove()
        : m_site(133, "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n"
                      "[[device]]\nid = \"glove\"\nfile = \"glove.toml\"\n") {}

    void SetUp() override {
        std::ifstream example(TELETA_SOURCE_DIR "/resources/devices/taxels-glove.toml");
        std::string text((std::istreambuf_iterator<char>(example)), {});
        // The board's checksum is over the bytes that begin a frame, too.
        for (const auto& [its, ours] :
             {std::pair("/dev/ttyACM0", "port"), std::pair("from = 2", "from = 0")}) {
            ASSERT_NE(text.find(its), std::string::npos);
            text.replace(text.find(its), std::string(its).size(), ours);
        }
        std::ofstream(m_site.folder().filePath("glove.toml").toStdString()) << text;
        m_board.start(QStringLiteral("/usr/bin/python3"),
                      {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/taxels/board.py"), QStringLiteral("pty"),
                       QStringLiteral("counted"), m_site.folder().filePath("port")});
        ASSERT_TRUE(m_board.waitFor("ready ")) << m_board.errors();
        m_site.start();
    }

    SiteProcess m_site;
    PeerProcess m_board;
    int m_next = 0; ///< frame of the board
};

TEST_F(SiteGlove, whatItsSensorLostIsLostAtItsConsoles) {
    TestConsole console(m_site, "a");
    const auto opened = app::openRemote(console.sharedClient(), {{}, "lab", "glove", console.sharedClient()});
    ASSERT_TRUE(opened) << core::describe(opened.error());
    const auto channel = std::dynamic_pointer_cast<pipeline::TouchChannel>(*opened);
    ASSERT_TRUE(channel);
    EXPECT_TRUE(channel->countsLosses());
    core::Wakeup data;
    channel->start(data);
    const auto reads = [&](std::uint64_t frames) {
        const std::uint64_t end = channel->framesProcessed() + frames;
        return TestConsole::eventually([&] {
            m_board.say("write " + std::to_string(m_next++));
            channel->process();
            return channel->framesProcessed() >= end;
        });
    };
    ASSERT_TRUE(reads(5));
    EXPECT_EQ(channel->lostAtSite(), 0U);
    m_next += 7;
    ASSERT_TRUE(reads(20));
    EXPECT_EQ(channel->lostAtSite(), 7U);
    EXPECT_GE(channel->status().framesLost, 7U);
    channel->stop();
}

} // namespace
} // namespace teleta
