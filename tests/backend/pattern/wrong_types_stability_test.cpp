// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are valid JSON but not of their format: every value of a good file is replaced by values of
// every other type; and endless nesting.
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/laws/law_checker.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace teleta::pattern;
using nlohmann::ordered_json;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

const std::string kData = std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/";

std::vector<ordered_json> otherValues() {
    std::string deep;
    for (int k = 0; k < 50; ++k)
        deep += "[{\"a\":";
    deep += "1";
    for (int k = 0; k < 50; ++k)
        deep += "}]";
    return {nullptr,
            true,
            "",
            "circle",
            std::string(100'000, 'x'),
            0,
            -1,
            7,
            9007199254740993LL,
            1e308,
            -1e308,
            0.5,
            ordered_json::array(),
            ordered_json::object(),
            ordered_json::array({1, 2, 3}),
            ordered_json(1000, ordered_json::array({0.1, 0.5})),
            ordered_json::parse(deep)};
}

void collect(const ordered_json& value, const ordered_json::json_pointer& here,
             std::vector<ordered_json::json_pointer>& all) {
    all.push_back(here);
    if (value.is_object()) {
        for (const auto& [key, child] : value.items())
            collect(child, here / key, all);
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i)
            collect(value[i], here / i, all);
    }
}

void expectSound(const Pattern& pattern) {
    ASSERT_TRUE(pattern.duration_s >= 0.0 && pattern.duration_s <= Pattern::kLongest_s);
    for (const double t_s : {0.0, 0.1, 0.5 * pattern.duration_s, pattern.duration_s}) {
        for (const double intensity : evaluate(pattern, t_s))
            EXPECT_TRUE(intensity >= 0.0 && intensity <= 1.0);
    }
    if (pattern.duration_s < 100.0)
        (void)checkLaws(pattern, assumedMotors());
}

class WrongType : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(WrongType, ofAnyValueIsRefusedWithItsPlaceOrReadAsAPatternThatIsSound) {
    const ordered_json good = ordered_json::parse(readAll(kData + GetParam()));
    std::vector<ordered_json::json_pointer> places;
    collect(good, ordered_json::json_pointer(), places);
    const std::vector<ordered_json> others = otherValues();
    const TemporaryFolder folder;
    int refused = 0;
    for (const ordered_json::json_pointer& place : places) {
        ordered_json wrong = good;
        for (const ordered_json& other : others) {
            wrong[place] = other;
            const std::string path = folder.write(GetParam(), wrong.dump());
            const Expected<Pattern> pattern = loadPattern(path);
            if (pattern) {
                expectSound(*pattern);
                continue;
            }
            ++refused;
            EXPECT_EQ(pattern.error().kind, ErrorKind::badInput) << place;
            EXPECT_EQ(pattern.error().where.file.substr(0, path.size()), path);
        }
        ordered_json without = good;
        if (!place.empty() && good.at(place.parent_pointer()).is_object()) {
            without.at(place.parent_pointer()).erase(place.back());
            const Expected<Pattern> pattern = loadPattern(folder.write(GetParam(), without.dump()));
            if (pattern)
                expectSound(*pattern);
        }
    }
    EXPECT_GT(refused, static_cast<int>(places.size()));
}

INSTANTIATE_TEST_SUITE_P(Formats, WrongType,
                         testing::Values("everything.json", "two_tactors.hjif", "emphasis.haptic",
                                         "dots.tact", "fades.tact", "taps.ahap", "paths.tact", "bands.hjif"));

TEST(DeepFile, ofEveryFormatIsRefused) {
    const TemporaryFolder folder;
    const std::string arrays(1'000'000, '[');
    std::string objects;
    for (int k = 0; k < 100'000; ++k)
        objects += "{\"tracks\":";
    for (const char* ending : {"json", "hjif", "haptic", "ahap", "tact"}) {
        for (const std::string& text : {arrays, objects}) {
            const Expected<Pattern> pattern = loadPattern(folder.write(std::string("a.") + ending, text));
            ASSERT_FALSE(pattern) << ending;
            EXPECT_EQ(pattern.error().kind, ErrorKind::badInput) << ending;
            EXPECT_EQ(pattern.error().where.line, 1) << ending;
        }
    }
    EXPECT_FALSE(loadPattern(folder.write("a.haptic.zip", arrays)));
}
