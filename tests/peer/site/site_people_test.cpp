// SPDX-License-Identifier: GPL-3.0-or-later
// What consoles learn of each other: who sits there, why somebody declined, that a name is taken.
#include "devices/site/console_ends.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_control.h"
#include "tests/peer/site/site_process.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <vector>

namespace teleta {
namespace {

using site::CommandRefusal;
using site::RequestAnswer;
using site::RequestKind;
using test::SiteProcess;
using test::TestConsole;

constexpr const char* kPractice = "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n";

TEST(SitePeople, personsAreKnownAsLongAsTheyAreThere) {
    SiteProcess site(144, kPractice);
    site.start();
    TestConsole one(site.fileOf("a", false, "A. Name"));
    TestConsole two(site.fileOf("v", true));
    auto three = std::make_unique<TestConsole>(site.fileOf("b", true, "B. Name"));
    using Persons = std::map<std::string, std::string>;
    for (TestConsole* console : {&one, &two})
        EXPECT_TRUE(TestConsole::eventually([&] {
            return console->view().persons == Persons{{"a", "A. Name"}, {"b", "B. Name"}};
        }));
    three.reset();
    EXPECT_TRUE(TestConsole::eventually([&] { return two.view().persons == Persons{{"a", "A. Name"}}; }));
}

TEST(SitePeople, aTakeOverIsDeclinedWithAReason) {
    SiteProcess site(145, kPractice);
    site.start();
    TestConsole one(site, "a");
    TestConsole boss(site, "boss");
    ASSERT_EQ(one.ask(RequestKind::request), RequestAnswer::done);
    const std::uint64_t id = boss.request(RequestKind::takeOver);
    ASSERT_TRUE(TestConsole::eventually([&] { return one.view().offeredTo == "boss"; }));
    EXPECT_EQ(one.ask(RequestKind::decline, "nearly done"), RequestAnswer::done);
    ASSERT_TRUE(TestConsole::eventually([&] {
        const auto request = boss.view().request;
        return request && request->id == id && request->answer == RequestAnswer::expired;
    }));
    EXPECT_EQ(boss.view().request->declined, "nearly done");
    EXPECT_EQ(one.view().controller, "a");
}

TEST(SitePeople, aSecondProgramOfANameIsToldSoAtOnce) {
    SiteProcess site(146, kPractice);
    site.start();
    TestConsole first(site, "a");
    TestConsole second(site, "a");
    EXPECT_EQ(first.ask(RequestKind::request), RequestAnswer::done);
    EXPECT_EQ(second.ask(RequestKind::request), RequestAnswer::noSuchConsole);
    EXPECT_TRUE(first.controls());
    EXPECT_FALSE(second.controls());
    EXPECT_EQ(first.ask(RequestKind::release), RequestAnswer::done);
}

TEST(SitePeople, theFirstNameTooManyIsRefusedInTheLog) {
    SiteProcess site(157, kPractice);
    site.start();
    const auto file = site_link::readRemoteSite(site.fileOf("c0"));
    ASSERT_TRUE(file) << core::describe(file.error());
    const auto participant = file->meeting.join();
    ASSERT_TRUE(participant) << core::describe(participant.error());
    const site_link::SiteTopics topics("lab");
    std::vector<dds::Writer<ros::ConsolePresence>> consoles;
    for (std::size_t i = 0; i <= site_link::SiteControl::kMostConsoles; ++i) {
        auto opened = dds::Writer<ros::ConsolePresence>::open(
            *participant, topics.presence("c" + std::to_string(i)), site_link::kPresenceProfile);
        ASSERT_TRUE(opened) << core::describe(opened.error());
        consoles.push_back(std::move(*opened));
    }
    EXPECT_TRUE(site.says("console_refused"));
}

TEST(SitePeople, loopsAndRefusalsAreCounted) {
    SiteProcess site(147, kPractice);
    site.start();
    TestConsole console(site, "a");
    EXPECT_DOUBLE_EQ(console.client().loopLimit_s(), 0.5);
    ASSERT_TRUE(
        TestConsole::eventually([&] { return console.view().loops && console.view().shownOffset_ns; }));
    const site_link::SiteView view = console.view();
    EXPECT_GT(view.loops->median_s, 0.0);
    EXPECT_GE(view.loops->slow_s, view.loops->median_s);
    // The first offset is shown as it is, later ones follow it slowly; both clocks are one here.
    EXPECT_LE(std::abs(*view.shownOffset_ns), view.clock->bound_ns + 10'000'000);
    console.press(0.3);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().refused > 5; }));
    console.letGo();
    const site_link::SiteView refused = console.view();
    EXPECT_GT(refused.refusedBy[static_cast<std::size_t>(CommandRefusal::notController)], 0U);
    EXPECT_LE(std::accumulate(refused.refusedBy.begin(), refused.refusedBy.end(), std::uint64_t{0}),
              refused.refused);
}

TEST(SitePeople, acceptedProbesOfTheClockAreRecordedAsTheyWere) {
    SiteProcess site(149, kPractice);
    site.start();
    TestConsole console(site, "v", true);
    const recording::StreamInfo stream = console.client().clockStream();
    EXPECT_EQ(stream.name, "lab-clock");
    EXPECT_EQ(stream.channels(), 4U);
    const auto tap = std::make_shared<core::StreamTap>(64);
    console.client().recordClock(tap);
    std::vector<core::TappedFrames> probes;
    ASSERT_TRUE(TestConsole::eventually([&] {
        for (core::TappedFrames block; tap->pop(block);)
            probes.push_back(block);
        return probes.size() >= 3;
    }));
    console.client().recordClock(nullptr);
    for (const core::TappedFrames& probe : probes) {
        ASSERT_EQ(probe.frames(), 1U);
        std::array<double, 4> t{};
        ASSERT_EQ(probe.values.size(), sizeof t);
        std::memcpy(t.data(), probe.values.data(), sizeof t);
        // One clock on this machine: sent, received, answered, received.
        EXPECT_LE(t[0], t[1]);
        EXPECT_LE(t[1], t[2]);
        EXPECT_LE(t[2], t[3]);
        EXPECT_NEAR(t[3], static_cast<double>(probe.time_ns[0]), 1.0);
    }
}

} // namespace
} // namespace teleta
