// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace teleta::pattern;
using teleta::core::Error;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

const std::string kData = std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/";

/// A pattern file with one line of text in place of the one that begins with the same key.
std::string minimalWith(const std::string& line) {
    const std::string key = line.substr(0, line.find(':'));
    std::string text = "{\n";
    for (const std::string member :
         {R"("format": "teleta-pattern",)", R"("version": 1,)", R"("duration_s": 1,)",
          R"("tracks": [[], [], [], [], [], []],)", R"("objects": [],)"})
        text += (member.starts_with(key) ? line : member) + "\n";
    return text + R"("name": "x")" + "\n}\n";
}

Error errorOf(const std::string& text) {
    const Expected<Pattern> pattern = patternFromJson(text, "p.json");
    EXPECT_FALSE(pattern) << text;
    return pattern ? Error{} : pattern.error();
}

void expectErrorAt(const std::string& text, long long line, long long column) {
    const Error error = errorOf(text);
    EXPECT_EQ(error.kind, ErrorKind::badInput);
    EXPECT_EQ(error.where.file, "p.json");
    EXPECT_EQ(error.where.line, line) << describe(error) << '\n' << text;
    EXPECT_EQ(error.where.column, column) << describe(error) << '\n' << text;
    EXPECT_NE(error.message, "");
}

} // namespace

TEST(PatternJson, readsAHandWrittenFileWithAllObjects) {
    const Expected<Pattern> read = loadPattern(kData + "everything.json");
    ASSERT_TRUE(read) << describe(read.error());
    const Pattern& pattern = *read;
    EXPECT_EQ(pattern.id, "user.everything");
    EXPECT_EQ(pattern.name, "Alles für die Probe");
    EXPECT_EQ(pattern.task, Task::shape);
    EXPECT_EQ(pattern.condition, Condition::dynamic);
    EXPECT_EQ(pattern.tags, (std::vector<std::string>{"probe", "mine"}));
    EXPECT_EQ(pattern.duration_s, 4.5);
    EXPECT_EQ(pattern.tracks[0], (Track{{0.0, 0.25}, {1.0, 0.75, Easing::easeInOut}, {1.5, 0.0}}));
    EXPECT_TRUE(pattern.tracks[1].empty());
    ASSERT_EQ(pattern.objects.size(), 6U);
    EXPECT_EQ(pattern.objects[0].name, "first");
    EXPECT_EQ(pattern.objects[0].form, ObjectForm(Sweep{0.5, 0.1, std::nullopt, {0, 1, 2}, 0.9}));
    EXPECT_EQ(pattern.objects[1].form, ObjectForm(Ring{1.0, 2.0, 4, 5, false, std::nullopt, 1.0}));
    EXPECT_EQ(pattern.objects[2].form, ObjectForm(Phantom{0.0, 1.0, 2, 3, 0.0, 1.0, 0.5}));
    EXPECT_EQ(pattern.objects[3].form, ObjectForm(Ramp{3.0, 1.0, {0, 3}, 0.2, 0.8, Easing::easeOut}));
    EXPECT_EQ(pattern.objects[4].form, ObjectForm(PulseTrain{2.0, 1.0, 0.25, 0.05, {4}, 1.0}));
    EXPECT_EQ(pattern.objects[5].form, ObjectForm(Stroke{0.0, {{0.0, 0.0, 0.0}, {1.0, -6.25, 1.0}}, 0.7}));
}

TEST(PatternJson, keepsTheKeysItDoesNotKnow) {
    const Expected<Pattern> pattern = loadPattern(kData + "everything.json");
    ASSERT_TRUE(pattern) << describe(pattern.error());
    const Expected<std::string> text = patternToJson(*pattern);
    ASSERT_TRUE(text) << describe(text.error());
    const auto root = nlohmann::ordered_json::parse(*text);
    EXPECT_EQ(root["colour"], "#884400");
    EXPECT_EQ(root["x-editor"], (nlohmann::ordered_json{{"zoom", 2.5}, {"lanes", {1, 2}}}));
    EXPECT_EQ(root["objects"][0]["locked"], true);
}

TEST(PatternJson, everyBuiltInPatternAndEveryObjectComesBackAsItWas) {
    std::vector<Pattern> patterns(builtInPatterns().begin(), builtInPatterns().end());
    const Expected<Pattern> everything = loadPattern(kData + "everything.json");
    ASSERT_TRUE(everything);
    patterns.push_back(*everything);
    const TemporaryFolder folder;
    for (const Pattern& pattern : patterns) {
        const std::string path = folder.path(pattern.id + ".json");
        ASSERT_TRUE(savePattern(pattern, path));
        const Expected<Pattern> again = loadPattern(path);
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_EQ(*again, pattern) << pattern.id;
    }
}

TEST(PatternJson, theArmIsAKeyOfItsOwnAndRightWithoutIt) {
    Pattern pattern;
    pattern.id = "x";
    pattern.duration_s = 1.0;
    EXPECT_EQ(patternToJson(pattern)->find("arm"), std::string::npos);
    EXPECT_EQ(patternFromJson(*patternToJson(pattern), "p.json")->arm, Arm::right);
    pattern.arm = Arm::left;
    const Expected<std::string> text = patternToJson(pattern);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("\"arm\": \"left\""), std::string::npos);
    const Expected<Pattern> again = patternFromJson(*text, "p.json");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, pattern);
    EXPECT_TRUE(again->unknown.empty());
}

TEST(PatternJson, aWrongValueIsRefusedWithItsPlace) {
    expectErrorAt(minimalWith(R"("duration_s": 1, "arm": "third",)"), 4, 25);
    expectErrorAt(minimalWith(R"("duration_s": "1",)"), 4, 15);
    expectErrorAt(minimalWith(R"("duration_s": -1,)"), 4, 15);
    expectErrorAt(minimalWith(R"("version": 2,)"), 3, 12);
    expectErrorAt(minimalWith(R"("version": 1.5,)"), 3, 12);
    expectErrorAt(minimalWith(R"("format": "other",)"), 2, 11);
    expectErrorAt(minimalWith(R"("tracks": [[], [], [], [], []],)"), 5, 11);
    expectErrorAt(minimalWith(R"("tracks": [[], [[0, 1], [1, 2]], [], [], [], []],)"), 5, 29);
    expectErrorAt(minimalWith(R"("tracks": [[], [[0, 1], [1]], [], [], [], []],)"), 5, 25);
    expectErrorAt(minimalWith(R"("tracks": [[[1, 1], [0.5, 1]], [], [], [], [], []],)"), 5, 22);
    expectErrorAt(minimalWith(R"("tracks": [[[0, 1, "jump"]], [], [], [], [], []],)"), 5, 20);
    expectErrorAt(minimalWith(R"("objects": [{"type": "spiral"}],)"), 6, 22);
    expectErrorAt(minimalWith(R"("objects": [{"type": "sweep"}],)"), 6, 13);
    expectErrorAt(minimalWith(R"("objects": [{"type": "ring", "start_s": 0, "duration_s": 1, "turns": 0}],)"),
                  6, 70);
    expectErrorAt("[]", 1, 1);
}

TEST(PatternJson, columnsCountCharactersAndStringsMayHoldAnything) {
    expectErrorAt(
        "{\"format\": \"teleta-pattern\", \"version\": 1, \"name\": \"{[\\\"ü\\\\\", \"duration_s\": null}",
        1, 77);
}

TEST(PatternJson, aMissingKeyNamesItself) {
    const Error error = errorOf(R"({"format": "teleta-pattern", "version": 1, "duration_s": 1})");
    EXPECT_NE(error.message.find("\"tracks\""), std::string::npos) << error.message;
}

TEST(PatternJson, textThatIsDamagedIsRefusedWhereItBreaks) {
    expectErrorAt("{\n  \"format\": nope\n}", 2, 14);
    expectErrorAt("{\"format\": \"teleta-pattern\"", 1, 28);
    EXPECT_EQ(errorOf("").kind, ErrorKind::badInput);
    EXPECT_EQ(errorOf("\xff\xfe").kind, ErrorKind::badInput);
    EXPECT_EQ(errorOf(minimalWith("\"duration_s\": 1e999,")).where.line, 4);
}

TEST(PatternJson, aKeyThatIsThereTwiceIsRefused) {
    const Error error = errorOf(minimalWith(R"("duration_s": 1, "duration_s": 2,)"));
    EXPECT_NE(error.message.find("duration_s"), std::string::npos);
}

TEST(PatternJson, aMillionBracketsAreRefusedAtTheFirstThatIsTooDeep) {
    expectErrorAt(std::string(1'000'000, '['), 1, 65);
    std::string objects;
    for (int i = 0; i < 100'000; ++i)
        objects += "{\"a\":";
    expectErrorAt(objects, 1, 64 * 5 + 1);
}

TEST(PatternJson, valuesThatAFileCannotHoldAreNotWritten) {
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks[2] = {{0.0, std::nan("")}, {1.0, 1.0}};
    const TemporaryFolder folder;
    const Expected<void> saved = savePattern(pattern, folder.path("p.json"));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().kind, ErrorKind::refused);
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(PatternFile, withoutAnIdGetsItsName) {
    const TemporaryFolder folder;
    const Expected<Pattern> pattern =
        loadPattern(folder.write("Wave 1.JSON", minimalWith("\"version\": 1,")));
    ASSERT_TRUE(pattern) << describe(pattern.error());
    EXPECT_EQ(pattern->id, "Wave 1");
}

TEST(PatternFile, thatIsNotThereOrOfNoFormatIsRefused) {
    EXPECT_EQ(loadPattern("/nowhere/p.json").error().kind, ErrorKind::notFound);
    EXPECT_EQ(findPattern("shape.Z.static").error().kind, ErrorKind::notFound);
    const TemporaryFolder folder;
    EXPECT_EQ(loadPattern(folder.write("p.txt", "{}")).error().kind, ErrorKind::badInput);
    EXPECT_EQ(loadPattern(folder.write("p.csv", "time_s\n")).error().kind, ErrorKind::badInput);
    EXPECT_FALSE(savePattern(Pattern{}, folder.path("p.txt")));
    EXPECT_FALSE(savePattern(Pattern{}, folder.path("no/p.json")));
}

TEST(PatternMap, comesBackFromItsFile) {
    PatternMap map = PatternMap::defaults();
    map.stiffness[2] = "user.\"mine\"";
    map.shape[6] = "shape.F.static";
    const Expected<PatternMap> again = patternMapFromJson(patternMapToJson(map), "map.json");
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(*again, map);
}

TEST(PatternMap, readsAHandWrittenFileAndRefusesAWrongOne) {
    const Expected<PatternMap> map = patternMapFromJson(R"({"format": "teleta-pattern-map", "version": 1,
        "stiffness": ["a", "b", "c", "d", "e"], "shape": {"line": "l"}})",
                                                        "m");
    ASSERT_TRUE(map) << describe(map.error());
    EXPECT_EQ(map->ofStiffness(4), "d");
    EXPECT_EQ(map->ofShape("line"), "l");
    EXPECT_EQ(map->ofShape("circle"), "");
    const Expected<PatternMap> wrong = patternMapFromJson(R"({"format": "teleta-pattern-map", "version": 1,
"stiffness": ["a", "b", "c", "d", "e"],
"shape": {"hexagon": "l"}})",
                                                          "m");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().where.line, 3);
    EXPECT_EQ(wrong.error().where.column, 22);
    EXPECT_FALSE(
        patternMapFromJson(R"({"format": "teleta-pattern-map", "version": 1, "stiffness": [1]})", "m"));
}
