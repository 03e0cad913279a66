// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_figure.h"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

using namespace teleta::cost;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++found;
    return found;
}

RungCost rung(const std::string& name, double time_s, double error, bool pareto) {
    RungCost made;
    made.name = name;
    made.errorMean = error;
    made.errorP95 = 2.0 * error;
    made.timeMedian_s = time_s;
    made.timeP99_s = 1.5 * time_s;
    made.pareto = pareto;
    return made;
}

} // namespace

TEST(CostFigure, drawsAPointARungAndNamesIt) {
    const LadderCost ladder{
        "stiffness",
        "1",
        {rung("quick", 1e-6, 0.1, true), rung("exact", 1e-3, 0.001, true), rung("poor", 1e-2, 0.05, false)}};
    const std::string svg = costSvg(ladder, "Stiffness & more");
    EXPECT_EQ(svg.substr(0, 4), "<svg");
    EXPECT_NE(svg.find("Stiffness &amp; more"), std::string::npos);
    EXPECT_EQ(count(svg, "<circle"), 3U);
    EXPECT_EQ(count(svg, "class=\"series0\""), 2U) << "those on the front are filled";
    for (const char* name : {">quick<", ">exact<", ">poor<"})
        EXPECT_NE(svg.find(name), std::string::npos) << name;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(CostFigure, goesRightWithTheTimeAndDownWithTheError) {
    const LadderCost ladder{"a", "m", {rung("quick", 1e-6, 0.1, true), rung("exact", 1e-3, 0.001, true)}};
    const std::string svg = costSvg(ladder, "A");
    const std::regex circle("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
    std::sregex_iterator found(svg.begin(), svg.end(), circle);
    ASSERT_NE(found, std::sregex_iterator());
    const double x = std::stod((*found)[1]), y = std::stod((*found)[2]);
    ++found;
    EXPECT_GT(std::stod((*found)[1]), x);
    EXPECT_GT(std::stod((*found)[2]), y) << "y points downwards";
}

TEST(CostFigure, hasAPlaceForNoErrorAndARemarkForWhatWasNotMeasured) {
    const LadderCost ladder{
        "scene-effects",
        "N",
        {rung("all", 1e-5, 0.0, true), rung("none", 1e-6, 0.01, true), rung("noisy", kNan, 0.01, false)}};
    const std::string svg = costSvg(ladder, "Effects");
    EXPECT_EQ(count(svg, "<circle"), 2U);
    EXPECT_NE(svg.find("noisy"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(CostFigure, ofNothingIsAnEmptyPicture) {
    EXPECT_EQ(count(costSvg({"a", "m", {}}, "A"), "<circle"), 0U);
    EXPECT_EQ(count(costSvg({"a", "m", {rung("all", kNan, kNan, false)}}, "A"), "<circle"), 0U);
}
