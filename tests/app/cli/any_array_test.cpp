// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr double kTolerance = 1e-8; // loads are single precision

/// Two taxels 10 mm apart along x, with three values each.
constexpr const char* kTwoTaxels = "[layout]\ncomponents = 3\nrows = 1\ncolumns = 2\npitch_x_mm = 10\n";
/// 2 N on the left one and 1 N on the right one; pulled by 0.375 N to the right and by 0.5 N upwards. The
/// first frame is empty.
constexpr const char* kPulled = "time_s,t0_x,t0_y,t0_z,t1_x,t1_y,t1_z\n"
                                "0,0,0,0,0,0,0\n0.5,0.375,0,-2,0,0.5,-1\n";

class AnyArray : public testing::Test {
protected:
    /// The last row, by its column.
    std::map<std::string, std::string> lastRow(const std::vector<std::string>& arguments) {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        m_err = result.err;
        const auto rows = splitCsv(result.out);
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; rows.size() > 1 && i < rows[0].size(); ++i)
            row[rows[0][i]] = rows.back().at(i);
        return row;
    }
    [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
        return m_folder.write(name, text);
    }
    /// How the program refuses it.
    static std::string refusal(const std::vector<std::string>& arguments, int exitCode) {
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        return result.err;
    }
    /// What kPulled has, in this unit.
    static void expectPulled(const std::map<std::string, std::string>& row, const std::string& unit,
                             const std::string& momentUnit) {
        ASSERT_TRUE(row.contains("shear_x_" + unit));
        EXPECT_NEAR(std::stod(row.at("force_" + unit)), 3.0, kTolerance);
        EXPECT_NEAR(std::stod(row.at("shear_x_" + unit)), 0.375, kTolerance);
        EXPECT_NEAR(std::stod(row.at("shear_y_" + unit)), 0.5, kTolerance);
        // The centre of pressure is at x = (2 (-5) + 1 (5)) / 3 mm; 0.5 N act 5 + 5/3 mm right of it.
        EXPECT_NEAR(std::stod(row.at("moment_z_" + momentUnit)), 0.5 * (0.005 + 0.005 / 3.0), 1e-9);
        EXPECT_NEAR(std::stod(row.at("friction_ratio")), 0.625 / 3.0, kTolerance);
    }

    TemporaryFolder m_folder;
    std::string m_err;
};

} // namespace

TEST_F(AnyArray, aRawFileOfTekscanShowsCountsUntilAGainIsGiven) {
    const std::string frames =
        file("raw.asf", "ROWS 1\nCOLS 2\nROW_SPACING 5 mm\nCOL_SPACING 5 mm\nSECONDS_PER_FRAME 0.01\n"
                        "UNITS RAW\nASCII_DATA @@\nFrame 1\n30,10\n");
    const auto features = lastRow({"features", frames});
    EXPECT_EQ(features.at("force_counts"), "40");
    EXPECT_FALSE(features.contains("force_n"));
    EXPECT_NE(m_err.find("counts"), std::string::npos) << m_err;
    const auto contacts = lastRow({"contacts", frames});
    EXPECT_EQ(contacts.at("force_counts"), "40");
    EXPECT_EQ(contacts.at("peak_counts"), "30");
    EXPECT_FALSE(contacts.contains("force_n") || contacts.contains("peak_n"));

    const std::string noisy =
        file("noisy.asf", "ROWS 1\nCOLS 1\nROW_SPACING 5 mm\nCOL_SPACING 5 mm\nSECONDS_PER_FRAME 0.01\nUNITS "
                          "RAW\nNOISE_THRESHOLD 3\nASCII_DATA @@\nFrame 1\n30\n");
    EXPECT_EQ(lastRow({"features", noisy, "--gain", "1"}).at("force_n"), "30");
    EXPECT_NE(m_err.find("no effect: NOISE_THRESHOLD"), std::string::npos) << m_err;
    EXPECT_EQ(lastRow({"features", frames, "--gain", "0.5"}).at("force_n"), "20");
    EXPECT_EQ(m_err, "");
    EXPECT_EQ(lastRow({"features", frames, "--gain", "1"}).at("force_n"), "40") << "a gain of 1 is one";
    EXPECT_EQ(lastRow({"contacts", frames, "--gain", "0.5"}).at("peak_n"), "15");
}

TEST_F(AnyArray, vectorsComeInByALayout) {
    const std::string frames = file("pulled.csv", kPulled);
    const std::string layout = file("layout.toml", std::string(kTwoTaxels) + "unit = \"N\"\n");
    for (const std::string command : {"features", "contacts"}) {
        const auto row = lastRow({command, frames, "--layout", layout});
        EXPECT_EQ(m_err, "");
        EXPECT_EQ(row.at("time_s"), "0.5");
        expectPulled(row, "n", "nm");
    }
    EXPECT_EQ(lastRow({"contacts", frames, "--layout", layout}).at("contact_id"), "1");

    const std::string why = refusal({"features", frames}, 3);
    EXPECT_NE(why.find("vectors"), std::string::npos) << why;
    EXPECT_NE(why.find("--layout"), std::string::npos) << why;
    EXPECT_NE(refusal({"features", frames, "--layout", layout, "--rows", "1"}, 2).find("--layout"),
              std::string::npos);
    EXPECT_NE(refusal({"features", frames, "--layout", layout, "--summit"}, 2).find("--summit"),
              std::string::npos);
    EXPECT_NE(refusal({"features", frames, "--layout", m_folder.path("none.toml")}, 3).find("none.toml"),
              std::string::npos);
}

TEST_F(AnyArray, aFieldIsNeverShownInNewtons) {
    const std::string frames = file("pulled.csv", kPulled);
    const std::string layout = file("field.toml", std::string(kTwoTaxels) + "unit = \"\u00b5T\"\n");
    expectPulled(lastRow({"features", frames, "--layout", layout, "--threshold", "0.5"}), "ut", "ut_m");
    EXPECT_NE(m_err.find("\u00b5T"), std::string::npos) << m_err;
    expectPulled(lastRow({"contacts", frames, "--layout", layout, "--threshold", "0.5"}), "ut", "ut_m");
    // 0.2 of it is noise: the threshold is asked for, also in a recording.
    for (const std::vector<std::string>& command : {std::vector<std::string>{"features"},
                                                    {"contacts"},
                                                    {"import", "--out", m_folder.path("no.teleta")}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {frames, "--layout", layout});
        const std::string why = refusal(arguments, 2);
        EXPECT_NE(why.find("--threshold"), std::string::npos) << why;
        EXPECT_NE(why.find("\u00b5T"), std::string::npos) << why;
    }
    // The file of the layout can say it: of 2 and 1 uT one counts.
    const std::string told =
        file("told.toml", "threshold = 1.5\n" + std::string(kTwoTaxels) + "unit = \"\u00b5T\"\n");
    EXPECT_EQ(lastRow({"features", frames, "--layout", told}).at("active"), "1");
    EXPECT_EQ(lastRow({"features", frames, "--layout", told, "--threshold", "0.5"}).at("active"), "2");

    const std::string calibrated =
        file("calibrated.toml", std::string(kTwoTaxels) + "unit = \"\u00b5T\"\nnewtons_per_unit = 2\n");
    EXPECT_NEAR(std::stod(lastRow({"features", frames, "--layout", calibrated}).at("force_n")), 6.0,
                kTolerance);
    EXPECT_EQ(m_err, "");
}

TEST_F(AnyArray, newtonsThatTheFileSaysItselfAreNotMultiplied) {
    // 2 x 3 taxels in N; in the last frame they have 6, 6.25, ... 7.25.
    const std::string packed = TELETA_SOURCE_DIR "/tests/data/frames/packed.h5";
    const std::string grid = "[layout]\nrows = 2\ncolumns = 3\npitch_x_mm = 4\nnewtons_per_unit = 0.5\n";
    const std::string ofCounts = file("counts.toml", grid);
    // Here the layout corrects newtons.
    const std::string ofNewtons = file("newtons.toml", grid + "unit = \"N\"\n");
    const auto force_N = [&](const std::string& frames, const std::string& layout) {
        return std::stod(lastRow({"features", frames, "--layout", layout}).at("force_n"));
    };
    EXPECT_NEAR(force_N(packed, ofCounts), 39.75, 1e-5);
    EXPECT_NEAR(force_N(packed, ofNewtons), 39.75 / 2.0, 1e-5);
    // A table says no unit.
    const std::string table = file("table.csv", "time_s,t0,t1,t2,t3,t4,t5\n0,1,1,1,1,1,1\n");
    EXPECT_NEAR(force_N(table, ofCounts), 3.0, kTolerance);
    EXPECT_NEAR(force_N(table, ofNewtons), 3.0, kTolerance);
}

TEST_F(AnyArray, aDeviceFileTurnsTheAxesOfAnotherProgramsTable) {
    // The sensor comes first with what presses, then against y, then along x; and from the right.
    const std::string frames = file("foreign.csv", "t,a,b,c,d,e,f\n0,0,0,0,0,0,0\n500,1,-0.5,0,2,0,0.375\n");
    const std::string layout =
        file("layout.toml", std::string(kTwoTaxels) + "unit = \"N\"\naxes = [\"-z\", \"-y\", \"+x\"]\n"
                                                      "places = [1, 0]\n");
    const std::vector<std::string> options{"--layout",      layout, "--columns",   "2..7",
                                           "--time-column", "t",    "--time-unit", "ms"};
    std::vector<std::string> arguments{"features", frames};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectPulled(lastRow(arguments), "n", "nm");
    EXPECT_NE(refusal({"features", frames, "--layout", layout, "--columns", "2..6", "--time-column", "t"}, 3)
                  .find("6, as the layout has them"),
              std::string::npos);
}

TEST_F(AnyArray, placesOffAGridAreThoseOfTheLayout) {
    const std::string frames = file("skin.csv", "time_s,t0,t1,t2\n0,1,1,2\n");
    const std::string layout =
        file("skin.toml", "[layout]\nunit = \"N\"\npositions_mm = [[-7, -4], [5, -3], [0, 6]]\n");
    // The middle of the box is (-1, 1) mm.
    const auto row = lastRow({"features", frames, "--layout", layout});
    EXPECT_EQ(row.at("force_n"), "4");
    EXPECT_NEAR(std::stod(row.at("cop_x_m")), (1.0 * -6 + 1.0 * 6 + 2.0 * 1) / 4.0 * 1e-3, kTolerance);
    EXPECT_NEAR(std::stod(row.at("cop_y_m")), (1.0 * -5 + 1.0 * -4 + 2.0 * 5) / 4.0 * 1e-3, kTolerance);
    EXPECT_FALSE(row.contains("shear_x_n"));
    EXPECT_EQ(lastRow({"contacts", frames, "--layout", layout}).at("force_n"), "4");
}

TEST_F(AnyArray, aTareIsTakenOfAllComponents) {
    const std::string frames = file("pulled.csv", "time_s,t0_x,t0_y,t0_z,t1_x,t1_y,t1_z\n"
                                                  "0,5,6,7,8,9,10\n1,5,6,7,8,9,10\n2,5.375,6,5,8,9.5,9\n");
    const std::string layout = file("layout.toml", std::string(kTwoTaxels) + "unit = \"N\"\n");
    expectPulled(lastRow({"features", frames, "--layout", layout, "--tare", "median"}), "n", "nm");
    EXPECT_NE(refusal({"features", frames, "--layout", layout, "--tare", "untouched"}, 2).find("untouched"),
              std::string::npos);
}

TEST_F(AnyArray, aRecordingOfVectorsIsReplayedAndExportedAsSuch) {
    const std::string layout = file("field.toml", std::string(kTwoTaxels) + "unit = \"\u00b5T\"\n");
    const std::string recording = m_folder.path("pulled.teleta");
    const ProgramResult imported = run({"import", file("pulled.csv", kPulled), "--layout", layout,
                                        "--threshold", "0.5", "--out", recording, "--json"});
    ASSERT_EQ(imported.exitCode, 0) << imported.err;
    EXPECT_EQ(nlohmann::json::parse(imported.out)["components"], 3);
    const auto replayed = lastRow({"replay", recording});
    EXPECT_FALSE(replayed.contains("force_n"));
    expectPulled(replayed, "ut", "ut_m");

    const std::string npz = m_folder.path("pulled.npz");
    const ProgramResult exported = run({"export", recording, "--npz", npz, "--json"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    EXPECT_EQ(nlohmann::json::parse(exported.out)["shape"], nlohmann::json::parse("[2, 2, 3]"));
    expectPulled(lastRow({"features", npz, "--layout", layout, "--threshold", "0.5"}), "ut", "ut_m");
    // What is exported is in the order of {s}: a layout that turns axes does not turn it again.
    const std::string turning =
        file("turning.toml", std::string(kTwoTaxels) + "axes = [\"-z\", \"-y\", \"+x\"]\nunit = \"N\"\n");
    expectPulled(lastRow({"features", npz, "--layout", turning}), "n", "nm");
    EXPECT_NE(refusal({"features", npz}, 3).find("--layout"), std::string::npos);
}

TEST_F(AnyArray, aRecordingOfCountsIsReplayedInCounts) {
    const std::string recording = m_folder.path("counts.teleta");
    ASSERT_EQ(run({"import", file("counts.csv", "time_s,t0,t1\n0,0,0\n0.1,30,10\n"), "--rows", "1",
                   "--columns", "2", "--unit", "counts", "--out", recording})
                  .exitCode,
              0);
    const auto row = lastRow({"replay", recording});
    EXPECT_EQ(row.at("force_counts"), "40");
    EXPECT_FALSE(row.contains("force_n"));
}

TEST_F(AnyArray, placesOffAGridAreExportedWithTheirFrames) {
    const std::string recording = m_folder.path("skin.teleta");
    const std::string npz = m_folder.path("skin.npz");
    const std::string layout =
        file("skin.toml", "[layout]\nunit = \"N\"\npositions_mm = [[-7, -4], [5, -3], [0, 6]]\n");
    const std::string frames = file("skin.csv", "time_s,t0,t1,t2\n0,0,0,0\n1,1,1,2\n");
    ASSERT_EQ(run({"import", frames, "--layout", layout, "--out", recording}).exitCode, 0);
    const ProgramResult exported = run({"export", recording, "--npz", npz, "--json"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    EXPECT_EQ(nlohmann::json::parse(exported.out)["shape"], nlohmann::json::parse("[2, 3]"));
    EXPECT_EQ(lastRow({"features", npz, "--layout", layout}),
              lastRow({"features", frames, "--layout", layout}));
    EXPECT_NE(refusal({"features", npz}, 3).find("positions_m"), std::string::npos);
    // The same places from another origin are the same; taxels in another order, or others, are not.
    const std::string moved =
        file("moved.toml", "[layout]\nunit = \"N\"\npositions_mm = [[93, -4], [105, -3], [100, 6]]\n");
    EXPECT_EQ(lastRow({"features", npz, "--layout", moved}).at("force_n"), "4");
    const std::string swapped =
        file("swapped.toml", "[layout]\nunit = \"N\"\npositions_mm = [[5, -3], [-7, -4], [0, 6]]\n");
    const std::string why = refusal({"features", npz, "--layout", swapped}, 3);
    // The middle of the box is at x = -1 mm.
    EXPECT_NE(why.find("positions_m has taxel 0 at x = -6 mm, the layout at 6 mm"), std::string::npos) << why;
}
