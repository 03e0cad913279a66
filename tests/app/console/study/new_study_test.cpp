// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/new_study_dialog.h"
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/forms/protocol_reading.h"
#include "tests/app/console/study/study_bench.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

using namespace teleta;
using console::NewStudyDialog;
using test::kPatience_ms;

/// A new study, from the page to the folder.
class NewStudyTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    NewStudyDialog* m_dialog = nullptr;

    QString write(const QString& name, const QByteArray& text) {
        QFile file(m_folder->filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the protocol");
        return file.fileName();
    }

    /// Opens the dialog as a user does.
    void askForOne() {
        openPage();
        QTest::mouseClick(m_page->findChild<QPushButton*>("newStudyButton"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<NewStudyDialog*>(), kPatience_ms);
        m_dialog = m_page->findChild<NewStudyDialog*>();
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->isVisible(), kPatience_ms);
    }

    /// Chooses a file by typing its path.
    void chooseFile(const QString& path) {
        QTest::mouseClick(m_dialog->findChild<QPushButton*>("fromFile"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QFileDialog*>(), kPatience_ms);
        auto* line =
            m_dialog->findChild<QFileDialog*>()->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        QVERIFY(line != nullptr);
        line->setText(path);
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QFileDialog*>(), kPatience_ms);
    }

    [[nodiscard]] QComboBox* protocol() const { return m_dialog->findChild<QComboBox*>("protocol"); }
    [[nodiscard]] QString problem() const { return m_dialog->findChild<QLabel*>("problem")->text(); }
    [[nodiscard]] QPushButton* make() const { return m_dialog->findChild<QPushButton*>("makeStudy"); }

private slots:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void everyWayToBeginIsReachedByTheKeys() {
        openPage();
        QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
        const auto button = [this](const char* name) {
            return m_page->findChild<QPushButton*>(QLatin1String(name));
        };
        QVERIFY2(!button("continueStudyButton")->isVisible(), "there is none to go on with");
        button("watchRehearsal")->setFocus();
        for (const char* next :
             {"publishedProtocolButton", "newStudyButton", "openStudyButton", "serverStudyButton"}) {
            QTest::keyClick(m_page->focusWidget(), Qt::Key_Tab);
            QCOMPARE(m_page->focusWidget(), button(next));
        }
        button("publishedProtocolButton")->setFocus();
        QTest::keyClick(button("publishedProtocolButton"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<console::ProtocolReading*>(), kPatience_ms);
        QTest::mouseClick(m_page->findChild<QPushButton*>("changeProtocol"), Qt::LeftButton);
        QVERIFY(m_page->findChild<console::ProtocolDialog*>() != nullptr);
    }

    void theStudyThatWasOpenLastIsOfferedWithHowFarItIs() {
        openStudy();
        m_page.reset();
        openPage();
        m_page->setLast(studyFolder());
        auto* goOn = m_page->findChild<QPushButton*>("continueStudyButton");
        QTRY_VERIFY_WITH_TIMEOUT(goOn->isVisible(), kPatience_ms);
        QVERIFY(goOn->isDefault());
        QCOMPARE(goOn->parentWidget()->accessibleName(), QString("Go on with \u201cshort\u201d"));
        QCOMPARE(goOn->accessibleDescription(), QString("0 of 2 sessions are finished."));
        QTest::mouseClick(goOn, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QCOMPARE(controller().overview()->location.folder, studyFolder().toStdString());
    }

    void aStudyThatIsGoneIsNotOffered() {
        openPage();
        m_page->setLast(studyFolder());
        QTest::mouseClick(m_page->findChild<QPushButton*>("publishedProtocolButton"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<console::ProtocolReading*>(), kPatience_ms);
        QVERIFY(!m_page->findChild<QPushButton*>("continueStudyButton")->isVisible());
    }

    void isOfThePapersProtocolUnlessAnotherIsChosen() {
        askForOne();
        QCOMPARE(protocol()->currentText(), QStringLiteral("TeleTA (comes with the program)"));
        m_dialog->findChild<QLineEdit*>("folder")->setText(studyFolder());
        QTest::mouseClick(make(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QCOMPARE(controller().overview()->head.protocol.testTrials(), std::size_t(110));
    }

    void hasASeedOfItsOwnThatIsShownAndKept() {
        askForOne();
        const QString shown = m_dialog->findChild<QLineEdit*>("seed")->text();
        const NewStudyDialog another(study::paperProtocol().value(), studyFolder());
        // Equal by chance once in 4 thousand million.
        QVERIFY(another.findChild<QLineEdit*>("seed")->text() != shown);
        m_dialog->findChild<QLineEdit*>("folder")->setText(studyFolder());
        QTest::mouseClick(make(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QCOMPARE(QString::number(controller().overview()->head.seed), shown);
    }

    void afterwardsReturnAndSpacePressTheNextStep() {
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space}) {
            askForOne();
            m_dialog->findChild<QLineEdit*>("folder")->setText(studyFolder() + QString::number(key));
            QTest::keyClick(make(), Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value() && nextButton()->isEnabled(),
                                     kPatience_ms);
            m_page->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
            QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), nextButton(), kPatience_ms);
            QCOMPARE(nextButton()->text(), QStringLiteral("Add a participant"));
            QTest::keyClick(QApplication::focusWidget(), key);
            QCOMPARE(QApplication::focusWidget(), m_page->findChild<QLineEdit*>("participantId"));
        }
    }

    void isMadeOfAProtocolFileThatIsChosen() {
        const QString path = write(QStringLiteral("mine.toml"), test::kShort);
        askForOne();
        m_dialog->findChild<QLineEdit*>("folder")->setText(studyFolder());
        chooseFile(path);
        QTRY_COMPARE_WITH_TIMEOUT(protocol()->currentText(), QStringLiteral("short (mine.toml)"),
                                  kPatience_ms);
        QVERIFY2(m_dialog->findChild<QLabel*>("trials")->text().startsWith(QStringLiteral("8 ")),
                 qPrintable(m_dialog->findChild<QLabel*>("trials")->text()));
        QTest::mouseClick(make(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        const study::Protocol& made = controller().overview()->head.protocol;
        QCOMPARE(made.name, std::string("short"));
        QCOMPARE(made.source, std::string(test::kShort));
    }

    void aBadFileIsSaidWithItsLineAndNothingIsLost() {
        const QString path = write(QStringLiteral("mine.toml"), "name = \"x\"\nstimulus_s = \"two\"\n");
        askForOne();
        const int shipped = protocol()->count();
        m_dialog->findChild<QLineEdit*>("folder")->setText(studyFolder());
        m_dialog->findChild<QLineEdit*>("seed")->setText(QStringLiteral("42"));
        m_dialog->setMode(study::Mode::pilot);
        chooseFile(path);
        QTRY_VERIFY2_WITH_TIMEOUT(problem().contains(QStringLiteral("mine.toml:2:")), qPrintable(problem()),
                                  kPatience_ms);
        QVERIFY2(problem().contains(QStringLiteral("expected")), qPrintable(problem()));
        QCOMPARE(protocol()->count(), shipped);
        QCOMPARE(m_dialog->folder(), studyFolder());
        QCOMPARE(m_dialog->head().seed, std::uint64_t(42));
        QCOMPARE(m_dialog->head().mode, study::Mode::pilot);
        QVERIFY(make()->isEnabled());

        write(QStringLiteral("mine.toml"), test::kShort);
        chooseFile(path);
        QTRY_COMPARE_WITH_TIMEOUT(protocol()->currentText(), QStringLiteral("short (mine.toml)"),
                                  kPatience_ms);
        QCOMPARE(problem(), QString());
        // After a change and another read it is still one choice.
        write(QStringLiteral("mine.toml"),
              QByteArray(test::kShort).replace("name = \"short\"", "name = \"shorter\""));
        chooseFile(path);
        QTRY_COMPARE_WITH_TIMEOUT(protocol()->currentText(), QStringLiteral("shorter (mine.toml)"),
                                  kPatience_ms);
        QCOMPARE(protocol()->count(), shipped + 1);
    }

    void aProtocolWithoutItsPatternsMakesNoStudy() {
        const QByteArray taste = QByteArray(test::kShort).replace("id = \"shape\"", "id = \"taste\"");
        const QString path = write(QStringLiteral("taste.toml"), taste);
        const QString lost = write(
            QStringLiteral("lost.toml"),
            QByteArray(test::kShort)
                .replace("name = \"circle\"", "name = \"circle\", stimulus = { static = \"away.json\" }"));
        askForOne();
        chooseFile(path);
        QTRY_VERIFY2_WITH_TIMEOUT(problem().contains(QStringLiteral("taste.A.static")), qPrintable(problem()),
                                  kPatience_ms);
        QVERIFY(!make()->isEnabled());
        QTest::keyClick(protocol(), Qt::Key_Home);
        QTRY_COMPARE_WITH_TIMEOUT(problem(), QString(), kPatience_ms);
        QVERIFY(make()->isEnabled());
        chooseFile(lost);
        QTRY_VERIFY2_WITH_TIMEOUT(problem().contains(QStringLiteral("away.json")), qPrintable(problem()),
                                  kPatience_ms);
        QCOMPARE(m_dialog->head().protocol.name, study::paperProtocol()->name);
    }
};

QTEST_MAIN(NewStudyTest)
#include "new_study_test.moc"
