// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/new_study_dialog.h"
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/forms/questionnaire_editor.h"
#include "tests/support/form_labels.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

using namespace teleta;
using console::ProtocolDialog;

namespace {

study::Protocol paper() {
    return study::paperProtocol().value();
}

} // namespace

class ProtocolDialogTest : public QObject {
    Q_OBJECT

    static QMessageBox* question(const ProtocolDialog& dialog) {
        return dialog.findChild<QMessageBox*>("unsavedProtocol");
    }
    static void answer(const ProtocolDialog& dialog, QMessageBox::ButtonRole role) {
        QMessageBox* box = question(dialog);
        QVERIFY(box != nullptr);
        for (QAbstractButton* button : box->buttons()) {
            if (box->buttonRole(button) == role) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        QFAIL("there is no such button");
    }

private slots:
    void everyProtocolThatComesWithTheProgramIsTheSameInTheForm() {
        const auto all = study::builtInProtocols();
        QVERIFY(all.has_value());
        for (const study::Protocol& protocol : *all) {
            const ProtocolDialog dialog(protocol);
            const auto entered = dialog.protocol();
            QVERIFY2(entered.has_value(), entered ? "" : core::describe(entered.error()).c_str());
            QCOMPARE(QString::fromStdString(study::protocolText(*entered)),
                     QString::fromStdString(study::protocolText(protocol)));
            QVERIFY(!dialog.isChanged());
        }
    }

    void aTaskWithLevelsIsEnteredByHand() {
        ProtocolDialog dialog(study::readProtocol(":/studies/tactor-detection.toml").value());
        dialog.show();
        const auto line = [&](const char* name) { return dialog.findChild<QLineEdit*>(name); };
        const auto enter = [&](const char* name, const char* text) {
            line(name)->setFocus();
            line(name)->selectAll();
            QTest::keyClicks(line(name), text);
        };
        auto* procedure = dialog.findChild<QComboBox*>("procedure");
        auto* design = dialog.findChild<QComboBox*>("design");
        QVERIFY(line("slope")->isVisibleTo(&dialog) && !line("first")->isVisibleTo(&dialog));
        QVERIFY(!line("catchShare")->isVisibleTo(&dialog));
        procedure->setFocus();
        QTest::keyClick(procedure, Qt::Key_Up);
        QCOMPARE(procedure->currentIndex(), 1);
        QVERIFY(!line("slope")->isVisibleTo(&dialog) && line("first")->isVisibleTo(&dialog));
        enter("first", "0.25");
        enter("stepUp", "0.05");
        enter("stepDown", "0.05");
        // Levitt: 2 down and equal steps stay at the square root of one half.
        QVERIFY2(dialog.findChild<QLabel*>("targetShare")->text().contains("70.7"),
                 qPrintable(dialog.findChild<QLabel*>("targetShare")->text()));
        enter("stepUp", "loud");
        QVERIFY(!dialog.findChild<QLabel*>("targetShare")->text().contains('%'));
        enter("stepUp", "0.0911");
        design->setFocus();
        QTest::keyClick(design, Qt::Key_Up);
        QVERIFY(line("catchShare")->isVisibleTo(&dialog) && !line("gap_s")->isVisibleTo(&dialog));
        enter("catchShare", "0.2");
        const auto entered = dialog.protocol();
        QVERIFY2(entered.has_value(), entered ? "" : core::describe(entered.error()).c_str());
        const study::StudyTask& task = entered->tasks[0];
        QCOMPARE(task.design, study::Design::yesNo);
        QCOMPARE(task.levels.catchShare, 0.2);
        const auto& staircase = std::get<study::StaircaseSettings>(task.levels.procedure);
        QCOMPARE(staircase.first, 0.25);
        QCOMPARE(staircase.stepUp, 0.0911);

        enter("first", "loud");
        QVERIFY(!dialog.protocol());
        QVERIFY(!dialog.findChild<QPushButton*>("makeStudy")->isEnabled());
        QVERIFY(dialog.findChild<QLabel*>("verdict")->text().contains("loud"));
        enter("first", "2");
        QVERIFY2(dialog.findChild<QLabel*>("verdict")->text().contains("2"), "not among the levels");
        QVERIFY(!dialog.protocol());
        QTest::mouseClick(dialog.findChild<QPushButton*>("removeLevelTask"), Qt::LeftButton);
        QTest::mouseClick(dialog.findChild<QPushButton*>("addLevelTask"), Qt::LeftButton);
        QVERIFY2(!dialog.protocol(), "it has no stimulus yet");
    }

    void whatIsEnteredIsLostOnlyWhenThatIsConfirmed() {
        ProtocolDialog dialog(paper());
        dialog.show();
        QVERIFY(!dialog.isChanged());
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY2(!dialog.isVisible() && question(dialog) == nullptr, "nothing was entered");
        dialog.show();
        auto* patterns = dialog.findChild<QPlainTextEdit*>("taskPatterns");
        patterns->appendPlainText("not yet");
        QVERIFY2(dialog.isChanged(), "also while it is not valid");
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(dialog.isVisible());
        answer(dialog, QMessageBox::RejectRole);
        QTRY_VERIFY(question(dialog) == nullptr);
        QVERIFY(dialog.isVisible() && dialog.isChanged());
        QVERIFY(!dialog.close());
        answer(dialog, QMessageBox::DestructiveRole);
        QVERIFY(!dialog.isVisible());
    }

    void changesOfEachKindCountAndWhatIsTakenBackDoesNot() {
        ProtocolDialog dialog(paper());
        auto* seconds = dialog.findChild<QDoubleSpinBox*>("rest_s");
        const double before_s = seconds->value();
        seconds->setValue(before_s + 1.0);
        QVERIFY(dialog.isChanged());
        seconds->setValue(before_s);
        QVERIFY(!dialog.isChanged());
        QTest::mouseClick(dialog.findChild<QPushButton*>("addQuestionnaire"), Qt::LeftButton);
        QVERIFY(dialog.isChanged());
        QTest::mouseClick(dialog.findChildren<QPushButton*>("removeQuestionnaire").last(), Qt::LeftButton);
        QTRY_VERIFY(!dialog.isChanged()); // it goes with the next turn of the event loop
    }

    void rulesOfExclusionStayAndCanBeEntered() {
        study::Protocol strict = paper();
        strict.exclusions = {{"late", study::ExclusionKind::responseTimeAbove_s, 8.5},
                             {"guesses", study::ExclusionKind::accuracyNotAboveChance, 0.05}};
        ProtocolDialog dialog(strict);
        dialog.show();
        QVERIFY(!dialog.isChanged());
        QCOMPARE(dialog.protocol()->exclusions, strict.exclusions);

        QTest::mouseClick(dialog.findChild<QPushButton*>("addExclusion"), Qt::LeftButton);
        QVERIFY(dialog.isChanged());
        const auto newest = [&](const char* name) { return dialog.findChildren<QLineEdit*>(name).last(); };
        QTRY_COMPARE(QApplication::focusWidget(), newest("exclusionId"));
        newest("exclusionId")->selectAll();
        QTest::keyClicks(newest("exclusionId"), "unusual");
        auto* kind = dialog.findChildren<QComboBox*>("exclusionKind").last();
        kind->setFocus();
        QTest::keyClick(kind, Qt::Key_Down);
        QTest::keyClick(kind, Qt::Key_Down);
        newest("exclusionValue")->selectAll();
        QTest::keyClicks(newest("exclusionValue"), "3");
        const auto entered = dialog.protocol();
        QVERIFY2(entered.has_value(), entered ? "" : core::describe(entered.error()).c_str());
        QCOMPARE(entered->exclusions.size(), std::size_t(3));
        QCOMPARE(entered->exclusions.back(),
                 (study::ExclusionRule{"unusual", study::ExclusionKind::responseTimeMad, 3.0}));

        newest("exclusionValue")->setText("many");
        QVERIFY(!dialog.protocol());
        QVERIFY(dialog.findChild<QLabel*>("verdict")->text().contains("many"));
        QTest::mouseClick(dialog.findChildren<QPushButton*>("removeExclusion").last(), Qt::LeftButton);
        QVERIFY(!dialog.isChanged());
        QCOMPARE(dialog.protocol()->exclusions, strict.exclusions);
    }

    void aNewRuleHasANameOfItsOwnAlsoAfterOneIsRemoved() {
        ProtocolDialog dialog(paper());
        dialog.show();
        auto* addRule = dialog.findChild<QPushButton*>("addExclusion");
        QTest::mouseClick(addRule, Qt::LeftButton);
        QTest::mouseClick(addRule, Qt::LeftButton);
        QTest::mouseClick(dialog.findChildren<QPushButton*>("removeExclusion").first(), Qt::LeftButton);
        QTest::mouseClick(addRule, Qt::LeftButton);
        const auto made = dialog.protocol();
        QVERIFY2(made.has_value(), made ? "" : core::describe(made.error()).c_str());
        QCOMPARE(made->exclusions.size(), std::size_t(2));
        QVERIFY(made->exclusions.front().id != made->exclusions.back().id);
    }

    void aPublishedQuestionnaireIsChosenByItsName() {
        ProtocolDialog dialog(paper());
        dialog.show();
        QTest::mouseClick(dialog.findChild<QPushButton*>("addQuestionnaire"), Qt::LeftButton);
        dialog.findChildren<QLineEdit*>("questionnaireId").last()->setText("load");
        auto* use = dialog.findChildren<QComboBox*>("questionnaireUse").last();
        QVERIFY(!dialog.protocol());
        use->setCurrentIndex(2);
        QVERIFY(!dialog.findChildren<QLineEdit*>("questionText").last()->isVisible());
        const auto made = dialog.protocol();
        QVERIFY(made.has_value());
        QCOMPARE(made->questionnaires.back().use, study::StandardQuestionnaire::nasaTlxWeighted);
        QCOMPARE(made->questionnaires.back().items.size(), std::size_t(21));
        QVERIFY(made->questionnaires.back().items.front().required);
        dialog.findChildren<QCheckBox*>("questionnaireRequired").last()->setChecked(false);
        QVERIFY(!dialog.protocol()->questionnaires.back().items.front().required);
        // The form of such a protocol shows it again.
        const ProtocolDialog again(*made);
        QCOMPARE(again.protocol()->questionnaires.back().use, study::StandardQuestionnaire::nasaTlxWeighted);
    }

    void authorsTriggersAndRecordingsAreAskedFor() {
        using Kind = core::TriggerSettings::Kind;
        ProtocolDialog dialog(paper());
        dialog.show();
        QTest::keyClicks(dialog.findChild<QLineEdit*>("protocolAuthors"), "A. Writer; B. Reader");
        auto* kind = dialog.findChild<QComboBox*>("triggerKind");
        auto* device = dialog.findChild<QLineEdit*>("triggerDevice");
        auto* port = dialog.findChild<QSpinBox*>("triggerPort");
        QVERIFY(!device->isVisible() && !port->isVisible());
        QTest::keyClick(kind, Qt::Key_Down);
        QVERIFY(device->isVisible() && !port->isVisible());
        QVERIFY2(!dialog.protocol(), "a serial port has a name");
        QTest::keyClicks(device, "/dev/ttyUSB1");
        QTest::keyClick(dialog.findChild<QCheckBox*>("recordSessions"), Qt::Key_Space);
        auto made = dialog.protocol();
        QVERIFY(made.has_value());
        QCOMPARE(made->authors, (std::vector<std::string>{"A. Writer", "B. Reader"}));
        QVERIFY(made->trigger.kind == Kind::serial);
        QCOMPARE(made->trigger.device, std::string("/dev/ttyUSB1"));
        QVERIFY(made->recordSessions);
        QVERIFY(dialog.isChanged());
        QTest::keyClick(kind, Qt::Key_Down);
        QVERIFY(!device->isVisible() && port->isVisible());
        port->setValue(9100);
        made = dialog.protocol();
        QVERIFY(made->trigger.kind == Kind::osc);
        QCOMPARE(made->trigger.port, std::uint16_t(9100));
        QCOMPARE(made->trigger.host, std::string("127.0.0.1"));
    }

    void whatIsNotEditedStays() {
        study::Protocol protocol = paper();
        protocol.authors = {"A. Writer"};
        protocol.trigger.kind = core::TriggerSettings::Kind::osc;
        protocol.trigger.port = 9001;
        protocol.recordSessions = true;
        const ProtocolDialog dialog(protocol);
        const auto made = dialog.protocol();
        QVERIFY(made.has_value());
        QCOMPARE(made->authors, protocol.authors);
        QVERIFY(made->trigger == protocol.trigger);
        QVERIFY(made->recordSessions);
    }

    void whatIsEnteredIsSavedBeforeTheFormGoes() {
        const QTemporaryDir folder;
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        ProtocolDialog dialog(paper());
        dialog.show();
        auto* name = dialog.findChild<QLineEdit*>("protocolName");
        name->setText("Mine");
        QVERIFY(!dialog.close());
        answer(dialog, QMessageBox::AcceptRole);
        auto* files = dialog.findChild<QFileDialog*>();
        QVERIFY(files != nullptr && dialog.isVisible());
        const QString path = folder.filePath("mine.toml");
        emit files->fileSelected(path);
        files->close();
        QTRY_VERIFY(!dialog.isVisible());
        QVERIFY(!dialog.isChanged());
        const auto saved = study::readProtocol(path.toStdString());
        QVERIFY(saved.has_value());
        QCOMPARE(saved->name, std::string("Mine"));
        // One that cannot be read again is not saved.
        dialog.show();
        dialog.findChild<QLineEdit*>("taskId")->clear();
        QVERIFY(!dialog.protocol());
        QVERIFY(!dialog.close());
        for (QAbstractButton* button : question(dialog)->buttons())
            QCOMPARE(button->isEnabled(), question(dialog)->buttonRole(button) != QMessageBox::AcceptRole);
    }

    void aFormOfWhichAStudyWasMadeGoes() {
        ProtocolDialog dialog(paper());
        dialog.show();
        dialog.findChild<QLineEdit*>("protocolName")->setText("Mine");
        const study::Protocol entered = dialog.protocol().value();
        dialog.leaveTo(entered);
        QVERIFY2(dialog.isVisible(), "nobody asked for a study");
        QTest::mouseClick(dialog.findChild<QPushButton*>("makeStudy"), Qt::LeftButton);
        QVERIFY2(dialog.isVisible(), "there may be none in the end");
        dialog.leaveTo(paper());
        QVERIFY2(dialog.isVisible(), "it is another study");
        dialog.leaveTo(entered);
        QVERIFY(!dialog.isVisible());
    }

    void changesNothingThatNobodyTouches() {
        study::Protocol protocol = paper();
        protocol.stimulus_s = 1.23456789;
        protocol.responseLimit_s = 20.0 / 3.0;
        protocol.noise_dBA = 64.987;
        protocol.tasks[0].patterns[0].name = "circle, large \"and\" round";
        const ProtocolDialog dialog(protocol);
        const auto read = dialog.protocol();
        QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
        QCOMPARE(read->stimulus_s, protocol.stimulus_s);
        QCOMPARE(read->responseLimit_s, protocol.responseLimit_s);
        QCOMPARE(read->noise_dBA, protocol.noise_dBA);
        QCOMPARE(read->tasks.size(), protocol.tasks.size());
        for (std::size_t t = 0; t < read->tasks.size(); ++t) {
            QCOMPARE(read->tasks[t].conditions, protocol.tasks[t].conditions);
            QCOMPARE(read->tasks[t].patterns.size(), protocol.tasks[t].patterns.size());
            for (std::size_t p = 0; p < read->tasks[t].patterns.size(); ++p) {
                QCOMPARE(read->tasks[t].patterns[p].letter, protocol.tasks[t].patterns[p].letter);
                QCOMPARE(read->tasks[t].patterns[p].name, protocol.tasks[t].patterns[p].name);
            }
        }
    }

    void saysBeforeAStudyIsMadeThatItsStimuliAreMissing() {
        ProtocolDialog dialog(paper());
        auto* make = dialog.findChild<QPushButton*>("makeStudy");
        auto* verdict = dialog.findChild<QLabel*>("verdict");
        QVERIFY(make->isEnabled());
        auto* id = dialog.findChild<QLineEdit*>("taskId");
        id->setText("taste");
        QVERIFY(!make->isEnabled());
        QVERIFY2(verdict->text().contains("taste.A.static"), qPrintable(verdict->text()));
        id->setText("shape");
        QVERIFY(make->isEnabled());
    }

    void patternsOfOnesOwnAreReadAndCanBeNamed() {
        study::Protocol protocol = paper();
        protocol.tasks[0].patterns[1].files = {{"static", "/home/a b/my  own.json"}, {"dynamic", "/b.tact"}};
        ProtocolDialog dialog(protocol);
        QCOMPARE(dialog.protocol()->tasks[0].patterns[1].files, protocol.tasks[0].patterns[1].files);
        auto* make = dialog.findChild<QPushButton*>("makeStudy");
        auto* verdict = dialog.findChild<QLabel*>("verdict");
        auto* patterns = dialog.findChild<QPlainTextEdit*>("taskPatterns");
        auto* files = dialog.findChild<QPlainTextEdit*>("taskFiles");
        files->clear();
        patterns->setPlainText("A circle\nZ zigzag");
        QVERIFY2(!make->isEnabled() && verdict->text().contains("shape.Z.static"),
                 qPrintable(verdict->text()));
        QTest::keyClicks(files, "Z static /patterns/zigzag.json");
        QVERIFY2(!make->isEnabled() && verdict->text().contains("shape.Z.dynamic"),
                 qPrintable(verdict->text()));
        QTest::keyClick(files, Qt::Key_Return);
        QTest::keyClicks(files, "Z dynamic zigzag.json");
        QVERIFY2(verdict->text().contains("full path"), qPrintable(verdict->text()));
        files->setPlainText("Z static /z.json\nZ dynamic /patterns/z.json");
        QVERIFY(make->isEnabled());
        QCOMPARE(dialog.protocol()->tasks[0].patterns[1].files.at("dynamic"),
                 std::string("/patterns/z.json"));
        files->setPlainText("Z static /z.json\nZ fast /patterns/z.json");
        QVERIFY2(verdict->text().contains("Z fast"), qPrintable(verdict->text()));
        files->setPlainText("Z static /z.json\nZ static /patterns/z.json");
        QVERIFY2(verdict->text().contains("two files"), qPrintable(verdict->text()));
        QVERIFY(!make->isEnabled());
        // A file is asked for only where there is a place for it.
        auto* choose = dialog.findChild<QPushButton*>("choosePattern");
        QVERIFY(!choose->isEnabled());
        files->setPlainText("Z static /z.json");
        QVERIFY(choose->isEnabled());
        patterns->setPlainText("Z zigzag");
        files->setPlainText("Z static /z.json\nZ dynamic /patterns/z.json");
        QVERIFY(!choose->isEnabled());
    }

    void questionnairesAreMadeChangedAndRemoved() {
        study::Protocol protocol = paper();
        study::QuestionnaireItem hard;
        hard.id = "hard";
        hard.kind = study::ItemKind::likert;
        hard.question = "How hard was it?";
        hard.required = false;
        hard.points = 9;
        hard.low = "easy";
        hard.high = "hard";
        study::QuestionnaireItem hand;
        hand.id = "hand";
        hand.kind = study::ItemKind::choice;
        hand.question = "Which hand?";
        hand.choices = {{"l", "the left one"}, {"r", "the right one"}};
        protocol.questionnaires = {
            {"effort", "Effort", study::QuestionnaireTime::afterSession, {hard, hand}}};
        ProtocolDialog dialog(protocol);
        const auto entered = [&] {
            const auto valid = dialog.protocol();
            return valid ? valid->questionnaires : std::vector<study::Questionnaire>();
        };
        const study::Questionnaire read = entered().front();
        QCOMPARE(read.id, std::string("effort"));
        QCOMPARE(read.title, std::string("Effort"));
        QCOMPARE(read.when, study::QuestionnaireTime::afterSession);
        QCOMPARE(read.items.size(), std::size_t(2));
        QCOMPARE(read.items[0].points, std::size_t(9));
        QCOMPARE(read.items[0].high, std::string("hard"));
        QVERIFY(!read.items[0].required);
        QVERIFY(read.items[1].required);
        QCOMPARE(read.items[1].choices[1].id, std::string("r"));
        QCOMPARE(read.items[1].choices[1].text, std::string("the right one"));

        QTest::mouseClick(dialog.findChild<QPushButton*>("addQuestionnaire"), Qt::LeftButton);
        QVERIFY2(!dialog.protocol(), "it has neither a name nor a question yet");
        auto* made = dialog.findChildren<console::QuestionnaireEditor*>().at(1);
        QTest::keyClicks(made->findChild<QLineEdit*>("questionnaireId"), "person");
        QTest::keyClicks(made->findChild<QLineEdit*>("questionId"), "age");
        QTest::keyClicks(made->findChild<QLineEdit*>("questionText"), "How old are you?");
        made->findChild<QComboBox*>("questionnaireWhen")->setCurrentIndex(0);
        QCOMPARE(entered().size(), std::size_t(2));
        QCOMPARE(entered()[1].when, study::QuestionnaireTime::beforeStudy);
        QCOMPARE(entered()[1].items[0].question, std::string("How old are you?"));
        made->findChild<QComboBox*>("questionKind")->setCurrentIndex(2);
        QVERIFY2(entered().empty(), "a question of two answers at least");
        made->findChild<QPlainTextEdit*>("questionChoices")->setPlainText("young up to 40\nold");
        QCOMPARE(entered()[1].items[0].choices[0].text, std::string("up to 40"));
        QCOMPARE(entered()[1].items[0].choices[1].text, std::string("old"));
        QTest::mouseClick(made->findChild<QPushButton*>("addQuestion"), Qt::LeftButton);
        QVERIFY(entered().empty());

        QTest::mouseClick(made->findChild<QPushButton*>("removeQuestionnaire"), Qt::LeftButton);
        QCOMPARE(entered().size(), std::size_t(1));
        QCOMPARE(entered().front().id, std::string("effort"));
    }

    void restsAreReadAndCanBeChanged() {
        study::Protocol protocol = paper();
        protocol.rest = {10, 12.3456};
        ProtocolDialog dialog(protocol);
        auto* seconds = dialog.findChild<QDoubleSpinBox*>("rest_s");
        QCOMPARE(dialog.protocol()->rest.atLeast_s, 12.3456);
        QVERIFY(seconds->isEnabled());
        seconds->setValue(20.0);
        auto* every = dialog.findChild<QSpinBox*>("restEvery");
        every->setValue(15);
        QCOMPARE(dialog.protocol()->rest.everyTrials, std::size_t(15));
        QCOMPARE(dialog.protocol()->rest.atLeast_s, 20.0);
        every->setValue(0);
        QVERIFY(!seconds->isEnabled());
        QCOMPARE(dialog.protocol()->rest.everyTrials, std::size_t(0));
    }

    void everyLetterOfItsLabelsReachesAField() {
        const ProtocolDialog dialog(paper());
        QCOMPARE(test::labelsWithBareMnemonic(dialog), QStringList());
        const console::NewStudyDialog form(paper(), QStringLiteral("study"));
        QCOMPARE(test::labelsWithBareMnemonic(form), QStringList());
    }

    void takesWhatIsTyped() {
        ProtocolDialog dialog(paper());
        auto* patterns = dialog.findChild<QPlainTextEdit*>("taskPatterns");
        patterns->selectAll();
        QTest::keyClicks(patterns, "A one, two");
        QTest::keyClick(patterns, Qt::Key_Return);
        QTest::keyClicks(patterns, "B  three ");
        auto* stimulus = dialog.findChild<QDoubleSpinBox*>("stimulus_s");
        stimulus->setValue(1.5);
        const auto read = dialog.protocol();
        QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
        QCOMPARE(read->stimulus_s, 1.5);
        QCOMPARE(read->tasks[0].patterns.size(), std::size_t(2));
        QCOMPARE(read->tasks[0].patterns[0].name, std::string("one, two"));
        QCOMPARE(read->tasks[0].patterns[1].name, std::string("three"));
    }
};

QTEST_MAIN(ProtocolDialogTest)
#include "protocol_dialog_test.moc"
