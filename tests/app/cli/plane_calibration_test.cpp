// SPDX-License-Identifier: GPL-3.0-or-later
// teleta calibrate --plane
#include "backend/vision/gel/marker_gel_file.h"
#include "tests/app/cli/gel_video.h"
#include "tests/app/cli/program_run.h"
#include "tests/backend/vision/gel/drawn_board.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include <cmath>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

/// 12 500 px/m, turned by 0.2 rad: 0.08 mm a pixel.
Eigen::Matrix3d seenSquarely() {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix.topLeftCorner<2, 2>() = 12'500.0 * Eigen::Rotation2Dd(0.2).toRotationMatrix();
    matrix.topRightCorner<2, 1>() = Eigen::Vector2d(95.0, 50.0);
    return matrix;
}

std::string boardIn(const TemporaryFolder& folder) {
    const std::string path = folder.path("board.png");
    cv::imwrite(path, teleta::test::drawnBoard(seenSquarely(), {7, 5, 0.002}, 2.0));
    return path;
}

} // namespace

TEST(PlaneCalibration, findsTheScaleFromAChessboardAndWritesItForTheSensorFile) {
    const TemporaryFolder folder;
    const std::string lines = folder.path("plane.toml");
    const ProgramResult result = run({"calibrate", "--plane", boardIn(folder), "--board", "7x5",
                                      "--square-mm", "2", "--out", lines, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json found = ordered_json::parse(result.out, nullptr, false);
    EXPECT_NEAR(found["mm_per_px"], 0.08, 2e-4);
    EXPECT_GT(found["mm_per_px_se"], 0.0);
    EXPECT_LT(found["mm_per_px_se"], 2e-4);
    EXPECT_EQ(found["points"], 35);
    const auto gel = teleta::vision::parseMarkerGel(
        "kind = \"marker_gel\"\nname = \"gel\"\ngrid = \"free\"\n" + readAll(lines), "gel.toml");
    ASSERT_TRUE(gel) << teleta::core::describe(gel.error());
    ASSERT_EQ(gel->plane.homography.size(), 9U);
    EXPECT_NEAR(gel->plane.homography[0], 8e-5, 2e-6);

    const ProgramResult printed =
        run({"calibrate", "--plane", boardIn(folder), "--board", "5x7", "--square-mm", "2"});
    EXPECT_EQ(printed.exitCode, 0) << printed.err;
    EXPECT_NE(printed.out.find("[plane]\nhomography = ["), std::string::npos) << printed.out;
}

TEST(PlaneCalibration, findsTheScaleFromTheMarkersOfAGel) {
    const TemporaryFolder folder;
    const std::string video = folder.path("press.avi");
    ASSERT_TRUE(teleta::test::writeGelVideo(video, 10));
    const std::string sensor = folder.write("gel.toml", teleta::test::kGelFile);
    const ProgramResult result =
        run({"calibrate", "--plane", video, "--sensor", sensor, "--pitch-mm", "2", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json found = ordered_json::parse(result.out, nullptr, false);
    EXPECT_EQ(found["points"], 80);
    EXPECT_TRUE(found["homography"].is_null());
    // The gel that was drawn has its own pitch.
    const std::vector<Eigen::Vector2d> places = teleta::simulation::GelRenderer({}).rest_px();
    double nearest_px = 1e9;
    for (std::size_t i = 1; i < places.size(); ++i)
        nearest_px = std::min(nearest_px, (places[i] - places[0]).norm());
    EXPECT_NEAR(found["mm_per_px"].get<double>() * nearest_px / 2.0, 1.0, 0.05);
    EXPECT_LT(found["mm_per_px_se"].get<double>(), 0.01 * found["mm_per_px"].get<double>());
}

TEST(PlaneCalibration, findsTheScaleFromARuler) {
    const ProgramResult result = run({"calibrate", "--plane", "--ruler", "100,50,400,450,20"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("[plane]\nmm_per_px = 0.04\n"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("Kept"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("Off by"), std::string::npos) << result.out;
}

/// x = (u - cx) / fx; the lens shows it at x (1 + k1 x^2). Points at x = -0.25 and 0.25 on the axis are shown
/// at 160 -+ 400 * 0.25 * (1 - 0.4 * 0.0625) = 160 -+ 97.5, and are 200 px apart without the lens.
TEST(PlaneCalibration, takesTheLensOutOfARuler) {
    const TemporaryFolder folder;
    const std::string lens = "[lens]\nfx = 400\nfy = 400\ncx = 160\ncy = 120\nk1 = -0.4\n";
    const std::string head = "kind = \"marker_gel\"\ngrid = \"free\"\n";
    const std::string sensor = folder.write("gel.toml", head + lens);
    const auto scale = [](const ProgramResult& result) {
        const ordered_json found = ordered_json::parse(result.out, nullptr, false);
        return found.is_discarded() ? 0.0 : found["mm_per_px"].get<double>();
    };
    const ProgramResult byPicture = run({"calibrate", "--plane", "--ruler", "62.5,120,257.5,120,20",
                                         boardIn(folder), "--sensor", sensor, "--json"});
    EXPECT_NEAR(scale(byPicture), 0.1, 1e-6) << byPicture.out << byPicture.err;
    // The same through a crop and a flip: pixels are those of the whole picture.
    const std::string cropped =
        folder.write("cropped.toml", head + "crop = [40, 30, 320, 240]\nflip_x = true\n" +
                                         "[lens]\nfx = 400\nfy = 400\ncx = 159\ncy = 120\nk1 = -0.4\n");
    const ProgramResult byCrop =
        run({"calibrate", "--plane", "--ruler", "102.5,150,297.5,150,20", "--sensor", cropped, "--json"});
    EXPECT_NEAR(scale(byCrop), 0.1, 1e-6) << byCrop.out << byCrop.err;
    EXPECT_TRUE(ordered_json::parse(byCrop.out)["rms_px"].is_null());
}

TEST(PlaneCalibration, takesASensorFileWhosePlaneIsStillToBeFound) {
    const TemporaryFolder folder;
    const std::string video = folder.path("press.avi");
    ASSERT_TRUE(teleta::test::writeGelVideo(video, 10));
    std::string text = teleta::test::kGelFile;
    text.resize(text.find("[plane]"));
    const std::string sensor = folder.write("gel.toml", text);
    const ProgramResult result =
        run({"calibrate", "--plane", video, "--sensor", sensor, "--pitch-mm", "2", "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    // The other commands need it.
    EXPECT_NE(run({"markers", video, "--sensor", sensor}).exitCode, 0);
}

TEST(PlaneCalibration, refusesWhatShowsNoPlane) {
    const TemporaryFolder folder;
    const std::string board = boardIn(folder);
    const std::string grey = folder.path("grey.png");
    cv::imwrite(grey, cv::Mat1b(240, 320, std::uint8_t{99}));
    const std::string cropped =
        folder.write("cropped.toml", "kind = \"marker_gel\"\ngrid = \"rectangular\"\nrows = 4\ncolumns = 4\n"
                                     "crop = [0, 0, 9000, 9000]\n");
    const std::string folded =
        folder.write("folded.toml", "kind = \"marker_gel\"\ngrid = \"free\"\n"
                                    "[lens]\nfx = 100\nfy = 100\ncx = 160\ncy = 120\nk1 = -2\n");
    struct Case {
        std::vector<std::string> arguments;
        int exitCode;
        std::string error;
    };
    const std::vector<Case> cases{
        {{"--plane", board}, 2, "one of --board"},
        {{"--plane", board, "--board", "7x1", "--square-mm", "2"}, 2, "single row"},
        {{"--plane", board, "--board", "7by5", "--square-mm", "2"}, 2, "not a size"},
        {{"--plane", board, "--board", "7x5"}, 2, "--square-mm"},
        {{"--plane", "--board", "7x5", "--square-mm", "2"}, 2, "a file is needed"},
        {{"--plane", "--ruler", "1,2,3"}, 2, "U,V,U,V,MM"},
        {{"--plane", "--ruler", "10,10,10,10,5"}, 1, "too close"},
        {{"--plane", "--ruler", "0,0,500,0,20", "--ruler", "0,0,600,0,20"}, 1, "contradict"},
        {{"--plane", "--ruler", "0,0,500,0,20", board}, 2, "outside the picture of 320 x 240"},
        {{"--plane", "--ruler", "0,0,200,0,20", "--residuals", "no.csv"}, 2, "--residuals"},
        {{"--plane", "--ruler", "0,0,200,0,20", "--method", "paper"}, 2, "--method"},
        {{"--plane", board, "--board", "7x5", "--square-mm", "2", "--sensor", cropped, "--out", cropped},
         2,
         "replace the input"},
        {{"--plane", board, "--pitch-mm", "2", "--sensor", cropped}, 3, "board.png"},
        {{"--plane", board, "--board", "7x5", "--square-mm", "2", "--sensor", folded}, 3, "folded.toml"},
        {{"--plane", "--ruler", "0,0,200,0,20", "--sensor", folded}, 2, "size of the picture"},
        {{"--plane", "--ruler", "0,0,200,0,20", "--sensor", folded, board}, 3, "folded.toml"},
        {{"--plane", board, "--board", "9x6", "--square-mm", "2"}, 3, "board.png"},
        {{"--plane", grey, "--board", "7x5", "--square-mm", "2"}, 3, "grey.png"},
        {{"--plane", folder.write("no.png", "no picture"), "--board", "7x5", "--square-mm", "2"},
         3,
         "no.png"},
        {{"--plane", "/nowhere.png", "--board", "7x5", "--square-mm", "2"}, 3, "nowhere"},
    };
    for (const Case& c : cases) {
        std::vector<std::string> arguments{"calibrate"};
        arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, c.exitCode) << c.error << '\n' << result.err;
        EXPECT_NE(result.err.find(c.error), std::string::npos) << result.err;
    }
}
