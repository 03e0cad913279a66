// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/wearer_limits.h"
#include "tests/backend/core/temporary_folder.h"

#include <QByteArray>

#include <gtest/gtest.h>

using namespace teleta;
using motors::parseLimits;
using motors::WearerLimits;

namespace {

WearerLimits sample() {
    return {"TB-0042 \"left\"\\\t", {0.0, 0.1 + 0.2, 1.0 / 3.0, 0.8, 1.0, 0.55}};
}

std::string whyNot(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
    const auto parsed = parseLimits(text, "l.toml");
    return parsed ? std::string() : core::describe(parsed.error());
}

} // namespace

TEST(WearerLimits, comeBackAsTheyWereWritten) {
    const auto again = parseLimits(limitsText(sample()), "l.toml");
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_EQ(*again, sample());
}

TEST(WearerLimits, areRefusedWithThePlaceOfWhatIsWrong) {
    const std::string text = limitsText(sample());
    EXPECT_NE(whyNot(text, "strongest = 0.8", "strongest = 1.8").find("l.toml:15:13"), std::string::npos)
        << whyNot(text, "strongest = 0.8", "strongest = 1.8");
    EXPECT_NE(whyNot(text, "strongest = 0.8", "strongest = nan").find("l.toml:15:13"), std::string::npos);
    EXPECT_NE(whyNot(text, "strongest = 0.8", "weakest = 0.8").find("weakest"), std::string::npos);
    EXPECT_NE(whyNot(text, "version = 1", "version = 2").find("newer"), std::string::npos);
    EXPECT_NE(whyNot(text, "teleta-limits", "teleta-motors").find("teleta-limits"), std::string::npos);
    EXPECT_FALSE(parseLimits(text + "\n[[motor]]\nstrongest = 0.5\n", "l.toml")) << "a seventh motor";
}

TEST(WearerLimits, areKeptUnderTheSerialNumberAndFullWhereNobodySetAny) {
    const test::TemporaryFolder folder;
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(folder.path("")));
    WearerLimits limits = sample();
    limits.bracelet = "tcp://192.168.0.20:502#1";
    const std::string path = motors::limitsPath(limits.bracelet);
    EXPECT_NE(path.find("teleta/motors/tcp%3A%2F%2F192%2E168%2E0%2E20%3A502%231.limits.toml"),
              std::string::npos)
        << path;
    const auto none = motors::findLimits(limits.bracelet);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->strongest, WearerLimits{}.strongest);
    EXPECT_EQ(none->bracelet, limits.bracelet);
    ASSERT_TRUE(motors::writeLimits(limits, path));
    const auto found = motors::findLimits(limits.bracelet);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, limits);
    // A file that was copied to another bracelet's name.
    ASSERT_TRUE(motors::writeLimits(limits, motors::limitsPath("other")));
    EXPECT_FALSE(motors::findLimits("other"));
    EXPECT_TRUE(motors::limitsPath("").empty());
    ASSERT_TRUE(motors::findLimits(""));
    before.isNull() ? qunsetenv("XDG_CONFIG_HOME") : qputenv("XDG_CONFIG_HOME", before);
}
