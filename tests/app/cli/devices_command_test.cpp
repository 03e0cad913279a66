// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/gel_video.h"
#include "tests/app/cli/program_run.h"
#include "tests/devices/camera/written_video.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

/// Nobody listens on the loopback address at the port of discard.
const std::string kNobody =
    "kind = 'modbus'\nname = 'driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = 9\n"
    "[watchdog]\naddress = 6\n[tactors]\naddress = 0\ntype = 'uint16'\nunit = 'V'\nfull = 3\n";

class DevicesCommand : public testing::Test {
protected:
    ProgramResult probe(const std::string& text, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"devices", "--probe", m_folder.write("d.toml", text)});
        return run(options);
    }
    TemporaryFolder m_folder;
};

} // namespace

TEST_F(DevicesCommand, listsWhatIsPluggedIn) {
    const ProgramResult result = run({"devices", "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    ASSERT_TRUE(document["devices"].is_array()) << result.out;
    for (const ordered_json& device : document["devices"])
        EXPECT_TRUE(device["kind"] == "hid_bracelet" || device["kind"] == "mouse3d" ||
                    device["kind"] == "camera");
    EXPECT_EQ(run({"devices"}).exitCode, 0);
}

TEST_F(DevicesCommand, saysWhyADeviceIsNotConnected) {
    const ProgramResult result = probe(kNobody, {"--json"});
    EXPECT_EQ(result.exitCode, 1);
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    ASSERT_EQ(document["devices"].size(), 1U) << result.out;
    const ordered_json& device = document["devices"][0];
    EXPECT_EQ(device["kind"], "modbus");
    EXPECT_EQ(device["name"], "driver");
    EXPECT_EQ(device["where"], "tcp://127.0.0.1:9");
    EXPECT_EQ(device["connected"], false);
    EXPECT_NE(device["reason"].get<std::string>().find("Connection refused"), std::string::npos);
    EXPECT_TRUE(device["frame_rate_hz"].is_null());
    EXPECT_NE(result.err.find("Connection refused"), std::string::npos) << result.err;

    const ProgramResult table = probe(kNobody);
    EXPECT_EQ(table.exitCode, 1);
    EXPECT_NE(table.out.find("driver at tcp://127.0.0.1:9"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("not connected"), std::string::npos) << table.out;
}

TEST_F(DevicesCommand, saysWhenAnArrayIsNotThere) {
    const ProgramResult result =
        probe("kind = 'wts'\nname = 'array'\naddress = '/dev/nothing-here'\n", {"--json"});
    EXPECT_EQ(result.exitCode, 1) << result.err;
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    ASSERT_EQ(document["devices"].size(), 1U) << result.out;
    EXPECT_EQ(document["devices"][0]["kind"], "wts");
    EXPECT_EQ(document["devices"][0]["connected"], false);
}

TEST_F(DevicesCommand, readsACameraAndAVideoOfOne) {
    const std::string path = m_folder.path("tube.avi");
    ASSERT_NO_FATAL_FAILURE(teleta::test::writeVideo(path, 5, 25.0));
    const ProgramResult result =
        probe("kind = 'camera'\nname = 'tube'\nsource = '" + path + "'\n", {"--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    ASSERT_EQ(document["devices"].size(), 1U) << result.out;
    const ordered_json& device = document["devices"][0];
    EXPECT_EQ(device["kind"], "camera");
    EXPECT_EQ(device["where"], path);
    EXPECT_EQ(device["connected"], true);
    EXPECT_EQ(device["frame_rate_hz"], 25.0);
    EXPECT_EQ(device["values"][0]["value"], 160.0);
    EXPECT_EQ(device["values"][1]["value"], 120.0);

    const ProgramResult missing = probe("kind = 'camera'\nname = 'tube'\nsource = '9876'\n", {"--json"});
    EXPECT_EQ(missing.exitCode, 1) << missing.err;
    EXPECT_NE(missing.out.find("camera 9876 cannot be opened"), std::string::npos) << missing.out;
}

TEST_F(DevicesCommand, probesAFlatGelForItsMarkers) {
    const std::string video = m_folder.path("press.avi");
    ASSERT_TRUE(teleta::test::writeGelVideo(video, 12));
    const std::string file = teleta::test::kGelFile;
    const ProgramResult result = probe("source = 'press.avi'\n" + file, {"--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json device = ordered_json::parse(result.out)["devices"][0];
    EXPECT_EQ(device["kind"], "marker_gel");
    EXPECT_EQ(device["where"], video);
    EXPECT_EQ(device["frame_rate_hz"], 25.0);
    EXPECT_EQ(device["values"][2]["name"], "markers");
    EXPECT_EQ(device["values"][2]["value"], 80.0);
    EXPECT_NEAR(device["values"][4]["value"].get<double>(), 28.0, 0.1);
    // Another grid than the one in the picture, no source, no such camera.
    const std::vector<std::string> wrong{"source = 'press.avi'\nkind = 'marker_gel'\ngrid = 'rectangular'\n"
                                         "rows = 30\ncolumns = 40\n[plane]\nmm_per_px = 0.1\n",
                                         file, "source = '9876'\n" + file};
    for (const std::string& text : wrong) {
        const ProgramResult refused = probe(text, {"--json"});
        EXPECT_EQ(refused.exitCode, 1) << refused.err;
        EXPECT_EQ(ordered_json::parse(refused.out)["devices"][0]["connected"], false) << refused.out;
    }
}

TEST_F(DevicesCommand, refusesABadDescriptionWithItsPlace) {
    struct Case {
        std::string text;
        std::string error;
    };
    const std::vector<Case> cases = {
        {"kind = 'modem'\n", "d.toml:1:8: unknown value \"modem\" of \"kind\""},
        {"name = 'n'\n", "d.toml:1:1: \"kind\" is missing (expected kind = \"modbus\", \"wts\", \"camera\", "
                         "\"hid_bracelet\", \"taxels\", \"magnetometers\", \"xela\", \"sound_bracelet\", "
                         "\"marker_gel\", \"ros_tactile\" or \"ros_camera\")"},
        {"kind = 'hid_bracelet'\nname = 'b'\nvendor_id = 70000\nproduct_id = 1\n", "d.toml:3:13: "},
        {kNobody + "scale = 0\n", "d.toml:14:9: \"scale\" is 0"},
        {"kind = 'wts'\nname = 'a'\naddress = 'tcp://h'\n", "d.toml:3:11: "},
        {"kind = 'wts'\nname = 'a'\naddress = '/dev/ttyS0'\nspeed = 1\n",
         "d.toml:4:1: unknown key \"speed\""},
        {"kind = 'camera'\nname = 'c'\n", "\"source\" is missing"},
        {"kind = 'magnetometers'\nname = 'm'\npath = '/dev/ttyS0'\nchips = 1\nformat = "
         "'binary'\nthreshold_uT = 9\n"
         "positions_mm = [[0, 0]]\nloads = 'newtons.csv'\n",
         "newtons.csv:2:"},
        {"kind = 'camera'\nname = 'c'\nsource = '0'\nwidth_px = -1\n", "d.toml:4:12: "},
        {"kind = \n", "d.toml:1:"},
    };
    m_folder.write("newtons.csv", "load,signal,gain,gain_se,rest,least,greatest,scatter\n"
                                  "force_n,t1_z,0.5,0.01,0,0,10,0.02\n");
    for (const Case& c : cases) {
        const ProgramResult result = probe(c.text);
        EXPECT_EQ(result.exitCode, 3) << result.err;
        EXPECT_NE(result.err.find(c.error), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
    EXPECT_EQ(run({"devices", "--probe", "/nowhere/d.toml"}).exitCode, 3);
    EXPECT_EQ(run({"devices", "--probe"}).exitCode, 2);
}
