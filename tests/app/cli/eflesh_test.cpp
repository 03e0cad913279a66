// SPDX-License-Identifier: GPL-3.0-or-later
// Five magnetometers under a soft skin that a probe presses (../shared/data/eflesh). The file does not say in
// which unit the load is; it stands in the column force_n here, and all errors are shares of the largest
// load.
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

using Rows = std::vector<std::vector<std::string>>;

const std::string kFolder = TELETA_SOURCE_DIR "/../shared/data/eflesh/";
constexpr std::size_t kChips = 5;
constexpr std::size_t kNumbers = 3 * kChips;

/// The chips' places are not known; they stand off a grid.
const std::string kDescription = "kind = 'taxels'\nname = 'eflesh'\nthreshold = 40.0\n"
                                 "[link]\ntype = 'file'\npath = '" +
                                 kFolder +
                                 "sensor.csv'\n"
                                 "[frame]\nencoding = 'csv'\ncolumns = '2..16'\ntime_column = 1\n"
                                 "[layout]\ncomponents = 3\nunit = '\u00b5T'\n"
                                 "positions_mm = [[0, 0], [7, 1], [-7, 0], [1, 7], [0, -6.5]]\n";

class Eflesh : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kFolder + "sensor.csv"))
            GTEST_SKIP() << "skipped: the recording is not here";
        m_sensor = splitCsv(readAll(kFolder + "sensor.csv"));
        m_states = splitCsv(readAll(kFolder + "states.csv"));
        ASSERT_EQ(m_sensor.size(), 3600U);
        ASSERT_EQ(m_states.size(), 3600U);
    }

    /// Runs a command on the recording.
    ProgramResult ofRecording(std::vector<std::string> arguments) {
        const std::string layout = m_folder.write("eflesh.toml", kDescription);
        arguments.insert(arguments.begin() + 1, kFolder + "sensor.csv");
        arguments.insert(arguments.end(), {"--layout", layout, "--columns", "2..16", "--time-column", "1",
                                           "--tare", "median"});
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return result;
    }

    /// What a calibration of x, y and z of a chip with the first half of the presses makes of the second one,
    /// against the loads: root of the mean square, as a share of the largest load.
    double errorOf(const Rows& frames, std::size_t chip) {
        constexpr std::size_t kComponents = 3;
        const std::size_t column0 = 1 + kComponents * chip;
        std::string header;
        for (std::size_t i = 0; i < kComponents; ++i)
            header += frames[0][column0 + i] + ',';
        std::vector<std::string> rows;
        std::vector<double> loads;
        for (std::size_t frame = 0; frame < m_states.size(); ++frame) {
            const double load = std::stod(m_states[frame][4]);
            if (load < 0.0)
                continue; // there is none
            std::string row;
            for (std::size_t i = 0; i < kComponents; ++i)
                row += frames[frame + 1][column0 + i] + ',';
            rows.push_back(row + m_states[frame][4] + '\n');
            loads.push_back(load);
        }
        const std::size_t half = rows.size() / 2;
        std::string first = header + "force_n\n";
        std::string second = header + "load\n";
        for (std::size_t i = 0; i < rows.size(); ++i)
            (i < half ? first : second) += rows[i];
        std::string signals = header.substr(0, header.size() - 1);
        const std::string calibration = m_folder.path("newtons.csv");
        const ProgramResult fitted = run(
            {"loads", "fit", m_folder.write("first.csv", first), "--signals", signals, "--out", calibration});
        EXPECT_EQ(fitted.exitCode, 0) << fitted.err;
        const ProgramResult applied =
            run({"loads", "apply", calibration, m_folder.write("second.csv", second)});
        EXPECT_EQ(applied.exitCode, 0) << applied.err;
        const Rows found = splitCsv(applied.out);
        EXPECT_EQ(found.size(), rows.size() - half + 1);
        const auto column = std::ranges::find(found[0], "force_n") - found[0].begin();
        double sum = 0.0;
        double largest = 0.0;
        for (std::size_t i = 1; i < found.size(); ++i) {
            const double load = loads[half + i - 1];
            sum += std::pow(std::stod(found[i].at(static_cast<std::size_t>(column))) - load, 2);
            largest = std::max(largest, load);
        }
        return std::sqrt(sum / static_cast<double>(found.size() - 1)) / largest;
    }

    TemporaryFolder m_folder;
    Rows m_sensor;
    Rows m_states;
};

} // namespace

TEST_F(Eflesh, theLoadIsWhatTheFieldFallsBelowItsMedian) {
    std::vector<float> rest; // of z of each chip
    for (std::size_t chip = 0; chip < kChips; ++chip) {
        std::vector<float> values;
        for (const auto& row : m_sensor)
            values.push_back(std::stof(row[3 + 3 * chip]));
        std::ranges::sort(values);
        rest.push_back(0.5F * (values[1799] + values[1800]));
    }
    const Rows rows = splitCsv(ofRecording({"features", "--threshold", "40"}).out);
    ASSERT_EQ(rows.size(), 3601U);
    ASSERT_EQ(rows[0][2], "force_ut");
    ASSERT_EQ(rows[0][13], "shear_x_ut");
    for (std::size_t i = 0; i < m_sensor.size(); ++i) {
        double load = 0.0;
        for (std::size_t chip = 0; chip < kChips; ++chip)
            load += static_cast<double>(std::max(0.0F, rest[chip] - std::stof(m_sensor[i][3 + 3 * chip])));
        ASSERT_NEAR(std::stod(rows[i + 1][2]), load, 0.02) << "row " << i;
    }
}

TEST_F(Eflesh, aCalibrationOfOnePartGivesTheLoadsOfTheRest) {
    const std::string recording = m_folder.path("eflesh.teleta");
    (void)ofRecording({"import", "--out", recording});
    ASSERT_EQ(run({"export", recording, "--csv", m_folder.path("csv")}).exitCode, 0);
    const Rows frames = splitCsv(readAll(m_folder.path("csv/sensor-frames.csv")));
    ASSERT_EQ(frames.size(), 3601U);
    ASSERT_EQ(frames[0][1], "t0_x");
    ASSERT_EQ(frames[0][kNumbers], "t4_z");
    for (std::size_t i = 0; i < kNumbers; ++i)
        EXPECT_EQ(std::stof(frames[1000][i + 1]), std::stof(m_sensor[999][i + 1])) << i;
    // numpy.linalg.lstsq of the same rows gives these of 3293.42, the largest load.
    EXPECT_NEAR(errorOf(frames, 0), 151.14150253 / 3293.42, 1e-6);
    EXPECT_NEAR(errorOf(frames, 1), 120.07635948 / 3293.42, 1e-6);
}
