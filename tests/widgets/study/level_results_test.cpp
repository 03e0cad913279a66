// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/figure/svg_view.h"
#include "widgets/study/results/level_content.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>
#include <optional>

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
    study::LevelResults results{study::thresholdResults(trials), study::detectionResults(trials)};
    study::FeltTask felt;
    felt.task = "detect";
    felt.tracks["t1"] = {{0}, {0}};
    results.felt = {felt};
    return std::make_shared<const study::LevelResults>(std::move(results));
}

/// Speed is 50 Hz at the start, 0.2, and 250 Hz at full drive.
pattern::MotorProfiles measuredMotors() {
    pattern::MotorProfiles motors = pattern::assumedMotors();
    for (pattern::MotorProfile& motor : motors) {
        motor.assumed = motor.rangeAssumed = false;
        motor.startDrive = 0.2;
        motor.fullDrive = 1.0;
        motor.curve = {{0.2, 50.0}, {1.0, 250.0}};
    }
    return motors;
}

/// Tactors 2 to 6 against tactor 1 at 0.6: all feel as strong at 0.6, but tactor 2 at 0.8.
study::ResultsScene balanceScene() {
    study::LevelTrials trials;
    study::LevelTaskFacts& facts = trials.factsOf(std::string_view("strength"));
    facts.design = study::Design::compare;
    facts.unit = "drive";
    facts.procedure = "constant";
    facts.scale = study::LevelScale::linear;
    study::FeltTask felt;
    felt.task = "strength";
    felt.design = study::Design::compare;
    for (std::size_t tactor = 1; tactor < core::kTactors; ++tactor) {
        const std::string id = "t" + std::to_string(tactor + 1);
        felt.tracks[id] = {{tactor}, {0}};
        auto& track = trials.trackOf({"strength", "rest", id, "P01"});
        track.reference = 0.6;
        const double equal = tactor == 1 ? 0.8 : 0.6;
        const int more[] = {1, 4, 10, 16, 19};
        for (int level = 0; level < 5; ++level) {
            // Below the reference the reference is what has more.
            const double shown = equal + 0.1 * (level - 2);
            for (std::size_t trial = 0; trial < 20; ++trial) {
                const bool saysMore = static_cast<int>(trial) < more[level];
                const bool isRight = saysMore == (shown > 0.6 - 1e-6);
                track.trials.push_back(*study::levelTrialOf(study::Design::compare, shown, 0.6, trial % 2,
                                                            isRight ? trial % 2 : 1 - trial % 2));
            }
        }
    }
    study::TrialTally tally;
    study::TalliedTrial one;
    one.participant = "P01";
    one.task = "strength";
    one.condition = "rest";
    one.stimulus = one.response = "1";
    if (!tally.add(one))
        qFatal("too many names");
    study::LevelResults results{study::thresholdResults(trials), {}};
    results.felt = {felt};
    study::ResultsScene all;
    all.tasks = study::studyResults(tally);
    all.levels = std::make_shared<const study::LevelResults>(std::move(results));
    return all;
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
        // Shares of right answers, which depend on the levels, are not compared.
        const auto* anova = view.findChild<QWidget*>("anovaTable");
        tabs->setCurrentIndex(0);
        QVERIFY(anova->isHidden());
        tasks->setCurrentIndex(tasks->findData("shape"));
        QVERIFY(!tabs->isTabVisible(tabOf("thresholds")));
        QVERIFY(!anova->isHidden());
    }

    void eachPersonHasACurveThatCanBeSaved() {
        ResultsView view;
        view.setScene(scene());
        view.findChild<QComboBox*>("resultTask")
            ->setCurrentIndex(view.findChild<QComboBox*>("resultTask")->findData("detect"));
        auto* choice = view.findChild<QComboBox*>("thresholdsChoice");
        auto* picture = view.findChild<base::SvgView*>("thresholdsView");
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

    void speedAndForceStandBesideLevelsOfMeasuredMotors() {
        const auto results = levelResults();
        const pattern::MotorProfiles measured = measuredMotors();
        const pattern::MotorProfiles assumed = pattern::assumedMotors();
        const auto table = LevelContent::thresholdTable(*results, "detect", {}, &measured);
        QCOMPARE(table.header.size(), 14);
        // 0.0618208 of the way from 50 to 250 Hz.
        const double speed_Hz = 50.0 + 200.0 * table.rows[0][4].data.toDouble();
        QVERIFY(std::abs(table.rows[0][12].data.toDouble() - speed_Hz) < 1e-9);
        QVERIFY(std::abs(table.rows[0][13].data.toDouble() - 100.0 * std::pow(speed_Hz / 250.0, 2)) < 1e-9);
        QVERIFY(table.rows[2].size() == table.rows[0].size());
        QVERIFY(LevelContent::motorNote(*results, "detect", &measured).isEmpty());
        QCOMPARE(LevelContent::thresholdTable(*results, "detect", {}, &assumed).header.size(), 12);
        QVERIFY(LevelContent::motorNote(*results, "detect", &assumed).contains("Calibrate"));
        QVERIFY(LevelContent::motorNote(*results, "detect", nullptr).contains("Connect"));
    }

    void thresholdsWithoutTheRulesStandBesideThoseWithThem() {
        study::LevelResults results = *levelResults();
        QVERIFY(!LevelContent::thresholdTable(results, "detect", {}).header.contains("Without rules"));
        results.withoutRules = results.thresholds;
        results.withoutRules->lines[0].fit.threshold = 0.5;
        results.withoutRules->groups[0].threshold.reset();
        const auto table = LevelContent::thresholdTable(results, "detect", {});
        QCOMPARE(table.header.last(), QStringLiteral("Without rules"));
        QCOMPARE(table.rows[0].back().data, QStringLiteral("0.5"));
        QCOMPARE(table.rows[1].back().data, table.rows[1][4].data);
        QCOMPARE(table.rows[2].back().data, QStringLiteral("NA"));
    }

    void equalStrengthCanBeUsedForAConnectedBracelet() {
        ResultsView view;
        view.resize(1000, 800);
        view.setScene(balanceScene());
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        auto* use = view.findChild<QPushButton*>("useForBracelet");
        auto* table = view.findChild<study::ResultTable*>("strengthTable");
        QCOMPARE(table->rowCount(), 6);
        QVERIFY(!use->isEnabled());
        QVERIFY(view.findChild<QLabel*>("strengthNote")->text().contains("Connect"));
        view.setMotors(study::BraceletMotors{QStringLiteral("bracelet"), measuredMotors()});
        QVERIFY2(use->isEnabled(), qPrintable(view.findChild<QLabel*>("strengthNote")->text()));
        std::optional<pattern::MotorProfiles> wanted;
        QString from;
        connect(&view, &ResultsView::useRequested, this,
                [&](const pattern::MotorProfiles& motors, const QString& who) {
                    wanted = motors;
                    from = who;
                });
        auto* who = view.findChild<QComboBox*>("strengthOf");
        who->setCurrentIndex(who->findData("P01"));
        use->click();
        QVERIFY(wanted.has_value());
        QCOMPARE(from, QStringLiteral("P01"));
        // Drives 0.2 + 0.8 x: the others do with 0.68 what tactor 2 needs 0.84 for.
        QVERIFY(std::abs((*wanted)[1].fullDrive - 1.0) < 1e-6);
        QVERIFY(std::abs((*wanted)[0].fullDrive - 0.68 / 0.84) < 1e-3);
        view.setMotors({});
        QVERIFY(!use->isEnabled());
    }

    void whatSimulatedParticipantsFeltIsNotUsedForARealBracelet() {
        study::ResultsScene scene = balanceScene();
        scene.mode = study::Mode::simulated;
        ResultsView view;
        view.setScene(scene);
        auto* use = view.findChild<QPushButton*>("useForBracelet");
        view.setMotors(study::BraceletMotors{QStringLiteral("bracelet"), measuredMotors()});
        QVERIFY(!use->isEnabled());
        QVERIFY(view.findChild<QLabel*>("strengthNote")->text().contains("simulated"));
        view.setMotors(study::BraceletMotors{QStringLiteral("bracelet"), measuredMotors(), true});
        QVERIFY(use->isEnabled());
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
