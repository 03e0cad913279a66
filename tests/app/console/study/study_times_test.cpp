// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/runner_bench.h"

#include <QTest>

using namespace teleta;
using namespace teleta::test;

/// When a press counts, and what a limit, an early press and a short stimulus make of it.
class StudyTimesTest : public QObject, protected StudyRunnerBench {
    Q_OBJECT

private slots:
    void cleanup() { tearDown(); }

    void countsAnswersUntilTheLimitItself_data() {
        QTest::addColumn<qint64>("after_ns");
        QTest::addColumn<bool>("counts");
        QTest::newRow("9.999 s") << qint64(9999 * kMs) << true;
        QTest::newRow("10 s") << qint64(10 * kS) << true;
        QTest::newRow("10 s and 1 ns") << qint64(10 * kS + 1) << false;
        QTest::newRow("10.001 s") << qint64(10001 * kMs) << false;
    }
    void countsAnswersUntilTheLimitItself() {
        QFETCH(qint64, after_ns);
        QFETCH(bool, counts);
        make();
        startTrial();
        const std::int64_t onset = m_now;
        endStimulus();
        m_now = onset + after_ns;
        digit(1);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].outcome == Outcome::timeout, !counts);
        QCOMPARE(m_kept[0].responseTime_s.has_value(), counts);
    }

    void letsTheLimitPassWithoutAPress() {
        make();
        startTrial();
        endStimulus();
        pass(8 * kS);
        m_runner->poll();
        QVERIFY2(m_kept.empty(), "the limit itself still counts");
        pass(1);
        QTRY_COMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].outcome, Outcome::timeout);
    }

    void aPressThatWaitedWhileTheProgramWasBusyCountsFromWhenItWasMade() {
        make();
        // The system's clock, which the window learns from what is handled at once.
        const auto send = [this](QEvent::Type type, int key, std::int64_t at_ns) {
            QKeyEvent event(type, key, Qt::NoModifier);
            event.setTimestamp(static_cast<quint64>((at_ns - 7 * kS) / kMs));
            QApplication::sendEvent(m_window.get(), &event);
        };
        for (int i = 0; i < 3; ++i) {
            pass(50 * kMs);
            send(QEvent::KeyRelease, Qt::Key_2, m_now);
        }
        startTrial();
        const std::int64_t onset = m_now;
        endStimulus();
        // What stands still is the event loop: it looks at the time first and then finds the press.
        m_now = onset + 10'050 * kMs;
        m_runner->poll();
        send(QEvent::KeyPress, Qt::Key_1, onset + 9980 * kMs);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QVERIFY(m_kept[0].outcome != Outcome::timeout);
        QCOMPARE(m_kept[0].responseTime_s, std::optional(9.98));
        send(QEvent::KeyRelease, Qt::Key_1, m_now);

        startTrial();
        const std::int64_t next = m_now;
        endStimulus();
        m_now = next + 10'050 * kMs;
        m_runner->poll();
        send(QEvent::KeyPress, Qt::Key_1, next + 10'001 * kMs);
        QCOMPARE(m_kept.size(), std::size_t(2));
        QCOMPARE(m_kept[1].outcome, Outcome::timeout);
        QCOMPARE(m_kept[1].earlyPresses, std::size_t(0));
    }

    void aPressFromBeforeTheOnsetThatIsHandledAfterItIsEarly() {
        make();
        startTrial();
        study::KeyPress press{0, "keyboard", "Digit1", m_now - kMs, false};
        m_runner->press(press);
        QCOMPARE(stage(), Stage::stimulus);
        m_runner->release(press.device, press.key);
        press.time_ns = m_now + 300 * kMs;
        m_runner->press(press);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].earlyPresses, std::size_t(1));
        QCOMPARE(m_kept[0].responseTime_s, std::optional(0.3));
    }

    void anEarlyPressDoesNotHoldTheTestThatTheExperimenterHasBegun() {
        make();
        finishPractice();
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::none);
        startTrial();
        endStimulus();
        digit(2);
        QCOMPARE(m_kept.size(), std::size_t(3));
        QCOMPARE(m_kept[2].planned.phase, Phase::test);
        QCOMPARE(m_kept[2].earlyPresses, std::size_t(1));
    }

    void theTestBeginsOnceAlthoughTheLastPracticeTrialIsStillBeingKept() {
        make();
        doTrial();
        m_slowDisk = true;
        doTrial();
        space();
        QCOMPARE(m_runner->hold(), Hold::blockEnd);
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        m_waiting.back()({});
        QCOMPARE(m_runner->hold(), Hold::none);
        m_slowDisk = false;
        startTrial();
        // Another session asks again.
        const std::vector<study::TrialResult> kept = m_kept;
        begin(kept);
        QCOMPARE(m_runner->hold(), Hold::blockEnd);
    }

    void restsWhereTheProtocolSaysSoUntilTheParticipantGoesOn() {
        make("[pause]\nevery_trials = 2\nat_least_s = 30.0\n");
        doTrial();
        doTrial();
        space();
        QCOMPARE(m_runner->hold(), Hold::blockEnd); // no rest where the test begins anyway
        m_runner->goOn();
        doTrial();
        QCOMPARE(m_runner->hold(), Hold::none);
        doTrial();
        QCOMPARE(m_runner->hold(), Hold::rest);
        QVERIFY(!m_runner->flow()->waitsForExperimenter());
        QCOMPARE(m_runner->restLeft_s(), 30.0);
        pass(30 * kS - 1);
        space();
        QCOMPARE(m_runner->hold(), Hold::rest);
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::rest);
        pass(1);
        QCOMPARE(m_runner->restLeft_s(), 0.0);
        startTrial();
        QCOMPARE(m_runner->hold(), Hold::none);
        endStimulus();
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::none);
        doTrial();
        QCOMPARE(stage(), Stage::finished);
        QCOMPARE(m_runner->hold(), Hold::none); // none after the last trial
    }

    void aRestIsEndedByTheExperimenterHeldByStopAndNotRepeatedAfterAnInterruption() {
        make("[pause]\nevery_trials = 2\nat_least_s = 30.0\n");
        finishPractice();
        doTrial();
        doTrial();
        QCOMPARE(m_runner->hold(), Hold::rest);
        const std::vector<study::TrialResult> kept = m_kept;
        m_stop.engage();
        m_runner->poll();
        QCOMPARE(m_runner->hold(), Hold::stopped);
        m_stop.release();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        begin(kept);
        QCOMPARE(m_runner->hold(), Hold::none);
        startTrial();
        m_runner->abort();

        make("[pause]\nevery_trials = 2\nat_least_s = 30.0\n");
        finishPractice();
        doTrial();
        doTrial();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        startTrial();
    }

    void aRestCanBePausedAndAPauseWhereOneIsDueTakesItsPlace() {
        make("[pause]\nevery_trials = 2\nat_least_s = 30.0\n");
        finishPractice();
        doTrial();
        doTrial();
        QCOMPARE(m_runner->hold(), Hold::rest);
        m_runner->pause(); // as when the participant's screen is lost
        QCOMPARE(m_runner->hold(), Hold::paused);
        pass(31 * kS);
        space();
        QCOMPARE(m_runner->hold(), Hold::paused);
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        startTrial();

        make("[pause]\nevery_trials = 2\nat_least_s = 30.0\n");
        finishPractice();
        doTrial();
        startTrial();
        m_runner->pause();
        endStimulus();
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::paused);
        m_runner->goOn();
        startTrial(); // without a rest after the pause
    }

    void anAnswerBeforeTheEndOfAShortStimulusIsTimedFromItsOwnEnd() {
        make();
        space();
        pass(8 * kMs);
        m_device->m_state = {.onset_ns = m_now, .due_ns = m_now + 300 * kMs};
        m_runner->poll();
        pass(250 * kMs);
        digit(1);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].responseTime_s, std::optional(0.25));
        QVERIFY(std::abs(m_kept[0].responseTimeOffset_s.value() + 0.05) < 1e-9);
    }

    void takesAPressJustBeforeTheOnsetAsEarlyAlthoughTheOnsetIsKnownByThen() {
        make();
        space();
        const std::int64_t press = m_now + 5 * kMs;
        m_device->m_state.onset_ns = m_now + 6 * kMs;
        m_now = press;
        digit(1);
        QVERIFY(m_kept.empty());
        QCOMPARE(stage(), Stage::starting);
        pass(2 * kMs);
        m_runner->poll();
        QCOMPARE(stage(), Stage::stimulus);
        digit(1);
        QCOMPARE(m_kept[0].earlyPresses, std::size_t(1));
        QCOMPARE(m_kept[0].responseTime_s, std::optional(0.001));
    }
};

QTEST_MAIN(StudyTimesTest)
#include "study_times_test.moc"
