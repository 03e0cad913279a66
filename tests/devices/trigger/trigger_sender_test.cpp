// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/study/session/trigger_sender.h"
#include "devices/trigger/serial_trigger.h"
#include "tests/support/pseudo_terminal.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace teleta::study {

namespace {

using Kind = core::TriggerEvent::Kind;
using Bytes = std::vector<std::uint8_t>;

core::TriggerEvent event(Kind kind, std::size_t index = 0) {
    core::TriggerEvent made;
    made.kind = kind;
    made.index = index;
    made.time_ns = core::steadyNow_ns();
    return made;
}

/// Waits at most 20 s.
template <typename Condition>
bool comes(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::yield();
    }
    return true;
}

TriggerSender::Opener serial(const std::string& name, double pulse_ms) {
    return [name, pulse_ms] { return trigger::SerialTrigger::open(name, pulse_ms); };
}

} // namespace

TEST(TriggerSender, writesEventsInTheirOrderAndAZeroBehindThem) {
    const test::PseudoTerminal line;
    TriggerSender sender(serial(line.name(), 1.0));
    sender.post(event(Kind::session));
    EXPECT_EQ(line.read(2), (Bytes{1, 0}));
    sender.post(event(Kind::answer, 2));
    EXPECT_EQ(line.read(2), (Bytes{202, 0}));
    EXPECT_TRUE(comes([&] { return sender.status().written == 2; }));
    EXPECT_EQ(sender.status().state, TriggerStatus::State::open);
    EXPECT_EQ(sender.status().failures, 0U);
}

TEST(TriggerSender, writesTheNextEventEvenWithinAPulse) {
    const test::PseudoTerminal line;
    TriggerSender sender(serial(line.name(), 500.0));
    sender.post(event(Kind::session));
    sender.post(event(Kind::pause));
    EXPECT_EQ(line.read(3), (Bytes{1, 3, 0}));
}

TEST(TriggerSender, writesWhatWasPostedBeforeItsEnd) {
    const test::PseudoTerminal line;
    {
        TriggerSender sender(serial(line.name(), 0.0));
        for (std::size_t i = 1; i <= 9; ++i)
            sender.post(event(Kind::answer, i));
    }
    EXPECT_EQ(line.read(9), (Bytes{201, 202, 203, 204, 205, 206, 207, 208, 209}));
}

TEST(TriggerSender, writesAStimulusAtItsConfirmedOnset) {
    const test::PseudoTerminal line;
    TriggerSender sender(serial(line.name(), 0.0));
    std::atomic<std::int64_t> onset_ns{0};
    std::atomic<int> looks{0};
    sender.await(event(Kind::stimulus, 3), [&] {
        ++looks;
        return onset_ns.load();
    });
    EXPECT_TRUE(comes([&] { return looks > 3; }));
    EXPECT_EQ(sender.status().written, 0U) << "nothing has begun";
    EXPECT_FALSE(sender.onsetToWritten_ms());
    onset_ns = core::steadyNow_ns() - 2'000'000;
    EXPECT_EQ(line.read(1), Bytes{103});
    ASSERT_TRUE(comes([&] { return sender.onsetToWritten_ms().has_value(); }));
    EXPECT_GE(*sender.onsetToWritten_ms(), 2.0);
    // Once only.
    sender.post(event(Kind::noAnswer));
    EXPECT_EQ(line.read(1), Bytes{200});
}

TEST(TriggerSender, forgetsAStimulusThatDidNotBegin) {
    const test::PseudoTerminal line;
    TriggerSender sender(serial(line.name(), 0.0));
    std::atomic<std::int64_t> onset_ns{0};
    sender.await(event(Kind::stimulus, 3), [&] { return onset_ns.load(); });
    sender.forget();
    onset_ns = core::steadyNow_ns();
    sender.post(event(Kind::fault));
    EXPECT_EQ(line.read(1), Bytes{5});
    EXPECT_FALSE(sender.onsetToWritten_ms());
    // One that has begun is not lost by being forgotten.
    sender.await(event(Kind::stimulus, 4), [&] { return onset_ns.load(); });
    sender.forget();
    EXPECT_EQ(line.read(1), Bytes{104});
}

TEST(TriggerSender, countsWhatAMissingDeviceDidNotGetAndComesBack) {
    const test::PseudoTerminal line;
    std::atomic<bool> isThere{false};
    TriggerSender sender([&]() -> core::Expected<std::unique_ptr<core::TriggerPort>> {
        if (!isThere)
            return core::failed(core::ErrorKind::notFound, QStringLiteral("unplugged"));
        return trigger::SerialTrigger::open(line.name(), 0.0);
    });
    ASSERT_TRUE(comes([&] { return sender.status().state == TriggerStatus::State::failed; }));
    sender.post(event(Kind::session));
    ASSERT_TRUE(comes([&] { return sender.status().failures == 1; }));
    EXPECT_EQ(sender.status().error->message, "unplugged");
    isThere = true;
    ASSERT_TRUE(comes([&] { return sender.status().state == TriggerStatus::State::open; }));
    sender.post(event(Kind::pause));
    EXPECT_EQ(line.read(1), Bytes{3}) << "and not the event that came too early";
}

TEST(TriggerSender, outlivesADeviceThatGoesAway) {
    test::PseudoTerminal line;
    TriggerSender sender(serial(line.name(), 0.0));
    sender.post(event(Kind::session));
    EXPECT_EQ(line.read(1), Bytes{1});
    line.hangUp();
    sender.post(event(Kind::pause));
    ASSERT_TRUE(comes([&] { return sender.status().failures > 0; }));
    EXPECT_EQ(sender.status().state, TriggerStatus::State::failed);
    ASSERT_TRUE(sender.status().error.has_value());
}

} // namespace teleta::study
