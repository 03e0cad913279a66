// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_runner.h"
#include "app/console/study/trial_lines.h"
#include "backend/study/protocol.h"
#include "widgets/study/answer_button.h"
#include "widgets/study/participant_window.h"

#include <QSignalSpy>
#include <QTest>

#include <deque>
#include <memory>

using namespace teleta;
using console::StimulusState;
using console::StudyRunner;
using study::Outcome;
using study::Phase;
using study::Stage;
using studyview::ParticipantWindow;
using Hold = StudyRunner::Hold;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kS = 1'000'000'000;

/// A bracelet that does what the test says.
class ScriptedStimulus : public console::StimulusOutput {
public:
    QString obstacle() const override { return m_obstacle; }
    QString description() const override { return QStringLiteral("scripted"); }
    bool isSimulated() const override { return true; }
    void begin(const pattern::Pattern& pattern, double, std::int64_t) override {
        m_begun.push_back(pattern.id);
        m_state = {};
    }
    void stop() override { ++m_stops; }
    StimulusState state(std::int64_t) const override { return m_state; }

    QString m_obstacle;
    StimulusState m_state;
    std::vector<std::string> m_begun;
    int m_stops = 0;
};

study::Protocol protocol(const char* extra = "") {
    const std::string text = std::string(R"(name = "short"
stimulus_s = 2.0
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
)") + extra + R"(
[practice]
repetitions = 1
feedback = true
diagram = true
[test]
repetitions = 2
[masking_noise]
colour = "none"
[[task]]
id = "shape"
condition = [{ id = "static" }]
pattern = [{ letter = "A", name = "circle" }, { letter = "B", name = "rectangle" }]
)";
    auto parsed = study::parseProtocol(text, "test");
    if (!parsed)
        qFatal("%s", core::describe(parsed.error()).c_str());
    return *parsed;
}

} // namespace

/// One session driven by a participant's keys, with a clock and a device of the test.
class StudyRunnerTest : public QObject {
    Q_OBJECT

    std::int64_t m_now = 100 * kS;
    core::StopSwitch m_stop;
    std::unique_ptr<ScriptedStimulus> m_device;
    std::unique_ptr<StudyRunner> m_runner;
    std::unique_ptr<ParticipantWindow> m_window;
    study::Protocol m_protocol;
    study::PlannedSession m_plan;
    std::vector<study::TrialResult> m_kept;
    std::deque<StudyRunner::Kept> m_waiting; ///< results that are being kept, when m_slowDisk
    bool m_slowDisk = false;
    bool m_fullDisk = false;

    void make(const char* extra = "") {
        m_stop.release();
        m_slowDisk = m_fullDisk = false;
        m_kept.clear();
        m_waiting.clear();
        m_device = std::make_unique<ScriptedStimulus>();
        m_protocol = protocol(extra);
        m_plan = study::planSessions(m_protocol, 1, 0).front();
        m_runner = std::make_unique<StudyRunner>(
            m_stop, [this] { return m_now; },
            [this](const study::TrialResult& result, StudyRunner::Kept kept) {
                if (m_fullDisk) {
                    kept(core::Unexpected(core::Error{core::ErrorKind::ioFailed, "disk full", {}, {}}));
                    return;
                }
                m_kept.push_back(result);
                if (m_slowDisk)
                    m_waiting.push_back(std::move(kept));
                else
                    kept({});
            });
        m_window = std::make_unique<ParticipantWindow>([this] { return m_now; });
        m_window->setChoices({{"A", "circle", {}}, {"B", "rectangle", {}}});
        connect(m_window.get(), &ParticipantWindow::nextRequested, m_runner.get(), &StudyRunner::next);
        connect(m_window.get(), &ParticipantWindow::replayRequested, m_runner.get(), &StudyRunner::replay);
        connect(m_window.get(), &ParticipantWindow::pressed, m_runner.get(), &StudyRunner::press);
        connect(m_window.get(), &ParticipantWindow::released, m_runner.get(),
                [this](const QString& device, const QString& key) {
                    m_runner->release(device.toStdString(), key.toStdString());
                });
        m_window->show();
        begin();
    }
    void begin(const std::vector<study::TrialResult>& kept = {}) {
        const auto begun = m_runner->begin(*m_device, m_protocol, m_plan, kept, m_now);
        QVERIFY2(begun.has_value(), begun ? "" : core::describe(begun.error()).c_str());
    }

    const study::Session& session() {
        const study::Session* active = m_runner->session();
        if (active == nullptr)
            qFatal("there is no session");
        return *active;
    }
    const study::PlannedTrial& current() {
        const study::PlannedTrial* trial = session().current();
        if (trial == nullptr)
            qFatal("there is no trial");
        return *trial;
    }
    Stage stage() { return session().stage(); }
    void pass(std::int64_t time_ns) { m_now += time_ns; }
    void space() { QTest::keyClick(m_window.get(), Qt::Key_Space); }
    void digit(std::size_t number) {
        QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>(number)));
    }
    /// Asks for the next trial, whose stimulus begins 8 ms later.
    void startTrial() {
        space();
        QCOMPARE(stage(), Stage::starting);
        pass(8 * kMs);
        m_device->m_state.onset_ns = m_now;
        m_runner->poll();
        QCOMPARE(stage(), Stage::stimulus);
    }
    void endStimulus() {
        pass(2 * kS);
        m_device->m_state.end_ns = m_now;
        m_runner->poll();
        QCOMPARE(stage(), Stage::answering);
    }
    std::size_t presented() { return current().stimulus; }
    void doTrial() {
        startTrial();
        endStimulus();
        const std::size_t answer = presented() + 1;
        pass(700 * kMs);
        digit(answer);
    }
    void finishPractice() {
        doTrial();
        doTrial();
        space();
        QCOMPARE(m_runner->hold(), Hold::blockEnd);
        m_runner->goOn();
    }

private slots:
    void cleanup() {
        m_window.reset();
        m_runner.reset();
    }

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
        QCOMPARE(console::confusionOf(m_runner->results(), Phase::test, 2).correct(), 4);
        QCOMPARE(m_device->m_begun.size(), std::size_t(6));
        QVERIFY(m_device->m_begun[0].starts_with("shape."));
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
        const studyview::AnswerButton* button = m_window->buttons()[1];
        QTest::mouseClick(m_window.get(), Qt::LeftButton, {}, button->geometry().center());
        QCOMPARE(m_kept.size(), std::size_t(2));
        QCOMPARE(m_kept[1].responseDevice, std::string("mouse"));
        QCOMPARE(m_kept[1].response, std::optional<std::size_t>(1));
    }

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

    void feelsAStimulusAgainWhereTheProtocolAllowsIt() {
        make("replays = 1");
        m_window->setScene({.state = studyview::ParticipantScene::State::answering, .canReplay = true});
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
        space();
        m_runner->goOn();
        QCOMPARE(m_runner->hold(), Hold::notKept);
        m_runner->retry();
        QCOMPARE(m_runner->hold(), Hold::notKept);
        m_fullDisk = false;
        m_runner->retry();
        QCOMPARE(m_kept.size(), std::size_t(1));
        QCOMPARE(m_runner->hold(), Hold::paused);
        m_runner->goOn();
        startTrial();
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
        const auto begun = m_runner->begin(*m_device, m_protocol, m_plan, {}, m_now);
        QVERIFY(!begun);
        QVERIFY(QString::fromStdString(begun.error().message).contains("taste.A.static"));
    }
};

QTEST_MAIN(StudyRunnerTest)
#include "study_runner_test.moc"
