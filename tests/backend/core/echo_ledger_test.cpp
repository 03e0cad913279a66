// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/echo_ledger.h"

#include <gtest/gtest.h>

using teleta::core::EchoLedger;

TEST(EchoLedger, countsEchoesInOrderAsNoLoss) {
    EchoLedger ledger;
    for (int i = 1; i <= 200'000; ++i) {
        const std::uint16_t sequence = ledger.send();
        ASSERT_EQ(sequence, static_cast<std::uint16_t>(i)) << "wraps";
        ledger.echo(sequence);
    }
    EXPECT_EQ(ledger.sent(), 200'000U);
    EXPECT_EQ(ledger.echoed(), 200'000U);
    EXPECT_EQ(ledger.lost(), 0U);
    EXPECT_EQ(ledger.stray(), 0U);
    EXPECT_EQ(ledger.inFlight(), 0U);
}

TEST(EchoLedger, countsAGapWhenTheLaterEchoComes) {
    EchoLedger ledger;
    for (int i = 0; i < 10; ++i)
        (void)ledger.send();
    ledger.echo(1);
    EXPECT_EQ(ledger.lost(), 0U) << "the rest may be under way";
    EXPECT_EQ(ledger.inFlight(), 9U);
    ledger.echo(5);
    EXPECT_EQ(ledger.lost(), 3U);
    EXPECT_EQ(ledger.echoed(), 2U);
    EXPECT_EQ(ledger.inFlight(), 5U);
}

TEST(EchoLedger, countsAGapAcrossTheWrap) {
    EchoLedger ledger;
    for (int i = 1; i <= 0xFFFE; ++i)
        ledger.echo(ledger.send());
    for (int i = 0; i < 4; ++i)
        (void)ledger.send(); // FFFF, 0, 1, 2
    ledger.echo(1);
    EXPECT_EQ(ledger.lost(), 2U);
    EXPECT_EQ(ledger.inFlight(), 1U);
}

TEST(EchoLedger, takesNoEchoThatNothingWaitsFor) {
    EchoLedger ledger;
    ledger.echo(0);
    ledger.echo(77);
    EXPECT_EQ(ledger.stray(), 2U);
    const std::uint16_t first = ledger.send();
    const std::uint16_t second = ledger.send();
    ledger.echo(second);
    ledger.echo(second);
    ledger.echo(first);
    ledger.echo(3);
    EXPECT_EQ(ledger.stray(), 5U) << "a second one, an old one, one from the future";
    EXPECT_EQ(ledger.echoed(), 1U);
    EXPECT_EQ(ledger.lost(), 1U);
}

TEST(EchoLedger, countsWhatIsInFlightAtALossOfTheConnection) {
    EchoLedger ledger;
    for (int i = 0; i < 5; ++i)
        (void)ledger.send();
    ledger.echo(2);
    ledger.endConnection();
    EXPECT_EQ(ledger.lost(), 4U);
    EXPECT_EQ(ledger.inFlight(), 0U);
    ledger.echo(4);
    EXPECT_EQ(ledger.stray(), 1U);
    ledger.echo(ledger.send());
    EXPECT_EQ(ledger.lost(), 4U);
}

TEST(EchoLedger, countsWhatTheBoardRefusesAsLostAndNotAsEchoed) {
    EchoLedger ledger;
    for (int i = 0; i < 4; ++i)
        (void)ledger.send();
    ledger.echo(1);
    ledger.refuse(3);
    EXPECT_EQ(ledger.lost(), 2U) << "the one before it, too";
    EXPECT_EQ(ledger.refused(), 1U);
    EXPECT_EQ(ledger.echoed(), 1U);
    EXPECT_EQ(ledger.newestEchoed(), 1U);
    EXPECT_EQ(ledger.inFlight(), 1U);
    ledger.refuse(3);
    EXPECT_EQ(ledger.stray(), 1U) << "a second answer";
    EXPECT_EQ(ledger.refused(), 1U);
    ledger.echo(4);
    EXPECT_EQ(ledger.newestEchoed(), 4U);
    EXPECT_EQ(ledger.lost(), 2U);
}

TEST(EchoLedger, countsTheFramesOfABoardThatNeverAnswers) {
    EchoLedger ledger;
    for (std::uint64_t i = 0; i < 100'000; ++i)
        (void)ledger.send();
    EXPECT_EQ(ledger.lost(), 100'000U - EchoLedger::kLongestFlight);
    EXPECT_EQ(ledger.inFlight(), EchoLedger::kLongestFlight);
}

TEST(EchoLedger, tellsTheNewestFrameThatWasEchoedAcrossTheWrapAndTheEndOfAConnection) {
    EchoLedger ledger;
    EXPECT_EQ(ledger.newestEchoed(), 0U);
    for (int i = 1; i <= 70'000; ++i)
        (void)ledger.send();
    ledger.echo(static_cast<std::uint16_t>(69'990));
    EXPECT_EQ(ledger.newestEchoed(), 69'990U);
    ledger.echo(static_cast<std::uint16_t>(69'980));
    EXPECT_EQ(ledger.newestEchoed(), 69'990U) << "a stray one";
    ledger.endConnection();
    EXPECT_EQ(ledger.newestEchoed(), 69'990U) << "what was given up was not echoed";
}
