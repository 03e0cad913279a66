// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/backend/contour/contour_points.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>

using nlohmann::ordered_json;
using teleta::contour::circlePoints;
using teleta::contour::Points;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

std::string csvOf(const Points& points) {
    std::string text = "x_m,y_m\n";
    char line[80];
    for (const auto& p : points) {
        std::snprintf(line, sizeof line, "%.17g,%.17g\n", p.x(), p.y());
        text += line;
    }
    return text;
}

class ContourCommand : public testing::Test {
protected:
    ProgramResult contour(const std::string& points, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"contour", m_folder.write("points.csv", points)});
        return run(options);
    }

    ordered_json json(const std::string& points, std::vector<std::string> options = {}) {
        options.push_back("--json");
        const ProgramResult result = contour(points, options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return ordered_json::parse(result.out, nullptr, false);
    }

    void expectError(const ProgramResult& result, int exitCode, const std::string& text) {
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }

    TemporaryFolder m_folder;
};

const std::string kRectangle =
    "x_m,y_m\n0,0\n0.02,0\n0.04,0\n0.06,0\n0.06,0.02\n0.06,0.04\n0.04,0.04\n0.02,0.04\n"
    "0,0.04\n0,0.02\n";

} // namespace

TEST_F(ContourCommand, jsonHasTheKeysOfTheFormatInTheirOrder) {
    const ordered_json answer = json(csvOf(circlePoints(12, 0.05)));
    std::vector<std::string> keys;
    for (const auto& [key, value] : answer.items())
        keys.push_back(key);
    EXPECT_EQ(keys,
              (std::vector<std::string>{"points", "shape", "confidence", "candidates", "probabilities",
                                        "closed", "length_m", "vertices", "circle", "max_curvature_per_m"}));
    keys.clear();
    for (const auto& [key, value] : answer["probabilities"].items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"circle", "rectangle", "triangle", "arc", "line", "point",
                                              "unknown"}));
    keys.clear();
    for (const auto& [key, value] : answer["circle"].items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"x", "y", "radius", "rms"}));
}

TEST_F(ContourCommand, recognisesACircle) {
    const ordered_json answer = json(csvOf(circlePoints(24, 0.05)), {"--spline", "interpolating"});
    EXPECT_EQ(answer["points"], 24);
    EXPECT_EQ(answer["shape"], "circle");
    EXPECT_EQ(answer["closed"], true);
    EXPECT_GT(answer["confidence"].get<double>(), 0.9);
    EXPECT_NEAR(answer["circle"]["radius"].get<double>(), 0.05, 1e-12);
    EXPECT_NEAR(answer["circle"]["x"].get<double>(), 0.0, 1e-12);
    EXPECT_TRUE(answer["vertices"].empty());
    EXPECT_NEAR(answer["length_m"].get<double>(), 2.0 * std::numbers::pi * 0.05, 1e-5);
    EXPECT_NEAR(answer["max_curvature_per_m"].get<double>(), 20.0, 0.5);
}

TEST_F(ContourCommand, recognisesARectangleAndItsVertices) {
    const ordered_json answer = json(kRectangle);
    EXPECT_EQ(answer["shape"], "rectangle");
    EXPECT_TRUE(answer["circle"].is_null());
    ASSERT_EQ(answer["vertices"].size(), 4U);
    double area2_m2 = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& a = answer["vertices"][i];
        const auto& b = answer["vertices"][(i + 1) % 4];
        area2_m2 += a[0].get<double>() * b[1].get<double>() - a[1].get<double>() * b[0].get<double>();
    }
    EXPECT_NEAR(area2_m2, 2.0 * 0.06 * 0.04, 1e-12);
}

TEST_F(ContourCommand, namesTheCandidatesWhenThePointsDoNotDecide) {
    const std::string square = "x_m,y_m\n0.03,0\n0.06,0.03\n0.03,0.06\n0,0.03\n";
    const ordered_json answer = json(square);
    ASSERT_GT(answer["candidates"].size(), 1U);
    EXPECT_EQ(answer["candidates"][0], answer["shape"]);
    EXPECT_EQ(answer["probabilities"][answer["shape"].get<std::string>()], answer["confidence"]);
    double sum = 0.0;
    for (const auto& [key, value] : answer["probabilities"].items())
        sum += value.get<double>();
    EXPECT_NEAR(sum, 1.0, 1e-12);
    const ProgramResult table = contour(square);
    EXPECT_NE(table.out.find("Candidates"), std::string::npos) << table.out;
    EXPECT_EQ(json(kRectangle)["candidates"], ordered_json::array({"rectangle"}));
}

TEST_F(ContourCommand, theResolutionMakesAPoint) {
    const std::string points = csvOf(circlePoints(12, 0.005));
    EXPECT_EQ(json(points)["shape"], "circle");
    EXPECT_EQ(json(points, {"--resolution-m", "0.02"})["shape"], "point");
    EXPECT_EQ(json("x_m,y_m\n0.1,0.2\n")["shape"], "point");
}

TEST_F(ContourCommand, approximatingIsTheDefaultAndCutsCorners) {
    // Eq. (10): at 12 points the curve is 4.49 % inside the circle between the points, and a little less at
    // them.
    const std::string points = csvOf(circlePoints(12, 0.05));
    const double length_m = json(points)["length_m"];
    EXPECT_EQ(json(points, {"--spline", "approximating"})["length_m"], length_m);
    EXPECT_NEAR(length_m / (2.0 * std::numbers::pi * 0.05), 1.0 - 0.0449, 0.001);
}

TEST_F(ContourCommand, closedAsToldAddsTheClosingSegment) {
    const std::string line = "x_m,y_m\n0,0\n0.03,0\n0.06,0\n0.09,0\n";
    EXPECT_EQ(json(line)["shape"], "line");
    EXPECT_EQ(json(line)["closed"], false);
    EXPECT_NEAR(json(line)["length_m"].get<double>(), 0.09, 1e-12);
    EXPECT_EQ(json(line)["max_curvature_per_m"], 0.0);
    const ordered_json told = json(line, {"--closed"});
    EXPECT_EQ(told["closed"], true);
    EXPECT_GT(told["length_m"].get<double>(), 0.1);
}

TEST_F(ContourCommand, writesTheCurve) {
    const std::string path = m_folder.path("curve.csv");
    const ProgramResult result = contour(csvOf(circlePoints(12, 0.05)),
                                         {"--spline", "interpolating", "--samples", "13", "--curve", path});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const auto rows = teleta::test::splitCsv(text.str());
    ASSERT_EQ(rows.size(), 14U);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"t", "x_m", "y_m", "curvature_per_m"}));
    const Points points = circlePoints(12, 0.05);
    for (std::size_t i = 0; i <= 12; ++i) {
        EXPECT_NEAR(std::stod(rows[i + 1][0]), static_cast<double>(i) / 12.0, 1e-15);
        EXPECT_NEAR(std::stod(rows[i + 1][1]), points[i % 12].x(), 1e-15);
        EXPECT_NEAR(std::stod(rows[i + 1][2]), points[i % 12].y(), 1e-15);
        EXPECT_NEAR(std::stod(rows[i + 1][3]), 20.0, 0.5);
    }
}

TEST_F(ContourCommand, printsATableForPeople) {
    const ProgramResult result = contour(kRectangle);
    EXPECT_EQ(result.exitCode, 0);
    for (const char* text : {"rectangle", "Points", "Length", "Vertex 4", "confidence"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " in\n" << result.out;
}

TEST_F(ContourCommand, wrongUsageIsExitCodeTwo) {
    expectError(contour(kRectangle, {"--spline", "guess"}), 2, "--spline");
    expectError(contour(kRectangle, {"--samples", "1"}), 2, "--samples");
    expectError(contour(kRectangle, {"--resolution-m", "0"}), 2, "--resolution-m");
    expectError(run({"contour"}), 2, "points");
}

TEST_F(ContourCommand, badInputIsExitCodeThreeWithItsPlace) {
    expectError(contour("x_m,y_m\n0,0\n1,abc\n"), 3, "points.csv:3:3:");
    expectError(contour("x_m,y_m\n0,nan\n"), 3, "points.csv:2:3:");
    expectError(contour("x_m,z_m\n0,0\n"), 3, "y_m");
    expectError(contour("x_m,y_m\n"), 3, "no points");
    expectError(contour("x_m,y_m\n0,1e200\n"), 3, "too large");
    expectError(run({"contour", m_folder.path("absent.csv")}), 3, "absent.csv");
}

TEST_F(ContourCommand, aCurveThatCannotBeWrittenIsExitCodeOne) {
    expectError(contour(kRectangle, {"--curve", m_folder.path("absent/curve.csv")}), 1, "absent");
}
