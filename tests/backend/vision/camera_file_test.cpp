// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_file.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/vision/test_cameras.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::vision {
namespace {

CameraFile paperFile() {
    CameraCovariance covariance = CameraCovariance::Identity() * 1e-7;
    covariance(0, 1) = covariance(1, 0) = 3e-8;
    return {CylinderCamera(*CameraModel::create(paperCamera()), CylinderSurface{0.024, -0.001, 0.09},
                           covariance, 0.4),
            {"robust", 250, 240, 0.5, 0.6, 2e-4, {"off_surface", "structured"}}};
}

std::string text() {
    return cameraJson(paperFile()).dump(2);
}

std::string with(std::string from, const std::string& old, const std::string& replacement) {
    const std::size_t at = from.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return from.replace(at, old.size(), replacement);
}

core::Error errorOf(const std::string& changed) {
    const auto file = parseCamera(changed, "camera.json");
    EXPECT_FALSE(file);
    return file ? core::Error{} : file.error();
}

TEST(CameraFile, readsBackWhatItWrote) {
    const test::TemporaryFolder folder;
    const CameraFile written = paperFile();
    ASSERT_TRUE(writeCamera(written, folder.path("camera.json")));
    const auto read = readCamera(folder.path("camera.json"));
    ASSERT_TRUE(read) << core::describe(read.error());
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(400.0, 500.0), Eigen::Vector2d(900.0, 900.0)}) {
        const auto point_m = written.camera.locate_m(pixel);
        ASSERT_TRUE(point_m);
        EXPECT_EQ(*read->camera.locate_m(pixel), *point_m);
        EXPECT_EQ(*read->camera.standardDeviation_m(*point_m), *written.camera.standardDeviation_m(*point_m));
    }
    EXPECT_EQ(read->camera.covariance(), written.camera.covariance());
    EXPECT_EQ(read->summary.method, "robust");
    EXPECT_EQ(read->summary.kept, 240U);
    EXPECT_EQ(read->summary.warnings, (std::vector<std::string>{"off_surface", "structured"}));
    EXPECT_EQ(cameraJson(*read), cameraJson(written));
}

TEST(CameraFile, warningsAreWordsAndMayBeMissing) {
    const std::string words = "\"warnings\": [\n      \"off_surface\",\n      \"structured\"\n    ]";
    const auto unknown = parseCamera(with(text(), words, "\"warnings\": [\"of_a_newer_version\"]"), "a");
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->summary.warnings, std::vector<std::string>{"of_a_newer_version"});
    const auto without = parseCamera(with(text(), ",\n    " + words, ""), "a");
    ASSERT_TRUE(without);
    EXPECT_TRUE(without->summary.warnings.empty());
    EXPECT_EQ(errorOf(with(text(), words, "\"warnings\": [3]")).kind, core::ErrorKind::badInput);
    EXPECT_EQ(errorOf(with(text(), words, "\"warnings\": true")).kind, core::ErrorKind::badInput);
}

TEST(CameraFile, keepsKeysThatItDoesNotKnow) {
    const auto read = parseCamera(with(text(), "\"K\"", "\"made_by\": {\"name\": \"rig 3\"},\n  \"K\""), "a");
    ASSERT_TRUE(read);
    EXPECT_EQ(cameraJson(*read)["made_by"]["name"], "rig 3");
}

TEST(CameraFile, whatIsWrongIsNamedWithItsPlace) {
    EXPECT_EQ(errorOf("{\n  \"format\": \"other\"\n}").where.line, 2);
    EXPECT_EQ(errorOf("{").where.file, "camera.json");
    const core::Error version = errorOf(with(text(), "\"version\": 1", "\"version\": 2"));
    EXPECT_EQ(version.where.line, 3);
    EXPECT_NE(version.message.find("newer"), std::string::npos);
    const core::Error width = errorOf(with(text(), "\"width_px\": 1640", "\"width_px\": -4"));
    EXPECT_EQ(width.where.line, 4);
    EXPECT_EQ(width.where.column, 15);
    EXPECT_NE(errorOf(with(text(), "\"K\"", "\"Q\"")).message.find("\"K\""), std::string::npos);
    EXPECT_NE(errorOf(with(text(), "700.0", "-700.0")).message.find("focal"), std::string::npos);
    EXPECT_NE(errorOf(with(text(), "\"lowest_z_m\": -0.001", "\"lowest_z_m\": 0.2")).message.find("length"),
              std::string::npos);
    EXPECT_NE(errorOf(with(text(), "\"mirrored\": true", "\"mirrored\": 7")).message.find("true"),
              std::string::npos);
}

TEST(CameraFile, refusesNumbersThatNoCameraHas) {
    const nlohmann::ordered_json good = cameraJson(paperFile());
    ASSERT_TRUE(parseCamera(good.dump(), "camera.json"));
    const auto refuses = [&](const char* pointer, double value) {
        nlohmann::ordered_json changed = good;
        const nlohmann::ordered_json::json_pointer place(pointer);
        EXPECT_TRUE(changed.contains(place)) << pointer;
        changed[place] = value;
        const auto read = parseCamera(changed.dump(), "camera.json");
        return !read && read.error().kind == core::ErrorKind::badInput && read.error().where.line > 0;
    };
    for (const char* pointer : {"/K/0/0", "/K/0/2", "/C_m/0", "/distortion/k1", "/distortion/p2",
                                "/cylinder/radius_m", "/cylinder/lowest_z_m", "/cylinder/highest_z_m",
                                "/noise_px", "/covariance/0/0", "/covariance/1/0"}) {
        EXPECT_TRUE(refuses(pointer, -9.2e18)) << pointer;
        EXPECT_TRUE(refuses(pointer, 9.2e18)) << pointer;
    }
    EXPECT_TRUE(refuses("/covariance/2/2", -1e-12)) << "a negative variance";
    EXPECT_TRUE(refuses("/covariance/0/1", 2e-7)) << "larger than both variances";
}

TEST(CameraFile, aFileThatIsNotThereIsNotFound) {
    const auto read = readCamera("/nonexistent/camera.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, core::ErrorKind::notFound);
}

TEST(PairFile, readsPairsAndNamesWhatIsWrong) {
    const test::TemporaryFolder folder;
    const auto pairs = readPairs(folder.write("a.csv", "z_m,u_px,v_px,x_m,y_m,note\n0.3,1,2,0.1,0.2,5\n"));
    ASSERT_TRUE(pairs) << core::describe(pairs.error());
    ASSERT_EQ(pairs->size(), 1U);
    EXPECT_EQ((*pairs)[0].pixel, Eigen::Vector2d(1.0, 2.0));
    EXPECT_EQ((*pairs)[0].p_Sensor_m, Eigen::Vector3d(0.1, 0.2, 0.3));
    const auto damaged = readPairs(folder.write("b.csv", "u_px,v_px,x_m,y_m,z_m\n1,2,3,4,x\n"));
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().where.line, 2);
    EXPECT_EQ(damaged.error().where.column, 9);
    EXPECT_FALSE(readPairs(folder.write("c.csv", "u_px,v_px,x_m,y_m\n")));
}

TEST(CalibrationRefusals, allHaveWords) {
    for (int i = 0; i <= static_cast<int>(CalibrationRefusal::folds); ++i) {
        const core::Error error = describe(static_cast<CalibrationRefusal>(i), 4);
        EXPECT_FALSE(error.message.empty()) << i;
        EXPECT_FALSE(error.expected.empty()) << i;
        EXPECT_STRNE(toString(static_cast<CalibrationRefusal>(i)), "") << i;
    }
}

} // namespace
} // namespace teleta::vision
