// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/gel_video.h"
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <string>
#include <vector>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

enum Column { kFrame, kTime, kMarker, kRow, kColumn, kRestU, kRestV, kU, kV, kDx, kDy, kFound };

class MarkersCommand : public testing::Test {
protected:
    void SetUp() override {
        m_sensor = m_folder.write("gel.toml", teleta::test::kGelFile);
        ASSERT_TRUE(teleta::test::writeGelVideo(m_video, kFrames));
    }
    /// A video of pictures of one grey level.
    std::string even(const std::string& name, int frames, int level) {
        cv::VideoWriter video(m_folder.path(name), cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25.0,
                              {320, 240}, false);
        for (int i = 0; i < frames; ++i)
            video.write(cv::Mat1b(240, 320, static_cast<std::uint8_t>(level)));
        return m_folder.path(name);
    }
    /// Expects that the video is refused with exit code 3 and these words.
    void expectRefused(const std::string& video, const std::string& words) {
        const std::string out = m_folder.path("out.csv");
        const ProgramResult result = run({"markers", video, "--sensor", m_sensor, "--out", out});
        EXPECT_EQ(result.exitCode, 3) << result.err;
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
        EXPECT_NE(result.err.find(video), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    }

    static constexpr int kFrames = 20;
    TemporaryFolder m_folder;
    std::string m_video = m_folder.path("press.avi");
    std::string m_sensor;
};

} // namespace

TEST_F(MarkersCommand, writesEachMarkerOfEachFrame) {
    const ProgramResult result = run({"markers", m_video, "--sensor", m_sensor});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
              "frame,time_s,marker,row,column,rest_u_px,rest_v_px,u_px,v_px,dx_m,dy_m,found");
    const auto rows = splitCsv(result.out);
    ASSERT_EQ(rows.size(), 1U + kFrames * 80U);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto& row = rows[i];
        const int marker = static_cast<int>((i - 1) % 80);
        ASSERT_EQ(row[kFrame], std::to_string((i - 1) / 80));
        EXPECT_NEAR(std::stod(row[kTime]), 0.04 * std::stod(row[kFrame]), 1e-6);
        EXPECT_EQ(row[kMarker], std::to_string(marker));
        EXPECT_EQ(row[kRow], std::to_string(marker / 10));
        EXPECT_EQ(row[kColumn], std::to_string(marker % 10));
        EXPECT_EQ(row[kFound], "1");
        EXPECT_NEAR(std::stod(row[kDx]), 1e-4 * (std::stod(row[kU]) - std::stod(row[kRestU])), 1e-9);
        EXPECT_NEAR(std::stod(row[kDy]), 1e-4 * (std::stod(row[kV]) - std::stod(row[kRestV])), 1e-9);
    }
    // In the last frame the markers that stick have moved by 6 px; that of row 3, column 4 is one.
    const auto& stuck = rows[rows.size() - 80 + 34];
    const double dragged_px = teleta::test::kDraggedPerFrame_px * (kFrames - teleta::test::kStillFrames);
    EXPECT_NEAR(std::stod(stuck[kDx]), 1e-4 * dragged_px, 2e-5);
    EXPECT_NEAR(std::stod(stuck[kDy]), 0.0, 2e-5);
}

TEST_F(MarkersCommand, summarizesTheVideo) {
    const ProgramResult table = run({"markers", m_video, "--sensor", m_sensor, "--summary"});
    ASSERT_EQ(table.exitCode, 0) << table.err;
    EXPECT_NE(table.out.find("80"), std::string::npos);
    const ProgramResult result = run({"markers", m_video, "--sensor", m_sensor, "--summary", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto summary = nlohmann::json::parse(result.out);
    EXPECT_EQ(summary["frames"], kFrames);
    EXPECT_EQ(summary["markers"], 80);
    EXPECT_EQ(summary["found_share"], 1.0);
    EXPECT_EQ(summary["reference_frames"], teleta::test::kStillFrames);
    EXPECT_NEAR(summary["pitch_px"].get<double>(), 28.0, 0.1);
    EXPECT_NEAR(summary["diameter_px"].get<double>(), 8.0, 1.0);
    EXPECT_NEAR(summary["largest_displacement_m"].get<double>(), 6e-4, 3e-5);
    EXPECT_TRUE(summary["torn_at_s"].is_null());
    ASSERT_EQ(summary["contacts"].size(), 1U);
    EXPECT_NEAR(summary["contacts"][0]["centre_x_m"].get<double>(), 0.016, 0.002);
    EXPECT_NEAR(summary["contacts"][0]["centre_y_m"].get<double>(), 0.012, 0.002);
    EXPECT_GT(summary["contacts"][0]["shear_proxy_x_m"].get<double>(), 1e-4);
}

TEST_F(MarkersCommand, takesTheSourceThatTheSensorFileNames) {
    const std::string sensor =
        m_folder.write("named.toml", "source = \"press.avi\"\n" + std::string(teleta::test::kGelFile));
    const ProgramResult result = run({"markers", "--sensor", sensor, "--summary", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out)["frames"], kFrames);
    EXPECT_EQ(run({"markers", "--sensor", m_sensor}).exitCode, 2);
}

TEST_F(MarkersCommand, numbersAFreeLayoutWithoutRows) {
    const std::string sensor =
        m_folder.write("free.toml", "kind = \"marker_gel\"\ngrid = \"free\"\n[plane]\npitch_mm = 2.8\n");
    const ProgramResult result = run({"markers", m_video, "--sensor", sensor, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = nlohmann::json::parse(result.out);
    std::set<int> numbers;
    for (const auto& row : rows) {
        EXPECT_TRUE(row["row"].is_null());
        numbers.insert(row["marker"].get<int>());
    }
    EXPECT_EQ(numbers.size(), 80U);
}

TEST_F(MarkersCommand, refusesVideosInWhichNothingCanBeFollowed) {
    expectRefused(m_folder.write("empty.avi", ""), "not a readable video");
    expectRefused(even("black.avi", 20, 0), "black");
    expectRefused(even("grey.avi", 20, 120), "no contrast");
    ASSERT_TRUE(teleta::test::writeGelVideo(m_folder.path("one.avi"), 1));
    expectRefused(m_folder.path("one.avi"), "only one frame");
    cv::VideoWriter video(m_folder.path("slope.avi"), cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25.0,
                          {320, 240}, false);
    cv::Mat1b slope(240, 320);
    for (int v = 0; v < slope.rows; ++v)
        for (int u = 0; u < slope.cols; ++u)
            slope(v, u) = static_cast<std::uint8_t>(40 + u / 2);
    for (int i = 0; i < 20; ++i)
        video.write(slope);
    video.release();
    expectRefused(m_folder.path("slope.avi"), "markers were found");
    expectRefused(m_folder.path("missing.avi"), "does not exist");
}

TEST_F(MarkersCommand, refusesAFileThatDoesNotFit) {
    const std::string wrong = m_folder.write("wrong.toml", "kind = \"marker_gel\"\ngrid = \"square\"\n");
    ProgramResult result = run({"markers", m_video, "--sensor", wrong});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("wrong.toml:2:8"), std::string::npos) << result.err;
    const std::string crop =
        m_folder.write("crop.toml", "crop = [200, 0, 200, 240]\n" + std::string(teleta::test::kGelFile));
    result = run({"markers", m_video, "--sensor", crop});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("320 x 240"), std::string::npos) << result.err;
    EXPECT_EQ(run({"markers", m_video, "--sensor", m_sensor, "--summary", "--out", "x.csv"}).exitCode, 2);
    EXPECT_EQ(run({"markers", m_video}).exitCode, 2);
}
