// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace teleta::architecture {
namespace {

std::string contentOf(const std::string& path) {
    std::ostringstream content;
    content << std::ifstream(std::string(TELETA_SOURCE_DIR) + '/' + path).rdbuf();
    return content.str();
}

/// Version to date of each release that the text names by the two groups of a pattern.
std::map<std::string, std::string> releases(const std::string& text, const std::regex& pattern) {
    std::map<std::string, std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found[(*match)[1]] = (*match)[2];
    return found;
}

std::string value(const std::string& text, const std::regex& pattern) {
    std::smatch match;
    return std::regex_search(text, match, pattern) ? match[1].str() : std::string();
}

const std::regex kInChangelog(R"(\n## (\d+\.\d+\.\d+) - (\d{4}-\d\d-\d\d)\n)");
const std::regex kInMetainfo(R"rx(<release version="([^"]+)" date="([^"]+)")rx");

TEST(ReleasesTest, theChangelogAndTheMetainfoTellTheSameVersionsAndDates) {
    const auto changelog = releases(contentOf("CHANGELOG.md"), kInChangelog);
    const auto metainfo = releases(contentOf("resources/org.teleta.Console.metainfo.xml.in"), kInMetainfo);
    EXPECT_FALSE(changelog.empty());
    for (const auto& [version, date] : changelog) {
        const auto same = metainfo.find(version);
        if (same == metainfo.end())
            ADD_FAILURE() << "the metainfo lacks " << version << " of CHANGELOG.md";
        else
            EXPECT_EQ(same->second, date) << "CHANGELOG.md has another date of " << version;
    }
    for (const auto& [version, date] : metainfo)
        EXPECT_TRUE(changelog.contains(version)) << "CHANGELOG.md lacks " << version << " of the metainfo";
}

TEST(ReleasesTest, theVersionOfTheProjectIsTheNewestReleaseEverywhere) {
    const auto changelog = releases(contentOf("CHANGELOG.md"), kInChangelog);
    const std::string version =
        value(contentOf("CMakeLists.txt"), std::regex(R"(\n    VERSION (\d+\.\d+\.\d+)\n)"));
    const std::string citation = contentOf("CITATION.cff");
    EXPECT_EQ(value(citation, std::regex(R"(\nversion: (\S+)\n)")), version);
    ASSERT_TRUE(changelog.contains(version)) << version;
    EXPECT_EQ(value(citation, std::regex(R"rx(\ndate-released: "([^"]+)"\n)rx")), changelog.at(version));
}

TEST(ReleasesTest, findADifferenceThatWasPlanted) {
    EXPECT_EQ(releases("# Changelog\n\n## Unreleased\n\n## 0.2.0 - 2030-01-01\n\n## 0.1.0 - 2029-01-01\n",
                       kInChangelog),
              (std::map<std::string, std::string>{{"0.2.0", "2030-01-01"}, {"0.1.0", "2029-01-01"}}));
    EXPECT_EQ(releases(R"(<release version="0.1.0" date="2029-01-02">)", kInMetainfo).at("0.1.0"),
              "2029-01-02");
}

} // namespace
} // namespace teleta::architecture
