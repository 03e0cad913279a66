// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/taxels/taxel_files.h"

#include <gtest/gtest.h>

#include <array>
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
    std::vector<float> loads(file->grid.layout().values());
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

TEST(TaxelGrid, turnsThreeComponentsIntoTheAxesOfTheArray) {
    const std::string three = "rows = 1\ncolumns = 2\npitch_x_mm = 4.0\ncomponents = 3\n";
    EXPECT_EQ(placed(three, 6), (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(placed(three + "axes = ['+x', '-y', '-z']", 6), (std::vector<float>{1, -2, -3, 4, -5, -6}));
    EXPECT_EQ(placed(three + "axes = ['-z', '+x', '+y']", 6), (std::vector<float>{2, 3, -1, 5, 6, -4}));
    EXPECT_EQ(placed("rows = 1\ncolumns = 2\npitch_x_mm = 4.0\ncomponents = 3\nmask = [0]", 3),
              (std::vector<float>{kNone, kNone, kNone, 1, 2, 3}));
}

TEST(TaxelGrid, knowsPitchesThatDiffer) {
    const auto file = withLayout(kTwoByThree + "pitch_y_mm = 5.0", 6);
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->grid.layout(), (core::ArrayLayout{2, 3, 0.004, 0.005}));
    const auto places = withLayout("positions_mm = [[0, 0], [4, 0], [0, 9], [4, 9]]", 4);
    ASSERT_TRUE(places) << core::describe(places.error());
    EXPECT_EQ(places->grid.layout(), (core::ArrayLayout{2, 2, 0.004, 0.009}));
}

TEST(TaxelGrid, saysWhereAGridHasNoTaxel) {
    const auto file = withLayout(kTwoByThree + "mask = [0, 5]", 4);
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->grid.layout().isAbsent(0));
    EXPECT_FALSE(file->grid.layout().isAbsent(1));
    EXPECT_TRUE(file->grid.layout().isAbsent(5));
}

TEST(TaxelGrid, leavesPlacesOffAGridWhereTheyAre) {
    const auto file = withLayout("components = 3\npositions_mm = [[0, 0], [4, 1], [9, 0]]\n"
                                 "heights_mm = [0, 2, 0]\nnormals = [[0, 0, 2], [0, 0, 1], [0.6, 0, 0.8]]",
                                 9);
    ASSERT_TRUE(file) << core::describe(file.error());
    const core::TaxelLayout layout = file->grid.layout();
    ASSERT_FALSE(layout.isGrid());
    EXPECT_EQ(layout.values(), 9U);
    const core::TaxelPlaces& places = *layout.places();
    // The middle of the box around them is the origin.
    EXPECT_NEAR(places[0].x_m, -0.0045, 1e-15);
    EXPECT_NEAR(places[1].x_m, -0.0005, 1e-15);
    EXPECT_NEAR(places[1].y_m, 0.0005, 1e-15);
    EXPECT_NEAR(places[1].z_m, 0.002, 1e-15);
    EXPECT_EQ(places[0].normal, (std::array<double, 3>{0.0, 0.0, 1.0}));
    EXPECT_NEAR(places[2].normal[0], 0.6, 1e-15);
    EXPECT_EQ(placed("positions_mm = [[0, 0], [1, 0], [2.5, 0]]", 3), (std::vector<float>{1, 2, 3}));
    EXPECT_FALSE(withLayout("positions_mm = [[0, 0], [0, 0.001], [9000, 0]]", 3)->grid.layout().isGrid())
        << "a grid of them would be nearly empty";
}

TEST(TaxelGrid, putsACrossOnAGrid) {
    const std::string cross =
        "positions_mm = [[0, 0], [7, 0], [-7.0, 0], [0, 7.01], [0, -7]]"; // as of a ReSkin board, 0.1 % off
    EXPECT_EQ(placed(cross, 5), (std::vector<float>{kNone, 5, kNone, 3, 1, 2, kNone, 4, kNone}));
    const auto file = withLayout(cross, 5);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->grid.layout().grid().rows, 3);
    EXPECT_EQ(file->grid.layout().grid().columns, 3);
    EXPECT_NEAR(file->grid.layout().grid().pitchX_m, 0.007, 1e-5);
    EXPECT_EQ(file->grid.layout().grid().aspect(), 1.0);
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
    EXPECT_EQ(column->grid.layout().grid().rows, 5);
    EXPECT_EQ(column->grid.layout().grid().columns, 1);
}

TEST(TaxelGrid, mayKnowWhatAUnitIsInNewtons) {
    const auto counts = withLayout(kTwoByThree + "unit = 'counts'\nnewtons_per_unit = 0.004", 6);
    ASSERT_TRUE(counts) << core::describe(counts.error());
    EXPECT_EQ(counts->grid.newtonsPerUnit(), 0.004);
    EXPECT_EQ(counts->grid.unit(), "counts");
    EXPECT_EQ(counts->grid.loadUnit(), "N");
    const auto field = withLayout(kTwoByThree + "unit = 'mT'", 6);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->grid.newtonsPerUnit(), std::nullopt);
    EXPECT_EQ(field->grid.loadUnit(), "mT") << "a unit that is no force is never shown as N";
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
        {kTwoByThree + "components = 3\naxes = ['+x', '+y', '+y']", 18, "not three distinct axes", 12},
        {kTwoByThree + "components = 3\naxes = ['x', '+y', '+z']", 18, "not three distinct axes", 12},
        {kTwoByThree + "pitch_y_mm = -5.0", 6, "above 0", 11},
        {kTwoByThree + "newtons_per_unit = 0.0", 6, "above 0", 11},
        {kTwoByThree + "mask = [0, 1, 2, 3, 4, 5]", 1, "this mask does not fit the array", 11},
        {kTwoByThree + "mask = [0.5]", 5, "this mask does not fit the array", 11},
        {kTwoByThree + "mask = [6]", 5, "from 0 to 5", 11},
        {kTwoByThree + "mask = [-1]", 5, "at least 0", 11},
        {kTwoByThree + "mask = [2e6]", 5, "from 0 to 5", 11},
        {kTwoByThree + "places = [-1, 0]", 2, "at least 0", 11},
        {"positions_mm = [[nan, 0], [7, 0], [14, nan]]", 3, "-10000", 8},
        {kTwoByThree + "places = [0, 0]", 2, "places of taxels", 11},
        {kTwoByThree + "places = [0]\nmask = [1]", 1, "already where no taxel is", 12},
        {kTwoByThree, 7, "7 numbers, but the layout has 6 taxels with 1 each", 13},
        {"positions_mm = [[0, 0], [4, 0], [0, 0]]", 3, "taxels 0 and 2 are at the same place", 8},
        {"positions_mm = [[0, 0], [4, 0]]\nheights_mm = [1]", 2, "there are 2 positions", 9},
        {"positions_mm = [[0, 0]]\nnormals = [[0, 0, 0]]", 1, "a normal is zero", 9},
        {"positions_mm = [[0, 0]]\nheights_mm = [inf]", 1, "-10000", 9},
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
