// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_edit.h"
#include "backend/core/keys/toml_table.h"

#include <gtest/gtest.h>

using namespace teleta::core;

namespace {

using Values = std::vector<std::pair<std::string, TomlValue>>;

TomlDocument edited(const std::string& text, const Values& values) {
    const auto after = withTomlValues(text, "a.toml", values);
    EXPECT_TRUE(after) << describe(after.error());
    auto document = TomlDocument::parse(after.value_or(""), "a.toml");
    EXPECT_TRUE(document);
    return *document;
}

const std::string kText = R"(top = 1.5
[arm.control]
kind = "soft"
[[object]]
name = "sponge"
k = 1
[[object]]
name = "wood"
k = 2
steps = [{ t = 0.0 }, { t = 1.0 }]
)";

} // namespace

TEST(TomlEdit, setsValuesByTableNumberAndName) {
    const TomlDocument document = edited(kText, {{"top", 0.1},
                                                 {"arm.control.kind", std::string("a \"b\"\n")},
                                                 {"arm.speed", 3LL},
                                                 {"object.0.k", 7.25},
                                                 {"object.wood.k", true},
                                                 {"object.1.steps.1.t", 1e-300}});
    TomlTable root = document.root();
    EXPECT_EQ(root.number("top", NumberRange::any()), 0.1);
    TomlTable arm = root.table("arm");
    EXPECT_EQ(arm.integer("speed", 0, 9), 3);
    EXPECT_EQ(arm.table("control").text("kind"), "a \"b\"\n");
    std::vector<TomlTable> objects = root.tables("object", 2);
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_EQ(objects[0].number("k", NumberRange::any()), 7.25);
    EXPECT_TRUE(objects[1].boolean("k", false));
    EXPECT_EQ(objects[1].tables("steps", 2)[1].number("t", NumberRange::any()), 1e-300);
    EXPECT_FALSE(document.firstError());
}

TEST(TomlEdit, addsAnEntryThatIsNamed) {
    const TomlDocument document = edited(kText, {{"object.rubber.k", 5LL}});
    std::vector<TomlTable> objects = document.root().tables("object", 3);
    ASSERT_EQ(objects.size(), 3U);
    EXPECT_EQ(objects[2].text("name"), "rubber");
    EXPECT_EQ(objects[2].integer("k", 0, 9), 5);
}

TEST(TomlEdit, keepsEveryDoubleToTheLastDigit) {
    for (const double value : {0.1, 1.0 / 3.0, 1e300, 5e-324, -0.0, 123456789.123456789}) {
        TomlTable root = edited("x = 1.0\n", {{"x", value}}).root();
        EXPECT_EQ(root.number("x", NumberRange::any()), value);
    }
}

TEST(TomlEdit, refusesAPathThatLeadsNowhere) {
    for (const char* path : {"object.2.k", "object.0", "object", "top.x", "", "arm.", "object.0.k.x"}) {
        const auto after = withTomlValues(kText, "a.toml", Values{{path, 1LL}});
        if (std::string(path) == "object")
            EXPECT_TRUE(after) << path; // a value in place of the list: what reads it will refuse it
        else
            EXPECT_FALSE(after) << path;
    }
    EXPECT_FALSE(withTomlValues("x = [", "a.toml", {}));
}

TEST(TomlTable, readsListsOfUnlikeValues) {
    const auto document = TomlDocument::parse("x = [1, 2.5, \"a\", true]\ny = [1, []]\n", "a.toml");
    ASSERT_TRUE(document);
    TomlTable root = document->root();
    const std::vector<TomlValue> values = root.valueList("x");
    ASSERT_EQ(values.size(), 4U);
    EXPECT_EQ(plainText(values[0]), "1");
    EXPECT_EQ(plainText(values[1]), "2.5");
    EXPECT_EQ(plainText(values[2]), "a");
    EXPECT_EQ(plainText(values[3]), "true");
    (void)root.valueList("y");
    ASSERT_TRUE(document->firstError());
    EXPECT_EQ(document->firstError()->where.line, 2);
    EXPECT_EQ(document->firstError()->where.column, 9);
}
