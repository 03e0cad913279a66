// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_figure.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

using namespace teleta;

namespace {

/// Results of a plan whose only measure is the number of the cell.
sweep::SweepResults numbered(const sweep::SweepPlan& plan) {
    sweep::SweepResults results;
    results.measures = {"number"};
    results.shares = {false};
    for (std::uint64_t cell = 0; cell < plan.cells(); ++cell) {
        sweep::CellResult& result = results.cells.emplace_back();
        result.cell = cell;
        result.measures.push_back(
            sweep::cellMeasure({static_cast<double>(cell) - 0.5, static_cast<double>(cell) + 0.5}, false));
    }
    return results;
}

sweep::SweepPlan planWith(const std::string& vary) {
    auto plan = sweep::parseSweepPlan("[sweep]\nscene = \"a\"\n[sweep.vary]\n" + vary, "a.toml");
    EXPECT_TRUE(plan) << describe(plan.error());
    return *plan;
}

QString svgOf(const std::optional<figure::SvgCanvas>& picture) {
    return picture ? QString::fromStdString(picture->standalone()) : QString();
}

QString figureOf(const sweep::SweepPlan& plan) {
    const QString svg = svgOf(sweep::sweepFigure(plan, numbered(plan), 0));
    QXmlStreamReader reader(svg);
    while (!reader.atEnd())
        reader.readNext();
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    return svg;
}

qsizetype fields(const QString& svg) {
    return svg.count(QStringLiteral("stroke:none")) - 60; // without the legend's
}

} // namespace

TEST(SweepFigure, ofOneKeyIsALineThroughItsMeans) {
    const QString svg = figureOf(planWith("\"a.speed_m_per_s\" = [1.0, 2.0, 4.0]\n"));
    EXPECT_TRUE(svg.contains(QStringLiteral(">speed_m_per_s<")));
    EXPECT_EQ(svg.count(QStringLiteral("<circle")), 3);
    // Means 0, 1, 2 are evenly spaced upwards; 1, 2, 4 are places 0, 1/3 and 1.
    const QRegularExpression circle(QStringLiteral("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\""));
    QRegularExpressionMatchIterator found = circle.globalMatch(svg);
    std::vector<double> x, y;
    while (found.hasNext()) {
        const QRegularExpressionMatch match = found.next();
        x.push_back(match.captured(1).toDouble());
        y.push_back(match.captured(2).toDouble());
    }
    ASSERT_EQ(x.size(), 3U);
    EXPECT_NEAR((x[1] - x[0]) / (x[2] - x[0]), 1.0 / 3.0, 0.001);
    EXPECT_NEAR(y[0] - y[1], y[1] - y[2], 0.02);
    EXPECT_GT(y[0], y[2]);
}

TEST(SweepFigure, ofTwoKeysHasLinesAndAMap) {
    const QString svg = figureOf(planWith("x = [1, 2, 3]\nkind = [\"soft\", \"hard\"]\n"));
    EXPECT_TRUE(svg.contains(QStringLiteral(">soft<")));
    EXPECT_EQ(fields(svg), 6);
    // Too many lines for the eye: the map alone.
    const QString many = figureOf(planWith("x = [1, 2]\ny = [1, 2, 3, 4, 5, 6, 7]\n"));
    EXPECT_EQ(fields(many), 14);
    EXPECT_FALSE(many.contains(QStringLiteral("<circle")));
}

TEST(SweepFigure, ofMoreKeysHasAMapForEachOfTheOthers) {
    const QString svg = figureOf(planWith("a = [1, 2, 3]\nx = [1, 2]\ny = [1, 2]\n"));
    EXPECT_EQ(fields(svg), 12);
    EXPECT_TRUE(svg.contains(QStringLiteral(">a = 3<")));
    const QString many =
        figureOf(planWith("a = { from = 1, to = 30, steps = 30 }\nx = [1, 2]\ny = [1, 2]\n"));
    EXPECT_EQ(fields(many), 24 * 4);
    EXPECT_TRUE(many.contains(QStringLiteral("24 of 30")));
}

TEST(SweepFigure, joinsNoTexts) {
    const QString texts = figureOf(planWith("kind = [\"soft\", \"hard\", \"rigid\"]\n"));
    EXPECT_EQ(texts.count(QStringLiteral("<circle")), 3);
    EXPECT_FALSE(texts.contains(QStringLiteral("class=\"hollow series0\"")));
    const QString numbers = figureOf(planWith("x = [1, 2, 3]\n"));
    EXPECT_TRUE(numbers.contains(QStringLiteral("class=\"hollow series0\"")));
}

TEST(SweepFigure, namesWhatKeysHaveInCommonOnce) {
    auto plan = sweep::parseSweepPlan(
        "[sweep]\nscene = \"a\"\n[sweep.pairs]\n\"object.0.k_N_per_m\" = [200.0, 600.0]\n"
        "\"object.1.k_N_per_m\" = [200.0, 700.0]\n",
        "a.toml");
    ASSERT_TRUE(plan);
    EXPECT_EQ(sweep::axisTitle(plan->axes[0]), QStringLiteral("k_N_per_m"));
    EXPECT_EQ(sweep::valueText(plan->axes[0], 0), QStringLiteral("200"));
    EXPECT_EQ(sweep::valueText(plan->axes[0], 1), QStringLiteral("600, 700"));
}

TEST(SweepFigure, ofNothingVariedIsNone) {
    const sweep::SweepPlan plan = planWith("x = [1]\n");
    EXPECT_TRUE(sweep::sweepFigure(plan, numbered(plan), 0) == std::nullopt);
}

TEST(SweepFigure, leavesOutWhatNoRunHas) {
    const sweep::SweepPlan plan = planWith("x = [1, 2]\ny = [1, 2]\n");
    sweep::SweepResults results = numbered(plan);
    results.cells[2].measures[0] = {};
    const QString svg = svgOf(sweep::sweepFigure(plan, results, 0));
    EXPECT_EQ(fields(svg), 3);
    for (sweep::CellResult& cell : results.cells)
        cell.measures[0] = {};
    EXPECT_TRUE(sweep::sweepFigure(plan, results, 0) == std::nullopt);
}
