// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_folder.h"
#include "backend/pattern/files/recovery_file.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace teleta::pattern;
using teleta::core::ErrorKind;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

Pattern named(const std::string& id, const std::string& name) {
    Pattern pattern;
    pattern.id = id;
    pattern.name = name;
    pattern.duration_s = 1.0;
    pattern.tracks[0] = {{0.0, 0.5}, {1.0, 0.5}};
    return pattern;
}

} // namespace

TEST(PatternFolder, thatIsNotThereIsEmptyAndIsMadeByTheFirstPattern) {
    const TemporaryFolder place;
    const PatternFolder folder(place.path("a/b"));
    EXPECT_TRUE(folder.read().empty());
    const auto path = folder.add(named("mine.1", "Slow Wave: 2 turns!"));
    ASSERT_TRUE(path) << describe(path.error());
    EXPECT_EQ(std::filesystem::path(*path).filename(), "slow-wave-2-turns.json");
    const auto again = folder.add(named("mine.2", "Slow wave  2 turns"));
    ASSERT_TRUE(again);
    EXPECT_EQ(std::filesystem::path(*again).filename(), "slow-wave-2-turns-2.json");
    const auto all = folder.read();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].id, "mine.2"); // '-' sorts before '.'
    EXPECT_EQ(all[1].pattern->name, "Slow Wave: 2 turns!");
}

TEST(PatternFolder, namesThatNoFileCanHaveGetAnother) {
    const TemporaryFolder place;
    const PatternFolder folder(place.path("p"));
    for (const char* name : {"", "/", "../../etc/passwd", "\n", "...", "-"}) {
        const auto path = folder.add(named("mine", name));
        ASSERT_TRUE(path) << name;
        EXPECT_EQ(std::filesystem::path(*path).parent_path(), place.path("p")) << name;
    }
    EXPECT_EQ(folder.read().size(), 6U);
}

TEST(PatternFolder, givesEveryPatternAnIdOfItsOwn) {
    const TemporaryFolder place;
    ASSERT_TRUE(savePattern(named("wave", "a"), place.path("a.json")));
    ASSERT_TRUE(savePattern(named("wave", "b"), place.path("b.json")));
    ASSERT_TRUE(savePattern(named("shape.A.static", "c"), place.path("c.json")));
    ASSERT_TRUE(savePattern(named("wave.b", "d"), place.path("0.json")));
    const auto all = PatternFolder(place.path("")).read();
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[0].id, "wave.b");
    EXPECT_EQ(all[1].id, "wave");
    EXPECT_EQ(all[2].id, "wave.b-2");
    EXPECT_EQ(all[3].id, "shape.A.static.c");
    for (const StoredPattern& stored : all)
        EXPECT_EQ(stored.pattern->id, stored.id);
}

TEST(PatternFolder, listsDamagedFilesWithTheReasonAndLeavesThem) {
    const TemporaryFolder place;
    const std::string path = place.write("broken.json", "{\"format\": \"teleta-pattern\",\n \"version\": ");
    place.write("notes.txt", "not a pattern");
    ASSERT_TRUE(savePattern(named("good", "good"), place.path("good.json")));
    const auto all = PatternFolder(place.path("")).read();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_FALSE(all[0].pattern);
    ASSERT_TRUE(all[0].error);
    EXPECT_EQ(all[0].error->where.line, 2);
    EXPECT_TRUE(std::filesystem::exists(path));
    EXPECT_TRUE(all[1].pattern);
}

TEST(PatternFolder, readsOnlyWhatHasChanged) {
    const TemporaryFolder place;
    ASSERT_TRUE(savePattern(named("a", "a"), place.path("a.json")));
    ASSERT_TRUE(savePattern(named("b", "b"), place.path("b.json")));
    const PatternFolder folder(place.path(""));
    const auto first = folder.read();
    Pattern longer = named("b", "b, but longer than before");
    ASSERT_TRUE(savePattern(longer, place.path("b.json")));
    const auto second = folder.read(first);
    ASSERT_EQ(second.size(), 2U);
    EXPECT_EQ(second[0].pattern, first[0].pattern);
    EXPECT_NE(second[1].pattern, first[1].pattern);
    EXPECT_EQ(second[1].pattern->name, longer.name);
}

TEST(PatternFolder, deletesSoThatItCanComeBack) {
    const TemporaryFolder place;
    const PatternFolder folder(place.path("p"));
    const std::string path = folder.add(named("a", "a")).value();
    const std::string content = readAll(path);
    const auto removed = folder.remove(path);
    ASSERT_TRUE(removed) << describe(removed.error());
    EXPECT_TRUE(folder.read().empty());
    const std::string other = folder.add(named("b", "a")).value();
    EXPECT_EQ(other, path);
    const auto restored = folder.restore(*removed, path);
    ASSERT_TRUE(restored) << describe(restored.error());
    EXPECT_NE(*restored, path) << "another file has the name by now";
    EXPECT_EQ(readAll(*restored), content);
    EXPECT_EQ(folder.remove(place.path("p/none.json")).error().kind, ErrorKind::ioFailed);
}

TEST(PatternFolder, renamesAndDuplicates) {
    const TemporaryFolder place;
    const PatternFolder folder(place.path("p"));
    const std::string path = folder.add(named("a", "a")).value();
    ASSERT_TRUE(folder.rename(path, "other"));
    EXPECT_EQ(loadPattern(path)->name, "other");
    const Pattern& builtIn = *findBuiltIn("shape.A.static");
    const auto copy = folder.duplicate(builtIn, "my circle");
    ASSERT_TRUE(copy);
    const Pattern read = loadPattern(*copy).value();
    EXPECT_EQ(read.name, "my circle");
    EXPECT_EQ(read.tracks, builtIn.tracks);
    EXPECT_NE(read.id, builtIn.id);
    ASSERT_TRUE(savePattern(named("t", "t"), place.path("p/t.tact")));
    EXPECT_EQ(folder.rename(place.path("p/t.tact"), "x").error().kind, ErrorKind::refused);
}

TEST(RecoveryFile, comesBackWithItsPathAndIsAPatternFileForAllOthers) {
    const TemporaryFolder place;
    RecoveredPattern edited{named("a", "edited"), "/home/me/wave.json", 1'790'000'000'123};
    edited.pattern.unknown.emplace_back("author", "\"somebody\"");
    const std::string file = place.path("r.json");
    ASSERT_TRUE(writeRecovery(file, edited));
    const auto back = readRecovery(file);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->pattern, edited.pattern);
    EXPECT_EQ(back->path, edited.path);
    EXPECT_EQ(back->edited_ms, edited.edited_ms);
    EXPECT_EQ(loadPattern(file)->name, "edited");
    // Recovered and kept once more: one key, not two.
    ASSERT_TRUE(writeRecovery(file, {loadPattern(file).value(), "", 5}));
    EXPECT_EQ(readRecovery(file)->edited_ms, 5);
}

TEST(RecoveryFile, thatIsNoneOrIsDamagedIsRefused) {
    const TemporaryFolder place;
    ASSERT_TRUE(savePattern(named("a", "a"), place.path("a.json")));
    EXPECT_EQ(readRecovery(place.path("a.json")).error().kind, ErrorKind::badInput);
    Pattern wrong = named("a", "a");
    wrong.unknown.emplace_back("recovery", "[1, 2]");
    ASSERT_TRUE(savePattern(wrong, place.path("b.json")));
    EXPECT_EQ(readRecovery(place.path("b.json")).error().kind, ErrorKind::badInput);
    wrong.unknown[0].second = "{\"path\": \"\", \"edited_ms\": \"yesterday\"}";
    ASSERT_TRUE(savePattern(wrong, place.path("c.json")));
    EXPECT_EQ(readRecovery(place.path("c.json")).error().where.file, place.path("c.json"));
    wrong.unknown[0].second = "{\"path\": \"\", \"edited_ms\": 9223372036854775807}";
    ASSERT_TRUE(savePattern(wrong, place.path("d.json")));
    EXPECT_EQ(readRecovery(place.path("d.json")).error().kind, ErrorKind::badInput);
    EXPECT_EQ(readRecovery(place.path("none.json")).error().kind, ErrorKind::notFound);
}
