// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/study/participant/event_clock.h"

#include <QTest>

using teleta::study::EventClock;

namespace {

constexpr std::int64_t kMs = 1'000'000;

} // namespace

/// The system's clock is 700 ms behind the steady one in all of it.
class EventClockTest : public QObject {
    Q_OBJECT

    EventClock m_clock;
    /// An event of this time, handled so much later. What the clock says of it, in ms.
    double timed(std::int64_t at_ms, std::int64_t later_ms = 0) {
        return static_cast<double>(
                   m_clock.time_ns(static_cast<std::uint64_t>(at_ms - 700), (at_ms + later_ms) * kMs)) /
               kMs;
    }
    void learn(std::int64_t from_ms) {
        for (int i = 0; i < 3; ++i)
            timed(from_ms + i);
    }

private slots:
    void init() { m_clock = {}; }

    void anEventThatWaitedIsOfTheTimeAtWhichItCame() {
        learn(1000);
        QCOMPARE(timed(9980, 70), 9980.0);
        QCOMPARE(timed(10'001), 10'001.0);
    }

    void nothingIsLaterThanItsHandlingAndTheFirstEventsAreOfTheirHandling() {
        QCOMPARE(timed(1000, 50), 1050.0);
        QCOMPARE(timed(1100, 50), 1150.0);
        learn(1200);
        QCOMPARE(timed(1300, 50), 1300.0);
    }

    void anEventWithoutATimestampIsOfTheTimeOfItsHandling() {
        learn(1000);
        QCOMPARE(m_clock.time_ns(0, 2000 * kMs), 2000 * kMs);
        QCOMPARE(timed(2100, 30), 2100.0);
    }

    void timestampsOfAnotherClockSayNothing() {
        learn(10'000);
        // Hours away in both directions, and at the ends of what a timestamp can be.
        for (const std::uint64_t other :
             {std::uint64_t{1}, std::uint64_t{90'000'000}, ~std::uint64_t{0}, ~std::uint64_t{0} / 2})
            QCOMPARE(EventClock(m_clock).time_ns(other, 20'000 * kMs), 20'000 * kMs);
        // Timestamps that count events instead of time never agree.
        EventClock counted;
        for (int i = 1; i < 50; ++i)
            QCOMPARE(counted.time_ns(static_cast<std::uint64_t>(500 * i), i * 700 * kMs), i * 700 * kMs);
    }

    void aClockThatDriftsIsFollowed() {
        // 1 ms slower each second: after ten minutes 600 ms, of which it knows the last two minutes.
        learn(1000);
        double worst_ms = 0.0;
        for (std::int64_t s = 2; s < 600; ++s) {
            const std::int64_t now_ns = s * 1000 * kMs;
            const std::int64_t time_ns = m_clock.time_ns(static_cast<std::uint64_t>(s * 999 - 700), now_ns);
            worst_ms = std::max(worst_ms, static_cast<double>(now_ns - time_ns) / kMs);
        }
        QVERIFY2(worst_ms <= 120.0, qPrintable(QString::number(worst_ms)));
    }
};

static const teleta::test::Registration<EventClockTest> registration;
#include "event_clock_test.moc"
