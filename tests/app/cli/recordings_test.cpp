// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;

namespace {

/// One of the two pressure arrays with which the postures of one person were recorded.
struct Array {
    std::string name;
    int rows = 0;
    int columns = 0;
    bool inverted = false;
    double threshold = 0.0; ///< in raw units, above the idle noise
};

const Array kSensomatt{"sensomatt", 12, 6, true, 20.05};
const Array kTactilus{"tactilus", 64, 27, false, 5.05};
constexpr double kPitch_m = 0.01;
constexpr double kSingle = 0x1p-24; ///< relative rounding of single precision

/// What the frames give when the definitions are written down plainly: tare = column means of the unloaded
/// file, load = max(0, +-(raw - tare)) and sums over the taxels.
struct Expectation {
    double time_s = 0.0;
    double force = 0.0;
    double momentX = 0.0, momentY = 0.0;
    int active = 0;
    double activeForce = 0.0;
    double activeX = 0.0, activeY = 0.0; ///< sums of the coordinates
    double peak = 0.0;
    double rounding = 0.0; ///< how far single precision of tare and load may move the force
};

class Recordings : public testing::TestWithParam<std::tuple<Array, std::string>> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(file("empty1")))
            GTEST_SKIP() << "skipped: the recordings are not here";
    }

    static std::string file(const std::string& posture) {
        return TELETA_SOURCE_DIR "/../shared/data/popu/" + array().name + '_' + posture + ".csv";
    }
    static const Array& array() { return std::get<0>(GetParam()); }
    static const std::string& posture() { return std::get<1>(GetParam()); }

    static std::vector<std::vector<std::string>> rowsOf(const std::string& command) {
        std::vector<std::string> arguments{command,       file(posture()),
                                           "--rows",      std::to_string(array().rows),
                                           "--columns",   std::to_string(array().columns),
                                           "--pitch-mm",  "10",
                                           "--threshold", std::to_string(array().threshold),
                                           "--tare",      file("empty1")};
        if (array().inverted)
            arguments.emplace_back("--invert");
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        std::vector<std::vector<std::string>> rows = splitCsv(result.out);
        rows.erase(rows.begin());
        return rows;
    }

    static std::vector<Expectation> expectations() {
        const auto unloaded = splitCsv(readAll(file("empty1")));
        std::vector<double> tare(unloaded[0].size() - 1, 0.0);
        for (std::size_t row = 1; row < unloaded.size(); ++row)
            for (std::size_t i = 0; i < tare.size(); ++i)
                tare[i] += std::stod(unloaded[row][i + 1]) / static_cast<double>(unloaded.size() - 1);

        std::vector<Expectation> result;
        const auto frames = splitCsv(readAll(file(posture())));
        for (std::size_t row = 1; row < frames.size(); ++row) {
            Expectation& expected = result.emplace_back();
            expected.time_s = std::stod(frames[row][0]);
            for (std::size_t i = 0; i < tare.size(); ++i) {
                const double change = std::stod(frames[row][i + 1]) - tare[i];
                const double load = std::max(0.0, array().inverted ? -change : change);
                const auto taxel = static_cast<int>(i);
                const double x_m = (taxel % array().columns - (array().columns - 1) / 2.0) * kPitch_m;
                const double y_m = (taxel / array().columns - (array().rows - 1) / 2.0) * kPitch_m;
                expected.rounding += kSingle * (std::abs(tare[i]) + load);
                expected.force += load;
                expected.momentX += load * x_m;
                expected.momentY += load * y_m;
                // A load that is the threshold but for the rounding of the mean could go either way; the
                // thresholds above are no tenths, which the means of ten whole numbers are, so none comes
                // near.
                if (load >= array().threshold) {
                    ++expected.active;
                    expected.activeForce += load;
                    expected.activeX += x_m;
                    expected.activeY += y_m;
                }
                expected.peak = std::max(expected.peak, load);
            }
        }
        return result;
    }
};

} // namespace

TEST_P(Recordings, haveTheFeaturesThatPlainSumsGive) {
    const auto rows = rowsOf("features");
    const std::vector<Expectation> expected = expectations();
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Expectation& e = expected[i];
        const double extent_m = kPitch_m * std::max(array().rows, array().columns);
        EXPECT_EQ(std::stod(rows[i][0]), e.time_s);
        EXPECT_NEAR(std::stod(rows[i][2]), e.force, e.rounding);
        ASSERT_EQ(std::stoi(rows[i][12]), e.active) << "frame " << i;
        if (e.active == 0) {
            EXPECT_EQ(rows[i][1], "none");
            for (const std::size_t centre : {3, 4, 5, 6, 7, 8})
                EXPECT_EQ(rows[i][centre], "NA");
            continue;
        }
        // Each moment is off by the rounding times half the extent at most, its quotient with the force twice
        // that.
        const double tolerance_m = extent_m * e.rounding / e.force;
        EXPECT_NEAR(std::stod(rows[i][3]), e.momentX / e.force, tolerance_m);
        EXPECT_NEAR(std::stod(rows[i][4]), e.momentY / e.force, tolerance_m);
        const double cocX_m = e.activeX / e.active;
        const double cocY_m = e.activeY / e.active;
        EXPECT_NEAR(std::stod(rows[i][5]), cocX_m, 1e-12);
        EXPECT_NEAR(std::stod(rows[i][6]), cocY_m, 1e-12);
        EXPECT_NEAR(std::stod(rows[i][7]), e.momentY / e.force - cocY_m, tolerance_m);
        EXPECT_NEAR(std::stod(rows[i][8]), e.momentX / e.force - cocX_m, tolerance_m);
    }
}

TEST_P(Recordings, haveContactsThatShareAllActiveTaxels) {
    const auto rows = rowsOf("contacts");
    std::size_t row = 0;
    for (const Expectation& e : expectations()) {
        double force = 0.0;
        double area_m2 = 0.0;
        double peak = 0.0;
        for (; row < rows.size() && std::stod(rows[row][0]) == e.time_s; ++row) {
            force += std::stod(rows[row][4]);
            peak = std::max(peak, std::stod(rows[row][5]));
            area_m2 += std::stod(rows[row][6]);
            EXPECT_LE(std::abs(std::stod(rows[row][2])), kPitch_m * (array().columns - 1) / 2.0);
            EXPECT_LE(std::abs(std::stod(rows[row][3])), kPitch_m * (array().rows - 1) / 2.0);
        }
        EXPECT_NEAR(force, e.activeForce, e.rounding);
        EXPECT_NEAR(area_m2, e.active * kPitch_m * kPitch_m, 1e-9);
        EXPECT_NEAR(peak, e.active > 0 ? e.peak : 0.0, e.rounding);
    }
    EXPECT_EQ(row, rows.size());
}

INSTANTIATE_TEST_SUITE_P(Popu, Recordings,
                         testing::Combine(testing::Values(kSensomatt, kTactilus),
                                          testing::Values("empty1", "left1", "prone2", "right3", "supine1",
                                                          "sequence")),
                         [](const auto& instance) {
                             return std::get<0>(instance.param).name + '_' + std::get<1>(instance.param);
                         });
