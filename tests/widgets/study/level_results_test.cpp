// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/study/results/level_content.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/results/results_view.h"
#include "widgets/study/results/svg_view.h"

#include <QComboBox>
#include <QFileInfo>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

using namespace teleta;
using study::LevelContent;
using study::ResultsView;

namespace {

/// Two intervals, six levels of forty trials: data set P1 of two people, once shifted.
study::LevelTrials detection() {
    study::LevelTrials trials;
    study::LevelTaskFacts& facts = trials.factsOf(std::string_view("detect"));
    facts.design = study::Design::interval;
    facts.intervals = 2;
    facts.unit = "drive";
    facts.procedure = "constant";
    const double levels[] = {.02, .04, .06, .08, .12, .16};
    const int correct[] = {22, 25, 29, 33, 38, 39};
    for (const double factor : {1.0, 2.0}) {
        auto& track = trials.trackOf({"detect", "rest", "t1", factor == 1.0 ? "P01" : "P02"});
        for (std::size_t i = 0; i < 6; ++i) {
            for (int trial = 0; trial < 40; ++trial)
                track.trials.push_back(*study::levelTrialOf(
                    study::Design::interval, factor * levels[i], 0.0, static_cast<std::size_t>(trial % 2),
                    trial < correct[i] ? static_cast<std::size_t>(trial % 2)
                                       : static_cast<std::size_t>(1 - trial % 2)));
        }
    }
    return trials;
}

std::shared_ptr<const study::LevelResults> levelResults() {
    const study::LevelTrials trials = detection();
    return std::make_shared<const study::LevelResults>(
        study::LevelResults{study::thresholdResults(trials), study::detectionResults(trials)});
}

/// The answers of the same task, and a task without levels.
study::ResultsScene scene() {
    study::TrialTally tally;
    for (const char* task : {"detect", "shape"}) {
        for (const char* answer : {"1", "2"}) {
            study::TalliedTrial one;
            one.participant = "P01";
            one.task = task;
            one.condition = "rest";
            one.stimulus = "1";
            one.response = answer;
            if (!tally.add(one))
                qFatal("too many names");
        }
    }
    study::ResultsScene all;
    all.tasks = study::studyResults(tally);
    all.levels = levelResults();
    all.mode = study::Mode::simulated;
    return all;
}

} // namespace

class LevelResultsTest : public QObject {
    Q_OBJECT

private slots:
    void tableHasThresholdsAndTheirMean() {
        const auto results = levelResults();
        const study::TableContent table = LevelContent::thresholdTable(*results, "detect", {});
        QCOMPARE(table.rows.size(), std::size_t(3));
        QCOMPARE(table.rows[0][4].shown, QLocale().toString(0.0618, 'g', 3));
        QVERIFY(table.rows[0][4].data.startsWith("0.0618208"));
        QVERIFY(table.rows[0][5].data.startsWith("0.04484"));
        QCOMPARE(table.rows[2][0].data, QStringLiteral("GROUP"));
        // The mean of t and 2 t on a logarithmic scale is t sqrt 2.
        QVERIFY(std::abs(table.rows[2][4].data.toDouble() - 0.06182085 * std::sqrt(2.0)) < 1e-6);
    }

    void onlyATaskWithLevelsHasTheirTabs() {
        ResultsView view;
        view.resize(1000, 800);
        view.setScene(scene());
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        auto* tasks = view.findChild<QComboBox*>("resultTask");
        auto* tabs = view.findChild<QTabWidget*>("resultTabs");
        const auto tabOf = [&](const char* widget) {
            QWidget* page = view.findChild<QWidget*>(QLatin1String(widget) + QLatin1String("View"));
            while (page != nullptr && tabs->indexOf(page) < 0)
                page = page->parentWidget();
            return tabs->indexOf(page);
        };
        tasks->setCurrentIndex(tasks->findData("detect"));
        for (const char* family : {"thresholds", "tracks", "sdt"}) {
            QVERIFY2(tabOf(family) > 0, family);
            QVERIFY2(tabs->isTabVisible(tabOf(family)), family);
        }
        tasks->setCurrentIndex(tasks->findData("shape"));
        QVERIFY(!tabs->isTabVisible(tabOf("thresholds")));
    }

    void eachPersonHasACurveThatCanBeSaved() {
        ResultsView view;
        view.setScene(scene());
        view.findChild<QComboBox*>("resultTask")
            ->setCurrentIndex(view.findChild<QComboBox*>("resultTask")->findData("detect"));
        auto* choice = view.findChild<QComboBox*>("thresholdsChoice");
        auto* picture = view.findChild<study::SvgView*>("thresholdsView");
        QCOMPARE(choice->count(), 3);
        QCOMPARE(picture->picture()->file, QStringLiteral("thresholds_detect"));
        choice->setCurrentIndex(2);
        QVERIFY(picture->accessibleName().contains("P02"));
        base::Figure figure = picture->figure();
        QVERIFY(figure.svg.contains("SIMULATED"));
        QVERIFY(figure.csv().startsWith("level,n,n_positive\n0.04,40,22\n"));
        const QTemporaryDir folder;
        for (const char* format : {"svg", "pdf", "png", "csv"}) {
            const QString path = folder.filePath(QStringLiteral("curve.") + QLatin1String(format));
            QVERIFY(base::saveFigure(figure, path));
            QVERIFY(QFileInfo(path).size() > 50);
        }
        // New trials keep what is shown.
        view.setScene(scene());
        QCOMPARE(choice->currentIndex(), 2);
    }

    void sensitivityHasEachPersonAndTheMean() {
        const auto results = levelResults();
        const study::TableContent table = LevelContent::detectionTable(*results, "detect", {});
        QCOMPARE(table.rows.size(), std::size_t(3));
        QCOMPARE(table.rows[0][3].shown, QStringLiteral("95/120"));
        QCOMPARE(table.rows[2][8].shown, QStringLiteral("mean of 2"));
        const auto items = LevelContent::detection(results, "detect", study::Mode::run, {});
        QCOMPARE(items.size(), std::size_t(1));
        QVERIFY(items[0].draw().canvas.standalone().find("P02") != std::string::npos);
    }

    void tracksShowEveryTrial() {
        const auto items = LevelContent::tracks(levelResults(), "detect", study::Mode::run, {});
        QCOMPARE(items.size(), std::size_t(2));
        QCOMPARE(items[0].draw().csv.count('\n'), 1 + 240);
    }
};

static const test::Registration<LevelResultsTest> levelRegistration;
#include "level_results_test.moc"
