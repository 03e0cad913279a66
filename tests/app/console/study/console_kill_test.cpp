// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/study_store.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

using namespace teleta::study;

namespace {

constexpr int kPatience_ms = 60'000;
constexpr int kKills = 5;

constexpr char kProtocol[] = R"(name = "short"
stimulus_s = 1.0
response_limit_s = 10.0
response_window = "from_onset"
order = "full_random"
[practice]
repetitions = 1
feedback = true
[test]
repetitions = 3
[masking_noise]
colour = "none"
[[task]]
id = "shape"
name = "Object shape"
condition = [{ id = "static" }, { id = "dynamic" }]
pattern = [{ letter = "A", name = "circle" }, { letter = "B", name = "rectangle" }]
)";

/// Participant, place in the plan, phase, trial, attempt, stimulus, response, time of the day.
using Row = std::tuple<std::string, std::size_t, Phase, std::size_t, std::size_t, std::size_t,
                       std::optional<std::size_t>, QDateTime>;

std::vector<Row> rowsOf(const std::string& folder) {
    std::vector<Row> rows;
    const auto store = StudyStore::open(folder);
    if (!store)
        return rows;
    const auto participants = store->participants();
    if (!participants)
        return rows;
    for (const Participant& participant : *participants) {
        const auto sessions = store->sessions(participant);
        if (!sessions)
            return rows;
        for (const SessionRecord& session : *sessions) {
            const auto trials = store->trials(session);
            if (!trials)
                return rows;
            for (const StoredTrial& trial : *trials) {
                const TrialResult& r = trial.result;
                rows.emplace_back(participant.id, session.planIndex, r.planned.phase, r.planned.trial,
                                  r.planned.attempt, r.planned.stimulus, r.response, trial.time);
            }
        }
    }
    return rows;
}

} // namespace

/// The console is killed while simulated participants go through a study on its page.
class ConsoleKillTest : public QObject {
    Q_OBJECT

private slots:
    void aRehearsalOnTheStudyPageLosesAndRepeatsNothing() {
        const QTemporaryDir folder;
        const std::string study = folder.filePath(QStringLiteral("study")).toStdString();
        StudyHead head;
        head.protocol = *parseProtocol(kProtocol, "short.toml");
        head.seed = 7;
        head.mode = Mode::simulated;
        head.plannedParticipants = 3;
        head.created = QDateTime::currentDateTimeUtc();
        QVERIFY(StudyStore::create(study, head));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.filePath(QStringLiteral("config")));
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));

        teleta::core::RandomStream random(4);
        std::vector<Row> before;
        for (int kill = 0; kill < kKills; ++kill) {
            QProcess console;
            console.setProcessEnvironment(environment);
            console.start(QStringLiteral(TELETA_CONSOLE_PROGRAM),
                          {QStringLiteral("--study"), QString::fromStdString(study),
                           QStringLiteral("--rehearse"), QStringLiteral("--page"), QStringLiteral("study")});
            QVERIFY(console.waitForStarted());
            const std::size_t wanted = before.size() + 1 + random.below(3);
            QTRY_VERIFY_WITH_TIMEOUT(
                rowsOf(study).size() >= wanted || console.state() == QProcess::NotRunning, kPatience_ms);
            QTest::qWait(static_cast<int>(random.below(200)));
            QVERIFY2(console.state() == QProcess::Running, console.readAllStandardError().constData());
            console.kill();
            QVERIFY(console.waitForFinished());
            const std::vector<Row> rows = rowsOf(study);
            QVERIFY(rows.size() >= wanted);
            QVERIFY2(std::equal(before.begin(), before.end(), rows.begin()), "what was kept stays as it was");
            before = rows;
        }

        auto store = StudyStore::open(study);
        QVERIFY(store);
        QVERIFY(rehearse(*store));
        const std::vector<Row> rows = rowsOf(study);
        QCOMPARE(rows.size(), std::size_t(3 * 2 * 8));
        QVERIFY(std::equal(before.begin(), before.end(), rows.begin()));
        // The order is as planned, across all kills.
        std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> tested;
        for (const Row& row : rows) {
            if (std::get<2>(row) == Phase::test)
                tested[{std::get<0>(row), std::get<1>(row)}].push_back(std::get<5>(row));
        }
        const auto participants = store->participants();
        for (const Participant& participant : *participants) {
            const auto plans = planSessions(head.protocol, head.seed, participant.enrolment);
            for (std::size_t session = 0; session < plans.size(); ++session)
                QCOMPARE((tested[{participant.id, session}]), plans[session].test);
        }
    }
};

QTEST_GUILESS_MAIN(ConsoleKillTest)
#include "console_kill_test.moc"
