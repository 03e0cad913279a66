// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/taxels/taxel_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace teleta::taxels {
namespace {

/// A file with this layout whose frames have so many numbers.
core::Expected<TaxelsFile> withLayout(const std::string& layout, std::size_t numbers) {
    return parseTaxels(test::head() + test::serialLink("/dev/ttyUSB0") + "[layout]\n" + layout +
                           "\n[frame]\nencoding = 'json'\nvalues = '/v'\ncount = " + std::to_string(numbers) +
                           "\n",
                       "glove.toml");
}

std::vector<float> placed(const std::string& layout, std::size_t numbers) {
    const auto file = withLayout(layout, numbers);
    EXPECT_TRUE(file) << core::describe(file.error());
    if (!file)
        return {};
    std::vector<float> values(numbers);
    std::iota(values.begin(), values.end(), 1.0F);
    std::vector<float> loads(file->grid.layout().taxels());
    file->grid.place(values, loads);
    for (float& load : loads)
        load = std::isnan(load) ? -99.0F : load;
    return loads;
}

const std::string kTwoByThree = "rows = 2\ncolumns = 3\npitch_x_mm = 4.0\n";
constexpr float kNone = -99.0F;

TEST(TaxelGrid, takesTaxelsRowByRowOrColumnByColumn) {
    EXPECT_EQ(placed(kTwoByThree, 6), (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(placed(kTwoByThree + "order = 'column'", 6), (std::vector<float>{1, 3, 5, 2, 4, 6}));
    EXPECT_EQ(placed(kTwoByThree + "places = [5, 4, 3, 2, 1, 0]", 6), (std::vector<float>{6, 5, 4, 3, 2, 1}));
}

TEST(TaxelGrid, leavesPlacesWithoutATaxelUndefined) {
    EXPECT_EQ(placed(kTwoByThree + "mask = [0, 5]", 4), (std::vector<float>{kNone, 1, 2, 3, 4, kNone}));
    EXPECT_EQ(placed(kTwoByThree + "order = 'column'\nmask = [3]", 5),
              (std::vector<float>{1, 2, 4, kNone, 3, 5}));
    EXPECT_EQ(placed(kTwoByThree + "places = [2, 0]", 2),
              (std::vector<float>{2, kNone, 1, kNone, kNone, kNone}));
}

TEST(TaxelGrid, showsWhatPressesOfThreeComponents) {
    const std::string three = "rows = 1\ncolumns = 2\npitch_x_mm = 4.0\ncomponents = 3\n";
    // z out of the surface: what presses is a negative force along it.
    EXPECT_EQ(placed(three, 6), (std::vector<float>{-3, -6}));
    EXPECT_EQ(placed(three + "axes = ['+x', '-y', '-z']", 6), (std::vector<float>{3, 6}));
    EXPECT_EQ(placed(three + "axes = ['-z', '+x', '+y']", 6), (std::vector<float>{1, 4}));
}

TEST(TaxelGrid, putsACrossOnAGrid) {
    const std::string cross =
        "positions_mm = [[0, 0], [7, 0], [-7.0, 0], [0, 7.01], [0, -7]]"; // as of a ReSkin board, 0.1 % off
    EXPECT_EQ(placed(cross, 5), (std::vector<float>{kNone, 5, kNone, 3, 1, 2, kNone, 4, kNone}));
    const auto file = withLayout(cross, 5);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->grid.layout().rows, 3);
    EXPECT_EQ(file->grid.layout().columns, 3);
    EXPECT_NEAR(file->grid.layout().pitch_m, 0.007, 1e-5);
    EXPECT_EQ(placed("positions_mm = [[3, 4]]", 1), (std::vector<float>{1}));
}

TEST(TaxelGrid, takesPlacesOfOneColumnThatAreSlightlyOffIt) {
    const std::string square = "positions_mm = [[0, 0], [7, 0], [0.01, 7], [7, 7]]";
    EXPECT_EQ(placed(square, 4), (std::vector<float>{1, 2, 3, 4}));
    const auto file = withLayout(square, 4);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->grid.layout(), (core::ArrayLayout{2, 2, 0.007}));
    const auto column = withLayout("positions_mm = [[0.01, 0], [0, 3], [-0.01, 6.01], [0, 12]]", 4);
    ASSERT_TRUE(column) << core::describe(column.error());
    EXPECT_EQ(column->grid.layout().rows, 5);
    EXPECT_EQ(column->grid.layout().columns, 1);
}

TEST(TaxelGrid, saysWhatIsWrongWithALayout) {
    struct Case {
        std::string layout;
        std::size_t numbers;
        const char* words;
        long long line;
    };
    const std::vector<Case> cases{
        {kTwoByThree + "components = 2", 12, "three components", 11},
        {kTwoByThree + "components = 3\naxes = ['+x', '+y', '+y']", 18, "no three axes", 12},
        {kTwoByThree + "components = 3\naxes = ['x', '+y', '+z']", 18, "no three axes", 12},
        {kTwoByThree + "pitch_y_mm = 5.0", 6, "4 mm apart in x and 5 mm in y", 11},
        {kTwoByThree + "mask = [0, 1, 2, 3, 4, 5]", 1, "places without a taxel", 11},
        {kTwoByThree + "mask = [0.5]", 5, "places without a taxel", 11},
        {kTwoByThree + "mask = [6]", 5, "from 0 to 5", 11},
        {kTwoByThree + "mask = [-1]", 5, "at least 0", 11},
        {kTwoByThree + "mask = [2e6]", 5, "from 0 to 5", 11},
        {kTwoByThree + "places = [-1, 0]", 2, "at least 0", 11},
        {"positions_mm = [[nan, 0], [7, 0], [14, nan]]", 3, "-10000", 8},
        {kTwoByThree + "places = [0, 0]", 2, "places of taxels", 11},
        {kTwoByThree + "places = [0]\nmask = [1]", 1, "already where no taxel is", 12},
        {kTwoByThree, 7, "7 numbers, but the layout has 6 taxels with 1 each", 13},
        {"positions_mm = [[0, 0], [1, 0], [2.5, 0]]", 3, "no square grid", 8},
        {"positions_mm = [[0, 0], [0, 0]]", 2, "no square grid", 8},
        {"positions_mm = [[0, 0], [0, 0.001], [9000, 0]]", 3, "no square grid", 8},
        {"positions_mm = [[0, 0, 0]]", 1, "each of 2 numbers", 8},
    };
    for (const Case& known : cases) {
        const auto file = withLayout(known.layout, known.numbers);
        ASSERT_FALSE(file) << known.layout;
        EXPECT_NE(core::describe(file.error()).find(known.words), std::string::npos)
            << core::describe(file.error());
        EXPECT_EQ(file.error().where.line, known.line) << core::describe(file.error());
        EXPECT_GT(file.error().where.column, 0);
    }
}

} // namespace
} // namespace teleta::taxels
