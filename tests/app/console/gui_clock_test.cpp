// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/gui_clock.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

using teleta::console::GuiClock;

/// The clock that drives the window and measures itself.
class GuiClockTest : public QObject {
    Q_OBJECT

private slots:
    void reportsNothingBeforeItRuns() {
        const GuiClock clock;
        QCOMPARE(clock.report().ticks, std::uint64_t(0));
        QCOMPARE(clock.report().work_max_s, 0.0);
    }

    void measuresTheWorkThatItsTicksDo() {
        constexpr int kBusy_ms = 20;
        GuiClock clock;
        connect(&clock, &GuiClock::tick, &clock, [] {
            QElapsedTimer busy;
            busy.start();
            while (busy.elapsed() < kBusy_ms) {
            }
        });
        QSignalSpy ticks(&clock, &GuiClock::tick);
        clock.start();
        QTRY_VERIFY(ticks.size() >= 3);
        clock.stop();
        QCOMPARE(clock.report().ticks, static_cast<std::uint64_t>(ticks.size()));
        QVERIFY(clock.report().work_p50_s >= kBusy_ms * 1e-3);
        QVERIFY(clock.report().work_max_s >= clock.report().work_p50_s);
    }

    void seesAStallOfTheEventLoopBetweenTwoTicks() {
        constexpr int kStall_ms = 150;
        GuiClock clock;
        QSignalSpy ticks(&clock, &GuiClock::tick);
        clock.start();
        QTRY_VERIFY(!ticks.isEmpty());
        QElapsedTimer busy;
        busy.start();
        while (busy.elapsed() < kStall_ms) {
        }
        const qsizetype before = ticks.size();
        QTRY_VERIFY(ticks.size() > before);
        QVERIFY(clock.report().stall_max_s >= (kStall_ms - GuiClock::kPeriod_ms) * 1e-3);
        clock.resetReport();
        QCOMPARE(clock.report().ticks, std::uint64_t(0));
    }
};

QTEST_GUILESS_MAIN(GuiClockTest)
#include "gui_clock_test.moc"
