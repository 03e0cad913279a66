// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded gel with markers, against the tracks of the sensor's maker and against OpenCV's Lucas-Kanade.
#include "backend/core/quantile.h"
#include "backend/vision/gel/marker_gel.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

namespace teleta::vision {
namespace {

constexpr const char* kFolder = TELETA_SOURCE_DIR "/../shared/data/gelsight-markers/";
constexpr double kMoved_px = 2.0; ///< published places are whole pixels

struct Published {
    std::size_t frame = 0;
    int row = 0, column = 0;
    Eigen::Vector2d moved_px;
};

std::vector<Published> publishedTracks() {
    std::vector<Published> tracks;
    std::ifstream file(std::string(kFolder) + "marker_locations_0.csv");
    for (std::string line; std::getline(file, line);) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream fields(line);
        Published track;
        Eigen::Vector2d rest_px, now_px;
        fields >> track.frame >> track.row >> track.column >> rest_px.x() >> rest_px.y() >> now_px.x() >>
            now_px.y();
        --track.frame;
        track.moved_px = now_px - rest_px;
        tracks.push_back(track);
    }
    return tracks;
}

struct Track {
    std::vector<Eigen::Vector2d> places_px; ///< of each frame
    std::vector<bool> found;
};

class RecordedGel : public testing::Test {
protected:
    void SetUp() override {
        cv::VideoCapture video(std::string(kFolder) + "video_0.avi");
        if (!std::filesystem::exists(std::string(kFolder) + "video_0.avi"))
            GTEST_SKIP() << "the recorded video is not there";
        ASSERT_TRUE(video.isOpened());
        for (cv::Mat image; video.read(image);) {
            cv::Mat1b green;
            cv::extractChannel(image, green, 1);
            m_pictures.push_back(green.clone());
            cv::cvtColor(image, m_grey.emplace_back(), cv::COLOR_BGR2GRAY);
        }
        ASSERT_EQ(m_pictures.size(), 38U);
        MarkerGelFile file;
        file.channel = GelChannel::green;
        file.diameter_px = 9.0;
        file.grid = MarkerGrid::rectangular;
        file.rows = 8;
        file.columns = 10;
        file.plane.mmPerPx = 0.0634;
        auto made = MarkerGel::make(file, std::span(m_pictures).first(8));
        ASSERT_TRUE(made) << made.error().message;
        m_markers = made->markers();
        ASSERT_EQ(m_markers.size(), 80U);
        m_tracks.resize(80);
        for (std::size_t frame = 0; frame < m_pictures.size(); ++frame) {
            ASSERT_TRUE(made->track(m_pictures[frame], 0.04 * static_cast<double>(frame)));
            for (std::size_t i = 0; i < 80; ++i) {
                m_tracks[i].places_px.push_back(made->motions()[i].place_px);
                m_tracks[i].found.push_back(made->motions()[i].found);
            }
        }
    }
    std::vector<cv::Mat1b> m_pictures;
    std::vector<cv::Mat1b> m_grey; ///< the arrows drawn into the video pull Lucas-Kanade less there
    std::vector<GelMarker> m_markers;
    std::vector<Track> m_tracks;
};

} // namespace

TEST_F(RecordedGel, movesAsTheMakersProgramSays) {
    std::vector<double> differences_px;
    double product = 0.0, square = 0.0;
    std::size_t moved = 0;
    for (const Published& theirs : publishedTracks()) {
        const auto i = static_cast<std::size_t>(10 * theirs.row + theirs.column);
        ASSERT_EQ(m_markers[i].grid.row, theirs.row);
        ASSERT_EQ(m_markers[i].grid.column, theirs.column);
        if (theirs.moved_px.norm() <= kMoved_px)
            continue;
        ++moved;
        if (!m_tracks[i].found[theirs.frame])
            continue;
        const Eigen::Vector2d ours_px = m_tracks[i].places_px[theirs.frame] - m_markers[i].rest_px;
        differences_px.push_back((ours_px - theirs.moved_px).norm());
        product += ours_px.dot(theirs.moved_px);
        square += theirs.moved_px.squaredNorm();
    }
    ASSERT_EQ(moved, 592U);
    std::cout << differences_px.size() << " of 592: median " << core::lowerQuantileOf(differences_px, 0.5)
              << " px, 95 % " << core::lowerQuantileOf(differences_px, 0.95) << " px, slope "
              << product / square << '\n';
    EXPECT_GE(differences_px.size(), 540U);
    EXPECT_LT(core::lowerQuantileOf(differences_px, 0.5), 0.65);
    EXPECT_LT(core::lowerQuantileOf(differences_px, 0.95), 1.6);
    EXPECT_GT(product / square, 0.97);
    EXPECT_LT(product / square, 1.08);
}

TEST_F(RecordedGel, movesAsLucasAndKanadeSee) {
    std::vector<cv::Point2f> before;
    for (const GelMarker& marker : m_markers)
        before.emplace_back(static_cast<float>(marker.rest_px.x()), static_cast<float>(marker.rest_px.y()));
    const std::vector<cv::Point2f> start = before;
    std::vector<double> differences_px;
    for (std::size_t frame = 1; frame < m_pictures.size(); ++frame) {
        std::vector<cv::Point2f> after;
        std::vector<std::uint8_t> status;
        std::vector<float> error;
        cv::calcOpticalFlowPyrLK(m_grey[frame - 1], m_grey[frame], before, after, status, error, {15, 15}, 2);
        before = after;
        for (std::size_t i = 0; i < m_markers.size(); ++i) {
            if (status[i] == 0 || !m_tracks[i].found[frame])
                continue;
            const Eigen::Vector2d ours_px = m_tracks[i].places_px[frame] - m_markers[i].rest_px;
            const cv::Point2f theirs_px = after[i] - start[i];
            differences_px.push_back(std::hypot(ours_px.x() - static_cast<double>(theirs_px.x),
                                                ours_px.y() - static_cast<double>(theirs_px.y)));
        }
    }
    std::cout << differences_px.size() << " places: median " << core::lowerQuantileOf(differences_px, 0.5)
              << " px, 95 % " << core::lowerQuantileOf(differences_px, 0.95) << " px\n";
    EXPECT_GT(differences_px.size(), 2800U);
    EXPECT_LT(core::lowerQuantileOf(differences_px, 0.5), 0.20);
    EXPECT_LT(core::lowerQuantileOf(differences_px, 0.95), 1.5);
}

TEST_F(RecordedGel, isStillAtRestAndAtRestAgain) {
    std::vector<double> jitter_px;
    std::size_t lost = 0;
    for (const Track& track : m_tracks) {
        std::vector<Eigen::Vector2d> places_px;
        for (std::size_t frame = 0; frame < 7; ++frame) {
            if (track.found[frame])
                places_px.push_back(track.places_px[frame]);
            else
                ++lost; // the arrows that are drawn into the video are dark in green
        }
        ASSERT_GE(places_px.size(), 4U);
        const auto count = static_cast<double>(places_px.size());
        Eigen::Vector2d mean = Eigen::Vector2d::Zero(), squares = mean;
        for (const Eigen::Vector2d& place_px : places_px)
            mean += place_px / count;
        for (const Eigen::Vector2d& place_px : places_px)
            squares += (place_px - mean).cwiseAbs2() / (count - 1.0);
        for (const double square : squares)
            jitter_px.push_back(square);
    }
    double sum = 0.0;
    for (const double square : jitter_px)
        sum += square / static_cast<double>(jitter_px.size());
    std::vector<double> off_px;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        EXPECT_TRUE(m_tracks[i].found.back()) << i;
        off_px.push_back((m_tracks[i].places_px.back() - m_markers[i].rest_px).norm());
    }
    EXPECT_LE(lost, 5U) << "of 560";
    std::cout << lost << " of 560 not found, jitter " << std::sqrt(sum)
              << " px an axis over the 7 frames before anything moves; at rest again to "
              << core::lowerQuantileOf(off_px, 0.5) << " px, most " << core::lowerQuantileOf(off_px, 1.0)
              << " px\n";
    EXPECT_LT(std::sqrt(sum), 0.08);
    EXPECT_LT(core::lowerQuantileOf(off_px, 0.5), 0.15);
    EXPECT_LT(core::lowerQuantileOf(off_px, 1.0), 3.0); // none swapped: neighbours are 32 px apart
}

} // namespace teleta::vision
