// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/foxglove/live_streams.h"
#include "tests/support/peer_process.h"

#include <QThread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

using namespace teleta;

namespace {

constexpr char kPeers[] = TELETA_SOURCE_DIR "/build/mcap-peers";

} // namespace

TEST(LiveViewPeer, theClientOfFoxgloveReadsEveryTopic) {
    if (!std::filesystem::exists(std::string(kPeers) + "/node_modules"))
        GTEST_SKIP() << "tests/peer/mcap/install.sh installs the peers";
    const auto view = test::listeningView();
    ASSERT_NE(view, nullptr);
    const auto tap = view->addStream(test::skinInfo());
    qputenv("TELETA_MCAP_PEERS", kPeers);
    test::PeerProcess client;
    client.start(QStringLiteral("node"),
                 {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/mcap/live_client.mjs"),
                  QString::number(view->status().port), QStringLiteral("4")});
    const auto subscribed = client.waitFor("subscribed");
    ASSERT_TRUE(subscribed) << client.errors();
    // Both topics of the array and an event arrive with what was sent.
    std::optional<std::string> line;
    ASSERT_TRUE(test::waitUntil([&] { return view->status().clients == 1; }));
    for (int i = 0; i < 200; ++i) {
        (void)test::appendSkin(*tap, static_cast<float>(i) / 4.0F);
        view->add({.time_ns = core::steadyNow_ns(), .kind = "mark", .text = "mark " + std::to_string(i)});
        QThread::msleep(2);
    }
    line = client.waitFor("received");
    ASSERT_TRUE(line) << client.errors();
    const auto received = nlohmann::json::parse(line->substr(line->find('{')));
    EXPECT_EQ(received["server"], "TeleTA Console");
    ASSERT_GE(received["/skin/array"].size(), 4U);
    const auto& array = received["/skin/array"][1];
    EXPECT_EQ(array["rows"], 2);
    EXPECT_EQ(array["columns"], 3);
    EXPECT_EQ(array["unit"], "N");
    const double first = array["value"][0].get<double>();
    EXPECT_EQ(first * 4.0, std::floor(first * 4.0));
    EXPECT_EQ(array["value"][5], 5.0);
    // In order, one after the other.
    const double second = received["/skin/array"][2]["value"][0].get<double>();
    EXPECT_EQ(second, first + 0.25);
    EXPECT_EQ(received["/skin/image"][0]["encoding"], "32FC1");
    EXPECT_EQ(received["/events"][0]["name"], "mark");
}
