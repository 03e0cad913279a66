// SPDX-License-Identifier: GPL-3.0-or-later
// The command against a Modbus server that somebody else wrote.
#include "tests/app/cli/program_run.h"
#include "tests/support/peer_process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::ordered_json;
using teleta::test::PeerProcess;
using teleta::test::ProgramResult;
using teleta::test::TemporaryFolder;

TEST(DevicesCommandPeer, readsTheInputsAndMeasuresTheRates) {
    const QString python = QStringLiteral("/usr/bin/python3");
    if (!teleta::test::runs(python,
                            {QStringLiteral("-c"), QStringLiteral("import pymodbus.server.async_io")}))
        GTEST_SKIP() << "python3-pymodbus or python3-serial-asyncio is not installed";
    PeerProcess server;
    server.start(python, {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"),
                          QStringLiteral("tcp"), QStringLiteral("0")});
    const auto ready = server.waitFor("ready ");
    ASSERT_TRUE(ready) << server.errors();
    ASSERT_TRUE(server.command("set 10 9 9 9 9 9 9"));
    ASSERT_TRUE(server.command("set 100 1250"));
    TemporaryFolder folder;
    const std::string file = folder.write(
        "d.toml", "kind = 'modbus'\nname = 'driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = " +
                      ready->substr(6) +
                      "\n[tactors]\naddress = 10\ntype = 'uint16'\nunit = '1'\nfull = "
                      "100\n[watchdog]\naddress = 20\n[[input]]\nname = "
                      "'supply'\naddress = 100\ntype = 'uint16'\nscale = 0.01\nunit = 'V'\n");
    const ProgramResult result = teleta::test::run({"devices", "--probe", file, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    ASSERT_EQ(document["devices"].size(), 1U) << result.out;
    const ordered_json& device = document["devices"][0];
    EXPECT_EQ(device["connected"], true);
    EXPECT_TRUE(device["reason"].is_null());
    EXPECT_GT(device["frame_rate_hz"], 0.0);
    EXPECT_LE(device["frame_rate_hz"], 200.0);
    EXPECT_GT(device["input_rate_hz"], 0.0);
    EXPECT_EQ(device["values"], ordered_json::parse(R"([{"name":"supply","value":12.5,"unit":"V"}])"));
    ASSERT_TRUE(server.command("sync"));
    bool zeroed = false;
    for (const std::string& line : server.takeLines()) {
        if (line.starts_with("write 10 ")) {
            EXPECT_EQ(line, "write 10 0 0 0 0 0 0");
        }
        zeroed = zeroed || line == "write 10 0 0 0 0 0 0";
    }
    EXPECT_TRUE(zeroed) << "the motors are off after a probe";

    const ProgramResult table = teleta::test::run({"devices", "--probe", file});
    EXPECT_NE(table.out.find("12.5 V"), std::string::npos) << table.out;
}
