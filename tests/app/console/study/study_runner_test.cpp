// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/trial_lines.h"
#include "backend/pattern/files/pattern_json.h"
#include "tests/app/console/study/runner_bench.h"

#include <QSignalSpy>
#include <QTest>

using namespace teleta;
using namespace teleta::test;

/// The rules of a session in the console, driven by keys.
class StudyRunnerTest : public QObject, protected StudyRunnerBench {
    Q_OBJECT

private slots:
    void cleanup() { tearDown(); }

    void runsAWholeSessionByKeyboard() {
        make();
        QSignalSpy finished(m_runner.get(), &StudyRunner::finished);
        QSignalSpy blocks(m_runner.get(), &StudyRunner::blockKept);
        finishPractice();
        QCOMPARE(blocks.count(), 1);
        for (int trial = 0; trial < 4; ++trial) {
            QCOMPARE(finished.count(), 0);
            doTrial();
        }
        QCOMPARE(finished.count(), 1);
        QCOMPARE(blocks.count(), 2);
        QCOMPARE(m_kept.size(), std::size_t(6));
        for (const study::TrialResult& result : m_kept) {
            QCOMPARE(result.outcome, Outcome::correct);
            QCOMPARE(result.responseTime_s, std::optional(2.7));
            QCOMPARE(result.responseTimeOffset_s, std::optional(0.7));
            QCOMPARE(result.duration_s, 2.0);
            QCOMPARE(result.deviceLatency_ms, std::optional(8.0));
            QCOMPARE(result.responseDevice, std::string("keyboard"));
            QCOMPARE(result.responseKey, QStringLiteral("Digit%1").arg(*result.response + 1).toStdString());
            QCOMPARE(result.earlyPresses, std::size_t(0));
        }
        QCOMPARE(console::confusionOf(m_runner->flow()->results(), Phase::test, 2).correct(), 4);
        QCOMPARE(m_device->m_begun.size(), std::size_t(6));
        QVERIFY(m_device->m_begun[0].starts_with("shape."));
    }

    // Two intervals of 0.5 s with a gap of 0.5 s; the first trial of this seed has the burst in one of them.
    void runsTrialsWithLevelsAsOnePattern() {
        make();
        m_runner->clear();
        auto read = study::parseProtocol(R"(name = "levels"
stimulus_s = 0.5
response_limit_s = 5.0
response_window = "from_end"
order = "full_random"
[practice]
repetitions = 0
[test]
repetitions = 1
[masking_noise]
colour = "none"
[[task]]
id = "detect"
design = "interval"
condition = [{ id = "rest" }]
track = [{ id = "t3", tactors = [3] }]
stimulus = { file = "burst.json", vary = "intensity" }
level = { lowest = 0.0, highest = 1.0 }
procedure = { kind = "staircase", first = 0.4, step_up = 0.1, step_down = 0.1, fast_factor = 1, most_trials = 3 }
)",
                                         "levels.toml");
        QVERIFY2(read.has_value(), read ? "" : core::describe(read.error()).c_str());
        m_protocol = *read;
        pattern::Pattern burst;
        burst.id = "burst";
        burst.duration_s = 0.3;
        burst.tracks[0] = {{0.0, 1.0, pattern::Easing::hold}, {0.3, 1.0}};
        m_stimuli =
            study::StimulusSet::of(
                m_protocol, {{"detect.stimulus", "burst.json", *pattern::patternToJson(burst)}}, "test")
                .value();
        m_plan = study::planSessions(m_protocol, 1, 0).front();
        m_window->setChoices({{"1", "1", {}, false}, {"2", "2", {}, false}});
        begin();
        QSignalSpy changed(m_runner.get(), &StudyRunner::changed);
        for (int trial = 0; trial < 3; ++trial) {
            startTrial();
            QCOMPARE(m_device->m_onset, console::OnsetFrame::any);
            QCOMPARE(m_device->m_last.duration_s, 1.5);
            const double level = *current().level;
            const std::size_t target = *current().target;
            QCOMPARE(evaluate(m_device->m_last, target == 0 ? 0.1 : 1.1)[2], level);
            QCOMPARE(evaluate(m_device->m_last, target == 0 ? 1.1 : 0.1)[2], 0.0);
            QCOMPARE(m_runner->interval(), std::size_t(1));
            digit(1);
            QCOMPARE(stage(), Stage::stimulus);
            pass(700 * kMs);
            changed.clear();
            m_runner->poll();
            QCOMPARE(changed.count(), 1);
            QCOMPARE(m_runner->interval(), std::size_t(0));
            pass(400 * kMs);
            m_runner->poll();
            QCOMPARE(m_runner->interval(), std::size_t(2));
            pass(400 * kMs);
            m_device->m_state.end_ns = m_now;
            m_runner->poll();
            QCOMPARE(stage(), Stage::answering);
            QCOMPARE(m_runner->interval(), std::size_t(0));
            pass(300 * kMs);
            digit(target + 1);
        }
        QCOMPARE(m_kept.size(), std::size_t(3));
        // Two right answers for a step down.
        QCOMPARE(m_kept[0].planned.level, std::optional(0.4));
        QCOMPARE(m_kept[1].planned.level, std::optional(0.4));
        QCOMPARE(*m_kept[2].planned.level, 0.4 - 0.1);
        for (const study::TrialResult& result : m_kept) {
            QCOMPARE(result.outcome, Outcome::correct);
            QCOMPARE(result.earlyPresses, std::size_t(1));
            QCOMPARE(result.responseTimeOffset_s, std::optional(0.3));
            QCOMPARE(result.planned.track, std::string("t3"));
        }
        QCOMPARE(stage(), Stage::finished);
    }

    void takesAnswersFromTheKeypadAndTheMouseWhileTheStimulusIsFelt() {
        make();
        startTrial();
        pass(500 * kMs);
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::KeypadModifier);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].responseDevice, std::string("keypad"));
        QCOMPARE(m_kept[0].responseKey, std::string("Numpad1"));
        QCOMPARE(m_kept[0].duration_s, 0.5);
        QCOMPARE(m_kept[0].responseTimeOffset_s, std::optional(-1.5));
        QVERIFY2(m_device->m_stops > 0, "an answer ends the stimulus");
        startTrial();
        endStimulus();
        const study::AnswerButton* button = m_window->buttons()[1];
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, button->geometry().center());
        QCOMPARE(m_kept.size(), std::size_t(2));
        QCOMPARE(m_kept[1].responseDevice, std::string("mouse"));
        QCOMPARE(m_kept[1].response, std::optional<std::size_t>(1));
    }

    void ignoresAKeyThatIsHeldFromTheTrialBefore() {
        make();
        startTrial();
        endStimulus();
        QTest::keyPress(m_window.get(), Qt::Key_1);
        QCOMPARE(m_kept.size(), std::size_t(1));
        startTrial();
        endStimulus();
        QTest::keyPress(m_window.get(), Qt::Key_1); // still down: a press without a release before
        QCOMPARE(m_kept.size(), std::size_t(1));
        QTest::keyRelease(m_window.get(), Qt::Key_1);
        QTest::keyPress(m_window.get(), Qt::Key_1);
        QCOMPARE(m_kept.size(), std::size_t(2));
        QCOMPARE(m_kept[1].earlyPresses, std::size_t(0));
    }

    void ignoresAutoRepeat() {
        make();
        startTrial();
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier, QStringLiteral("2"), true);
        QApplication::sendEvent(m_window.get(), &repeat);
        QVERIFY(m_kept.empty());
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), true);
        endStimulus();
        digit(1);
        digit(2);
        QApplication::sendEvent(m_window.get(), &held);
        QCOMPARE(stage(), Stage::feedback);
    }

    void countsEarlyPresses() {
        make();
        digit(1);
        space();
        digit(2);
        pass(5 * kMs);
        m_device->m_state.onset_ns = m_now;
        endStimulus();
        digit(1);
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_kept[0].earlyPresses, std::size_t(2));
        QCOMPARE(m_kept[0].response, std::optional<std::size_t>(0));
    }

    void feelsAStimulusAgainWhereTheProtocolAllowsIt() {
        make("replays = 1");
        m_window->setScene({.state = study::ParticipantScene::State::answering, .canReplay = true});
        startTrial();
        endStimulus();
        QTest::keyClick(m_window.get(), Qt::Key_R);
        QCOMPARE(m_device->m_begun.size(), std::size_t(2));
        QCOMPARE(stage(), Stage::starting);
        pass(10 * kMs);
        m_device->m_state.onset_ns = m_now;
        m_runner->poll();
        endStimulus();
        QTest::keyClick(m_window.get(), Qt::Key_R);
        QCOMPARE(m_device->m_begun.size(), std::size_t(2));
        digit(1);
        QCOMPARE(m_kept[0].replays, std::size_t(1));
    }

    void pausesBetweenTrialsOnly() {
        make();
        finishPractice();
        startTrial();
        m_runner->pause();
        QCOMPARE(m_runner->hold(), Hold::none);
        endStimulus();
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::paused);
        space();
        QCOMPARE(stage(), Stage::paused);
        m_runner->goOn();
        startTrial();
    }

    void abortsAndGoesOnLaterWithTheSameOrder() {
        make();
        finishPractice();
        doTrial();
        startTrial();
        const std::size_t interrupted = presented();
        QSignalSpy aborted(m_runner.get(), &StudyRunner::aborted);
        m_runner->abort();
        QCOMPARE(aborted.count(), 1);
        QCOMPARE(m_kept.back().outcome, Outcome::aborted);
        const std::vector<study::TrialResult> kept = m_kept;
        begin(kept);
        QCOMPARE(session().remainingTrials(), std::size_t(3));
        std::size_t shown = 0;
        std::optional<std::size_t> last;
        while (stage() != Stage::finished) {
            startTrial();
            last = presented();
            endStimulus();
            digit(1);
            ++shown;
        }
        QCOMPARE(shown, std::size_t(3));
        QCOMPARE(*last, interrupted);
        QCOMPARE(m_kept.back().planned.attempt, std::size_t(2));
    }

    void showsATrialAgainWhoseDeviceWasLost() {
        make();
        finishPractice();
        startTrial();
        const study::PlannedTrial lost = current();
        pass(300 * kMs);
        m_device->m_state.failure = QStringLiteral("unplugged");
        m_device->m_obstacle = QStringLiteral("no bracelet");
        m_runner->poll();
        QCOMPARE(m_kept.back().outcome, Outcome::deviceError);
        QCOMPARE(m_kept.back().deviceFaults, std::size_t(1));
        QCOMPARE(m_runner->hold(), Hold::deviceLost);
        QCOMPARE(m_runner->reason(), QStringLiteral("unplugged"));
        space();
        QCOMPARE(stage(), Stage::paused);
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::deviceLost);
        m_device->m_obstacle.clear();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        for (int trial = 0; trial < 3; ++trial)
            doTrial();
        QCOMPARE(current().stimulus, lost.stimulus);
        QCOMPARE(current().attempt, std::size_t(2));
    }

    void doesNotBeginATrialWithoutADevice() {
        make();
        m_device->m_obstacle = QStringLiteral("no bracelet");
        space();
        QCOMPARE(m_runner->hold(), Hold::deviceLost);
        QVERIFY(m_device->m_begun.empty());
        QVERIFY2(m_kept.empty(), "nothing was shown");
    }

    void stopHoldsTheSessionInEveryStage_data() {
        QTest::addColumn<int>("stages");
        QTest::newRow("ready") << 0;
        QTest::newRow("stimulus") << 1;
        QTest::newRow("answering") << 2;
        QTest::newRow("feedback") << 3;
    }
    void stopHoldsTheSessionInEveryStage() {
        QFETCH(int, stages);
        make();
        if (stages > 0)
            startTrial();
        if (stages > 1)
            endStimulus();
        if (stages > 2)
            digit(1);
        const std::size_t before = m_kept.size();
        m_stop.engage();
        m_runner->poll();
        QCOMPARE(m_runner->hold(), Hold::stopped);
        const bool ran = stages == 1 || stages == 2;
        QCOMPARE(m_kept.size() - before, std::size_t(ran ? 1 : 0));
        if (ran) {
            QCOMPARE(m_kept.back().outcome, Outcome::deviceError);
            QVERIFY(m_device->m_stops > 0);
        }
        space();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::stopped);
        m_stop.release();
        m_runner->poll();
        QCOMPARE(m_runner->hold(), Hold::stopped);
        const std::size_t begun = m_device->m_begun.size();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::none);
        QCOMPARE(m_device->m_begun.size(), begun);
        startTrial();
    }

    void beginsNoTrialBeforeTheLastOneIsSafe() {
        make();
        m_slowDisk = true;
        startTrial();
        endStimulus();
        digit(1);
        space();
        QCOMPARE(stage(), Stage::ready);
        QCOMPARE(m_device->m_begun.size(), std::size_t(1));
        m_waiting.front()({});
        QCOMPARE(stage(), Stage::starting);
        QCOMPARE(m_device->m_begun.size(), std::size_t(2));
    }

    void holdsATrialInMemoryThatCannotBeKept() {
        make();
        startTrial();
        endStimulus();
        m_fullDisk = true;
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::notKept);
        QVERIFY(m_runner->reason().contains(QStringLiteral("disk full")));
        QVERIFY(!m_runner->flow()->waitsForServer());
        space();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::notKept);
        const QDateTime ended = m_utc;
        m_utc = m_utc.addSecs(60);
        m_runner->retry();
        QCOMPARE(m_runner->hold(), Hold::notKept);
        m_fullDisk = false;
        m_runner->retry();
        QCOMPARE(m_kept.size(), std::size_t(1));
        QVERIFY2((m_times == std::vector<QDateTime>{ended, ended, ended}), "it ended when it ended");
        QCOMPARE(m_runner->hold(), Hold::paused);
        m_runner->goOn();
        doTrial();
        QCOMPARE(m_times.back(), m_utc);
    }

    void aTrialThatWaitsForItsServerIsHeldToo() {
        make();
        startTrial();
        endStimulus();
        m_fullDisk = true;
        m_failure = core::ErrorKind::unavailable;
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::notKept);
        QVERIFY(m_runner->flow()->waitsForServer());
        m_fullDisk = false;
        m_runner->retry();
        QCOMPARE(m_runner->hold(), Hold::paused);
        QVERIFY(!m_runner->flow()->waitsForServer());
    }

    void aSessionThatEndedWhileItsLastTrialCouldNotBeKeptIsOverOnceItIs() {
        make();
        startTrial();
        endStimulus();
        m_fullDisk = true;
        digit(1);
        QCOMPARE(m_runner->hold(), Hold::notKept);
        QSignalSpy aborted(m_runner.get(), &StudyRunner::aborted);
        m_runner->abort();
        QCOMPARE(m_runner->hold(), Hold::notKept);
        QCOMPARE(aborted.size(), 0);
        m_fullDisk = false;
        m_runner->retry();
        QCOMPARE(aborted.size(), 1);
        QCOMPARE(m_runner->hold(), Hold::none);
    }

    void refusesAStimulusThatIsNotThere() {
        make();
        m_protocol.tasks[0].id = "taste";
        const auto begun = m_runner->begin(*m_device, m_protocol, m_stimuli, m_plan, {}, m_now);
        QVERIFY(!begun);
        QVERIFY(QString::fromStdString(begun.error().message).contains("taste.A.static"));
    }
};

QTEST_MAIN(StudyRunnerTest)
#include "study_runner_test.moc"
