// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/source_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>

namespace teleta::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaximumLines = 600;

const std::vector<std::string> kFolders = {"app",       "widgets",      "backend", "devices",
                                           "resources", "translations", "tests",   "packaging"};
const std::vector<std::string> kCode = {".cpp", ".h"};
const std::vector<std::string> kText = {".cpp", ".h", ".cmake", "CMakeLists.txt", ".sh", ".toml", ".desktop"};

std::vector<Violation> withoutLicenceLine(const SourceFile& file) {
    static const std::regex licence(R"(^(//|#) SPDX-License-Identifier: GPL-3\.0-or-later$)");
    // A script begins with its interpreter.
    const std::size_t first = !file.lines.empty() && file.lines[0].starts_with("#!") ? 1 : 0;
    if (file.lines.size() > first && std::regex_match(file.lines[first], licence))
        return {};
    return {{file.path, static_cast<int>(first) + 1, "expected the SPDX licence line"}};
}

std::vector<Violation> tooLong(const SourceFile& file) {
    if (file.lines.size() <= kMaximumLines)
        return {};
    return {{file.path, 0, std::to_string(file.lines.size()) + " lines, at most 600 are allowed"}};
}

std::vector<Violation> unfinished(const SourceFile& file) {
    // Spelled so that this file does not name them.
    static const std::regex word(R"(\b(TO[D]O|FIX[M]E|X[X]X|HA[C]K)\b)");
    std::vector<Violation> violations;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (std::regex_search(file.lines[i], word))
            violations.push_back({file.path, static_cast<int>(i) + 1, "unfinished work"});
    }
    return violations;
}

/// What git leaves where two changes met and nobody chose.
std::vector<Violation> conflicts(const SourceFile& file) {
    static const std::regex mark("^(<{7}|>{7}) ");
    std::vector<Violation> violations;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (std::regex_search(file.lines[i], mark))
            violations.push_back({file.path, static_cast<int>(i) + 1, "an unresolved conflict"});
    }
    return violations;
}

/// What returns a part of a range does not compile with clang 14 and GCC 12's library.
std::vector<Violation> notForTheFuzzer(const SourceFile& file) {
    static const std::regex call(
        R"(\branges::(equal_range|find_end|partition|remove|remove_if|rotate|search|search_n|stable_partition|unique)\()");
    std::vector<Violation> violations;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (std::regex_search(file.lines[i], call))
            violations.push_back({file.path, static_cast<int>(i) + 1, "clang 14, which fuzzes it, fails"});
    }
    return violations;
}

std::string checkAll(const std::vector<SourceFile>& files,
                     const std::function<std::vector<Violation>(const SourceFile&)>& rule) {
    std::vector<Violation> violations;
    for (const SourceFile& file : files) {
        const std::vector<Violation> found = rule(file);
        violations.insert(violations.end(), found.begin(), found.end());
    }
    return describe(violations);
}

TEST(SourceFilesTest, haveTheLicenceLine) {
    const std::vector<SourceFile> files = readFiles(TELETA_SOURCE_DIR, kFolders, kText);
    ASSERT_GT(files.size(), 40U);
    EXPECT_EQ(checkAll(files, withoutLicenceLine), "");
}

TEST(SourceFilesTest, haveAtMost600Lines) {
    EXPECT_EQ(checkAll(readFiles(TELETA_SOURCE_DIR, kFolders, kCode), tooLong), "");
}

TEST(SourceFilesTest, haveNoUnfinishedWork) {
    EXPECT_EQ(checkAll(readFiles(TELETA_SOURCE_DIR, kFolders, kText), unfinished), "");
}

TEST(SourceFilesTest, haveNoConflictLeft) {
    std::vector<std::string> endings = kText;
    endings.insert(endings.end(), {".md", ".mjs", ".py", ".ts", ".txt", ".xml"});
    EXPECT_EQ(checkAll(readFiles(TELETA_SOURCE_DIR, kFolders, endings), conflicts), "");
}

TEST(SourceFilesTest, areCompiledByTheFuzzersCompiler) {
    EXPECT_EQ(checkAll(readFiles(TELETA_SOURCE_DIR, {"backend", "devices"}, kCode), notForTheFuzzer), "");
}

TEST(SourceFilesTest, findPlantedViolations) {
    EXPECT_EQ(notForTheFuzzer({"a.cpp", {"a();", "std::ranges::unique(a);"}}).size(), 1U);
    EXPECT_TRUE(notForTheFuzzer({"a.cpp", {"std::ranges::sort(a);", "std::unique(a, b);"}}).empty());
    EXPECT_EQ(conflicts({"a.md", {"a", std::string(7, '<') + " HEAD", std::string(7, '>') + " b"}}).size(),
              2U);
    EXPECT_TRUE(conflicts({"a.md", {"=======", "a << b", " <<<<<<< "}}).empty());
    EXPECT_EQ(withoutLicenceLine({"a.cpp", {"#include <vector>"}}).size(), 1U);
    EXPECT_EQ(withoutLicenceLine({"a.sh", {"#!/bin/sh", "set -e"}}).size(), 1U);
    EXPECT_EQ(withoutLicenceLine({"a.cpp", {}}).size(), 1U);
    EXPECT_TRUE(
        withoutLicenceLine({"a.sh", {"#!/bin/sh", "# SPDX-License-Identifier: GPL-3.0-or-later"}}).empty());
    EXPECT_EQ(tooLong({"a.cpp", std::vector<std::string>(601)}).size(), 1U);
    EXPECT_TRUE(tooLong({"a.cpp", std::vector<std::string>(600)}).empty());
    EXPECT_EQ(describe(unfinished({"a.cpp", {"int a;", std::string("// TO") + "DO: b"}})),
              "a.cpp:2: unfinished work\n");
}

/// Whether a build without the GUI may leave out the file.
bool isOfGui(const std::string& path) {
    static constexpr std::array kOfGui{"widgets/",           "app/console/",        "tests/widgets/",
                                       "tests/app/console/", "tests/peer/console/", "tests/peer/loop/",
                                       "tests/peer/ros/"};
    return std::ranges::any_of(kOfGui, [&path](const char* folder) { return path.starts_with(folder); });
}

/// Whether this build, which may leave out the GUI, the Python module or the benchmarks, is to compile the
/// file.
bool isPartOfThisBuild(const std::string& path) {
    const auto isBelow = [&](const char* folder) { return path.starts_with(folder); };
    if (!TELETA_HAS_GUI && isOfGui(path))
        return false;
    if (!TELETA_HAS_PYTHON && isBelow("app/python/"))
        return false;
    return TELETA_HAS_BENCHMARKS || !isBelow("tests/benchmarks/");
}

TEST(SourceFilesTest, areCompiled) {
    std::ifstream stream(TELETA_COMPILE_COMMANDS);
    std::string commands;
    for (std::string line; std::getline(stream, line);) {
        commands += line + '\n';
        // Sources that are compiled at once are named in a file that includes them.
        static const std::regex several(R"re("file": "(.*/unity_\d+_cxx\.cxx)")re");
        if (std::smatch match; std::regex_search(line, match, several)) {
            std::ifstream included(match[1].str());
            for (std::string source; std::getline(included, source);)
                commands += source + '\n';
        }
    }
    ASSERT_NE(commands.find("tests/architecture/source_files_test.cpp\""), std::string::npos);
    std::string forgotten;
    for (const SourceFile& file : readFiles(TELETA_SOURCE_DIR, kFolders, {".cpp"})) {
        const std::string entry = std::string("\"") + TELETA_SOURCE_DIR + '/' + file.path + '"';
        if (isPartOfThisBuild(file.path) && commands.find(entry) == std::string::npos)
            forgotten += file.path + '\n';
    }
    EXPECT_EQ(forgotten, "") << "name them in the CMakeLists.txt of their folder";
}

// A build with the GUI compiles all of them, and so does not notice one that the other build then misses.
TEST(SourceFilesTest, ofTheConsolesTestsLieInFoldersOfTheGui) {
    std::ifstream stream(std::string(TELETA_SOURCE_DIR) + "/tests/app/console/CMakeLists.txt");
    static const std::regex elsewhere(R"(\.\./\.\./(peer/[a-z_0-9/]+\.cpp))");
    std::size_t found = 0;
    for (std::string line; std::getline(stream, line);) {
        for (std::sregex_iterator match(line.begin(), line.end(), elsewhere), end; match != end;
             ++match, ++found)
            EXPECT_TRUE(isOfGui("tests/" + (*match)[1].str()))
                << (*match)[1] << ": move it to tests/peer/console";
    }
    EXPECT_GT(found, 0U);
}

TEST(SourceTreeTest, hasTheAgreedTopLevel) {
    const std::set<std::string> agreed = {"app",       "widgets",           "backend",      "devices",
                                          "resources", "translations",      "tests",        "packaging",
                                          "LICENSE",   "CMakePresets.json", "README.md",    "ARCHITECTURE.md",
                                          "build",     "CITATION.cff",      "CHANGELOG.md", "CMakeLists.txt"};
    for (const auto& entry : fs::directory_iterator(TELETA_SOURCE_DIR)) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name.starts_with('.') || agreed.contains(name))
            << name << " is not part of the agreed layout";
    }
    for (const std::string& folder : kFolders)
        EXPECT_TRUE(fs::is_directory(fs::path(TELETA_SOURCE_DIR) / folder)) << folder << " is missing";
}

} // namespace
} // namespace teleta::architecture
