// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_depth.h"
#include "backend/core/keys/toml_table.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using teleta::core::ErrorKind;
using teleta::core::NumberRange;
using teleta::core::TomlDocument;
using teleta::core::TomlTable;

namespace {

/// What describe() says after these reads of a text; empty when all is well.
std::string errorOf(const std::string& text, const std::function<void(TomlTable&)>& read) {
    const auto document = TomlDocument::parse(text, "f.toml");
    if (!document)
        return describe(document.error());
    TomlTable root = document->root();
    read(root);
    root.finish();
    return document->firstError() ? describe(*document->firstError()) : "";
}

} // namespace

TEST(TomlTable, readsEveryTypeAndFallsBackOnlyWhenTheKeyIsMissing) {
    const std::string text = "t = 'text'\nn = 2.5\nwhole = 3\ni = -4\nb = true\nc = 'two'\nx = nan\n"
                             "[sub]\nn = 1\n[[list]]\ni = 1\n[[list]]\ni = 2\n";
    const std::string error = errorOf(text, [](TomlTable& root) {
        EXPECT_EQ(root.text("t"), "text");
        EXPECT_EQ(root.text("t", "other"), "text");
        EXPECT_EQ(root.text("missing_t", "other"), "other");
        EXPECT_EQ(root.number("n", NumberRange::any()), 2.5);
        EXPECT_EQ(root.number("whole", NumberRange::any()), 3.0);
        EXPECT_EQ(root.number("missing_n", NumberRange::positive(), 7.0), 7.0);
        EXPECT_TRUE(std::isnan(root.number("x", NumberRange::anyOrNan())));
        EXPECT_EQ(root.integer("i", -4, 4), -4);
        EXPECT_EQ(root.integer("missing_i", 0, 4, 2), 2);
        EXPECT_TRUE(root.boolean("b", false));
        EXPECT_TRUE(root.boolean("missing_b", true));
        EXPECT_EQ(root.choice("c", {"one", "two"}), 1U);
        EXPECT_TRUE(root.has("t"));
        EXPECT_FALSE(root.has("u"));
        TomlTable sub = root.table("sub");
        EXPECT_EQ(sub.number("n", NumberRange::any()), 1.0);
        EXPECT_EQ(sub.place().line, 8);
        std::vector<TomlTable> list = root.tables("list", 2);
        ASSERT_EQ(list.size(), 2U);
        EXPECT_EQ(list[1].integer("i", 0, 9), 2);
        EXPECT_TRUE(root.tables("missing_list", 0).empty());
    });
    EXPECT_EQ(error, "");
}

TEST(TomlTable, readsListsAndNamesOfKeysInTheOrderOfTheFile) {
    const std::string text = "texts = ['a', 'b']\nrows = [[1, 2], [3, 4], [5, 6]]\n"
                             "[names]\nzeta = 'z'\nalpha = 'a'\n\"with space\" = 's'\n";
    const std::string error = errorOf(text, [](TomlTable& root) {
        EXPECT_EQ(root.textList("texts"), (std::vector<std::string>{"a", "b"}));
        EXPECT_TRUE(root.textList("missing").empty());
        EXPECT_EQ(root.numberRows("rows", NumberRange::any(), 3, 2),
                  (std::vector<std::vector<double>>{{1, 2}, {3, 4}, {5, 6}}));
        TomlTable names = root.table("names");
        EXPECT_EQ(names.keys(), (std::vector<std::string>{"zeta", "alpha", "with space"}));
    });
    EXPECT_EQ(error, "");
    // Names that nobody asked for are unknown all the same.
    EXPECT_EQ(errorOf("b = 1", [](TomlTable& root) { EXPECT_EQ(root.keys().size(), 1U); }),
              "f.toml:1:1: unknown key \"b\" (expected one of: )");
}

TEST(TomlTable, saysWhatIsWrongInAList) {
    const auto texts = [](TomlTable& root) { (void)root.textList("v"); };
    EXPECT_EQ(errorOf("v = 'a'", texts),
              "f.toml:1:5: wrong type for \"v\" (expected a list of texts in quotes)");
    EXPECT_EQ(errorOf("v = ['a', 2]", texts),
              "f.toml:1:11: wrong type for \"v\" (expected a text in quotes)");
    EXPECT_EQ(errorOf("v = ['a', '']", texts), "f.toml:1:11: \"v\" is empty (expected a text in quotes)");
    const auto rows = [](TomlTable& root) { (void)root.numberRows("v", NumberRange::any(), 2, 2); };
    for (const char* wrong : {"v = 1", "v = [1, 2]", "v = [[1, 2]]", "v = [[1, 2], [3]]", "v = [[1, 2], 3]"})
        EXPECT_EQ(errorOf(wrong, rows),
                  "f.toml:1:5: wrong type for \"v\" (expected a list of 2 lists, each of 2 numbers)");
    EXPECT_EQ(errorOf("v = [[1, 2], [3, 'x']]", rows),
              "f.toml:1:18: wrong type for \"v\" (expected a finite number)");
}

TEST(TomlTable, saysWhereAValueIsWrongAndWhatWasExpected) {
    const auto number = [](const NumberRange& range) {
        return [range](TomlTable& root) { (void)root.number("v", range); };
    };
    EXPECT_EQ(errorOf("\n  v = 'a'", number(NumberRange::positive())),
              "f.toml:2:7: wrong type for \"v\" (expected a number above 0)");
    EXPECT_EQ(errorOf("v = 0.0", number(NumberRange::positive())),
              "f.toml:1:5: \"v\" is out of range: 0 (expected a number above 0)");
    EXPECT_EQ(errorOf("v = -1", number(NumberRange::notNegative())),
              "f.toml:1:5: \"v\" is out of range: -1 (expected a number of at least 0)");
    EXPECT_EQ(errorOf("v = 1.5", number(NumberRange::between(0, 1))),
              "f.toml:1:5: \"v\" is out of range: 1.5 (expected a number from 0 to 1)");
    EXPECT_EQ(errorOf("v = inf", number(NumberRange::any())),
              "f.toml:1:5: \"v\" is out of range: inf (expected a finite number)");
    EXPECT_EQ(errorOf("v = nan", number(NumberRange::between(0, 1))),
              "f.toml:1:5: \"v\" is out of range: nan (expected a number from 0 to 1)");
    EXPECT_EQ(errorOf("v = 2.0", [](TomlTable& root) { (void)root.integer("v", 1, 9); }),
              "f.toml:1:5: wrong type for \"v\" (expected a whole number from 1 to 9)");
    EXPECT_EQ(errorOf("v = 10", [](TomlTable& root) { (void)root.integer("v", 1, 9); }),
              "f.toml:1:5: \"v\" is out of range: 10 (expected a whole number from 1 to 9)");
    EXPECT_EQ(errorOf("v = 1", [](TomlTable& root) { (void)root.boolean("v", false); }),
              "f.toml:1:5: wrong type for \"v\" (expected true or false)");
    EXPECT_EQ(errorOf("v = 1", [](TomlTable& root) { (void)root.text("v"); }),
              "f.toml:1:5: wrong type for \"v\" (expected a text in quotes)");
    EXPECT_EQ(errorOf("v = ''", [](TomlTable& root) { (void)root.text("v"); }),
              "f.toml:1:5: \"v\" is empty (expected a text in quotes)");
    EXPECT_EQ(
        errorOf("v = 'tow'",
                [](TomlTable& root) {
                    (void)root.choice("v", {"one", "two", "three"});
                }),
        "f.toml:1:5: unknown value \"tow\" of \"v\"; perhaps \"two\" is meant (expected one of: one, two, "
        "three)");
    EXPECT_EQ(errorOf("v = 1", [](TomlTable& root) { (void)root.table("v"); }),
              "f.toml:1:5: wrong type for \"v\" (expected a table: [v])");
    EXPECT_EQ(errorOf("[v]\n", [](TomlTable& root) { (void)root.tables("v", 0); }),
              "f.toml:1:1: wrong type for \"v\" (expected tables: [[v]] or v = [{...}])");
    EXPECT_EQ(errorOf("v = [1]", [](TomlTable& root) { (void)root.tables("v", 0); }),
              "f.toml:1:5: wrong type for \"v\" (expected tables: [[v]] or v = [{...}])");
    EXPECT_EQ(errorOf("v = []", [](TomlTable& root) { (void)root.tables("v", 1); }),
              "f.toml:1:5: \"v\" has too few entries (expected at least 1)");
}

TEST(TomlTable, namesTheFirstUnknownKeyRatherThanTheOneThatIsThenMissing) {
    const auto read = [](TomlTable& root) {
        (void)root.number("radius_m", NumberRange::positive());
        (void)root.text("name");
    };
    EXPECT_EQ(errorOf("name = 'a'\nradus_m = 1\nabc = 2", read),
              "f.toml:2:1: unknown key \"radus_m\"; perhaps \"radius_m\" is meant (expected one of: "
              "radius_m, name)");
    EXPECT_EQ(errorOf("name = 'a'\nradius = 1", read),
              "f.toml:2:1: \"radius\" has no unit in its name (expected radius_m)");
    EXPECT_EQ(errorOf("name = 'a'\nradius_mm = 1", read),
              "f.toml:2:1: \"radius_mm\" has another unit in its name (expected radius_m)");
    EXPECT_EQ(errorOf("name = 'a'\nradius_m = 1\ncolour = 1", read),
              "f.toml:3:1: unknown key \"colour\" (expected one of: radius_m, name)");
    EXPECT_EQ(errorOf("name = 'a'", read), "f.toml: \"radius_m\" is missing");
}

TEST(TomlTable, keepsTheFirstErrorAndReadsOnWithStandIns) {
    const std::string error = errorOf("a = 'x'\nb = 'y'", [](TomlTable& root) {
        EXPECT_EQ(root.number("a", NumberRange::any()), 0.0);
        EXPECT_EQ(root.integer("b", 3, 5), 3);
        TomlTable missing = root.table("t");
        EXPECT_EQ(missing.number("n", NumberRange::positive()), 0.0);
        EXPECT_EQ(missing.text("s"), "");
        EXPECT_TRUE(missing.tables("l", 1).empty());
        missing.finish();
    });
    EXPECT_EQ(error, "f.toml:1:5: wrong type for \"a\" (expected a finite number)");
}

TEST(TomlTable, aMissingTableHasNoOtherErrors) {
    const std::string error = errorOf("a = 1", [](TomlTable& root) {
        EXPECT_EQ(root.number("a", NumberRange::any()), 1.0);
        TomlTable missing = root.table("t");
        missing.fail("n", "what is not there is wrong", "");
        missing.finish();
    });
    EXPECT_EQ(error, "f.toml: \"t\" is missing");
}

TEST(TomlDocument, placesASyntaxErrorAndTellsAMissingFileFromAnEmptyOne) {
    const auto wrong = TomlDocument::parse("a = 1\nb = = 2\n", "f.toml");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().kind, ErrorKind::badInput);
    EXPECT_EQ(wrong.error().where.file, "f.toml");
    EXPECT_EQ(wrong.error().where.line, 2);
    EXPECT_EQ(wrong.error().where.column, 5);

    const auto missing = TomlDocument::open("/nonexistent/scene.toml");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::notFound);
    const teleta::test::TemporaryFolder folder;
    EXPECT_TRUE(TomlDocument::open(folder.write("empty.toml", "")));
    EXPECT_EQ(TomlDocument::open("/dev/null").error().kind, ErrorKind::badInput) << "a device is no file";
    EXPECT_FALSE(TomlDocument::open(TELETA_SOURCE_DIR)) << "a folder is no file";
}

TEST(TomlTable, refusesKeysThatGoTooDeepWithTheirPlace) {
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i)
            all += text;
        return all;
    };
    const auto refusal = [](const std::string& text) {
        const auto document = TomlDocument::parse(text, "f.toml");
        return document ? std::string() : describe(document.error());
    };
    // toml++ itself ends the program for the first two.
    EXPECT_EQ(refusal("b = 1\na" + repeated(".a", 50'000) + " = 1\n"),
              "f.toml:2:130: the keys are nested too deeply (expected at most 64 levels)");
    EXPECT_NE(refusal("[a" + repeated(".a", 50'000) + "]\n").find("f.toml:1:"), std::string::npos);
    EXPECT_NE(refusal("a = " + repeated("[", 100) + repeated("]", 100)).find("too deeply"),
              std::string::npos);
    EXPECT_NE(refusal("a = " + repeated("{ b.c.d.e = ", 20) + "1" + repeated(" }", 20)).find("too deeply"),
              std::string::npos);
}

TEST(TomlTable, takesForDepthOnlyWhatIsOne) {
    std::string dots;
    std::string numbers;
    for (int i = 0; i < 100; ++i) {
        dots += ".a";
        numbers += "1.5, [2.5, 3.5],\n";
    }
    std::string deepest = "a";
    for (int i = 0; i < 63; ++i)
        deepest += ".a";
    for (const std::string& text :
         {"t = \"" + dots + "\"\n", "t = '" + dots + "'\n", "t = '''\n" + dots + "''''' # five\n",
          "t = \"\"\"\\\"\"\"" + dots + "\"\"\"\n", "# " + dots + "\nt = 1\n", "\"" + dots + "\".b = 1\n",
          "t = [" + numbers + "]\n", "[" + deepest + "]\n" + deepest + " = 1\n"})
        EXPECT_TRUE(TomlDocument::parse(text, "f.toml")) << text;
}

TEST(TomlTable, isReadFromFilesOfAtMost16MiB) {
    const teleta::test::TemporaryFolder folder;
    const std::string comment = "# " + std::string(1022, 'x') + "\n";
    std::string text;
    while (text.size() <= teleta::core::kMostTomlBytes)
        text += comment;
    const auto document = TomlDocument::open(folder.write("f.toml", text));
    ASSERT_FALSE(document);
    EXPECT_EQ(document.error().kind, ErrorKind::badInput);
    EXPECT_EQ(TomlDocument::open("/dev/zero").error().kind, ErrorKind::badInput);
    EXPECT_FALSE(TomlDocument::parse(text, "f.toml"));
}

TEST(TomlTable, aKeyIsReadWithItsUnitInLowerCaseButNotTwice) {
    double rate_Hz = 0.0;
    const auto read = [&](TomlTable& table) {
        rate_Hz = table.number("rate_Hz", NumberRange::positive());
        (void)table.number("force_N", NumberRange::positive(), 1.0);
    };
    EXPECT_EQ(errorOf("rate_hz = 20\nforce_n = 2", read), "");
    EXPECT_EQ(rate_Hz, 20.0);
    EXPECT_EQ(errorOf("rate_Hz = 30", read), "");
    EXPECT_EQ(rate_Hz, 30.0);
    EXPECT_EQ(errorOf("rate_hz = 20\nrate_Hz = 20", read),
              "f.toml:1:1: \"rate_hz\" and \"rate_Hz\" are the same key (expected one of them)");
    EXPECT_EQ(errorOf("rate_hz = -1", read),
              "f.toml:1:11: \"rate_Hz\" is out of range: -1 (expected a number above 0)");
    EXPECT_NE(errorOf("rate_HZ = 20", read).find("perhaps \"rate_Hz\""), std::string::npos);
}
