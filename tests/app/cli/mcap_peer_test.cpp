// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/support/peer_process.h"

#include <QProcess>
#include <QProcessEnvironment>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

using nlohmann::ordered_json;
using teleta::test::PeerProcess;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr char kPeers[] = TELETA_SOURCE_DIR "/build/mcap-peers";

/// Exported files against the readers of @mcap/core, and files that it writes against the import.
class McapPeer : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(std::string(kPeers) + "/node_modules"))
            GTEST_SKIP() << "tests/peer/mcap/install.sh installs the peers";
    }

    /// Runs a script of tests/peer/mcap; returns what it prints.
    ordered_json node(const std::string& script, const std::vector<std::string>& arguments) {
        constexpr int kPatience_ms = 120'000;
        QStringList list{QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/mcap/") +
                         QString::fromStdString(script)};
        for (const std::string& argument : arguments)
            list << QString::fromStdString(argument);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("TELETA_MCAP_PEERS"), QString::fromUtf8(kPeers));
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral("node"), list);
        const bool ended = process.waitForFinished(kPatience_ms);
        const std::string errors = process.readAllStandardError().toStdString();
        EXPECT_TRUE(ended && process.exitCode() == 0) << script << ": " << errors;
        return ordered_json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);
    }

    std::string simulated(const std::string& scene, const std::string& duration_s) {
        const ProgramResult result =
            run({"simulate", scene, "--duration", duration_s, "--out", m_folder.path("run")});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return m_folder.path("run/recording.teleta");
    }

    /// Exports both ways and compares them; returns what the peer counted.
    ordered_json compared(const std::string& recording, const std::vector<std::string>& options) {
        const std::string csv = m_folder.path("csv");
        std::filesystem::remove_all(csv);
        EXPECT_EQ(run({"export", recording, "--csv", csv}).exitCode, 0);
        std::vector<std::string> arguments{"export", recording, "--mcap", m_folder.path("run.mcap"),
                                           "--force"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return node("check_export.mjs", {m_folder.path("run.mcap"), csv});
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(McapPeer, readsEveryValueOfAnArrayInEveryCompression) {
    const std::string recording = simulated("tactile-indenter", "2");
    for (const char* compression : {"zstd", "lz4", "none"}) {
        const ordered_json counted =
            compared(recording, {"--compression", compression, "--chunk-mb", "0.05"});
        ASSERT_TRUE(counted.is_object()) << compression;
        EXPECT_EQ(counted["topics"]["/frames/array"], counted["topics"]["/frames/image"]);
        EXPECT_GT(counted["values"], 10'000);
    }
}

TEST_F(McapPeer, readsJointsAndTouchesOfAnArm) {
    const ordered_json counted = compared(simulated("teleta-touch", "7"), {});
    ASSERT_TRUE(counted.is_object());
    EXPECT_EQ(counted["topics"]["/joints/joint_states"], counted["topics"]["/joints/joint_references"]);
    EXPECT_EQ(counted["topics"]["/touches/touches"], 1);
}

TEST_F(McapPeer, readsPicturesAndContactsOfACamera) {
    const ordered_json counted = compared(simulated("vtacarm-bump", "2"), {});
    ASSERT_TRUE(counted.is_object());
    EXPECT_GT(counted["topics"]["/camera/image/compressed"], 10);
    EXPECT_GT(counted["topics"]["/contacts/contacts"], 0);
    EXPECT_GE(counted["attachments"], 1);
    const ordered_json plain = compared(m_folder.path("run/recording.teleta"), {"--compression", "none"});
    EXPECT_EQ(plain["messages"], counted["messages"]);
}

TEST_F(McapPeer, writesFilesThatAreImported) {
    for (const char* compression : {"none", "zstd", "unchunked"}) {
        const std::string file = m_folder.path(std::string(compression) + ".mcap");
        const ordered_json written = node("write_file.mjs", {file, compression});
        ASSERT_TRUE(written.is_object()) << compression;
        const std::string recording = m_folder.path(std::string(compression) + ".teleta");
        const ProgramResult result = run({"import", file, "--out", recording, "--json"});
        ASSERT_EQ(result.exitCode, 0) << compression << ": " << result.err;
        const ordered_json report = ordered_json::parse(result.out);
        EXPECT_EQ(report["complete"], true);
        EXPECT_EQ(report["damaged_chunks"], 0);
        EXPECT_EQ(report["data_section_damaged"], false);
        const std::string csv = m_folder.path(std::string(compression) + "-csv");
        ASSERT_EQ(run({"export", recording, "--csv", csv}).exitCode, 0);
        for (const auto& [name, columns] : written["columns"].items()) {
            const auto rows = splitCsv(readAll(csv + "/" + name + ".csv"));
            ASSERT_EQ(rows.size(), written["rows"].size() + 1) << name;
            for (std::size_t row = 1; row < rows.size(); ++row) {
                const ordered_json& expected = written["rows"][row - 1];
                EXPECT_NEAR(std::stod(rows[row][0]), expected["time_s"].get<double>(), 1e-9);
                for (std::size_t i = 0; i < columns.size(); ++i) {
                    const auto column = std::ranges::find(rows[0], columns[i].get<std::string>());
                    ASSERT_NE(column, rows[0].end()) << name << ": " << columns[i];
                    const std::string& text = rows[row][static_cast<std::size_t>(column - rows[0].begin())];
                    EXPECT_EQ(std::stof(text), expected[name][i].get<float>()) << name << " row " << row;
                }
            }
        }
    }
}

TEST_F(McapPeer, writesNothingThatIsImportedFromAnotherEncoding) {
    const std::string file = m_folder.path("json.mcap");
    ASSERT_TRUE(node("write_file.mjs", {file, "json"}).is_object());
    const ProgramResult refused = run({"import", file, "--out", m_folder.path("json.teleta")});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.err.find("/chatter (json"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("json.teleta")));
}
