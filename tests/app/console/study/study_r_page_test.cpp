// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"

#include <QFile>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>

#include <cmath>
#include <map>

using namespace teleta;
using study::Mode;
using test::kPatience_ms;

/// A study that is rehearsed, analysed and exported in the console, and computed again in R.
class StudyRPageTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    using Row = std::map<QString, QString>;

    static std::vector<Row> rowsOf(const QString& csv) {
        const QStringList lines = csv.trimmed().split(QLatin1Char('\n'));
        const QStringList header = lines.first().split(QLatin1Char(','));
        std::vector<Row> rows;
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QStringList fields = lines[i].split(QLatin1Char(','));
            Row row;
            for (qsizetype j = 0; j < std::min(header.size(), fields.size()); ++j)
                row[header[j]] = fields[j];
            rows.push_back(row);
        }
        return rows;
    }
    std::vector<Row> writtenByR(const QString& name) {
        QFile file(studyFolder() + QLatin1Char('/') + name);
        return file.open(QIODevice::ReadOnly) ? rowsOf(QString::fromUtf8(file.readAll()))
                                              : std::vector<Row>{};
    }
    static bool same(const QString& shown, const QString& inR, double factor = 1.0) {
        const double expected = factor * inR.toDouble();
        return std::abs(shown.toDouble() - expected) <= 1e-6 * std::max(1e-3, std::abs(expected));
    }
    void choose(const QString& words) {
        auto* button = resultsView().findChild<QPushButton*>(QStringLiteral("resultExport"));
        QVERIFY(button != nullptr);
        for (QAction* action : button->menu()->actions()) {
            if (action->text().contains(words)) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(words));
    }

private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable(QStringLiteral("Rscript")).isEmpty())
            QSKIP("Rscript is not installed, so there is nothing to compare with");
    }
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void aRehearsalIsWatchedFromThePracticeToTheAnovaAndRGivesTheSameNumbers() {
        openPage();
        study::StudyHead rehearsed = head(Mode::simulated, 0.1);
        rehearsed.protocol.test.repetitions = 6;
        rehearsed.protocol.source = study::protocolText(rehearsed.protocol);
        rehearsed.plannedParticipants = 4;
        rehearsed.lapses = 0.3;
        rehearsed.seed = 5;
        controller().create(studyFolder().toStdString(), rehearsed);
        QTRY_VERIFY_WITH_TIMEOUT(controller().overview().has_value() && !controller().isBusy(), kPatience_ms);
        controller().setSpeed(200.0);
        bool practised = false;
        connect(&runner(), &console::StudyRunner::blockKept, this, [&] {
            practised =
                practised || runner().flow()->results().back().planned.phase == study::Phase::practice;
        });
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(controller().isRehearsing(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isRehearsing() && resultTable("anovaTable")->rowCount() >= 3,
                                 120'000);
        QVERIFY(practised);
        QTRY_COMPARE_WITH_TIMEOUT(resultTable("groupTable")->rowCount(), 2, kPatience_ms);

        QSignalSpy written(&controller(), &console::StudyController::written);
        choose(QStringLiteral("Psych-DS"));
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, kPatience_ms);
        QProcess inR;
        inR.start(QStringLiteral("Rscript"), {QStringLiteral("--vanilla"),
                                              studyFolder() + QStringLiteral("/analysis.R"), studyFolder()});
        QVERIFY(inR.waitForFinished(120'000));
        QVERIFY2(inR.exitCode() == 0, inR.readAllStandardError().constData());

        const auto groupsInR = writtenByR(QStringLiteral("group_r.csv"));
        const auto groups = rowsOf(resultTable("groupTable")->csv());
        QCOMPARE(groupsInR.size(), std::size_t(2));
        QCOMPARE(groups.size(), std::size_t(2));
        for (const Row& shown : groups) {
            const auto found = std::find_if(groupsInR.begin(), groupsInR.end(), [&](const Row& row) {
                return row.at("condition") == shown.at("Condition");
            });
            QVERIFY(found != groupsInR.end());
            QCOMPARE(shown.at("Participants"), found->at("participants"));
            QCOMPARE(shown.at("Trials"), found->at("n"));
            QVERIFY(same(shown.at("Right %"), found->at("accuracy_mean"), 100.0));
            QVERIFY(same(shown.at("SD"), found->at("accuracy_sd"), 100.0));
            QVERIFY(same(shown.at("IT bit"), found->at("it_bits")));
            QVERIFY(same(shown.at("IT corrected"), found->at("it_corrected_bits")));
        }
        const auto anovaInR = writtenByR(QStringLiteral("anova_r.csv"));
        int compared = 0;
        for (const Row& shown : rowsOf(resultTable("anovaTable")->csv())) {
            if (shown.at("F") == QLatin1String("NA"))
                continue;
            const auto found = std::find_if(anovaInR.begin(), anovaInR.end(), [&](const Row& row) {
                return row.at("effect") == shown.at("Effect") && row.at("stimulus") == shown.at("Pattern");
            });
            QVERIFY2(found != anovaInR.end(), qPrintable(shown.at("Effect")));
            QCOMPARE(shown.at("df"), found->at("df1") + QLatin1Char(';') + found->at("df2"));
            for (const auto& [ours, theirs] :
                 {std::pair("F", "f"), std::pair("p", "p"), std::pair("partial eta\u00b2", "partial_eta2"),
                  std::pair("gen. eta\u00b2", "generalized_eta2")})
                QVERIFY2(same(shown.at(ours), found->at(theirs)), ours);
            ++compared;
        }
        QVERIFY(compared >= 3);
    }
};

QTEST_MAIN(StudyRPageTest)
#include "study_r_page_test.moc"
