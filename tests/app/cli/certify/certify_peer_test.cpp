// SPDX-License-Identifier: GPL-3.0-or-later
// The command against a motor driver that somebody else wrote.
#include "tests/app/cli/program_run.h"
#include "tests/support/peer_process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::json;
using teleta::test::PeerProcess;
using teleta::test::ProgramResult;
using teleta::test::TemporaryFolder;

namespace {

/// A driver by pymodbus. Empty: it is not installed.
std::optional<std::string> startDriver(PeerProcess& server, const TemporaryFolder& folder,
                                       const char* watchdog) {
    const QString python = QStringLiteral("/usr/bin/python3");
    if (!teleta::test::runs(python,
                            {QStringLiteral("-c"), QStringLiteral("import pymodbus.server.async_io")}))
        return std::nullopt;
    server.start(python, {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"),
                          QStringLiteral("tcp"), QStringLiteral("0")});
    const auto ready = server.waitFor("ready ");
    if (!ready || (*watchdog != '\0' && !server.command(watchdog))) {
        ADD_FAILURE() << server.errors();
        return std::nullopt;
    }
    return folder.write("d.toml",
                        "kind = 'modbus'\nname = 'peer'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = " +
                            ready->substr(6) +
                            "\n[tactors]\naddress = 10\ntype = 'uint16'\nunit = '1'\nfull = "
                            "100\n[watchdog]\naddress = 20\n");
}

ProgramResult certify(const std::string& file, const TemporaryFolder& folder, const char* kinds) {
    return teleta::test::run({"certify", "--bracelet", file, "--yes", "--kinds", kinds, "--faults", "6",
                              "--bound", "2", "--out", folder.path("report"), "--json"});
}

} // namespace

TEST(CertifyCommandPeer, aDriverWithAWatchdogPasses) {
    TemporaryFolder folder;
    PeerProcess server;
    const auto file = startDriver(server, folder, "watchdog 10 6 20 0.1");
    if (!file)
        GTEST_SKIP() << "python3-pymodbus or python3-serial-asyncio is not installed";
    const ProgramResult result = certify(*file, folder, "kill,unplug,stop");
    EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
    const json report = json::parse(result.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << result.out;
    EXPECT_EQ(report["system"]["simulated"], false);
    EXPECT_EQ(report["system"]["driver"], "peer");
    EXPECT_EQ(report["total"]["faults"], 6);
    EXPECT_EQ(report["total"]["over_bound"], 0);
}

TEST(CertifyCommandPeer, aDriverWithoutAWatchdogIsFoundOut) {
    TemporaryFolder folder;
    PeerProcess server;
    const auto file = startDriver(server, folder, "");
    if (!file)
        GTEST_SKIP() << "python3-pymodbus or python3-serial-asyncio is not installed";
    const ProgramResult result = certify(*file, folder, "kill");
    EXPECT_EQ(result.exitCode, 1) << result.err << result.out;
    const json report = json::parse(result.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << result.out;
    EXPECT_EQ(report["passes"], false);
    EXPECT_EQ(report["total"]["not_zero"], 6) << "nothing turned the motors off";
}
