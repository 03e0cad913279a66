// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/control_arbiter.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace teleta::site;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSecond = 1'000'000'000;

BootName boot(std::uint8_t value) {
    BootName name{};
    name[0] = value;
    return name;
}

/// A site with two consoles and a viewer, and a clock.
class Site {
public:
    Site() {
        seeAll();
        pass(LeaseTimes().known_ns);
        seeAll();
    }

    ControlArbiter arbiter{{"two"}};
    std::int64_t now_ns = 100 * kSecond;

    void seeAll() {
        arbiter.presence("one", {boot(1), false, false}, now_ns);
        arbiter.presence("two", {boot(2), false, false}, now_ns);
        arbiter.presence("eyes", {boot(3), true, false}, now_ns);
    }
    void pass(std::int64_t time_ns) {
        now_ns += time_ns;
        arbiter.advance(now_ns);
    }
    RequestAnswer ask(const std::string& console, RequestKind kind, const std::string& target = {}) {
        const std::map<std::string, std::uint8_t> boots{{"one", 1}, {"two", 2}, {"eyes", 3}};
        return arbiter.request(console, boot(boots.at(console)), ++m_requests, kind, target, now_ns);
    }
    CommandHead head(const std::string& console, std::uint32_t press) {
        CommandHead made;
        made.boot = boot(console == "one" ? 1 : 2);
        made.number = ++m_numbers;
        made.epoch = arbiter.epoch();
        made.press = press;
        made.echoSite_ns = now_ns - 20 * kMs;
        return made;
    }
    CommandRefusal command(const std::string& console, std::uint32_t press) {
        return arbiter.command(console, head(console, press), now_ns);
    }
    [[nodiscard]] Mode mode() const { return arbiter.mode(now_ns); }
    [[nodiscard]] std::uint64_t lastRequest() const { return m_requests; }

private:
    std::uint64_t m_requests = 0;
    std::uint64_t m_numbers = 0;
};

} // namespace

TEST(ControlArbiter, theFirstRequestGetsControl) {
    Site site;
    EXPECT_EQ(site.mode(), Mode::free);
    EXPECT_EQ(site.ask("one", RequestKind::request), RequestAnswer::done);
    EXPECT_EQ(site.mode(), Mode::held);
    EXPECT_EQ(site.arbiter.controller(), "one");
    EXPECT_EQ(site.arbiter.epoch(), 1U);
    EXPECT_EQ(site.ask("two", RequestKind::request), RequestAnswer::busy);
    EXPECT_EQ(site.ask("eyes", RequestKind::request), RequestAnswer::notPermitted);
    EXPECT_EQ(site.ask("two", RequestKind::release), RequestAnswer::notController);
    EXPECT_EQ(site.ask("one", RequestKind::release), RequestAnswer::done);
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, aConsoleThatHasJustComeWaitsUntilItsSwitchIsKnown) {
    // As after a restart of the site: the switch has been held all the time, and the request comes first.
    ControlArbiter arbiter({}, {}, {}, 1000);
    const Presence one{boot(1), false, false};
    CommandHead held;
    held.boot = boot(1);
    held.press = 5;
    const auto command = [&](std::int64_t now_ns) {
        ++held.number;
        held.epoch = arbiter.epoch();
        held.echoSite_ns = now_ns;
        return arbiter.command("one", held, now_ns);
    };
    arbiter.presence("one", one, 0);
    EXPECT_EQ(arbiter.request("one", boot(1), 7, RequestKind::request, {}, 0), RequestAnswer::waits);
    EXPECT_EQ(arbiter.answerTo("one", 7), RequestAnswer::waits);
    EXPECT_EQ(arbiter.epoch(), 1000U);
    EXPECT_EQ(command(20 * kMs), CommandRefusal::notController);
    EXPECT_EQ(arbiter.request("one", boot(1), 7, RequestKind::request, {}, 299 * kMs), RequestAnswer::waits);
    EXPECT_EQ(arbiter.request("one", boot(1), 7, RequestKind::request, {}, 300 * kMs), RequestAnswer::done);
    EXPECT_EQ(arbiter.epoch(), 1001U);
    EXPECT_EQ(command(320 * kMs), CommandRefusal::pressAnew);
    held.press = 6;
    EXPECT_EQ(command(340 * kMs), CommandRefusal::none);
    // One that was cut off may have been pressed meanwhile.
    arbiter.advance(5 * kSecond);
    EXPECT_EQ(arbiter.mode(5 * kSecond), Mode::free);
    arbiter.presence("one", one, 5 * kSecond);
    EXPECT_EQ(arbiter.request("one", boot(1), 8, RequestKind::request, {}, 5 * kSecond),
              RequestAnswer::waits);
    // Whoever stays may wait for no longer than the first time.
    arbiter.presence("one", one, 5 * kSecond + 200 * kMs);
    EXPECT_EQ(arbiter.request("one", boot(1), 8, RequestKind::request, {}, 5 * kSecond + 300 * kMs),
              RequestAnswer::done);
}

TEST(ControlArbiter, aRepeatedRequestIsAnsweredOnce) {
    Site site;
    EXPECT_EQ(site.arbiter.request("one", boot(1), 7, RequestKind::request, {}, site.now_ns),
              RequestAnswer::done);
    EXPECT_EQ(site.ask("one", RequestKind::release), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.request("one", boot(1), 7, RequestKind::request, {}, site.now_ns),
              RequestAnswer::done);
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, commandsMoveForTheMotionLeaseOnly) {
    Site site;
    site.ask("one", RequestKind::request);
    EXPECT_EQ(site.command("one", 1), CommandRefusal::none);
    EXPECT_TRUE(site.arbiter.mayMove(site.now_ns));
    EXPECT_TRUE(site.arbiter.mayMove(site.now_ns + 100 * kMs));
    EXPECT_FALSE(site.arbiter.mayMove(site.now_ns + 101 * kMs));
    // A gap of up to half a second goes on with the same press, a longer one does not.
    site.pass(400 * kMs);
    EXPECT_EQ(site.mode(), Mode::held);
    EXPECT_EQ(site.command("one", 1), CommandRefusal::none);
    site.pass(501 * kMs);
    EXPECT_EQ(site.command("one", 1), CommandRefusal::pressAnew);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::none);
}

TEST(ControlArbiter, aHoldNeedsANewPress) {
    Site site;
    site.ask("one", RequestKind::request);
    site.command("one", 1);
    CommandHead hold = site.head("one", 1);
    hold.hold = true;
    EXPECT_EQ(site.arbiter.command("one", hold, site.now_ns), CommandRefusal::none);
    EXPECT_EQ(site.mode(), Mode::held);
    EXPECT_EQ(site.command("one", 1), CommandRefusal::pressAnew);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::none);
}

TEST(ControlArbiter, namesTheFirstConditionThatDoesNotHold) {
    Site site;
    EXPECT_EQ(site.command("one", 1), CommandRefusal::notController);
    site.ask("one", RequestKind::request);
    EXPECT_EQ(site.command("two", 1), CommandRefusal::notController);
    // The press of the refused command counts as seen.
    EXPECT_EQ(site.command("one", 1), CommandRefusal::pressAnew);
    const auto refusal = [&site](const std::function<void(CommandHead&)>& change) {
        CommandHead head = site.head("one", 2);
        change(head);
        return site.arbiter.command("one", head, site.now_ns);
    };
    EXPECT_EQ(refusal([](CommandHead& h) { h.epoch = 0; }), CommandRefusal::oldEpoch);
    EXPECT_EQ(refusal([&](CommandHead& h) { h.echoSite_ns = site.now_ns - 501 * kMs; }),
              CommandRefusal::oldLoop);
    EXPECT_EQ(refusal([&](CommandHead& h) { h.echoSite_ns = site.now_ns + 1; }), CommandRefusal::oldLoop);
    EXPECT_EQ(refusal([](CommandHead& h) { h.echoSite_ns = std::numeric_limits<std::int64_t>::min(); }),
              CommandRefusal::oldLoop);
    EXPECT_EQ(refusal([](CommandHead& h) { h.armKnown = false; }), CommandRefusal::unknownArm);
    EXPECT_EQ(refusal([](CommandHead& h) { h.finite = false; }), CommandRefusal::notFinite);
    EXPECT_EQ(refusal([](CommandHead& h) { h.armLive = false; }), CommandRefusal::notLive);
    EXPECT_EQ(refusal([](CommandHead& h) { h.boot = boot(9); }), CommandRefusal::otherBoot);
    EXPECT_EQ(refusal([](CommandHead&) {}), CommandRefusal::none);
    EXPECT_EQ(refusal([](CommandHead& h) { h.number = 1; }), CommandRefusal::oldNumber);
    EXPECT_EQ(site.arbiter.accepted(), 1U);
    EXPECT_EQ(site.arbiter.refused(CommandRefusal::oldLoop), 3U);
}

TEST(ControlArbiter, handsOverToTheOneWhoAccepts) {
    Site site;
    site.ask("one", RequestKind::request);
    site.command("one", 1);
    EXPECT_EQ(site.ask("one", RequestKind::offer, "nobody"), RequestAnswer::noSuchConsole);
    EXPECT_EQ(site.ask("one", RequestKind::offer, "eyes"), RequestAnswer::notPermitted);
    EXPECT_EQ(site.ask("one", RequestKind::offer, "two"), RequestAnswer::waits);
    const std::uint64_t offer = site.lastRequest();
    EXPECT_EQ(site.mode(), Mode::offered);
    EXPECT_EQ(site.arbiter.offeredTo(), "two");
    EXPECT_EQ(site.command("one", 2), CommandRefusal::notController);
    EXPECT_EQ(site.ask("two", RequestKind::accept), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.answerTo("one", offer), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.controller(), "two");
    EXPECT_EQ(site.arbiter.epoch(), 2U);
    EXPECT_EQ(site.command("one", 3), CommandRefusal::notController);
    EXPECT_EQ(site.command("two", 1), CommandRefusal::none);
}

TEST(ControlArbiter, whoDeclinesMaySayWhy) {
    Site site;
    ASSERT_EQ(site.ask("one", RequestKind::request), RequestAnswer::done);
    ASSERT_EQ(site.ask("two", RequestKind::takeOver), RequestAnswer::waits);
    const std::uint64_t first = site.lastRequest();
    EXPECT_FALSE(site.arbiter.declinedFor("two", first));
    EXPECT_EQ(site.ask("one", RequestKind::decline, "nearly done"), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.answerTo("two", first), RequestAnswer::expired);
    EXPECT_EQ(site.arbiter.declinedFor("two", first), "nearly done");
    EXPECT_EQ(site.arbiter.controller(), "one");

    // Without a reason, and with one that is too long.
    for (const std::string& reason :
         {std::string(), std::string(ControlArbiter::kLongestReason_bytes + 1, 'x')}) {
        ASSERT_EQ(site.ask("one", RequestKind::offer, "two"), RequestAnswer::waits);
        const std::uint64_t offer = site.lastRequest();
        EXPECT_EQ(site.ask("two", RequestKind::decline, reason), RequestAnswer::done);
        EXPECT_EQ(site.arbiter.declinedFor("one", offer), "");
    }
    // Who gives its own wish up is not declined, nor is one that nobody answered.
    ASSERT_EQ(site.ask("two", RequestKind::takeOver), RequestAnswer::waits);
    const std::uint64_t given = site.lastRequest();
    EXPECT_EQ(site.ask("two", RequestKind::decline, "never mind"), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.answerTo("two", given), RequestAnswer::expired);
    EXPECT_FALSE(site.arbiter.declinedFor("two", given));
}

TEST(ControlArbiter, aSecondProgramOfANameIsKnown) {
    Site site;
    const std::int64_t asked_ns = site.now_ns;
    EXPECT_EQ(site.arbiter.request("one", boot(9), 7, RequestKind::request, {}, site.now_ns),
              RequestAnswer::noSuchConsole);
    EXPECT_FALSE(site.arbiter.isNameTaken("one", boot(9), asked_ns)) << "the first one may have been killed";
    site.now_ns += 100 * kMs;
    site.arbiter.presence("one", {boot(1), false, false}, site.now_ns);
    EXPECT_TRUE(site.arbiter.isNameTaken("one", boot(9), asked_ns));
    EXPECT_FALSE(site.arbiter.isNameTaken("one", boot(1), asked_ns));
    EXPECT_FALSE(site.arbiter.isNameTaken("nobody", boot(9), asked_ns));
}

TEST(ControlArbiter, anOfferThatIsDeclinedOrForgottenChangesNothingButThePress) {
    Site site;
    site.ask("one", RequestKind::request);
    site.command("one", 1);
    site.ask("one", RequestKind::offer, "two");
    EXPECT_EQ(site.ask("two", RequestKind::decline), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.controller(), "one");
    EXPECT_EQ(site.arbiter.epoch(), 1U);
    EXPECT_EQ(site.command("one", 1), CommandRefusal::pressAnew);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::none);
    EXPECT_EQ(site.ask("one", RequestKind::offer, "two"), RequestAnswer::waits);
    for (int i = 0; i < 11; ++i) {
        site.pass(kSecond);
        site.seeAll();
    }
    EXPECT_EQ(site.mode(), Mode::held);
    EXPECT_EQ(site.arbiter.controller(), "one");
    EXPECT_EQ(site.arbiter.answerTo("one", site.lastRequest()), RequestAnswer::expired);
    EXPECT_EQ(site.ask("two", RequestKind::accept), RequestAnswer::expired);
}

TEST(ControlArbiter, onlyASupervisorTakesOverAndSilenceAgrees) {
    Site site;
    site.ask("two", RequestKind::request);
    EXPECT_EQ(site.ask("one", RequestKind::takeOver), RequestAnswer::notPermitted);
    site.ask("two", RequestKind::release);
    site.ask("one", RequestKind::request);
    EXPECT_EQ(site.ask("two", RequestKind::takeOver), RequestAnswer::waits);
    EXPECT_EQ(site.ask("one", RequestKind::decline), RequestAnswer::done);
    EXPECT_EQ(site.arbiter.answerTo("two", site.lastRequest() - 1), RequestAnswer::expired);
    EXPECT_EQ(site.arbiter.controller(), "one");
    EXPECT_EQ(site.ask("two", RequestKind::takeOver), RequestAnswer::waits);
    for (int i = 0; i < 6; ++i) {
        site.pass(kSecond);
        site.seeAll();
    }
    EXPECT_EQ(site.arbiter.controller(), "two");
    EXPECT_EQ(site.arbiter.answerTo("two", site.lastRequest()), RequestAnswer::done);
}

TEST(ControlArbiter, aControllerThatVanishesFreesControlAfterTwoSeconds) {
    Site site;
    site.ask("one", RequestKind::request);
    site.pass(1900 * kMs);
    EXPECT_EQ(site.mode(), Mode::held);
    site.pass(200 * kMs);
    EXPECT_EQ(site.mode(), Mode::free);
    site.arbiter.presence("two", {boot(2), false, false}, site.now_ns);
    site.pass(LeaseTimes().known_ns);
    EXPECT_EQ(site.ask("two", RequestKind::request), RequestAnswer::done);
}

TEST(ControlArbiter, stopIsALevelThatEveryHolderWithdraws) {
    Site site;
    site.ask("one", RequestKind::request);
    site.command("one", 1);
    site.arbiter.presence("eyes", {boot(3), true, true}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::stopped);
    EXPECT_EQ(site.ask("two", RequestKind::request), RequestAnswer::stopped);
    site.arbiter.setSiteStop(true);
    site.arbiter.presence("eyes", {boot(3), true, false}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    EXPECT_EQ(site.arbiter.stopHolders(), std::set<std::string>{"site"});
    site.arbiter.setSiteStop(false);
    // Control stays; what was pressed before or while STOP was engaged moves nothing.
    EXPECT_EQ(site.mode(), Mode::held);
    EXPECT_EQ(site.arbiter.controller(), "one");
    EXPECT_EQ(site.command("one", 2), CommandRefusal::pressAnew);
    EXPECT_EQ(site.command("one", 3), CommandRefusal::none);
}

TEST(ControlArbiter, stopOfAConsoleThatVanishedStaysUntilASupervisorWithdrawsIt) {
    Site site;
    site.arbiter.presence("one", {boot(1), false, true}, site.now_ns);
    EXPECT_EQ(site.ask("two", RequestKind::withdrawStop, "one"), RequestAnswer::notPermitted); // still there
    site.pass(3 * kSecond);
    site.arbiter.presence("two", {boot(2), false, false}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    // Started anew, it knows nothing of the STOP.
    site.arbiter.presence("one", {boot(7), false, false}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    site.pass(3 * kSecond);
    site.arbiter.presence("two", {boot(2), false, false}, site.now_ns);
    EXPECT_EQ(site.ask("two", RequestKind::withdrawStop, "one"), RequestAnswer::done);
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, somebodyAtTheSiteWithdrawsTheStopsOfThoseWhoVanishedAndNoOther) {
    Site site;
    site.arbiter.presence("one", {boot(1), false, true}, site.now_ns);
    site.pass(3 * kSecond);
    site.arbiter.presence("two", {boot(2), false, true}, site.now_ns);
    site.arbiter.withdrawStopsOfGone(site.now_ns);
    EXPECT_EQ(site.arbiter.stopHolders(), (std::set<std::string>{"two"}));
    site.arbiter.setSiteStop(true);
    site.arbiter.presence("two", {boot(2), false, false}, site.now_ns);
    site.arbiter.withdrawStopsOfGone(site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped) << "that of the site is withdrawn by itself";
    site.arbiter.setSiteStop(false);
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, theStopOfAProgramThatWasStartedAnewIsThatOfOneThatVanished) {
    Site site;
    site.arbiter.presence("one", {boot(1), false, true}, site.now_ns);
    site.pass(3 * kSecond);
    site.arbiter.presence("one", {boot(7), false, false}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    site.arbiter.withdrawStopsOfGone(site.now_ns);
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, stopsOfTheSitesProgramBeforeHoldUntilTheirOwnersWithdrawThem) {
    Site site;
    site.arbiter.setSiteStop(true);
    site.arbiter.presence("eyes", {boot(3), true, true}, site.now_ns);
    site.arbiter.presence("one", {boot(1), false, true}, site.now_ns);
    const StopHolders kept = site.arbiter.stops();

    ControlArbiter anew({"two"}, {}, kept);
    EXPECT_EQ(anew.mode(0), Mode::stopped);
    EXPECT_EQ(anew.stopHolders(), (std::set<std::string>{"eyes", "one", ControlArbiter::kSiteHolder}));
    EXPECT_EQ(anew.stops(), kept);
    // The program of one is still there and has withdrawn its STOP meanwhile; another one of its name could
    // not.
    EXPECT_TRUE(anew.presence("one", {boot(9), false, false}, kMs));
    EXPECT_TRUE(anew.stopHolders().contains("one"));
    EXPECT_FALSE(anew.presence("one", {boot(1), false, false}, 2 * kMs)) << "the other one is there";
    EXPECT_FALSE(anew.stopHolders().contains("one"));
    anew.setSiteStop(false);
    EXPECT_EQ(anew.mode(2 * kMs), Mode::stopped);
    // A supervisor withdraws that of one who is gone.
    EXPECT_TRUE(anew.presence("two", {boot(2), false, false}, 3 * kMs));
    EXPECT_EQ(anew.request("two", boot(2), 1, RequestKind::request, {}, 400 * kMs), RequestAnswer::stopped);
    EXPECT_EQ(anew.request("two", boot(2), 2, RequestKind::withdrawStop, "eyes", 400 * kMs),
              RequestAnswer::done);
    EXPECT_EQ(anew.mode(400 * kMs), Mode::free);
    EXPECT_EQ(anew.stops(), StopHolders());
}

TEST(ControlArbiter, aNameThatStopsAsManyProgramsNeedsNoMoreMemory) {
    Site site;
    for (int i = 0; i < 255; ++i) {
        const auto number = static_cast<std::uint8_t>(i);
        site.arbiter.presence("two", {boot(number), false, true}, site.now_ns);
        site.arbiter.presence("eyes", {boot(number), true, true}, site.now_ns);
    }
    EXPECT_EQ(site.arbiter.stops().consoles.size(), 2 * ControlArbiter::kMostStopsOfName);
    for (std::size_t i = 0; i < 2 * ControlArbiter::kMostStopsOfName; ++i) {
        EXPECT_EQ(site.mode(), Mode::stopped);
        const auto [console, program] = *site.arbiter.stops().consoles.begin();
        site.arbiter.presence(console, {program, false, false}, site.now_ns);
    }
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, aSecondProgramOfTheSameNameIsRefusedWhileTheFirstIsAlive) {
    Site site;
    site.ask("one", RequestKind::request);
    EXPECT_FALSE(site.arbiter.presence("one", {boot(8), false, false}, site.now_ns));
    EXPECT_EQ(site.arbiter.controller(), "one");
    // Its STOP counts all the same.
    EXPECT_FALSE(site.arbiter.presence("one", {boot(8), false, true}, site.now_ns));
    EXPECT_EQ(site.mode(), Mode::stopped);
    site.arbiter.presence("one", {boot(1), false, false}, site.now_ns);
    EXPECT_EQ(site.mode(), Mode::stopped);
    EXPECT_FALSE(site.arbiter.presence("one", {boot(8), false, false}, site.now_ns));
    EXPECT_EQ(site.mode(), Mode::held);
    // Once the first is gone, all that was known of it is dropped.
    site.pass(1100 * kMs);
    EXPECT_TRUE(site.arbiter.presence("one", {boot(8), false, false}, site.now_ns));
    EXPECT_EQ(site.mode(), Mode::free);
}

TEST(ControlArbiter, aFaultEndsWhenItsCauseIsGoneAndTheControllerClearsIt) {
    Site site;
    site.ask("one", RequestKind::request);
    site.command("one", 1);
    site.arbiter.setFaultCause(true);
    EXPECT_EQ(site.mode(), Mode::fault);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::notLive);
    EXPECT_EQ(site.ask("one", RequestKind::clearFault), RequestAnswer::busy);
    site.arbiter.setFaultCause(false);
    EXPECT_EQ(site.mode(), Mode::fault);
    EXPECT_EQ(site.ask("two", RequestKind::clearFault), RequestAnswer::notController);
    EXPECT_EQ(site.ask("one", RequestKind::clearFault), RequestAnswer::done);
    EXPECT_EQ(site.command("one", 2), CommandRefusal::pressAnew);
    EXPECT_EQ(site.command("one", 3), CommandRefusal::none);
}

namespace {

/// A site and what both consoles have done so far, as far as it matters.
struct Story {
    Site site;
    std::array<std::uint32_t, 2> presses{}; ///< newest press of each console
    std::array<bool, 2> pressFresh{};       ///< it was made after the last event that asks for a new one
    std::array<bool, 2> stops{};

    [[nodiscard]] std::string key() const {
        std::ostringstream text;
        const ControlArbiter& a = site.arbiter;
        text << a.controller() << ' ' << a.epoch() << ' ' << a.offeredTo() << ' '
             << static_cast<int>(site.mode()) << ' ' << a.controlLeft_ns(site.now_ns) << ' '
             << a.offerLeft_ns(site.now_ns);
        for (int i = 0; i < 2; ++i)
            text << ' ' << presses[i] << pressFresh[i] << stops[i];
        // What the arbiter keeps to itself shows in what it would do with the next commands.
        for (const char* console : {"one", "two"}) {
            for (const bool anew : {false, true}) {
                Story copy = *this;
                text << ' '
                     << static_cast<int>(
                            copy.site.command(console, presses[console == std::string("two")] + anew));
            }
        }
        return text.str();
    }
};

} // namespace

TEST(ControlArbiter, noOrderOfEightStepsOfTwoConsolesMovesWithoutRightAndPress) {
    const std::array<std::string, 2> names{"one", "two"};
    constexpr int kActions = 10;
    std::map<std::string, Story> level;
    level.emplace("start", Story{});
    std::size_t looked = 0;
    for (int step = 0; step < 8; ++step) {
        std::map<std::string, Story> next;
        for (const auto& [key, story] : level) {
            for (int action = 0; action < 2 * kActions + 2; ++action) {
                Story s = story;
                const std::size_t who = static_cast<std::size_t>(action / kActions) % 2;
                const std::string& me = names[who];
                const std::string before = s.site.arbiter.controller();
                const std::uint64_t epoch = s.site.arbiter.epoch();
                const bool wasStopped = s.site.mode() == Mode::stopped;
                const bool wasOffered = !s.site.arbiter.offeredTo().empty();
                bool commanded = false;
                CommandRefusal refusal = CommandRefusal::none;
                bool holds = false;
                if (action == 2 * kActions) {
                    s.site.pass(150 * kMs);
                } else if (action == 2 * kActions + 1) {
                    s.site.pass(700 * kMs);
                    s.pressFresh = {};
                } else {
                    switch (action % kActions) {
                    case 0:
                        s.site.ask(me, RequestKind::request);
                        break;
                    case 1:
                        s.site.ask(me, RequestKind::release);
                        break;
                    case 2:
                        s.site.ask(me, RequestKind::offer, names[1 - who]);
                        break;
                    case 3:
                        s.site.ask(me, RequestKind::accept);
                        break;
                    case 4:
                        s.site.ask(me, RequestKind::decline);
                        break;
                    case 5:
                        s.site.ask(me, RequestKind::takeOver);
                        break;
                    case 6: // presses anew
                        ++s.presses[who];
                        s.pressFresh[who] = true;
                        [[fallthrough]];
                    case 7: // commands on
                        commanded = true;
                        refusal = s.site.command(me, s.presses[who]);
                        break;
                    case 8: {
                        CommandHead hold = s.site.head(me, s.presses[who]);
                        hold.hold = true;
                        holds = s.site.arbiter.command(me, hold, s.site.now_ns) == CommandRefusal::none;
                        break;
                    }
                    case 9:
                        s.stops[who] = !s.stops[who];
                        s.site.arbiter.presence(
                            me, {boot(static_cast<std::uint8_t>(who + 1)), false, s.stops[who]},
                            s.site.now_ns);
                        break;
                    default:
                        break;
                    }
                }
                ++looked;
                const bool stopped = s.site.mode() == Mode::stopped;
                const bool offered = !s.site.arbiter.offeredTo().empty();
                const std::string& now = s.site.arbiter.controller();
                const bool accepted = commanded && refusal == CommandRefusal::none;
                // Truth, kept apart from the arbiter: who may command, and whether the press is fresh.
                if (accepted) {
                    ASSERT_EQ(before, me);
                    ASSERT_FALSE(wasStopped);
                    ASSERT_FALSE(wasOffered);
                    ASSERT_TRUE(s.pressFresh[who]) << key << " action " << action;
                }
                if (s.site.arbiter.mayMove(s.site.now_ns)) {
                    ASSERT_FALSE(stopped || offered || now.empty());
                }
                if (now != before && !now.empty()) {
                    ASSERT_EQ(s.site.arbiter.epoch(), epoch + 1);
                }
                if (commanded && !accepted)
                    s.pressFresh[who] = s.pressFresh[who] && before == me && !wasStopped && !wasOffered &&
                                        refusal != CommandRefusal::pressAnew;
                if (now != before || stopped != wasStopped || offered != wasOffered || holds)
                    s.pressFresh = {};
                next.emplace(s.key(), std::move(s));
            }
        }
        level = std::move(next);
        ASSERT_LT(level.size(), 200'000U);
    }
    EXPECT_GT(looked, 10'000U);
}
