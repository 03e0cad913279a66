// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_scenes.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/results/confusion_view.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"

#include <QApplication>
#include <QAudioDevice>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMediaDevices>
#include <QMessageBox>
#include <QPushButton>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>

using namespace teleta;
using console::StudyPage;
using study::Mode;
using study::Outcome;
using test::kPatience_ms;

/// A study from its participants to its results.
class StudyPageTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    static void waysNotToAnswer() {
        QTest::addColumn<double>("dropShare");
        QTest::newRow("every frame is lost, although writing succeeds") << 1.0;
        QTest::newRow("it takes frames and answers none") << 0.0;
    }

private slots:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void aSessionFromTheFirstPracticeTrialToTheResults() {
        openStudy();
        beginSession();
        auto* list = m_page->findChild<QTreeWidget*>("participants");
        QTRY_COMPARE_WITH_TIMEOUT(list->topLevelItem(0)->child(0)->text(1), QStringLiteral("running"),
                                  kPatience_ms);
        finishPractice();
        for (int trial = 0; trial < 4; ++trial)
            doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!controller().savedText().isEmpty(), kPatience_ms);
        QCOMPARE(m_page->findChild<study::ConfusionView*>("liveMatrix")->content().matrix.correct(), 4);
        QCOMPARE(window()->scene().state, study::ParticipantScene::State::finished);

        const auto trials = kept();
        QCOMPARE(trials.size(), std::size_t(6));
        for (const study::StoredTrial& trial : trials) {
            QCOMPARE(trial.result.outcome, Outcome::correct);
            QCOMPARE(trial.result.responseDevice, std::string("keyboard"));
            QVERIFY(trial.result.responseTime_s.value() >= 0.0);
            QVERIFY2(trial.result.deviceLatency_ms.value() >= 0.0, "from the request to the first frame");
            QVERIFY2(trial.result.frameWrite_ms.has_value(), "of the frames of the bracelet");
            QVERIFY(trial.result.framesMissed.has_value());
        }
        QVERIFY(!QDir(studyFolder() + "/data").entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());

        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QVERIFY(!runner().isActive());
        QCOMPARE(controller().chosen(), std::optional(std::pair(0, 1)));
        QCOMPARE(m_page->findChild<study::ConfusionView*>("liveMatrix")->content().matrix.total(), 0);
        controller().choose(0, 0);
        QCOMPARE(m_page->findChild<study::ConfusionView*>("liveMatrix")->content().matrix.correct(), 4);
        QCOMPARE(sessionPanel().findChild<QTableWidget*>()->rowCount(), 6);
        m_page->bringForward(QStringLiteral("results"));
        QTRY_COMPARE_WITH_TIMEOUT(resultsView().matrices().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(resultsView().matrices()[0]->content().matrix.correct(), 4);
        QCOMPARE(resultTable("peopleTable")->item(0, 3)->text(), QStringLiteral("4"));
    }

    void doesNotBeginWithoutTheNoiseAndSaysWhatToDo() {
        openStudy();
        QTRY_VERIFY_WITH_TIMEOUT(!sessionPanel().scene().checks.empty(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(std::count_if(sessionPanel().scene().checks.begin(),
                                                sessionPanel().scene().checks.end(),
                                                [](const auto& check) { return !check.passed; }),
                                  std::ptrdiff_t(1), kPatience_ms);
        QVERIFY(!nextButton()->isEnabled());
        const auto& checks = sessionPanel().scene().checks;
        QVERIFY(std::any_of(checks.begin(), checks.end(), [](const auto& check) {
            return check.remedy.contains(QStringLiteral("65 dBA"));
        }));
        controller().begin();
        QVERIFY(!runner().isActive());
    }

    void withoutParticipantsTheNextStepIsToNameOne() {
        openPage();
        controller().create(studyFolder().toStdString(), head(study::Mode::pilot, 0.1));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value() && nextButton()->isEnabled(),
                                 kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        auto* name = m_page->findChild<QLineEdit*>("participantId");
        QCOMPARE(m_page->focusWidget(), name);
    }

    void aRealRunNeedsARealBracelet() {
        openStudy(Mode::run);
        controller().setNoiseConfirmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(!sessionPanel().scene().checks.empty(), kPatience_ms);
        controller().begin();
        QTest::qWait(0);
        QVERIFY(!runner().isActive());
        QVERIFY(!nextButton()->isEnabled());
    }

    void aBraceletUnpluggedInMidStimulusCostsNoTrial() {
        openStudy(Mode::pilot, 2.0);
        beginSession();
        finishPractice();
        QTest::keyClick(window(), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(stage(), Stage::stimulus, kPatience_ms);
        const std::size_t lost = current().trial;
        bracelet().setFaults({.unplugged = true});
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::deviceLost, kPatience_ms);
        QCOMPARE(window()->scene().state, study::ParticipantScene::State::stopped);
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(3), kPatience_ms);
        QCOMPARE(kept().back().result.outcome, Outcome::deviceError);
        QTRY_VERIFY_WITH_TIMEOUT(!nextButton()->isEnabled(), kPatience_ms);
        bracelet().setFaults({});
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        for (int trial = 0; trial < 4; ++trial)
            doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        const auto trials = kept();
        QCOMPARE(trials.size(), std::size_t(7));
        QCOMPARE(trials.back().result.planned.trial, lost);
        QCOMPARE(trials.back().result.planned.attempt, std::size_t(2));
    }

    void aBraceletThatIsLetGoAfterATrialIsFreeForOthers() {
        openStudy();
        beginSession();
        doTrial();
        const std::weak_ptr<console::BraceletSession> session = m_station->session();
        m_station->choose(console::BraceletChoice::none);
        QTRY_VERIFY_WITH_TIMEOUT(session.expired(), kPatience_ms);
    }

    void aBraceletThatDoesNotAnswerPassesNoCheck_data() { waysNotToAnswer(); }
    void aBraceletThatDoesNotAnswerPassesNoCheck() {
        QFETCH(double, dropShare);
        openStudy();
        controller().setNoiseConfirmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        bracelet().setFaults({.mute = dropShare == 0.0, .dropShare = dropShare});
        QTRY_VERIFY_WITH_TIMEOUT(!nextButton()->isEnabled(), kPatience_ms);
        const auto& checks = sessionPanel().scene().checks;
        QVERIFY(std::any_of(checks.begin(), checks.end(), [](const auto& check) {
            return !check.passed && check.finding.contains(QStringLiteral("does not answer"));
        }));
        controller().begin();
        QVERIFY(!runner().isActive());
        bracelet().setFaults({});
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
    }

    void anAnswerToWhatTheBraceletDidNotConfirmIsNone_data() { waysNotToAnswer(); }
    void anAnswerToWhatTheBraceletDidNotConfirmIsNone() {
        QFETCH(double, dropShare);
        openStudy(Mode::pilot, 2.0);
        beginSession();
        finishPractice();
        bracelet().setFaults({.mute = dropShare == 0.0, .dropShare = dropShare});
        QTest::keyClick(window(), Qt::Key_Space);
        QCOMPARE(stage(), Stage::starting);
        answer(current().stimulus);
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::deviceLost, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(3), kPatience_ms);
        QCOMPARE(kept().back().result.outcome, Outcome::deviceError);
        QCOMPARE(kept().back().result.earlyPresses, std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(!nextButton()->isEnabled(), kPatience_ms);
        bracelet().setFaults({});
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(4), kPatience_ms);
        QCOMPARE(kept().back().result.outcome, Outcome::correct);
    }

    void aBraceletThatGrowsSilentInMidStimulusCostsNoTrial() {
        openStudy(Mode::pilot, 2.0);
        beginSession();
        finishPractice();
        startTrial();
        QCOMPARE(stage(), Stage::stimulus);
        bracelet().setFaults({.dropShare = 1.0});
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::deviceLost, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(3), kPatience_ms);
        QCOMPARE(kept().back().result.outcome, Outcome::deviceError);
        QVERIFY(runner().reason().contains(QStringLiteral("does not answer")));
    }

    void theTimeFromTheEndOfAShortPatternIsFromItsOwnEnd() {
        m_more = "[[task]]\nid = \"stiffness\"\ncondition = [{ id = \"dynamic\" }]\n"
                 "pattern = [{ letter = \"E\", name = \"soft\" }, { letter = \"D\", name = \"firm\" }]\n";
        openStudy(Mode::pilot, 2.0);
        const auto& sessions = controller().overview()->participants.front().sessions;
        int stiffness = 0;
        while (sessions[static_cast<std::size_t>(stiffness)].plan.task != 1)
            ++stiffness;
        controller().choose(0, stiffness);
        beginSession();
        for (int trial = 0; trial < 2; ++trial) {
            startTrial();
            answer(current().stimulus);
        }
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(2), kPatience_ms);
        for (const study::StoredTrial& trial : kept()) {
            const pattern::Pattern* pattern = pattern::findBuiltIn(
                trial.result.planned.stimulus == 0 ? "stiffness.E.dynamic" : "stiffness.D.dynamic");
            QVERIFY(pattern != nullptr && pattern->duration_s < 1.5);
            // The first nonzero frame comes a little after the pattern's start.
            const double length_s =
                trial.result.responseTime_s.value() - trial.result.responseTimeOffset_s.value();
            QVERIFY2(length_s > pattern->duration_s - 0.2 && length_s <= pattern->duration_s + 0.2,
                     qPrintable(QString::number(length_s)));
        }
    }

    void stopHoldsTheSessionUntilItIsReleasedAndSomebodyGoesOn() {
        openStudy();
        beginSession();
        startTrial();
        m_stop->engage();
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::stopped, kPatience_ms);
        QVERIFY(window()->instruction().contains(QStringLiteral("Stopped")));
        QVERIFY(sessionPanel().scene().state.contains(QStringLiteral("STOPPED")));
        QCOMPARE(sessionPanel().scene().tone, study::Tone::alarm);
        QVERIFY(!nextButton()->isEnabled());
        QTest::keyClick(window(), Qt::Key_Space);
        QCOMPARE(runner().hold(), Hold::stopped);
        m_stop->release();
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTRY_VERIFY(sessionPanel().scene().state.startsWith(QStringLiteral("STOP is released")));
        QTRY_VERIFY(window()->instruction().startsWith(QStringLiteral("Pause")));
        QCOMPARE(sessionPanel().scene().tone, study::Tone::attention);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QCOMPARE(runner().hold(), Hold::none);
        QVERIFY(core::isOff(bracelet().drive()));
        // A person stopped it, so no device is said to have failed.
        QVERIFY(!sessionPanel().scene().outcomes.empty());
        QCOMPARE(sessionPanel().scene().outcomes.front().outcome,
                 QStringLiteral("interrupted, repeated later"));
        doTrial();
    }

    void aRehearsalWithoutABraceletGoesOnOnlyWhenStopIsReleased() {
        openPage();
        controller().setSpeed(10.0);
        controller().create(studyFolder().toStdString(), head(study::Mode::simulated, 0.1));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value() && nextButton()->isEnabled(),
                                 kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        m_stop->engage();
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::stopped, kPatience_ms);
        QTRY_VERIFY(sessionPanel().scene().state.contains(QStringLiteral("Hold the STOP button")));
        QVERIFY(controller().output().obstacle().isEmpty());
        QVERIFY(nextButton()->text().contains(QStringLiteral("Go on after STOP")));
        QVERIFY(!nextButton()->isEnabled());
        m_stop->release();
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QVERIFY(!sessionPanel().scene().state.contains(QStringLiteral("Hold the STOP button")));
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::none, kPatience_ms);
    }

    void aRehearsalWithoutABraceletLeavesItToOthers() {
        openPage();
        controller().setSpeed(10.0);
        controller().create(studyFolder().toStdString(), head(study::Mode::simulated, 0.1));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value() && nextButton()->isEnabled(),
                                 kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QVERIFY2(!m_station->isReserved(), "its motors can be calibrated");
        auto* pause = m_page->findChild<QPushButton*>("pause");
        QVERIFY(pause != nullptr);
        QTest::mouseClick(pause, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().hold() != Hold::none, kPatience_ms);
        QVERIFY(!m_station->isReserved());
    }

    void anAbortIsAskedForAndTheSessionGoesOnAfterTheProgramWasStartedAgain() {
        openStudy();
        beginSession();
        finishPractice();
        doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        auto* abort = m_page->findChild<QPushButton*>("abort");
        QTest::mouseClick(abort, Qt::LeftButton);
        auto* box = m_page->findChild<QMessageBox*>("confirmAbort");
        QVERIFY(box != nullptr);
        QVERIFY2(stage() != Stage::aborted, "not yet");
        const auto state = [this] {
            return console::StudyScenes::study(controller()).participants[0].sessions[0].state;
        };
        QCOMPARE(state(), QStringLiteral("running"));
        for (QAbstractButton* button : box->buttons()) {
            if (box->buttonRole(button) == QMessageBox::DestructiveRole)
                QTest::mouseClick(button, Qt::LeftButton);
        }
        QCOMPARE(stage(), Stage::aborted);
        QTRY_VERIFY(window()->instruction().startsWith(QStringLiteral("The session has ended.")));
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isBusy(), kPatience_ms);
        const auto before = kept();
        QCOMPARE(before.size(), std::size_t(3));
        QCOMPARE(state(), QStringLiteral("3 of 6")); // before the session is left

        m_tick.reset();
        m_page.reset();
        openPage();
        m_page->open(studyFolder());
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QVERIFY(controller().foundInterrupted());
        QCOMPARE(m_page->messages().count(), 1);
        // The notice leads back to it from wherever one has gone meanwhile.
        const auto interrupted = controller().chosen();
        controller().choose(0, 1);
        m_page->bringForward(QStringLiteral("results"));
        const auto buttons = m_page->messages().findChildren<QToolButton*>();
        const auto show = std::ranges::find(buttons, QStringLiteral("Show it"), &QToolButton::text);
        QVERIFY(show != buttons.end());
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isBusy() && (*show)->isVisible(), kPatience_ms);
        QTest::mouseClick(*show, Qt::LeftButton);
        QCOMPARE(controller().chosen(), interrupted);
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isVisible(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->text().contains(QStringLiteral("Resume")), kPatience_ms);
        beginSession();
        QCOMPARE(session().remainingTrials(), std::size_t(3));
        for (int trial = 0; trial < 3; ++trial)
            doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        const auto after = kept();
        QCOMPARE(after.size(), std::size_t(6));
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(after[i].time, before[i].time);
        QVERIFY2(after[3].result.onset_s > after[2].result.onset_s, "the times of a session go on");
    }

    void aStudyOfPatternsOfOnesOwnPlaysAndShowsThem() {
        pattern::Pattern own;
        own.id = "mine";
        own.duration_s = 5.0;
        own.tracks[4] = {{0.0, 0.5, pattern::Easing::linear}, {5.0, 0.5, pattern::Easing::linear}};
        const QString file = m_folder->filePath(QStringLiteral("mine.json"));
        QVERIFY(pattern::savePattern(own, file.toStdString()));
        openPage();
        study::StudyHead made = head(Mode::pilot, 2.0);
        for (study::StudyPattern& pattern : made.protocol.tasks[0].patterns)
            pattern.files = {{"static", file.toStdString()}, {"dynamic", file.toStdString()}};
        made.protocol.source = study::protocolText(made.protocol);
        controller().create(studyFolder().toStdString(), made);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QVERIFY(QFile::remove(file));
        enrol("P01");
        beginSession();
        startTrial();
        // Only the fifth motor runs, unlike in a circle or a rectangle.
        const auto onlyFifth = [this] {
            const auto drive = bracelet().drive();
            for (std::size_t tactor = 0; tactor < drive.size(); ++tactor) {
                if ((drive[tactor] > 0) != (tactor == 4))
                    return false;
            }
            return true;
        };
        QTRY_VERIFY_WITH_TIMEOUT(onlyFifth(), kPatience_ms);
        QCOMPARE(console::StudyScenes::choices(controller()).front().diagram.strongest,
                 study::diagramOf(own, 2.0).strongest);
        answer(current().stimulus);
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(kept().front().result.outcome, Outcome::correct);
    }

    void aClockThatIsSetBackADayBetweenAnAbortAndTheRestLosesAndOverwritesNothing() {
        openStudy();
        beginSession();
        finishPractice();
        doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        controller().abort();
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isBusy(), kPatience_ms);
        const auto before = kept();
        QCOMPARE(before.size(), std::size_t(3));
        m_clockSet_s = -86'400;
        controller().leaveSession();
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->text().contains(QStringLiteral("Resume")), kPatience_ms);
        beginSession();
        for (int trial = 0; trial < 3; ++trial)
            doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        const auto after = kept();
        QCOMPARE(after.size(), std::size_t(6));
        for (std::size_t i = 0; i < before.size(); ++i) {
            QCOMPARE(after[i].time, before[i].time);
            QCOMPARE(after[i].result.onset_s, before[i].result.onset_s);
        }
        for (std::size_t i = before.size(); i < after.size(); ++i) {
            QVERIFY2(after[i].time < before.back().time, "the time of the clock, as it is");
            QVERIFY2(after[i].result.onset_s > after[i - 1].result.onset_s,
                     "the session goes on all the same");
        }
        // The next session is a new one although, by the clock, it began earlier.
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        beginSession();
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept(0, 1).size(), std::size_t(1), kPatience_ms);
        QCOMPARE(kept().size(), std::size_t(6));
    }

    void stimuliThatHaveChangedSinceTheStudyBeganKeepItFromGoingOn() {
        openStudy();
        execute("UPDATE study SET stimulus_set_sha256 = 'other', app_version = '0.7.1'");
        m_tick.reset();
        m_page.reset();
        openPage();
        m_page->open(studyFolder());
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        controller().setNoiseConfirmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(!sessionPanel().scene().checks.empty(), kPatience_ms);
        const auto& checks = sessionPanel().scene().checks;
        QVERIFY(std::any_of(checks.begin(), checks.end(), [](const auto& check) {
            return !check.passed && check.remedy.contains(QStringLiteral("0.7.1"));
        }));
        controller().begin();
        QVERIFY(!controller().isBusy());
        const auto participant = controller().chosenParticipant()->participant;
        const auto plan = controller().chosenSession()->plan;
        auto store = study::StudyStore::open(studyFolder().toStdString());
        QVERIFY(!console::openSession(*store, participant, 0, plan, QDateTime::currentDateTimeUtc()));
        QVERIFY(store->sessions(participant)->empty());
    }

    void aPageThatIsClosedInMidTrialLosesNothingThatWasAnswered() {
        openStudy();
        beginSession();
        doTrial();
        startTrial();
        m_tick.reset();
        m_page.reset();
        QCOMPARE(kept().size(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(core::isOff(bracelet().drive()), kPatience_ms);
    }

    void theParticipantsWindowThatIsClosedPausesTheSession() {
        openStudy();
        beginSession();
        window()->close();
        QCOMPARE(runner().hold(), Hold::paused);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QCOMPARE(runner().hold(), Hold::none);
    }

    void aNoteIsKeptWithItsSession() {
        openStudy();
        beginSession();
        auto* note = m_page->findChild<QLineEdit*>("note");
        QTest::keyClicks(note, QStringLiteral("the noise was off"));
        QTest::keyClick(note, Qt::Key_Return);
        const auto notes = [&] {
            const auto store = study::StudyStore::open(studyFolder().toStdString());
            return *store->notes(store->sessions(store->participants()->front())->front());
        };
        QTRY_COMPARE_WITH_TIMEOUT(notes().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(notes()[0].text, std::string("the noise was off"));
    }

    void aDamagedProtocolIsSaidWithItsLine() {
        openPage();
        QFile file(m_folder->filePath(QStringLiteral("damaged.toml")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("name = \"x\"\nstimulus_s = \"two\"\n");
        file.close();
        QString place;
        connect(m_page.get(), &StudyPage::openFailed, this,
                [&](const core::Error& error) { place = QString::fromStdString(core::describe(error)); });
        m_page->open(file.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY2(place.contains(QStringLiteral("damaged.toml:2:")), qPrintable(place));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
    }

    void aFolderWithoutAStudyIsSaid() {
        openPage();
        m_page->open(m_folder->path());
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(!controller().overview());
    }

    void noOtherStudyIsOpenedWhileASessionRuns() {
        openStudy();
        beginSession();
        m_page->open(m_folder->path());
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(runner().isActive());
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
    }

    void aStudyThatCannotBeReadLeavesTheOpenOneOpen() {
        openStudy();
        const QString damaged = m_folder->filePath(QStringLiteral("damaged"));
        {
            auto store = study::StudyStore::create(damaged.toStdString(), head(Mode::pilot, 0.1));
            const study::Participant participant = *store->enrol("P01");
            const auto plan = study::planSessions(store->head().protocol, store->head().seed, 0);
            QVERIFY(store->beginSession(participant, 0, plan[0], QDateTime::currentDateTimeUtc()));
        }
        {
            QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "damaged");
            database.setDatabaseName(QDir(damaged).filePath("study.sqlite"));
            QVERIFY(database.open());
            QVERIFY(QSqlQuery(database).exec("UPDATE session SET plan_index = 99"));
        }
        QSqlDatabase::removeDatabase("damaged");
        m_page->open(damaged);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(QString::fromStdString(controller().overview()->store).startsWith(studyFolder()));
        enrol("P02");
        QCOMPARE(study::StudyStore::open(studyFolder().toStdString())->participants()->size(),
                 std::size_t(2));
        QCOMPARE(m_page->messages().count(), 1);
    }

    void aParticipantIsNotEnrolledTwice() {
        openStudy();
        auto* edit = m_page->findChild<QLineEdit*>("participantId");
        QTest::keyClicks(edit, "P01");
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QCOMPARE(controller().overview()->participants.size(), std::size_t(1));
    }

    void aComputerWithoutSoundSaysSoAndTheNoiseCanStillBeConfirmed() {
        if (!QMediaDevices::defaultAudioOutput().isNull())
            QSKIP("This computer has a sound output");
        openStudy();
        auto* play = m_page->findChild<QPushButton*>("noisePlay");
        QTRY_VERIFY_WITH_TIMEOUT(play->isVisible(), kPatience_ms);
        const QString text = play->text();
        QTest::mouseClick(play, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(sessionPanel().scene().noiseText.contains(QStringLiteral("no sound output")),
                                 kPatience_ms);
        QCOMPARE(m_page->messages().count(), 0); // a notice would lie over the buttons of the session
        QVERIFY(!sessionPanel().scene().noisePlaying);
        QCOMPARE(play->text(), text);
        beginSession();
        QVERIFY(runner().isActive());
    }

    void noiseWithoutAnEndHasNoSeam() {
        console::LoopedSound sound({1.0F, 2.0F, 3.0F});
        sound.open(QIODevice::ReadOnly);
        std::vector<float> heard(8);
        for (std::size_t i = 0; i < heard.size(); i += 2)
            QCOMPARE(sound.read(reinterpret_cast<char*>(&heard[i]), 2 * sizeof(float)),
                     qint64(2 * sizeof(float)));
        QCOMPARE(heard, (std::vector<float>{1, 2, 3, 1, 2, 3, 1, 2}));
    }

    void simulatedParticipantsGoThroughTheWholeStudyAndTheResultsFollow() {
        openStudy(Mode::simulated);
        controller().setSpeed(200.0);
        controller().startRehearsal();
        QTRY_VERIFY_WITH_TIMEOUT(!resultsView().matrices().empty() && !controller().isRehearsing(), 60'000);
        QCOMPARE(controller().overview()->participants.size(), std::size_t(2));
        for (const console::ParticipantOverview& person : controller().overview()->participants)
            QVERIFY(!person.nextSession());
        QTRY_VERIFY_WITH_TIMEOUT(resultTable("anovaTable")->rowCount() >= 3, kPatience_ms);
        QCOMPARE(resultsView().matrices().size(), std::size_t(2));
        for (const study::ConfusionView* view : resultsView().matrices()) {
            QCOMPARE(view->content().matrix.total(), 8);
            QCOMPARE(view->content().mode, Mode::simulated);
        }
    }
};

QTEST_MAIN(StudyPageTest)
#include "study_page_test.moc"
