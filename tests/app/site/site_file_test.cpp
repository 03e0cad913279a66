// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <fstream>
#include <variant>

namespace teleta::site_program {
namespace {

constexpr const char* kHead = "kind = \"site\"\nname = \"lab\"\n[operator]\ninterface = \"lo\"\n"
                              "security = \"none\"\n";

std::string errorOf(const std::string& text) {
    const auto file = parseSite(text, "/files/site.toml");
    return file ? std::string() : core::describe(file.error());
}

TEST(SiteFile, hasTheKeysOfTheSpecification) {
    const auto file = parseSite(R"(kind = "site"
name = "lab"
supervisors = ["console1"]
motion_lease_ms = 120
control_lease_ms = 3000
loop_limit_ms = 400
record = true
publish_tactile_state = true
ros_reliable = true
[operator]
domain = 71
interface = "wg0"
peers = ["10.8.0.2", "10.8.0.3"]
security = "certificates"
certificates = "keys/site"
[ros]
domain = 5
interface = "eth1"
[[device]]
file = "arm.toml"
[[device]]
id = "pad"
wts = "/dev/ttyUSB0"
frame = "tool0"
pose = [0.0, 0.0, 0.02, 0.0, 0.0, 1.57]
[[device]]
id = "glove"
taxels = "glove.toml"
[[device]]
id = "practice"
scene = ":/scenes/teleoperation.toml"
)",
                                "/files/site.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->supervisors, std::set<std::string>{"console1"});
    EXPECT_EQ(file->times.motion_ns, 120'000'000);
    EXPECT_EQ(file->times.control_ns, 3'000'000'000);
    EXPECT_EQ(file->times.loopLimit_ns, 400'000'000);
    EXPECT_TRUE(file->record);
    ASSERT_TRUE(file->publishing);
    EXPECT_TRUE(file->publishing->reliable);
    EXPECT_EQ(file->publishing->domain, (dds::DomainConfig{5, "eth1", {}}));
    ASSERT_TRUE(file->meeting.security);
    EXPECT_EQ(file->meeting.security->folder, "/files/keys/site");
    ASSERT_EQ(file->devices.size(), 4U);
    EXPECT_EQ(file->devices[0].id, "arm");
    EXPECT_EQ(std::get<app::ArmRequest>(file->devices[0].request).path, "/files/arm.toml");
    EXPECT_EQ(file->devices[1].id, "pad");
    EXPECT_TRUE(std::holds_alternative<app::WtsRequest>(file->devices[1].request));
    ASSERT_TRUE(file->devices[1].pad);
    EXPECT_EQ(file->devices[1].pad->link, "tool0");
    EXPECT_EQ(file->devices[1].pad->position_m, (std::array{0.0, 0.0, 0.02}));
    EXPECT_EQ(file->devices[1].pad->rollPitchYaw_rad, (std::array{0.0, 0.0, 1.57}));
    EXPECT_FALSE(file->devices[2].pad);
    EXPECT_EQ(std::get<app::TaxelsRequest>(file->devices[2].request).path, "/files/glove.toml");
    EXPECT_EQ(file->devices[3].id, "practice");
    EXPECT_TRUE(std::holds_alternative<app::SceneRequest>(file->devices[3].request));
}

TEST(SiteFile, leasesHaveBoundsAndDefaults) {
    const std::string device = "[[device]]\nid = \"a\"\nscene = \":/scenes/teleoperation.toml\"\n";
    const auto file = parseSite(kHead + device, "site.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->times.motion_ns, 100'000'000);
    EXPECT_EQ(file->times.control_ns, 2'000'000'000);
    EXPECT_EQ(file->times.loopLimit_ns, 500'000'000);
    const std::string error = errorOf("motion_lease_ms = 301\n" + std::string(kHead) + device);
    EXPECT_NE(error.find("site.toml:1"), std::string::npos) << error;
}

TEST(SiteFile, aSceneOfTheProgramIsFoundByItsNameFromEveryFolder) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("site.toml").toStdString();
    const auto scene = [&] {
        const auto file =
            parseSite(std::string(kHead) + "[[device]]\nid = \"a\"\nscene = \"teleoperation\"\n", path);
        return file ? std::get<app::SceneRequest>(file->devices[0].request).path
                    : core::describe(file.error());
    };
    EXPECT_EQ(scene(), ":/scenes/teleoperation.toml");
    // A folder of results is no scene, a file is.
    ASSERT_TRUE(QDir(folder.path()).mkdir("teleoperation"));
    EXPECT_EQ(scene(), ":/scenes/teleoperation.toml");
    ASSERT_TRUE(QDir(folder.path()).rmdir("teleoperation"));
    std::ofstream(folder.filePath("teleoperation").toStdString()) << "name = 'mine'\n";
    EXPECT_EQ(scene(), folder.filePath("teleoperation").toStdString());
}

TEST(SiteFile, onlyAnArrayHasAPlaceOnAnArm) {
    const std::string head = std::string(kHead) + "[[device]]\nid = \"a\"\n";
    EXPECT_NE(errorOf(head + "scene = \":/scenes/teleoperation.toml\"\nframe = \"tool0\"\n").find("frame"),
              std::string::npos);
    EXPECT_NE(errorOf(head + "wts = \"/dev/x\"\npose = [0, 0, 0, 0, 0, 0]\n").find("needs a frame"),
              std::string::npos);
    EXPECT_NE(errorOf(head + "wts = \"/dev/x\"\nframe = \"a\"\npose = [0, 0, 0]\n").find("site.toml:10"),
              std::string::npos)
        << errorOf(head + "wts = \"/dev/x\"\nframe = \"a\"\npose = [0, 0, 0]\n");
}

TEST(SiteFile, devicesHaveNamesOfTheirOwn) {
    EXPECT_NE(errorOf(kHead).find("device"), std::string::npos);
    const std::string scene = "scene = \":/scenes/teleoperation.toml\"\n";
    EXPECT_NE(errorOf(kHead + ("[[device]]\n" + scene)).find("id"), std::string::npos);
    EXPECT_NE(errorOf(kHead + ("[[device]]\nid = \"a\"\n" + scene + "[[device]]\nid = \"a\"\n" + scene))
                  .find("two devices are called \"a\""),
              std::string::npos);
    EXPECT_NE(errorOf(std::string(kHead) + "[[device]]\nfile = \"Left Arm.toml\"\n").find("needs an id"),
              std::string::npos);
    EXPECT_NE(errorOf(std::string(kHead) + "[[device]]\nid = \"a\"\nrecording = \"0\"\n")
                  .find("does not send this kind"),
              std::string::npos);
}

TEST(SiteFile, aGelIsADeviceByItsOwnFileOrByAKey) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path("finger.toml")) << "kind = \"marker_gel\"\nsource = \"0\"\ngrid = \"free\"\n"
                                                 "[plane]\nmm_per_px = 0.1\n";
    const auto file = parseSite(std::string(kHead) + R"([[device]]
gel = "finger.toml"
id = "thumb"
quality = 95
max_kbit_s = 4000
[[device]]
file = "finger.toml"
)",
                                folder.path("site.toml"));
    ASSERT_TRUE(file) << core::describe(file.error());
    ASSERT_EQ(file->devices.size(), 2U);
    EXPECT_EQ(file->devices[0].id, "thumb");
    EXPECT_EQ(std::get<app::GelRequest>(file->devices[0].request).path, folder.path("finger.toml"));
    EXPECT_EQ(file->devices[0].pictures.quality, 95);
    EXPECT_EQ(file->devices[0].pictures.most_kbitPerS, 4000.0);
    EXPECT_EQ(file->devices[1].id, "finger");
    EXPECT_EQ(std::get<app::GelRequest>(file->devices[1].request).path, folder.path("finger.toml"));
    EXPECT_NE(errorOf(std::string(kHead) + "[[device]]\nid = \"a\"\ngel = \"g.toml\"\nframe = \"tool0\"\n")
                  .find("frame"),
              std::string::npos)
        << "it is no array on an arm";
}

TEST(SiteFile, aCameraIsLookedAt) {
    const auto file = parseSite(std::string(kHead) + R"([[device]]
id = "overview"
camera = "0"
quality = 60
max_kbit_s = 1500
[[device]]
id = "side"
scene_camera = "side.mp4"
width_px = 640
[[device]]
id = "pad"
wts = "/dev/ttyUSB0"
)",
                                "/files/site.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    ASSERT_EQ(file->devices.size(), 3U);
    EXPECT_EQ(std::get<app::SceneCameraRequest>(file->devices[0].request).source, "0");
    EXPECT_EQ(file->devices[0].pictures.quality, 60);
    EXPECT_EQ(file->devices[0].pictures.most_kbitPerS, 1500.0);
    EXPECT_EQ(std::get<app::SceneCameraRequest>(file->devices[1].request).source, "/files/side.mp4");
    EXPECT_EQ(std::get<app::SceneCameraRequest>(file->devices[1].request).width_px, 640);
    EXPECT_EQ(file->devices[1].pictures.quality, 70);
    EXPECT_EQ(file->devices[1].pictures.most_kbitPerS, 3000.0);
    for (const char* wrong :
         {"camera = \"0\"\nquality = 101\n", "camera = \"0\"\nmax_kbit_s = 1\n",
          "wts = \"/dev/ttyUSB0\"\nquality = 60\n", "camera = \"0\"\nscene_camera = \"1\"\n"})
        EXPECT_NE(errorOf(std::string(kHead) + "[[device]]\nid = \"a\"\n" + wrong).find("site.toml:"),
                  std::string::npos)
            << wrong;
}

TEST(SiteFile, aFileOfItsOwnSaysWhatItIs) {
    QTemporaryDir folder;
    const auto write = [&folder](const char* name, const std::string& text) {
        std::ofstream(folder.filePath(QLatin1String(name)).toStdString()) << text;
    };
    write("front.toml", "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"/front/image_raw\"\n");
    write("list.toml", "[[source]]\nscene = \"a\"\n[[source]]\nscene = \"b\"\n");
    const std::string path = folder.filePath("site.toml").toStdString();
    const auto file = parseSite(
        std::string(kHead) +
            "[[device]]\nfile = \"front.toml\"\nmax_kbit_s = 500\n[[device]]\nfile = \"arm.toml\"\n",
        path);
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->devices[0].id, "front");
    EXPECT_EQ(std::get<app::SceneCameraRequest>(file->devices[0].request).source,
              folder.filePath("front.toml").toStdString());
    EXPECT_EQ(file->devices[0].pictures.most_kbitPerS, 500.0);
    EXPECT_TRUE(std::holds_alternative<app::ArmRequest>(file->devices[1].request));
    const auto list = parseSite(std::string(kHead) + "[[device]]\nfile = \"list.toml\"\n", path);
    ASSERT_FALSE(list);
    EXPECT_NE(core::describe(list.error()).find("does not send this kind"), std::string::npos);
}

} // namespace
} // namespace teleta::site_program
