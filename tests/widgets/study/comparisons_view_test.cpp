// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/study/data_set_a.h"
#include "tests/widgets/test_registry.h"
#include "widgets/study/results/comparison_content.h"
#include "widgets/study/results/curve_view.h"
#include "widgets/study/results/interval_chart.h"
#include "widgets/study/results/page/comparisons_view.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/results/result_table.h"

#include <QLabel>
#include <QTabWidget>
#include <QTest>

using namespace teleta;
using study::ComparisonContent;

namespace {

const study::TaskResults& resultsA() {
    static const study::TaskResults all = study::dataSetA();
    return all;
}

const study::TaskSupplement& supplementA() {
    static const study::TaskSupplement all = study::taskSupplement(resultsA());
    return all;
}

QString textOf(const study::TableContent& table, const QString& pair, const QString& column) {
    for (const auto& cells : table.rows) {
        if (cells[2].shown == pair)
            return cells[static_cast<std::size_t>(table.header.indexOf(column))].shown;
    }
    return {};
}

study::ResultsScene sceneA() {
    study::ResultsScene scene;
    scene.tasks = {resultsA()};
    scene.supplements = {supplementA()};
    return scene;
}

} // namespace

class ComparisonsViewTest : public QObject {
    Q_OBJECT

private slots:
    // Expected values: R.
    void pairsHaveHolmsPAndEffectSizes() {
        const study::TableContent table = ComparisonContent::pairs(supplementA().comparisons);
        QCOMPARE(table.rows.size(), std::size_t(1 + 15 + 6));
        const QString pair = QStringLiteral("P1 \u2013 P6");
        QCOMPARE(textOf(table, pair, "p"), QStringLiteral("0.005"));
        QCOMPARE(textOf(table, pair, "p Holm"), QStringLiteral("0.059"));
        QCOMPARE(textOf(table, pair, "d_z"), QStringLiteral("1.45"));
        QCOMPARE(textOf(table, pair, "Difference %"), QStringLiteral("33.8"));
        QCOMPARE(table.rows[0][2].data, QStringLiteral("dynamic;static"));
    }

    void ranksAndFriedmanAreThoseOfR() {
        const study::TableContent ranks = ComparisonContent::ranks(supplementA().comparisons);
        QCOMPARE(textOf(ranks, QStringLiteral("dynamic \u2013 static"), "p"), QStringLiteral("0.016"));
        const study::TableContent effects = ComparisonContent::effects(resultsA(), supplementA().comparisons);
        QCOMPARE(effects.rows.size(), std::size_t(9));
        QCOMPARE(effects.rows[1][4].shown, QStringLiteral("19.55"));
        QCOMPARE(effects.rows[0][3].shown, QStringLiteral("0.159 \u2013 0.853"));
        QCOMPARE(effects.rows[1][3].data, QStringLiteral("NA"));
    }

    void aModelThatIsRefusedSaysWhy() {
        QVERIFY(ComparisonContent::modelNote(tl::unexpected(study::ModelRefusal::separable))
                    .contains(QStringLiteral("finite")));
        QVERIFY(ComparisonContent::modelNote(tl::unexpected(study::ModelRefusal::tooFewParticipants))
                    .contains(QStringLiteral("5")));
        QCOMPARE(ComparisonContent::model(supplementA().model).rows.size(), std::size_t(2));
    }

    void theTabOfComparisonsFollowsTheTask() {
        study::ResultsView view;
        view.setScene(sceneA());
        view.resize(1200, 900);
        view.show();
        auto* tabs = view.findChild<QTabWidget*>("resultTabs");
        QVERIFY(tabs != nullptr);
        tabs->setCurrentWidget(view.findChild<study::ComparisonsView*>());
        auto* pairs = view.findChild<study::ResultTable*>("pairTable");
        QTRY_VERIFY(pairs->isVisible());
        QCOMPARE(pairs->rowCount(), 22);
        // No times, no rules: their parts are not there.
        QVERIFY(!view.findChild<study::CurveView*>("cumulativeChart")->isVisible());
        QVERIFY(!view.findChild<study::ResultTable*>("ruleTable")->isVisible());
        // Corrected p below the patterns.
        const QStringList notes = view.findChild<study::IntervalChart*>("patternChart")->content().notes;
        QVERIFY2(notes[0].contains(QStringLiteral("Holm 0.682")), qPrintable(notes[0]));
    }

    void exclusionsAreShownWithAndWithoutTheRules() {
        study::ResultsScene scene = sceneA();
        scene.exclusions.lines.push_back(
            {"fast", study::ExclusionKind::responseTimeBelow_s, 0.2, false, {}, 480, 3, 0, 0, 0});
        scene.exclusions.withoutRules = {resultsA()};
        study::ResultsView view;
        view.setScene(scene);
        view.show();
        view.findChild<QTabWidget*>("resultTabs")
            ->setCurrentWidget(view.findChild<study::ComparisonsView*>());
        auto* rules = view.findChild<study::ResultTable*>("ruleTable");
        QTRY_VERIFY(rules->isVisible());
        QCOMPARE(rules->rowCount(), 1);
        QVERIFY(rules->csv().contains(QStringLiteral("fast,0.2,protocol,480,3")));
        // Two conditions and three effects.
        QCOMPARE(view.findChild<study::ResultTable*>("withoutTable")->rowCount(), 5);
    }

    void cumulativeCurvesEndAtHundredPercent() {
        study::TaskResults task = resultsA();
        for (study::ParticipantSummary& person : task.participants)
            person.times_s = {1.0, 2.0, 3.5};
        const study::CurveContent curves = ComparisonContent::cumulativeTimes(task);
        QCOMPARE(curves.series.size(), std::size_t(2));
        QCOMPARE(curves.series[0].points.front().y, 0.0);
        QCOMPARE(curves.series[0].points.back().y, 100.0);
        QCOMPARE(curves.series[0].points.back().x, 3.5);
        QCOMPARE(curves.highestX, 4.0);
        QVERIFY(
            study::curvesCsv(curves).startsWith(QStringLiteral("series,x,y,low,high\ndynamic,0,0,NA,NA\n")));
    }
};

static const test::Registration<ComparisonsViewTest> registration;
#include "comparisons_view_test.moc"
