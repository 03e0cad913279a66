// SPDX-License-Identifier: GPL-3.0-or-later
// The command against a Modbus server that somebody else wrote, and a board in Python.
#include "tests/app/cli/program_run.h"
#include "tests/devices/taxels/board.h"
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

TEST(DevicesCommandPeer, warnsOfMagnetometersThatAreWarmingUp) {
    TemporaryFolder folder;
    const std::string file =
        folder.write("skin.toml", "kind = 'magnetometers'\nname = 'skin'\npath = 'port'\nchips = 5\n"
                                  "format = 'binary'\nthreshold_uT = 40.0\n"
                                  "positions_mm = [[0, 0], [7, 0], [-7, 0], [0, 7], [0, -7]]\n");
    for (const bool warms : {false, true}) {
        teleta::taxels::test::Board board("pty", "skin", folder.path("port"));
        // Again and again: what came before the port was opened is not read.
        std::string line = "write";
        for (int i = 0; i < 8; ++i)
            line += warms ? " pause:400 0-9 416" : " pause:400 0-9 16";
        board.say(line);
        const ProgramResult result = teleta::test::run({"devices", "--probe", file, "--json"});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        const ordered_json device = ordered_json::parse(result.out, nullptr, false)["devices"][0];
        EXPECT_EQ(device["values"][4],
                  ordered_json::parse(R"({"name":"temperature_4","value":25.0,"unit":"degC"})"));
        EXPECT_EQ(device["values"][5]["name"], "temperature_change");
        EXPECT_EQ(device["values"][5]["value"], warms ? 6.5 : 0.25);
        EXPECT_EQ(device.contains("warning"), warms) << device.dump();
    }
}

TEST(DevicesCommandPeer, showsWhatADescribedArraySends) {
    TemporaryFolder folder;
    const std::string file = folder.write(
        "glove.toml",
        "kind = 'taxels'\nname = 'glove'\nthreshold = 5\n[link]\ntype = 'file'\npath = 'bytes.bin'\n"
        "[layout]\nrows = 6\ncolumns = 14\npitch_x_mm = 3.4\n[frame]\nencoding = 'binary'\nsync = 'AA 55'\n"
        "length = 179\nchecksum = { type = 'crc16-ccitt' }\n"
        "values = { at = 9, type = 'uint16', count = 84 }\n");
    {
        teleta::taxels::test::Board board("file", "counted", folder.path("bytes.bin"));
        ASSERT_TRUE(board.command("write noise:0041 7 flip:8 9"));
    }
    const ProgramResult result = teleta::test::run({"devices", "--probe", file, "--bytes", "181", "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const ordered_json device = ordered_json::parse(result.out, nullptr, false)["devices"][0];
    EXPECT_EQ(device["kind"], "taxels");
    EXPECT_EQ(device["name"], "glove");
    const ordered_json& stream = device["stream"];
    EXPECT_EQ(stream["frames"], 2);
    EXPECT_EQ(stream["wrong_checksums"], 1);
    EXPECT_EQ(stream["dropped_bytes"], 2 + 179);
    EXPECT_EQ(stream["unit"], "counts");
    EXPECT_EQ(stream["frames_found"], ordered_json::parse(R"([{"begin":2,"bytes":179}])"));
    EXPECT_EQ(stream["bytes_hex"].get<std::string>().substr(0, 8), "0041AA55");
    EXPECT_EQ(stream["bytes_hex"].get<std::string>().size(), 2 * 181U);
    EXPECT_EQ(stream["first_frame"][3], 7 * 131 + 3);

    const ProgramResult table = teleta::test::run({"devices", "--probe", file, "--bytes", "16"});
    EXPECT_EQ(table.exitCode, 0) << table.err;
    EXPECT_NE(table.out.find("000000  00 41>AA 55"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("First frame in counts"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("917"), std::string::npos) << table.out;

    const std::string silent =
        folder.write("silent.toml", std::string("kind = 'taxels'\nname = 'glove'\n") +
                                        "[link]\ntype = 'file'\npath = 'nothing.bin'\n"
                                        "[layout]\nrows = 1\ncolumns = 2\npitch_x_mm = "
                                        "3.4\nunit = 'N'\n[frame]\nencoding = "
                                        "'csv'\ncolumns = '1..2'\n");
    const ProgramResult missing = teleta::test::run({"devices", "--probe", silent});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_NE(missing.err.find("nothing.bin"), std::string::npos) << missing.err;
    folder.write("nothing.bin", "no numbers\n");
    const ProgramResult none = teleta::test::run({"devices", "--probe", silent});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_NE(none.err.find("no frame"), std::string::npos) << none.err;
}
