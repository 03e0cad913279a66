// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/camera_file.h"
#include "tests/app/cli/program_run.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

enum Column { kFrame, kTime, kId, kU, kV, kX, kY, kZ, kDx, kDy, kDz, kArea, kEvent };

/// Numbered images of a press that deepens, and the camera's file.
class TrackCommand : public testing::Test {
protected:
    void SetUp() override {
        teleta::scene::Scene scene = teleta::test::cameraScene();
        auto tube = teleta::simulation::SimulatedTube::make(scene, 1);
        ASSERT_TRUE(tube);
        const teleta::vision::CalibrationSummary none;
        const teleta::vision::CameraFile file{.camera = (*tube)->camera(), .summary = none};
        ASSERT_TRUE(teleta::vision::writeCamera(file, m_camera));
        cv::Mat1b frame;
        for (int i = 0; i < 6; ++i) {
            (*tube)->pressed({{.centre = {kAngle_rad, kZ_m}, .ballRadius_m = 0.01, .depth_m = 0.0003 * i}},
                             frame);
            ASSERT_TRUE(cv::imwrite(m_folder.path("frame_0" + std::to_string(i) + ".png"), frame));
        }
    }

    static constexpr double kAngle_rad = 1.0;
    static constexpr double kZ_m = 0.04;
    TemporaryFolder m_folder;
    std::string m_camera = m_folder.path("camera.json");
    std::string m_video = m_folder.path("frame_%02d.png");
};

} // namespace

TEST_F(TrackCommand, writesEachContactOfEachFrameWithItsPlaceOnTheTube) {
    const ProgramResult result = run({"track", m_video, "--camera", m_camera});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
              "frame,time_s,contact_id,u_px,v_px,x_m,y_m,z_m,dx_m,dy_m,dz_m,area_px,event");
    const auto rows = splitCsv(result.out);
    ASSERT_GE(rows.size(), 4U);
    EXPECT_EQ(rows[1][kEvent], "begin");
    const auto& last = rows.back();
    EXPECT_EQ(last[kFrame], "5");
    EXPECT_EQ(last[kId], "1");
    const double error_m =
        std::hypot(std::stod(last[kX]) - 0.025 * std::cos(kAngle_rad),
                   std::stod(last[kY]) - 0.025 * std::sin(kAngle_rad), std::stod(last[kZ]) - kZ_m);
    EXPECT_LT(error_m, 0.001);
    EXPECT_GT(std::stod(last[kArea]), 100.0);
}

TEST_F(TrackCommand, writesTheSameRowsToAFile) {
    const std::string out = m_folder.path("contacts.csv");
    const ProgramResult printed = run({"track", m_video, "--camera", m_camera});
    ASSERT_EQ(run({"track", m_video, "--camera", m_camera, "--out", out}).exitCode, 0);
    std::ostringstream written;
    written << std::ifstream(out).rdbuf();
    EXPECT_EQ(written.str(), printed.out);
}

TEST_F(TrackCommand, saysWhatIsWrongWithItsInput) {
    EXPECT_EQ(run({"track", m_video}).exitCode, 2);
    EXPECT_EQ(run({"track", m_video, "--camera", m_camera, "--preset", "best"}).exitCode, 2);
    EXPECT_EQ(run({"track", m_folder.path("no.avi"), "--camera", m_camera}).exitCode, 3);
    EXPECT_EQ(run({"track", m_folder.write("text.avi", "text"), "--camera", m_camera}).exitCode, 3);
    EXPECT_EQ(run({"track", m_video, "--camera", m_folder.path("no.json")}).exitCode, 3);
    EXPECT_EQ(run({"track", m_video, "--camera", m_folder.write("bad.json", "{")}).exitCode, 3);
    // Images of another size than the camera's are no frames of it.
    ASSERT_TRUE(cv::imwrite(m_folder.path("small_0.png"), cv::Mat1b(100, 100, std::uint8_t{100})));
    const ProgramResult small = run({"track", m_folder.path("small_%d.png"), "--camera", m_camera});
    EXPECT_EQ(small.exitCode, 1);
    EXPECT_NE(small.err.find("100 x 100"), std::string::npos) << small.err;
}
