// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/cost_words.h"
#include "backend/cost/frontier.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace teleta;
using console::CostWords;

namespace {

cost::RungCost setting(const char* name, double time_s, double error) {
    cost::RungCost rung;
    rung.name = name;
    rung.errorMean = error;
    rung.timeMedian_s = rung.timeP99_s = time_s;
    return rung;
}

cost::LadderCost job() {
    cost::LadderCost job{"job",
                         "m",
                         {setting("fast", 0.001, 0.0004), setting("middle", 0.002, 0.0002),
                          setting("slow", 0.005, 0.0001), setting("bad", 0.003, 0.0005),
                          setting("limit", 0.0001, std::nan(""))}};
    cost::markFrontier(job.rungs);
    return job;
}

/// With plain spaces.
QString about(const char* name, bool inUse = false) {
    return CostWords::about(job(), name, inUse).simplified().replace(QChar(0x00a0), QLatin1Char(' '));
}

} // namespace

/// What the page Cost says of a setting.
class CostWordsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theNeighboursOnBothSidesAreNamedWithWhatTheyChange() {
        QCOMPARE(about("middle", true),
                 QStringLiteral("In use: middle. It takes 2.00 ms and is off by 200 \u00b5m on average. "
                                "Faster: fast, twice as fast, 200 \u00b5m less accurate. "
                                "More accurate: slow, takes 2.5 times as long, 100 \u00b5m more accurate."));
    }
    void atAnEndThereIsNothingBeyond() {
        QVERIFY(about("fast").startsWith("fast takes 1.00 ms and is off by 400 "));
        QVERIFY(about("fast").contains("More accurate: middle, takes twice as long, 200 "));
        QVERIFY(about("fast").endsWith("No setting is faster."));
        QVERIFY(about("slow").contains("Faster: middle, 2.5 times as fast, 100 "));
        QVERIFY(about("slow").endsWith("No setting is more accurate."));
    }
    void aSettingThatAnotherOneBeatsSaysSo() {
        QVERIFY2(about("bad").contains("middle beats it: 1.5 times as fast, 300 "), qPrintable(about("bad")));
    }
    void equalTimesAndErrorsAreNoDifference() {
        cost::LadderCost equal{
            "job",
            "m",
            {setting("a", 0.001, 0.0002), setting("b", 0.004, 0.0002), setting("c", 0.001, 0.0004)}};
        cost::markFrontier(equal.rungs);
        const auto said = [&](const char* name) {
            return CostWords::about(equal, name, false).replace(QChar(0x00a0), QLatin1Char(' '));
        };
        QVERIFY2(said("b").contains("a beats it: 4 times as fast, equally accurate."), qPrintable(said("b")));
        QVERIFY2(said("c").contains("a beats it: as fast, 200 \u00b5m more accurate."),
                 qPrintable(said("c")));
        QVERIFY2(said("a").endsWith("No setting is faster. No setting is more accurate."),
                 qPrintable(said("a")));
    }
    void aSettingWithoutATimeOrAnErrorSaysWhy() {
        QVERIFY2(about("limit").contains("in less than 100 \u00b5s"), qPrintable(about("limit")));
        QVERIFY(about("unknown").isEmpty());
        cost::LadderCost noisy = job();
        noisy.rungs[1].timeMedian_s = std::nan("");
        QVERIFY(CostWords::about(noisy, "middle", true).startsWith("middle has no time: "));
        // And it is no neighbour.
        QVERIFY(CostWords::about(noisy, "fast", false).contains("slow"));
    }
    void aShareIsInPercent() {
        cost::LadderCost shares{"job", "1", {setting("a", 0.001, 0.2), setting("b", 0.002, 0.125)}};
        cost::markFrontier(shares.rungs);
        const QString text = CostWords::about(shares, "a", false).replace(QChar(0x00a0), QLatin1Char(' '));
        QVERIFY2(text.contains("7.50 percentage points more accurate"), qPrintable(text));
    }
};

QTEST_GUILESS_MAIN(CostWordsTest)
#include "cost_words_test.moc"
