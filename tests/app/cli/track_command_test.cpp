// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/finders/contact_ladder.h"
#include "tests/app/cli/program_run.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

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
        m_tube = std::move(*tube);
        writeFrames("frame", {0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015});
    }
    void writeFrames(const std::string& name, const std::vector<double>& depths_m) {
        cv::Mat1b frame;
        for (std::size_t i = 0; i < depths_m.size(); ++i) {
            m_tube->pressed({{.centre = {kAngle_rad, kZ_m}, .ballRadius_m = 0.01, .depth_m = depths_m[i]}},
                            frame);
            ASSERT_TRUE(cv::imwrite(m_folder.path(name + "_0" + std::to_string(i) + ".png"), frame));
        }
    }
    /// Of a row's place from the finger's.
    static double distance_m(const std::vector<std::string>& row) {
        return std::hypot(std::stod(row[kX]) - 0.025 * std::cos(kAngle_rad),
                          std::stod(row[kY]) - 0.025 * std::sin(kAngle_rad), std::stod(row[kZ]) - kZ_m);
    }

    static constexpr double kAngle_rad = 1.0;
    static constexpr double kZ_m = 0.04;
    std::unique_ptr<teleta::simulation::SimulatedTube> m_tube;
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
    EXPECT_LT(distance_m(last), 0.001);
    EXPECT_GT(std::stod(last[kArea]), 100.0);
}

TEST_F(TrackCommand, tellsWhenAContactBumpsAndWhenItEnds) {
    // 0.6 mm a frame at 30 frames a second are 18 mm/s; then it is deeper than 1.5 mm, and gone.
    const std::vector<double> depths_m{0.0, 0.0006, 0.0012, 0.0018, 0.0018, -0.001, -0.001, -0.001, -0.001};
    writeFrames("bump", depths_m);
    const ProgramResult result = run({"track", m_folder.path("bump_%02d.png"), "--camera", m_camera});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    std::vector<std::string> events;
    std::vector<std::string> frames;
    const auto rows = splitCsv(result.out);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i][kId], "1");
        if (rows[i][kEvent] == "NA")
            continue;
        events.push_back(rows[i][kEvent]);
        frames.push_back(rows[i][kFrame]);
    }
    EXPECT_EQ(events, (std::vector<std::string>{"begin", "bump", "end"}));
    EXPECT_EQ(frames.at(1), "3");
    EXPECT_GE(frames.at(2), "6");
    // An end has the place where the contact was seen last.
    const auto& end = rows.back();
    EXPECT_EQ(end[kEvent], "end");
    EXPECT_EQ(end[kZ], rows[rows.size() - 2][kZ]);
}

TEST_F(TrackCommand, findsTheContactWithEachPreset) {
    for (const teleta::vision::ContactRung& rung : teleta::vision::contactLadder()) {
        const ProgramResult result =
            run({"track", m_video, "--camera", m_camera, "--preset", std::string(rung.name)});
        ASSERT_EQ(result.exitCode, 0) << rung.name << ": " << result.err;
        double nearest_m = 1.0; // in the frame of the deepest press
        for (const auto& row : splitCsv(result.out)) {
            if (row[kFrame] == "5" && row[kEvent] != "end")
                nearest_m = std::min(nearest_m, distance_m(row));
        }
        EXPECT_LT(nearest_m, 0.005) << rung.name;
        if (rung.method == teleta::vision::FlowMethod::dots || rung.scale == 1.0) {
            EXPECT_LT(nearest_m, 0.001) << rung.name;
        }
    }
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
    const ProgramResult away = run({"track", "63", "--camera", m_camera});
    EXPECT_EQ(away.exitCode, 1);
    EXPECT_EQ(away.err, "teleta: 63: camera 63 cannot be opened\n");
    // Images of another size than the camera's are no frames of it.
    ASSERT_TRUE(cv::imwrite(m_folder.path("small_0.png"), cv::Mat1b(100, 100, std::uint8_t{100})));
    const ProgramResult small = run({"track", m_folder.path("small_%d.png"), "--camera", m_camera});
    EXPECT_EQ(small.exitCode, 1);
    EXPECT_NE(small.err.find("100 x 100"), std::string::npos) << small.err;
}
