// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_check.h"
#include "backend/core/keys/key_reference.h"
#include "backend/core/keys/toml_keys.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace teleta::core {
namespace {

struct Ball {
    double radius_m = 0.0;
    void describeKeys(Keys& keys) { keys.number("radius_m", radius_m, NumberRange::positive(), "Radius"); }
};

struct Box {
    double side_m = 0.0;
    int corners = 8;
    void describeKeys(Keys& keys) {
        keys.number("side_m", side_m, NumberRange::between(0.1, 1.0), "Length of a side");
        keys.whole("corners", corners, {4, 8}, "Corners", Need::optional);
    }
};

struct Thing {
    enum class Colour { red, blue };
    std::string name;
    std::variant<Ball, Box> shape;
    Colour colour = Colour::red;
    bool loud = false;
    std::vector<Ball> friends;
    std::optional<Box> hidden;
    std::optional<int> bit;

    void describeKeys(Keys& keys) {
        keys.text("name", name, "Its name");
        keys.variant("shape", shape, {{"ball", "It rolls"}, "box"}, "Its shape");
        keys.choice("colour", colour, {"red", "blue"}, "Its colour", Need::optional);
        keys.flag("loud", loud, "It can be heard");
        keys.tables("friend", friends, 1, "Who is with it");
        keys.table("hidden", hidden, "What is in it");
        keys.whole("bit", bit, {0, 15}, "A bit");
        if (name == "nobody")
            keys.refuse("name", "nobody is no name", "a name");
    }
};

Expected<Thing> read(const std::string& text) {
    return TomlDocument::parse(text, "f.toml").and_then(readKeys<Thing>);
}

std::string errorOf(const std::string& text) {
    const auto thing = read(text);
    return thing ? std::string() : describe(thing.error());
}

} // namespace

TEST(Keys, areReadIntoWhatTellsThem) {
    const auto thing =
        read("name = 'T'\nshape = 'box'\nside_m = 0.5\nloud = true\nbit = 3\n"
             "[[friend]]\nradius_m = 1\n[[friend]]\nradius_m = 2\n[hidden]\nside_m = 1\ncorners = 4\n");
    ASSERT_TRUE(thing) << describe(thing.error());
    EXPECT_EQ(thing->name, "T");
    EXPECT_EQ(std::get<Box>(thing->shape).side_m, 0.5);
    EXPECT_EQ(std::get<Box>(thing->shape).corners, 8);
    EXPECT_EQ(thing->colour, Thing::Colour::red);
    EXPECT_TRUE(thing->loud);
    ASSERT_EQ(thing->friends.size(), 2U);
    EXPECT_EQ(thing->friends[1].radius_m, 2.0);
    EXPECT_EQ(thing->hidden->corners, 4);
    EXPECT_EQ(thing->bit, 3);
    const auto plain =
        read("name = 'T'\nshape = 'ball'\nradius_m = 1\ncolour = 'blue'\nfriend = [{ radius_m = 1 }]\n");
    ASSERT_TRUE(plain) << describe(plain.error());
    EXPECT_EQ(plain->colour, Thing::Colour::blue);
    EXPECT_FALSE(plain->hidden || plain->bit);
}

TEST(Keys, tellWhatIsWrongInAFileAndWhere) {
    const std::string end = "friend = [{ radius_m = 1 }]\n";
    EXPECT_EQ(errorOf("name = 'T'\nshape = 'box'\nside_m = 2\n" + end),
              "f.toml:3:10: \"side_m\" is out of range: 2 (expected a number from 0.1 to 1)");
    EXPECT_EQ(
        errorOf("name = 'T'\nshape = 'ball'\nside_m = 0.5\nradius_m = 1\n" + end),
        "f.toml:3:1: unknown key \"side_m\" (expected one of: name, shape, radius_m, colour, loud, friend, "
        "hidden, bit)");
    EXPECT_EQ(errorOf("name = 'T'\nshape = 'ball'\nradius_m = 1\n"), "f.toml: \"friend\" is missing");
    EXPECT_EQ(errorOf("name = 'T'\nshape = 'ball'\nradius_m = 1\nbit = 16\n" + end),
              "f.toml:4:7: \"bit\" is out of range: 16 (expected a whole number from 0 to 15)");
    EXPECT_EQ(errorOf("name = 'nobody'\nshape = 'ball'\nradius_m = 1\n" + end),
              "f.toml:1:8: nobody is no name (expected a name)");
    EXPECT_EQ(errorOf("name = 'nobody'\nshape = 'ball'\n" + end), "f.toml: \"radius_m\" is missing")
        << "what is missing comes before what it makes look wrong";
}

TEST(Keys, areCheckedInWhatAProgramMade) {
    Thing thing;
    thing.shape = Ball{1.0};
    EXPECT_TRUE(checkKeys(thing)) << "texts and the lists of a file's top may be empty";
    const auto refused = [&](auto change) {
        Thing copy = thing;
        change(copy);
        const auto checked = checkKeys(copy);
        return checked ? std::string() : describe(checked.error());
    };
    EXPECT_EQ(refused([](Thing& t) { t.shape = Ball{0.0}; }),
              "radius_m: \"radius_m\" is out of range: 0 (expected a number above 0)");
    EXPECT_EQ(refused([](Thing& t) {
                  t.friends = {Ball{1.0}, Ball{-1.0}};
              }),
              "friend[1].radius_m: \"radius_m\" is out of range: -1 (expected a number above 0)");
    EXPECT_EQ(refused([](Thing& t) {
                  t.hidden = Box{0.5, 3};
              }),
              "hidden.corners: \"corners\" is out of range: 3 (expected a whole number from 4 to 8)");
    EXPECT_NE(refused([](Thing& t) { t.bit = -1; }), "");
    EXPECT_NE(refused([](Thing& t) { t.name = "nobody"; }), "");
}

TEST(Keys, areTheRowsOfAReference) {
    Thing thing;
    KeyReference reference;
    thing.describeKeys(reference);
    ASSERT_EQ(reference.tables().size(), 3U);
    const auto& top = reference.tables()[0];
    EXPECT_EQ(top.path, "");
    EXPECT_EQ(reference.tables()[1].path, "[[friend]]");
    EXPECT_EQ(reference.tables()[2].path, "[hidden]");
    const auto row = [&](const std::string& key) {
        const auto found = std::ranges::find(top.rows, key, &ReferenceTable::Row::key);
        return found == top.rows.end() ? ReferenceTable::Row{} : *found;
    };
    EXPECT_EQ(row("side_m").unit, "m");
    EXPECT_EQ(row("side_m").accepts, "0.1 … 1");
    EXPECT_EQ(row("side_m").fallback, "required");
    EXPECT_EQ(row("side_m").when, "`box`");
    EXPECT_EQ(row("radius_m").accepts, "> 0");
    EXPECT_EQ(row("corners").accepts, "whole, 4 … 8");
    EXPECT_EQ(row("corners").fallback, "8");
    EXPECT_EQ(row("shape").accepts, "`ball`, `box`");
    EXPECT_EQ(row("shape = \"ball\"").meaning, "It rolls");
    EXPECT_EQ(row("colour").fallback, "`red`");
    EXPECT_EQ(row("loud").fallback, "`false`");
    EXPECT_NE(reference.markdown(3).find("### `[hidden]`\n\n| Key | Unit |"), std::string::npos);
}

} // namespace teleta::core
