// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/new_study_dialog.h"
#include "backend/core/data/output_file.h"
#include "backend/study/methods/adaptive/track.h"
#include "tests/app/console/study/study_bench.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QProcess>
#include <QTabWidget>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

using namespace teleta;
using study::Hold;
using study::Stage;
using test::kPatience_ms;

namespace {

constexpr char kFolderVariable[] = "TELETA_TEST_STUDY_FOLDER";
constexpr int kWholeRun_ms = 240'000;
constexpr std::size_t kTrialsOfTrack = 6;
/// The simulated person feels levels from here on.
constexpr double kFelt = 0.1;

/// The protocol tactor-detection with two tactors and few trials.
study::Protocol shortDetection() {
    study::Protocol protocol = study::readProtocol(":/studies/tactor-detection.toml").value();
    study::LevelTask& levels = protocol.tasks[0].levels;
    levels.tracks.resize(2);
    levels.gap_s = 0.2;
    auto& bayes = std::get<study::BayesSettings>(levels.procedure);
    bayes.mostTrials = bayes.leastTrials = kTrialsOfTrack;
    protocol.practice.repetitions = 1;
    protocol.rest = {};
    protocol.noiseColour = "none";
    return protocol;
}

/// Phase, trial, attempt, complete, track, level, right answer, answer.
using Row = std::tuple<study::Phase, std::size_t, std::size_t, bool, std::string, double, std::size_t,
                       std::optional<std::size_t>>;

std::vector<Row> rowsOf(const QString& folder) {
    std::vector<Row> rows;
    const auto store = study::StudyStore::openForReading(folder.toStdString());
    if (!store)
        return rows;
    const auto participants = store->participants();
    if (!participants || participants->empty())
        return rows;
    const auto sessions = store->sessions(participants->front());
    if (!sessions || sessions->empty())
        return rows;
    const auto trials = store->trials(sessions->front());
    if (!trials)
        return rows;
    for (const study::StoredTrial& trial : *trials) {
        const study::PlannedTrial& planned = trial.result.planned;
        rows.emplace_back(planned.phase, planned.trial, planned.attempt, trial.result.isComplete(),
                          planned.track, *planned.level, planned.stimulus, trial.result.response);
    }
    return rows;
}

} // namespace

/// The program, in a process of its own: makes the study on its page or opens it, and goes through the
/// session to the results with an experimenter's and a participant's hands.
class ProgramAtWork : public QObject, protected test::StudyBench {
    Q_OBJECT

    QString m_place = qEnvironmentVariable(kFolderVariable);

    [[nodiscard]] QString path() const { return m_place + QStringLiteral("/study"); }

    void makeTheStudy() {
        QTest::mouseClick(m_page->findChild<QPushButton*>("newStudyButton"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<console::NewStudyDialog*>(), kPatience_ms);
        auto* dialog = m_page->findChild<console::NewStudyDialog*>();
        QTRY_VERIFY_WITH_TIMEOUT(dialog->isVisible(), kPatience_ms);
        QTest::mouseClick(dialog->findChild<QPushButton*>("fromFile"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(dialog->findChild<QFileDialog*>(), kPatience_ms);
        auto* name = dialog->findChild<QFileDialog*>()->findChild<QLineEdit*>("fileNameEdit");
        name->setText(m_place + QStringLiteral("/short.toml"));
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(dialog->head().protocol.testTrials() == 2 * kTrialsOfTrack, kPatience_ms);
        dialog->setMode(study::Mode::pilot);
        dialog->findChild<QLineEdit*>("folder")->setText(path());
        QTest::mouseClick(dialog->findChild<QPushButton*>("makeStudy"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        enrol(QStringLiteral("P01"));
    }

    void openTheStudy() {
        m_page->open(path());
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value(), kPatience_ms);
        QVERIFY(controller().foundInterrupted());
    }

    void answerTrial() {
        QTRY_VERIFY_WITH_TIMEOUT(stage() == Stage::answering, kPatience_ms);
        answer(*current().level >= kFelt ? current().stimulus : 0);
        QTRY_VERIFY_WITH_TIMEOUT(stage() != Stage::answering && !runner().isKeeping(), kPatience_ms);
    }

private slots:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void fromNewToResults() {
        openPage();
        if (QFileInfo::exists(path()))
            openTheStudy();
        else
            makeTheStudy();
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
        QVERIFY(m_station->isSimulated());
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        QVERIFY(window()->isVisible());
        while (!runner().flow()->isOver()) {
            if (runner().hold() == Hold::blockEnd) {
                QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled() && !runner().isKeeping(), kPatience_ms);
                QTest::mouseClick(nextButton(), Qt::LeftButton);
                continue;
            }
            QCOMPARE(runner().hold(), Hold::none);
            // Space also ends the feedback of the practice.
            QTest::keyClick(window(), Qt::Key_Space);
            if (stage() == Stage::starting || stage() == Stage::stimulus)
                answerTrial();
            if (QTest::currentTestFailed())
                return;
            QTest::qWait(1);
        }
        QTRY_VERIFY_WITH_TIMEOUT(controller().chosenSession()->isFinished(), kPatience_ms);

        m_page->bringForward(QStringLiteral("results"));
        auto* table = m_page->findChild<QTableWidget*>("thresholdsTable");
        // Two tactors, and their mean over the participants.
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 4, kPatience_ms);
        for (const char* tab : {"thresholdsView", "tracksView", "sdtView"}) {
            auto* tabs = m_page->findChild<QTabWidget*>("resultTabs");
            QWidget* page = m_page->findChild<QWidget*>(QLatin1String(tab));
            while (page != nullptr && tabs->indexOf(page) < 0)
                page = page->parentWidget();
            QVERIFY2(page != nullptr && tabs->isTabVisible(tabs->indexOf(page)), tab);
        }
    }
};

/// A study of tactor-detection is killed twice on its way from New to Results.
class DetectionKillTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString studyPath() const { return m_folder.filePath(QStringLiteral("study")); }

    void start(QProcess& program) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(kFolderVariable), m_folder.path());
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder.filePath(QStringLiteral("config")));
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(QCoreApplication::applicationFilePath(), QStringList());
        QVERIFY(program.waitForStarted());
    }

private slots:
    void losesAndRepeatsNothing() {
        QVERIFY(core::writeFile(m_folder.filePath(QStringLiteral("short.toml")).toStdString(),
                                study::protocolText(shortDetection())));
        std::vector<Row> before;
        for (const std::size_t wanted : {4U, 9U}) {
            QProcess program;
            start(program);
            QTRY_VERIFY_WITH_TIMEOUT(rowsOf(studyPath()).size() >= wanted ||
                                         program.state() == QProcess::NotRunning,
                                     kWholeRun_ms);
            QVERIFY2(program.state() == QProcess::Running, program.readAll().constData());
            program.kill();
            QVERIFY(program.waitForFinished());
            const std::vector<Row> rows = rowsOf(studyPath());
            QVERIFY(rows.size() >= wanted);
            QVERIFY2(std::equal(before.begin(), before.end(), rows.begin()), "what was kept stays as it was");
            before = rows;
        }
        QProcess program;
        start(program);
        QTRY_VERIFY_WITH_TIMEOUT(program.state() == QProcess::NotRunning, kWholeRun_ms);
        QVERIFY2(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0,
                 program.readAll().constData());
        const std::vector<Row> rows = rowsOf(studyPath());
        QVERIFY(std::equal(before.begin(), before.end(), rows.begin()));

        const study::Protocol protocol = shortDetection();
        const study::StudyTask& task = protocol.tasks[0];
        std::size_t practice = 0;
        std::map<std::string, std::vector<study::KeptTrial>> tracks;
        for (const auto& [phase, trial, attempt, isComplete, track, level, right, response] : rows) {
            if (isComplete && phase == study::Phase::practice)
                ++practice;
            else if (isComplete)
                tracks[track].push_back({level, response.value_or(0), response == right, true});
        }
        QCOMPARE(practice, std::size_t(2));
        QCOMPARE(tracks.size(), std::size_t(2));
        const study::Procedure procedure =
            study::procedureOf(task.design, task.levels, protocol.test.repetitions, false);
        for (const auto& [track, kept] : tracks) {
            QCOMPARE(kept.size(), kTrialsOfTrack);
            QVERIFY2(!study::firstForeignTrial(procedure, task.levels.range, 0, kept),
                     "each level is the one that the procedure asks for after the answers before it");
        }
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (qEnvironmentVariableIsSet(kFolderVariable)) {
        ProgramAtWork work;
        return QTest::qExec(&work, argc, argv);
    }
    DetectionKillTest killTest;
    return QTest::qExec(&killTest, argc, argv);
}

#include "detection_kill_test.moc"
