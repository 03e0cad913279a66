// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/process_times.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <thread>

namespace console = teleta::console;

/// What --measure says of the start.
class ProcessTimesTest : public QObject {
    Q_OBJECT

private slots:
    void theAgeGoesWithTheClock() {
        constexpr double kStep_s = 0.01; // of the kernel's count
        QElapsedTimer clock;
        clock.start();
        const double before_s = console::processAge_s();
        QVERIFY(before_s >= -kStep_s);
        QTest::qSleep(100);
        const double aged_s = console::processAge_s() - before_s;
        const double passed_s = 1e-9 * static_cast<double>(clock.nsecsElapsed());
        QVERIFY(aged_s >= 0.1);
        QVERIFY(aged_s <= passed_s);
    }

    /// Since a process began no more has been computed than all processors can do.
    void theAgeBeginsWithTheProcess() {
        const double processors = std::max(1U, std::thread::hardware_concurrency());
        QVERIFY(console::processorTime_s() <= processors * (console::processAge_s() + 0.01));
    }

    void theProcessorTimeGrowsWithWorkOnly() {
        const double before_s = console::processorTime_s();
        QTest::qSleep(100);
        QVERIFY(console::processorTime_s() - before_s < 0.05);
        double work = 0.0;
        while (console::processorTime_s() - before_s < 0.1)
            work += std::sqrt(work + 1.0);
        QVERIFY(work > 0.0);
    }
};

QTEST_GUILESS_MAIN(ProcessTimesTest)
#include "process_times_test.moc"
