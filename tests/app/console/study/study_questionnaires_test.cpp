// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/due_questionnaires.h"
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/participant/questionnaire_form.h"

#include <QAbstractButton>
#include <QFile>
#include <QMessageBox>
#include <QPointer>

using namespace teleta;
using study::Mode;
using test::kPatience_ms;
using State = study::ParticipantScene::State;

namespace {

constexpr char kQuestionnaires[] = R"(
[[questionnaire]]
id = "person"
title = "About you"
when = "before_study"
[[questionnaire.item]]
id = "age"
kind = "text"
question = "How old are you?"
[[questionnaire]]
id = "effort"
title = "Effort"
when = "after_session"
[[questionnaire.item]]
id = "hard"
kind = "likert"
question = "How hard was it?"
points = 7
[[questionnaire]]
id = "end"
title = "The end"
when = "after_study"
[[questionnaire.item]]
id = "hand"
kind = "choice"
question = "Which hand?"
choice = [{ id = "l", text = "Left" }, { id = "r", text = "Right" }]
)";

constexpr char kAlsoBefore[] = R"(
[[questionnaire]]
id = "mood"
title = "Mood"
when = "before_session"
[[questionnaire.item]]
id = "awake"
kind = "likert"
question = "How awake are you?"
points = 5
)";

} // namespace

/// Questionnaires before the first session, after each and after the last one, as the protocol says.
class StudyQuestionnairesTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    [[nodiscard]] study::QuestionnaireForm& form() { return window()->questionnaire(); }
    [[nodiscard]] std::vector<study::StoredAnswer> answers(std::size_t participant = 0) {
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        return *store->answers(store->participants()->at(participant));
    }
    void begin() {
        auto* noise = m_page->findChild<QCheckBox*>("noiseConfirmed");
        QTRY_VERIFY_WITH_TIMEOUT(noise->isVisible(), kPatience_ms);
        if (!noise->isChecked())
            QTest::mouseClick(noise, Qt::LeftButton, {}, QPoint(8, noise->height() / 2));
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().isActive(), kPatience_ms);
    }
    [[nodiscard]] std::string asked() {
        const study::Questionnaire* current = controller().questionnaires().current();
        return current == nullptr ? std::string() : current->id;
    }
    void fillIn(Qt::Key key) {
        QTRY_COMPARE_WITH_TIMEOUT(window()->scene().state, State::questionnaire, kPatience_ms);
        window()->activateWindow(); // the participant's hand; a dialog may have had the keyboard
        QVERIFY(QTest::qWaitForWindowActive(window()));
        QTest::keyClick(window()->focusWidget(), key);
        QTest::mouseClick(form().findChild<QPushButton*>("questionnaireDone"), Qt::LeftButton);
    }
    /// Whatever was asked of the store before is answered when this returns.
    void waitForTheStore() {
        const std::size_t before = notes().size();
        controller().keepNote(QStringLiteral("later"));
        QTRY_COMPARE_WITH_TIMEOUT(notes().size(), before + 1, kPatience_ms);
        QTest::qWait(0);
    }
    [[nodiscard]] QMessageBox* askToSkip() {
        QTest::mouseClick(m_page->findChild<QPushButton*>("skip"), Qt::LeftButton);
        return m_page->findChild<QMessageBox*>("confirmSkip");
    }
    static void confirm(QMessageBox& box) {
        const auto buttons = box.buttons();
        for (QAbstractButton* button : buttons) {
            if (box.buttonRole(button) == QMessageBox::DestructiveRole)
                QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    void doTrials() {
        finishPractice();
        for (int trial = 0; trial < 4; ++trial)
            doTrial();
    }

private slots:
    void init() {
        setUp();
        m_more = kQuestionnaires;
    }
    void cleanup() { tearDown(); }

    void areAskedInTheParticipantsWindowWhereTheProtocolSaysSoAndKept() {
        openStudy();
        begin();
        QCOMPARE(asked(), std::string("person"));
        QVERIFY(!runner().isActive());
        QVERIFY(window()->isVisible());
        QCOMPARE(window()->instruction(), QStringLiteral("About you"));
        fillIn(Qt::Key_9);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(answers().size(), std::size_t(1));
        doTrials();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("effort"), kPatience_ms);
        QVERIFY2(!controller().chosenSession()->isFinished(), "open until it is answered");
        fillIn(Qt::Key_4);
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        QCOMPARE(answers().size(), std::size_t(2));
        QCOMPARE(answers()[1].value, std::optional<std::string>("4"));

        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isActive(), kPatience_ms);
        begin();
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        doTrials();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("effort"), kPatience_ms);
        fillIn(Qt::Key_1);
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("end"), kPatience_ms);
        fillIn(Qt::Key_2);
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        const auto all = answers();
        QCOMPARE(all.size(), std::size_t(4));
        QCOMPARE(all[3].questionnaire, std::string("end"));
        QCOMPARE(all[3].value, std::optional<std::string>("r"));
        QVERIFY(!all[3].session);
        QFile table(studyFolder() + "/data/subject-P01/subject-P01_description-questionnaire_data.csv");
        QTRY_VERIFY_WITH_TIMEOUT(table.exists(), kPatience_ms);
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QByteArray rows = table.readAll();
        QVERIFY2(rows.contains(",end,after_study,hand,choice,Which hand?,r,Right,"), rows.constData());
    }

    void aQuestionnaireThatIsInterruptedIsAskedAgainAndNoTrialTwice() {
        openStudy();
        begin();
        fillIn(Qt::Key_9);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        doTrials();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("effort"), kPatience_ms);
        m_tick.reset();
        m_page.reset();
        QCOMPARE(kept().size(), std::size_t(6));
        QCOMPARE(answers().size(), std::size_t(1));

        openPage();
        m_page->open(studyFolder());
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QVERIFY(controller().foundInterrupted());
        begin();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("effort"), kPatience_ms);
        fillIn(Qt::Key_7);
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        QCOMPARE(kept().size(), std::size_t(6));
        QCOMPARE(answers().size(), std::size_t(2));
    }

    void anAbortInAQuestionnaireLeavesTheSessionOpen() {
        openStudy();
        begin();
        QCOMPARE(asked(), std::string("person"));
        auto* abort = m_page->findChild<QPushButton*>("abort");
        QVERIFY(abort->isEnabled());
        controller().abort();
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isActive() && !controller().isBusy(), kPatience_ms);
        QVERIFY(window()->scene().state != State::questionnaire);
        QCOMPARE(answers().size(), std::size_t(0));
        begin();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("person"), kPatience_ms);
    }

    void theExperimenterCanLeaveAQuestionnaireOutAndANoteSaysSo() {
        openStudy();
        begin();
        QVERIFY(m_page->findChild<QPushButton*>("skip")->isVisible());
        auto* box = askToSkip();
        QVERIFY(box != nullptr);
        QCOMPARE(asked(), std::string("person"));
        confirm(*box);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QVERIFY(answers().empty());
        QCOMPARE(notes().size(), std::size_t(1));
        QCOMPARE(notes()[0].text, std::string("questionnaire skipped: person"));
    }

    void aQuestionnaireIsLeftOutOnceAndTheNextOneStays() {
        m_more += kAlsoBefore;
        openStudy();
        begin();
        QCOMPARE(asked(), std::string("person"));
        confirm(*askToSkip());
        QVERIFY2(controller().questionnaires().isKeeping(), "the note is on its way");
        // The participant is done at the same moment, and somebody confirms once more.
        emit window()->questionnaireAnswered({{"age", "9"}});
        controller().questionnaires().skip(controller().questionnaires().shown());
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("mood"), kPatience_ms);
        waitForTheStore();
        QCOMPARE(asked(), std::string("mood"));
        QVERIFY(answers().empty());
        QCOMPARE(notes().size(), std::size_t(2));
        fillIn(Qt::Key_4);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(answers().size(), std::size_t(1));
    }

    void aQuestionnaireThatCouldNotBeLeftOutIsSaidAndTriedAgain() {
        openStudy();
        begin();
        execute("ALTER TABLE note RENAME TO hidden");
        confirm(*askToSkip());
        QTRY_VERIFY_WITH_TIMEOUT(!controller().questionnaires().problem().isEmpty(), kPatience_ms);
        const auto& scene = sessionPanel().scene();
        QVERIFY2(scene.state.contains(QStringLiteral("could not be skipped")), qPrintable(scene.state));
        QCOMPARE(nextButton()->text(), QStringLiteral("Try again to skip it"));
        QVERIFY2(window()->scene().questionnaireProblem.isEmpty(), "the participant's answers are not lost");
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!controller().questionnaires().problem().isEmpty(), kPatience_ms);
        execute("ALTER TABLE hidden RENAME TO note");
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(notes().size(), std::size_t(1));
        QCOMPARE(notes()[0].text, std::string("questionnaire skipped: person"));
        QVERIFY(answers().empty());
    }

    void answersThatCouldNotBeKeptStayAsTheyAreUntilTheyAre() {
        openStudy();
        begin();
        execute("ALTER TABLE answer RENAME TO hidden");
        fillIn(Qt::Key_9);
        QTRY_VERIFY_WITH_TIMEOUT(!window()->scene().questionnaireProblem.isEmpty(), kPatience_ms);
        // Other answers than those that are tried again cannot be shown.
        QVERIFY(window()->scene().questionnaireLocked);
        QVERIFY(!form().findChild<QPushButton*>("questionnaireDone")->isEnabled());
        QCOMPARE(form().answers().front().value, std::optional<std::string>("9"));
        execute("ALTER TABLE hidden RENAME TO answer");
        QCOMPARE(nextButton()->text(), QStringLiteral("Try again to save the answers"));
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(answers().size(), std::size_t(1));
        QCOMPARE(answers()[0].value, std::optional<std::string>("9"));
    }

    void theQuestionWhetherToLeaveOneOutIsAboutThatOne() {
        m_more += kAlsoBefore;
        openStudy();
        begin();
        QPointer<QMessageBox> box = askToSkip();
        QVERIFY2(box->informativeText().contains(QStringLiteral("asked again")),
                 qPrintable(box->informativeText()));
        fillIn(Qt::Key_9);
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("mood"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(box.isNull(), kPatience_ms);
        emit sessionPanel().skipRequested(controller().questionnaires().shown() - 1);
        waitForTheStore();
        QCOMPARE(asked(), std::string("mood"));
        fillIn(Qt::Key_2);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        doTrials();
        QTRY_COMPARE_WITH_TIMEOUT(asked(), std::string("effort"), kPatience_ms);
        box = askToSkip();
        QVERIFY2(box->informativeText().contains(QStringLiteral("finishes without it")),
                 qPrintable(box->informativeText()));
        confirm(*box);
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
    }

    void simulatedParticipantsAnswerAsInARehearsalWithoutAScreen() {
        openStudy(Mode::simulated);
        controller().setSpeed(200.0);
        controller().startRehearsal();
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isRehearsing(), 60'000);
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        const study::StudyHead& head = store->head();
        const auto participants = store->participants();
        for (const study::Participant& participant : *participants) {
            const auto given = *store->answers(participant);
            QCOMPARE(given.size(), std::size_t(4)); // person, effort twice, end
            const auto plans = planSessions(head.protocol, head.seed, participant.enrolment);
            const auto sessions = *store->sessions(participant);
            for (const study::StoredAnswer& answer : given) {
                std::size_t index = 0;
                while (head.protocol.questionnaires[index].id != answer.questionnaire)
                    ++index;
                study::PlannedSession plan;
                for (const study::SessionRecord& session : sessions) {
                    if (answer.session == session.key)
                        plan = plans.at(session.planIndex);
                }
                const auto expected = study::simulatedAnswers(head, participant, plan, index);
                QCOMPARE(answer.value, expected.front().value);
            }
        }
    }
};

QTEST_MAIN(StudyQuestionnairesTest)
#include "study_questionnaires_test.moc"
