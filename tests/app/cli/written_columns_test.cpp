// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/unit_names.h"
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::json;
using teleta::core::unitOfColumn;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

/// Names of the first line of a text; they contain no quotes.
std::vector<std::string> columnsOf(const std::string& text, char separator) {
    std::string line = text.substr(0, text.find('\n'));
    if (line.starts_with("\xEF\xBB\xBF"))
        line.erase(0, 3);
    std::erase_if(line, [](char c) { return c == '"' || c == '\r'; });
    std::vector<std::string> names(1);
    for (const char c : line) {
        if (c == separator)
            names.emplace_back();
        else
            names.back() += c;
    }
    return names;
}

/// The columns of a table that the table of units does not know, each with the file.
std::string unknownColumns(const std::vector<std::string>& columns, const std::string& file) {
    std::string unknown;
    for (const std::string& column : columns)
        if (!unitOfColumn(column))
            unknown += file + ": " + column + "\n";
    return unknown;
}

/// The keys of a document whose unit is in upper case.
std::string upperCaseKeys(const json& document, const std::string& file) {
    std::string wrong;
    for (const auto& [key, value] : document.items()) {
        if (document.is_object() && !teleta::core::unitOf(key).empty() &&
            teleta::core::lowerCaseUnit(key) != key)
            wrong += file + ": " + key + "\n";
        if (value.is_structured())
            wrong += upperCaseKeys(value, file);
    }
    return wrong;
}

class WrittenColumns : public testing::Test {
protected:
    void works(std::vector<std::string> arguments) {
        for (std::string& argument : arguments)
            if (argument.starts_with('@'))
                argument = m_folder.path(argument.substr(1));
        const ProgramResult result = run(arguments);
        // A servo that is cut off ends with 1, and its files are there.
        ASSERT_TRUE(result.exitCode == 0 || (result.exitCode == 1 && arguments.front() == "simulate"))
            << arguments.front() << ": " << result.err;
        if (result.out.starts_with('{') || result.out.starts_with('['))
            m_wrong += upperCaseKeys(json::parse(result.out), arguments.front() + " --json");
    }
    void simulate(const std::string& scene, const std::string& duration_s) {
        works({"simulate", scene, "--duration", duration_s, "--out", "@" + scene, "--json"});
        const std::string recording = "@" + scene + "/recording.teleta";
        if (fs::exists(m_folder.path(recording.substr(1))))
            works({"export", recording, "--csv", "@" + scene + "/csv", "--json"});
    }
    void checkAll() {
        for (const auto& entry : fs::recursive_directory_iterator(m_folder.path(""))) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".csv" || ending == ".tsv") {
                const std::string text = readAll(entry.path().string());
                const bool semicolons = entry.path().string().find("excel") != std::string::npos;
                addOnce(columnsOf(text, ending == ".tsv" ? '\t'
                                        : semicolons     ? ';'
                                                         : ','),
                        entry.path().filename().string());
                ++m_tables;
            } else if (ending == ".json") {
                m_wrong += upperCaseKeys(json::parse(readAll(entry.path().string())),
                                         entry.path().filename().string());
            }
        }
    }

    /// Names each unknown column with the first file that has it.
    void addOnce(const std::vector<std::string>& columns, const std::string& file) {
        for (const std::string& column : columns)
            if (m_seen.insert(column).second)
                m_wrong += unknownColumns({column}, file);
    }

    TemporaryFolder m_folder;
    std::set<std::string> m_seen;
    std::string m_wrong;
    int m_tables = 0;
};

} // namespace

TEST_F(WrittenColumns, ofScenesAndTheirRecordingsAllHaveAnEntryInTheTableOfUnits) {
    simulate("tactile-even-load", "3");
    simulate("tactile-two-contacts", "1");
    simulate("teleta-touch", "7");
    simulate("teleta-contour-circle", "4");
    simulate("teleoperation", "4");
    simulate("servo-bent-bar", "2");
    simulate("vtacarm-multicontact", "0.1");
    simulate("vtacarm-bump", "0.1");
    simulate("vtacarm-calibration", "60");
    simulate("gel-slip", "2");
    checkAll();
    EXPECT_GT(m_tables, 20);
    EXPECT_EQ(m_wrong, "");
}

TEST_F(WrittenColumns, ofTheOtherCommandsAllHaveAnEntryInTheTableOfUnits) {
    simulate("tactile-even-load", "3");
    const std::string frames = "@tactile-even-load/frames.csv";
    works({"features", frames, "--out", "@features.csv"});
    works({"contacts", frames, "--out", "@contacts.csv"});
    works({"gains", frames, "--out", "@gains.csv", "--json"});
    works({"replay", "@tactile-even-load/recording.teleta", "--out", "@replay.csv"});
    m_folder.write("points.csv", "x_m,y_m\n0.05,0\n0,0.05\n-0.05,0\n0,-0.05\n");
    works({"contour", "@points.csv", "--closed", "--curve", "@curve.csv", "--json"});
    simulate("vtacarm-calibration", "60");
    works({"calibrate", "@vtacarm-calibration/pairs.csv", "--out", "@camera.json", "--residuals",
           "@residuals.csv", "--json"});
    works({"locate", "@camera.json", "@vtacarm-calibration/pairs.csv", "--out", "@points3.csv"});
    works({"pattern", "render", "shape.A.static", "--csv", "@render.csv"});
    works({"pattern", "convert", "shape.A.static", "@converted.csv"});
    works({"simulate", "tactile-indenter", "--duration", "0.2", "--ablate", "--seeds", "2", "--out",
           "@ablation.csv"});
    works({"tradeoff", "contour", "--out", "@cost", "--largest-spread", "1000"});
    works({"study", "rehearse", "--participants", "2", "--seed", "5", "--out", "@study"});
    for (const char* form : {"psychds", "bids", "excel"})
        works({"study", "export", "@study", "--format", form});
    works({"study", "analyze", "@study", "--out", "@analysis", "--json"});
    checkAll();
    EXPECT_GT(m_tables, 20);
    EXPECT_EQ(m_wrong, "");
}

// What the console copies and saves as CSV is written by its views; the first line stands in their source.
TEST_F(WrittenColumns, ofTheViewsAllHaveAnEntryInTheTableOfUnits) {
    static const std::regex literal(R"rx(QStringLiteral\(((\s*"[^"\n]*")+)\s*\))rx");
    static const std::regex header(R"rx([a-zA-Z0-9_%]+(,[a-zA-Z0-9_%]+){2,}(\\n)?)rx");
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TELETA_SOURCE_DIR) / "widgets")) {
        if (entry.path().extension() != ".cpp")
            continue;
        const std::string source = readAll(entry.path().string());
        for (std::sregex_iterator found(source.begin(), source.end(), literal), end; found != end; ++found) {
            std::string text =
                std::regex_replace((*found)[1].str(), std::regex(R"rx("\s*"|^\s*"|"\s*$)rx"), "");
            if (!std::regex_match(text, header) || text.starts_with('%'))
                continue;
            ++m_tables;
            if (text.ends_with("\\n"))
                text.resize(text.size() - 2);
            std::vector<std::string> columns = columnsOf(text, ',');
            std::erase_if(columns,
                          [](const std::string& name) { return name.find('%') != std::string::npos; });
            m_wrong += unknownColumns(columns, entry.path().filename().string());
        }
    }
    EXPECT_GT(m_tables, 12);
    EXPECT_EQ(m_wrong, "");
}

TEST_F(WrittenColumns, aColumnWithoutAnEntryIsFound) {
    EXPECT_EQ(unknownColumns(columnsOf("time_s,\"force_N\",mood\r\n1,2,3\n", ','), "f"),
              "f: force_N\nf: mood\n");
    EXPECT_EQ(upperCaseKeys(json::parse(R"({"a": [{"rate_Hz": 1, "rate_hz": 1}]})"), "f"), "f: rate_Hz\n");
}
