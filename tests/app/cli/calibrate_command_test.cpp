// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

struct Pixel {
    double u = 0.0;
    double v = 0.0;
};

/// An equidistant lens of 700 px a radian on the axis, 20 mm before the sensor frame, y flipped: no formula
/// is shared with the program.
Pixel seen(double x_m, double y_m, double z_m) {
    const double across_m = std::hypot(x_m, y_m);
    const double distance_px = 700.0 * std::atan2(across_m, z_m + 0.02);
    return {820.0 + distance_px * x_m / across_m, 616.0 - distance_px * y_m / across_m};
}

/// The shell's holes; every outlierth pixel is somewhere else (0: none); x and y of the points divided by a
/// factor; pixels with noise.
std::string pairsCsv(int outlier = 0, double holeFactor = 1.0, double noise_px = 0.0) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::string text = "u_px,v_px,x_m,y_m,z_m\n";
    int number = 0;
    for (int i = 0; i < 25; ++i) {
        for (int j = 0; j < 10; ++j, ++number) {
            const double angle = 2.0 * std::numbers::pi * i / 25.0;
            const double x_m = 0.025 * std::cos(angle);
            const double y_m = 0.025 * std::sin(angle);
            const double z_m = 0.002 + 0.096 * j / 9.0;
            Pixel pixel = seen(x_m, y_m, z_m);
            if (outlier > 0 && number % outlier == 0)
                pixel = {100.0 + 37.0 * (number % 40), 1000.0 - 23.0 * (number % 31)};
            pixel.u += noise_px * normal(random);
            pixel.v += noise_px * normal(random);
            char line[160];
            std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%.17g,%.17g\n", pixel.u, pixel.v,
                          x_m / holeFactor, y_m / holeFactor, z_m);
            text += line;
        }
    }
    return text;
}

class CalibrateCommand : public testing::Test {
protected:
    ProgramResult calibrate(const std::string& pairs, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"calibrate", m_folder.write("pairs.csv", pairs)});
        return run(options);
    }

    std::string cameraFile() {
        const ProgramResult result = calibrate(pairsCsv(), {"--out", m_folder.path("camera.json")});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return m_folder.path("camera.json");
    }

    static void expectError(const ProgramResult& result, int exitCode, const std::string& text) {
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }

    TemporaryFolder m_folder;
};

using LocateCommand = CalibrateCommand;

} // namespace

TEST_F(CalibrateCommand, jsonHasTheKeysOfTheFormat) {
    const ProgramResult result = calibrate(pairsCsv(), {"--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_EQ(answer["pairs"], 250);
    EXPECT_EQ(answer["kept"], 250);
    EXPECT_LT(answer["rms_px"].get<double>(), 0.02);
    EXPECT_LT(answer["mean_px"].get<double>(), 0.02);
    EXPECT_LT(answer["mean_mm"].get<double>(), 0.01);
    EXPECT_GT(answer["valid_radius_px"].get<double>(), 650.0);
    const ordered_json& camera = answer["camera"];
    EXPECT_EQ(camera["format"], "teleta-camera");
    EXPECT_EQ(camera["width_px"], 1640);
    EXPECT_EQ(camera["mirrored"], true);
    EXPECT_NEAR(camera["C_m"][2].get<double>(), -0.02, 1e-4);
    EXPECT_NEAR(camera["K"][0][0].get<double>(), 700.0, 1.0);
}

TEST_F(CalibrateCommand, leavesWrongPairsOutAndWritesEachWithItsResidual) {
    const ProgramResult result =
        calibrate(pairsCsv(5), {"--json", "--residuals", m_folder.path("residuals.csv")});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(ordered_json::parse(result.out)["kept"], 200);
    const auto rows = splitCsv(readAll(m_folder.path("residuals.csv")));
    ASSERT_EQ(rows.size(), 251U);
    EXPECT_EQ(rows[0],
              (std::vector<std::string>{"u_px", "v_px", "x_m", "y_m", "z_m", "kept", "du_px", "dv_px",
                                        "x_located_m", "y_located_m", "z_located_m", "error_m"}));
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_EQ(rows[i][5], (i - 1) % 5 == 0 ? "0" : "1") << i;
    EXPECT_LT(std::stod(rows[2][11]), 1e-5);
}

TEST_F(CalibrateCommand, thePaperMethodIsLinear) {
    const ProgramResult result = calibrate(pairsCsv(), {"--json", "--method", "paper"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_EQ(answer["method"], "paper");
    for (const auto& [key, value] : answer["camera"]["distortion"].items())
        EXPECT_EQ(value.get<double>(), 0.0) << key;
    // Without a lens model it cannot fit a lens of 160 degrees.
    EXPECT_GT(answer["rms_px"].get<double>(), 1.0);
}

TEST_F(CalibrateCommand, aCameraWithoutALensIsWrittenWithAWarning) {
    const std::string path = m_folder.path("camera.json");
    const ProgramResult paper = calibrate(pairsCsv(), {"--method", "paper", "--out", path});
    EXPECT_EQ(paper.exitCode, 0) << paper.err;
    EXPECT_NE(paper.err.find("has no lens"), std::string::npos) << paper.err;
    const ProgramResult robust = calibrate(pairsCsv(), {"--out", path});
    EXPECT_EQ(robust.exitCode, 0);
    EXPECT_EQ(robust.err, "");
}

TEST_F(CalibrateCommand, holesOfTheShellAreBroughtOntoTheElastomer) {
    constexpr double kFactor = 0.97; // of the paper
    const std::string direct = pairsCsv();
    const std::string holes = pairsCsv(0, kFactor);
    const ProgramResult expected = calibrate(direct, {"--json"});
    const ProgramResult result = calibrate(holes, {"--json", "--hole-factor", "0.97"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json camera = ordered_json::parse(result.out)["camera"];
    const ordered_json same = ordered_json::parse(expected.out)["camera"];
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(camera["C_m"][i].get<double>(), same["C_m"][i].get<double>(), 1e-6);
    EXPECT_EQ(camera["cylinder"], same["cylinder"]);
    expectError(calibrate(direct, {"--hole-factor", "0"}), 2, "--hole-factor");
}

TEST_F(CalibrateCommand, aForgottenHoleFactorIsToldWithTheOneThatFits) {
    const std::string holes = pairsCsv(0, 0.97, 0.4);
    const ProgramResult table = calibrate(holes);
    EXPECT_EQ(table.exitCode, 0) << table.err;
    for (const char* text : {"Reliable", "Warning", "25.77 mm from the axis", "a hole factor of 0.97 "})
        EXPECT_NE(table.out.find(text), std::string::npos) << text << " in\n" << table.out;
    const ordered_json answer = ordered_json::parse(calibrate(holes, {"--json"}).out);
    EXPECT_EQ(answer["reliable"], false);
    EXPECT_EQ(answer["warnings"], ordered_json::array({"off_surface"}));
    EXPECT_EQ(answer["camera"]["calibration"]["warnings"], answer["warnings"]);
    EXPECT_NEAR(answer["fitting_hole_factor"].get<double>(), 0.97, 1e-9);
    EXPECT_LT(answer["fitting_hole_factor_se"].get<double>(), 1e-9);
    const ordered_json right = ordered_json::parse(calibrate(holes, {"--json", "--hole-factor", "0.97"}).out);
    EXPECT_EQ(right["reliable"], true);
    EXPECT_EQ(right["warnings"], ordered_json::array());
    EXPECT_NEAR(right["fitting_hole_factor"].get<double>(), 0.97, 1e-9);
    // The other way round: the points are on the elastomer already.
    const ordered_json twice =
        ordered_json::parse(calibrate(pairsCsv(0, 1.0, 0.4), {"--json", "--hole-factor", "0.97"}).out);
    EXPECT_EQ(twice["warnings"], ordered_json::array({"off_surface"}));
    EXPECT_NEAR(twice["fitting_hole_factor"].get<double>(), 1.0, 1e-9);
}

TEST_F(CalibrateCommand, swappedPixelsAreTold) {
    std::string swapped = pairsCsv(0, 1.0, 0.4);
    swapped.replace(0, swapped.find(",x_m"), "v_px,u_px");
    const ProgramResult table = calibrate(swapped);
    EXPECT_EQ(table.exitCode, 0) << table.err;
    EXPECT_NE(table.out.find("u and v seem to be swapped"), std::string::npos) << table.out;
    const ordered_json answer = ordered_json::parse(calibrate(swapped, {"--json"}).out);
    EXPECT_EQ(answer["warnings"], ordered_json::array({"swapped_pixels"}));
    EXPECT_EQ(answer["reliable"], false);
}

TEST_F(CalibrateCommand, printsATableForPeople) {
    const ProgramResult result = calibrate(pairsCsv());
    EXPECT_EQ(result.exitCode, 0);
    for (const char* text : {"Pairs", "Kept", "Valid radius", "Mirrored", "yes"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " in\n" << result.out;
}

TEST_F(CalibrateCommand, degeneratePairsAreRefusedInWords) {
    std::string ring = "u_px,v_px,x_m,y_m,z_m\n";
    for (int i = 0; i < 20; ++i) {
        const double angle = 0.3 * i;
        const Pixel pixel = seen(0.025 * std::cos(angle), 0.025 * std::sin(angle), 0.05);
        char line[160];
        std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%.17g,0.05\n", pixel.u, pixel.v,
                      0.025 * std::cos(angle), 0.025 * std::sin(angle));
        ring += line;
    }
    expectError(calibrate(ring), 1, "ring");
    expectError(calibrate("u_px,v_px,x_m,y_m,z_m\n1,2,3,4,5\n"), 1, "too few pairs: 1");
}

TEST_F(CalibrateCommand, wrongUsageAndBadInputHaveTheirExitCodes) {
    expectError(calibrate(pairsCsv(), {"--method", "guess"}), 2, "--method");
    expectError(calibrate(pairsCsv(), {"--radius-mm", "0"}), 2, "--radius-mm");
    expectError(calibrate(pairsCsv(), {"--width", "-1"}), 2, "--width");
    expectError(calibrate(pairsCsv(), {"--width", "16385"}), 2, "--width"); // no camera file may say it
    expectError(run({"calibrate"}), 2, "pairs");
    expectError(calibrate("u_px,v_px,x_m,y_m,z_m\n1,2,3,4,abc\n"), 3, "pairs.csv:2:9:");
    expectError(calibrate("u_px,v_px,x_m,y_m,z_m\n1,2,3,4,nan\n"), 3, "pairs.csv:2:9:");
    expectError(calibrate("u_px,v_px,x_m,y_m\n1,2,3,4\n"), 3, "z_m");
    expectError(calibrate(pairsCsv(), {"--out", m_folder.path("absent/camera.json")}), 1, "absent");
}

TEST_F(CalibrateCommand, doesNotReplaceThePairs) {
    const std::string pairs = m_folder.path("pairs.csv");
    expectError(calibrate(pairsCsv(), {"--out", pairs}), 2, "--out");
    expectError(calibrate(pairsCsv(), {"--residuals", pairs}), 2, "--residuals");
    const std::string both = m_folder.path("both");
    expectError(calibrate(pairsCsv(), {"--out", both, "--residuals", both}), 2, "--residuals");
    EXPECT_EQ(readAll(pairs), pairsCsv());
}

TEST_F(LocateCommand, tellsThePointAndItsDeviationOfEachPixel) {
    const Pixel a = seen(0.025, 0.0, 0.03);
    const Pixel b = seen(0.0, -0.025, 0.09);
    char pixels[200];
    std::snprintf(pixels, sizeof pixels, "u_px,v_px\n%.17g,%.17g\n%.17g,%.17g\n820,616\n1e6,0\n", a.u, a.v,
                  b.u, b.v);
    const ProgramResult result = run({"locate", cameraFile(), m_folder.write("pixels.csv", pixels)});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = splitCsv(result.out);
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"x_m", "y_m", "z_m", "sd_m"}));
    const double expected[2][3] = {{0.025, 0.0, 0.03}, {0.0, -0.025, 0.09}};
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(std::stod(rows[i + 1][k]), expected[i][k], 2e-5) << i << " " << k;
        EXPECT_GT(std::stod(rows[i + 1][3]), 0.0);
    }
    // Along the axis and outside the valid radius there is nothing.
    for (std::size_t i = 3; i < 5; ++i)
        EXPECT_EQ(rows[i], (std::vector<std::string>{"NA", "NA", "NA", "NA"}));
}

TEST_F(LocateCommand, wrongUsageAndBadInputHaveTheirExitCodes) {
    const std::string camera = cameraFile();
    const std::string pixels = m_folder.write("pixels.csv", "u_px,v_px\n1,2\n3,x\n");
    const ProgramResult damaged = run({"locate", camera, pixels, "--out", m_folder.path("out.csv")});
    expectError(damaged, 3, "pixels.csv:3:3:");
    expectError(run({"locate", camera}), 2, "pixels");
    expectError(run({"locate", m_folder.path("absent.json"), pixels}), 3, "absent.json");
    expectError(run({"locate", m_folder.write("bad.json", "{\n\"format\": 3}"), pixels}), 3, "bad.json:2:");
}
