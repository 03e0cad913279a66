// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/new_study_dialog.h"
#include "app/console/study/forms/server_fields.h"
#include "app/console/study/forms/server_study_dialog.h"
#include "app/console/study/study_leaving.h"
#include "tests/app/console/study/study_bench.h"
#include "tests/support/postgres_server.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/study_panel.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QUrl>

using namespace teleta;
using study::Mode;
using test::kPatience_ms;
using test::PostgresServer;

/// The Study page with a study on a real PostgreSQL server, which this test starts and kills.
class StudyServerPageTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    std::unique_ptr<PostgresServer> m_server;

    [[nodiscard]] study::StoreLocation location() const {
        return {studyFolder().toStdString(), m_server->url("shared")};
    }
    void create() {
        openPage();
        controller().create(location(), head(Mode::pilot, 0.1));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
    }
    [[nodiscard]] QString shownStore() { return m_page->findChild<QLabel*>(QStringLiteral("store"))->text(); }
    [[nodiscard]] std::vector<study::StoredTrial> onServer() {
        const auto store = study::StudyStore::open(location());
        if (!store)
            return {};
        const auto participants = store->participants();
        const auto sessions = store->sessions(participants->front());
        return sessions->empty() ? std::vector<study::StoredTrial>{} : *store->trials(sessions->front());
    }

private slots:
    void init() {
        if (PostgresServer::programs().empty())
            QSKIP("PostgreSQL is not installed, so there is no server to talk to");
        setUp();
        m_server = std::make_unique<PostgresServer>();
    }
    void cleanup() {
        tearDown();
        m_server.reset();
    }

    void aSessionRunsOnTheServerAndItsResultsAreShown() {
        create();
        QVERIFY2(!shownStore().contains(QStringLiteral("cret")), "no password is shown");
        QVERIFY(shownStore().contains(QStringLiteral("study=shared")));
        enrol("P01");
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
        beginSession();
        finishPractice();
        for (int trial = 0; trial < 4; ++trial)
            doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);
        QCOMPARE(onServer().size(), std::size_t(6));
        QVERIFY(!QDir(studyFolder() + "/data").entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
        QVERIFY(!QFile::exists(studyFolder() + "/study.sqlite"));
        m_page->bringForward(QStringLiteral("results"));
        QTRY_COMPARE_WITH_TIMEOUT(resultsView().matrices().size(), std::size_t(1), kPatience_ms);
        QCOMPARE(resultTable("peopleTable")->item(0, 3)->text(), QStringLiteral("4"));
    }

    void aServerThatGoesAwayHoldsTheSessionAtATrialThatIsSafe() {
        create();
        enrol("P01");
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
        beginSession();
        doTrial();
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        m_server->kill();
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::notKept, kPatience_ms);
        QVERIFY(sessionPanel().scene().state.contains(QStringLiteral("sent when the server is back")));
        QCOMPARE(sessionPanel().scene().tone, study::Tone::alarm);
        {
            // Whoever leaves now loses nothing: it is asked about the session, not about the trial.
            console::StudyLeaving leaving(controller(), *m_page);
            leaving.whenSettled([] {});
            QVERIFY(m_page->findChild<QMessageBox*>(QStringLiteral("notKept")) == nullptr);
            auto* question = m_page->findChild<QMessageBox*>(QStringLiteral("endSession"));
            QVERIFY(question != nullptr);
            question->reject();
        }
        m_server->start();
        m_clockSet_s = 60;
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        // It is tried while the session is held: only then is it known whether the trial is kept.
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        QVERIFY2(runner().hold() == Hold::paused, qPrintable(runner().reason()));
        QCOMPARE(onServer().size(), std::size_t(2));
        QVERIFY2(onServer().back().time < QDateTime::currentDateTimeUtc(),
                 "the trial has the time of its end, not of the second try");
    }

    void aServerThatIsAwayBeforeASessionIsSeenAndTheSessionDoesNotBegin() {
        create();
        enrol("P01");
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
        m_server->kill();
        QTRY_VERIFY_WITH_TIMEOUT(shownStore().contains(QStringLiteral("Server unreachable")), kPatience_ms);
        QVERIFY(!nextButton()->isEnabled());
        m_server->start();
        QTRY_VERIFY_WITH_TIMEOUT(shownStore().contains(QStringLiteral("On the server")), kPatience_ms);
    }

    void aServerThatAnswersButRefusesIsNotSaidToBeAway() {
        create();
        enrol("P01");
        m_server->kill();
        m_server->start();
        m_server->sql("ALTER SCHEMA shared RENAME TO hidden");
        QTRY_VERIFY_WITH_TIMEOUT(shownStore().contains(QStringLiteral("The study cannot be used")),
                                 kPatience_ms);
        m_server->sql("ALTER SCHEMA hidden RENAME TO shared");
        QTRY_VERIFY_WITH_TIMEOUT(shownStore().contains(QStringLiteral("On the server")), kPatience_ms);
    }

    void aServerThatDoesNotAnswerIsSaidAndNothingIsOpened() {
        m_server->kill();
        openPage();
        m_page->open(QString::fromStdString(m_server->url("shared")));
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(!controller().overview());
    }

    void theFormsMakeAnAddressOfWhatIsTyped() {
        const QString address = QString::fromStdString(m_server->url("shared", ""));
        const QString plain = QString(address).replace(QStringLiteral(":@"), QStringLiteral("@"));
        QUrl typed(plain);
        typed.setPassword(QString::fromLatin1(PostgresServer::kPassword), QUrl::DecodedMode);
        console::ServerStudyDialog dialog(m_folder->path());
        dialog.server().setAddress(QStringLiteral("http://somewhere"));
        QVERIFY(!dialog.server().problem().isEmpty());
        dialog.server().setAddress(plain);
        QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("serverPassword")),
                         QString::fromLatin1(PostgresServer::kPassword));
        QVERIFY2(dialog.server().problem().isEmpty(), qPrintable(dialog.server().problem()));
        QCOMPARE(QUrl(QString::fromStdString(dialog.location().server)), typed);
        QCOMPARE(QString::fromStdString(dialog.location().folder),
                 m_folder->filePath(QStringLiteral("shared-127.0.0.1-%1-postgres").arg(typed.port())));
        console::ServerFields other;
        other.setAddress(QStringLiteral("postgresql://a@b/c?study=../../x&host=/run/d"));
        QCOMPARE(other.folderName(), QStringLiteral("_._.._x-_run_d-c"));

        console::NewStudyDialog made(head(Mode::pilot, 0.1).protocol, studyFolder());
        QVERIFY(made.location().server.empty());
        made.findChild<QComboBox*>(QStringLiteral("store"))->setCurrentIndex(1);
        made.findChild<console::ServerFields*>()->setAddress(plain);
        QTest::keyClicks(made.findChild<QLineEdit*>(QStringLiteral("serverPassword")),
                         QString::fromLatin1(PostgresServer::kPassword));
        QCOMPARE(QUrl(QString::fromStdString(made.location().server)), typed);
        openPage();
        controller().create(made.location(), head(Mode::pilot, 0.1));
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
    }
};

QTEST_MAIN(StudyServerPageTest)
#include "study_server_page_test.moc"
