// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/participant/answer_button.h"

#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QWindow>

#include <algorithm>

using namespace teleta;
using test::kPatience_ms;

namespace {

constexpr char kAnotherTask[] = R"([[task]]
id = "stiffness"
name = "Stiffness"
condition = [{ id = "static" }]
pattern = [{ letter = "A", name = "soft" }, { letter = "B", name = "firm" }, { letter = "C", name = "hard" }]
)";

} // namespace

/// What is done while the store has not answered yet, and what is left when it refuses.
class StudyWaitingTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    void waitUntilASessionCanBegin() {
        controller().setNoiseConfirmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
    }
    [[nodiscard]] QLineEdit* nameField() { return m_page->findChild<QLineEdit*>("participantId"); }
    [[nodiscard]] QMessageBox* question(const char* name) { return m_page->findChild<QMessageBox*>(name); }
    [[nodiscard]] QAbstractButton* buttonOf(const char* name, QMessageBox::ButtonRole role) {
        for (QAbstractButton* button : question(name)->buttons())
            if (question(name)->buttonRole(button) == role)
                return button;
        return nullptr;
    }
    [[nodiscard]] bool isSaid(const QString& words) {
        const auto labels = m_page->messages().findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(words); });
    }

private slots:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void noOtherSessionIsChosenWhileOneBegins() {
        m_more = kAnotherTask;
        openStudy();
        waitUntilASessionCanBegin();
        const auto begun = controller().chosen();
        const auto patterns =
            controller().overview()->head.protocol.tasks[controller().chosenSession()->plan.task].patterns;
        const std::size_t other = [&] {
            const auto& sessions = controller().overview()->participants.front().sessions;
            std::size_t index = 0;
            while (sessions[index].plan.task == controller().chosenSession()->plan.task)
                ++index;
            return index;
        }();
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        controller().choose(0, static_cast<int>(other));
        QCOMPARE(controller().chosen(), begun);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(window()->buttons().size(), patterns.size());
        QCOMPARE(controller().chosen(), begun);
        doTrial();
    }

    void nobodyIsEnrolledWhileASessionBeginsAndTheNameStays() {
        openStudy();
        waitUntilASessionCanBegin();
        QTest::keyClicks(nameField(), "P02");
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTest::keyClick(nameField(), Qt::Key_Return);
        controller().enrol("P03");
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QCOMPARE(nameField()->text(), QStringLiteral("P02"));
        QVERIFY(nameField()->isReadOnly());
        QVERIFY(!m_page->findChild<QPushButton*>("addParticipant")->isEnabled());
        doTrial();
        QCOMPARE(controller().overview()->participants.size(), std::size_t(1));
    }

    void whoCouldNotBeEnrolledChangesNothingAndTheNameStays() {
        openStudy();
        const auto chosen = controller().chosen();
        QTest::keyClicks(nameField(), "P01");
        QTest::keyClick(nameField(), Qt::Key_Return);
        QCOMPARE(controller().chosen(), chosen);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QCOMPARE(controller().chosen(), chosen);
        QCOMPARE(nameField()->text(), QStringLiteral("P01"));
        QVERIFY(!nameField()->isReadOnly());
        nameField()->clear();
        enrol("P02");
        QCOMPARE(nameField()->text(), QString());
        QCOMPARE(controller().chosen(), std::optional(std::pair(1, 0)));
    }

    void aDialogOfTheExperimenterKeepsNothingFromTheParticipant() {
        openStudy();
        beginSession();
        startTrial();
        QTest::mouseClick(m_page->findChild<QPushButton*>("abort"), Qt::LeftButton);
        QVERIFY(m_page->findChild<QMessageBox*>("confirmAbort")->isVisible());
        const std::size_t stimulus = current().stimulus;
        // Through the window of the system, which dialogs may block, not to the widget.
        QTest::mouseClick(window()->windowHandle(), Qt::LeftButton, {},
                          window()->buttons()[stimulus]->geometry().center());
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(kept().front().result.response, std::optional(stimulus));
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        QTest::keyClick(window()->windowHandle(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(stage() == Stage::stimulus || stage() == Stage::answering, kPatience_ms);
    }

    void theParticipantsWindowDoesNotKeepTheProgramOpen() {
        openStudy();
        QVERIFY(window()->isWindow());
        QVERIFY(!window()->testAttribute(Qt::WA_QuitOnClose));
    }

    void aNoteThatCouldNotBeKeptIsStillThere() {
        openStudy();
        beginSession();
        execute("ALTER TABLE note RENAME TO hidden");
        auto* note = m_page->findChild<QLineEdit*>("note");
        QTest::keyClicks(note, "too loud");
        QTest::keyClick(note, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(isSaid("The note could not be saved."));
        QCOMPARE(note->text(), QStringLiteral("too loud"));
        execute("ALTER TABLE hidden RENAME TO note");
        QTest::keyClick(note, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(notes().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(notes().front().text, std::string("too loud"));
        QVERIFY(note->text().isEmpty());
    }

    void aSessionIsNotEndedByClosingBeforeThatIsConfirmed() {
        openStudy();
        int gone = 0;
        const auto leave = [&] { m_page->whenSettled([&gone] { ++gone; }); };
        QVERIFY(m_page->isSettled());
        leave();
        QCOMPARE(gone, 1);
        beginSession();
        doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        QVERIFY(!m_page->isSettled());
        leave();
        leave();
        QCOMPARE(m_page->findChildren<QMessageBox*>("endSession").size(), 1);
        QTest::mouseClick(question("endSession")->button(QMessageBox::Cancel), Qt::LeftButton);
        QCOMPARE(gone, 1);
        QVERIFY(runner().isActive());
        QTRY_VERIFY_WITH_TIMEOUT(question("endSession") == nullptr, kPatience_ms);
        leave();
        QTest::mouseClick(buttonOf("endSession", QMessageBox::AcceptRole), Qt::LeftButton);
        QCOMPARE(gone, 2);
        QCOMPARE(kept().size(), std::size_t(1));
    }

    void anAnswerThatIsNotKeptIsNotLostByClosingWithoutAWord() {
        openStudy();
        beginSession();
        int gone = 0;
        const auto leave = [&] { m_page->whenSettled([&gone] { ++gone; }); };
        execute("ALTER TABLE trial RENAME TO hidden");
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::notKept, kPatience_ms);
        QVERIFY(!m_page->isSettled());
        leave();
        QTest::mouseClick(question("notKept")->button(QMessageBox::Cancel), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(question("notKept") == nullptr, kPatience_ms);
        QCOMPARE(gone, 0);
        // It fails again, and is asked again.
        leave();
        QPointer<QMessageBox> first = question("notKept");
        QTest::mouseClick(buttonOf("notKept", QMessageBox::AcceptRole), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(first == nullptr && question("notKept") != nullptr, kPatience_ms);
        QCOMPARE(gone, 0);
        execute("ALTER TABLE hidden RENAME TO trial");
        QTest::mouseClick(buttonOf("notKept", QMessageBox::AcceptRole), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(gone, 1, kPatience_ms);
        QCOMPARE(kept().size(), std::size_t(1));
    }

    void anAnswerThatCannotBeKeptCanBeGivenUp() {
        openStudy();
        beginSession();
        int gone = 0;
        execute("ALTER TABLE trial RENAME TO hidden");
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::notKept, kPatience_ms);
        m_page->whenSettled([&gone] { ++gone; });
        QTest::mouseClick(buttonOf("notKept", QMessageBox::DestructiveRole), Qt::LeftButton);
        QCOMPARE(gone, 1);
    }

    void aNoteThatIsKeptButNotExportedIsSaidToBeSafe() {
        openStudy();
        beginSession();
        QFile inTheWay(studyFolder() + "/data");
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        auto* note = m_page->findChild<QLineEdit*>("note");
        QTest::keyClicks(note, "too loud");
        QTest::keyClick(note, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(isSaid("The note is safe in the study"));
        QCOMPARE(notes().size(), std::size_t(1));
        QVERIFY(note->text().isEmpty());
    }
};

QTEST_MAIN(StudyWaitingTest)
#include "study_waiting_test.moc"
