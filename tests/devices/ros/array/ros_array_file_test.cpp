// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/ros_array_file.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::ros_array {
namespace {

const std::string kShortest = "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
                              "format = \"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\n";

TEST(RosArrayFile, theShortestFileHasTheDefaults) {
    const auto file = parseRosArray(kShortest, "pad.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->format, ArrayFormat::float64MultiArray);
    EXPECT_EQ(file->layout, (core::ArrayLayout{14, 6, 0.0034}));
    EXPECT_EQ(file->unit, "N");
    EXPECT_EQ(file->scale, 1.0);
    EXPECT_EQ(file->threshold, 0.2);
    EXPECT_EQ(file->domain, dds::DomainConfig());
}

TEST(RosArrayFile, readsEveryKey) {
    const auto file = parseRosArray(
        "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/hand/tactile\"\nformat = \"TactileState\"\n"
        "sensor = \"palm\"\nrows = 4\ncols = 4\npitch_mm = 5\nunit = \"counts\"\nscale = -2.5\nthreshold = "
        "12\n"
        "rate_Hz = 100\n[ros]\ndomain = 7\ninterface = \"lo\"\npeers = [\"127.0.0.1\"]\n",
        "pad.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->format, ArrayFormat::tactileState);
    EXPECT_EQ(file->sensor, "palm");
    EXPECT_EQ(file->unit, "counts");
    EXPECT_EQ(file->scale, -2.5);
    EXPECT_EQ(file->threshold, 12.0);
    EXPECT_EQ(file->rate_Hz, 100.0);
    EXPECT_EQ(file->domain, (dds::DomainConfig{7, "lo", {"127.0.0.1"}}));
}

TEST(RosArrayFile, saysWhatIsWrongWhere) {
    for (const auto& [line, text] :
         {std::pair{"unit = \"counts\"\n", "threshold"}, std::pair{"scale = 0\n", "factor of 0"},
          std::pair{"sensor = \"palm\"\n", "TactileState"}, std::pair{"threshold = 0\n", "above 0"},
          std::pair{"columns = 6\n", "columns"}, std::pair{"[ros]\ndomain = 233\n", "232"}}) {
        const auto file = parseRosArray(kShortest + line, "pad.toml");
        ASSERT_FALSE(file) << line;
        EXPECT_NE(core::describe(file.error()).find(text), std::string::npos) << core::describe(file.error());
    }
    const auto topic =
        parseRosArray("kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"no topic\"\n", "pad.toml");
    ASSERT_FALSE(topic);
    EXPECT_EQ(topic.error().where.line, 3);
}

} // namespace
} // namespace teleta::ros_array
