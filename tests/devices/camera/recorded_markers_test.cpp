// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded soft sensor whose maker's program has tracked its markers: what our tracking makes of the same
// video.
#include "backend/vision/contacts/dot_detection.h"
#include "backend/vision/contacts/dot_tracker.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

namespace teleta::vision {
namespace {

constexpr const char* kFolder = TELETA_SOURCE_DIR "/../shared/data/gelsight-markers/";
constexpr double kDiameter_px = 9.0;

struct Marker {
    Eigen::Vector2d rest_px, now_px;
};

/// Markers of each frame, from 1.
std::map<int, std::vector<Marker>> publishedTracks() {
    std::map<int, std::vector<Marker>> tracks;
    std::ifstream file(std::string(kFolder) + "marker_locations_0.csv");
    for (std::string line; std::getline(file, line);) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream fields(line);
        int frame = 0;
        int row = 0;
        int column = 0;
        Marker marker;
        fields >> frame >> row >> column >> marker.rest_px.x() >> marker.rest_px.y() >> marker.now_px.x() >>
            marker.now_px.y();
        tracks[frame].push_back(marker);
    }
    return tracks;
}

/// The markers are dark in every channel; the arrows that are drawn over them are bright in one, and thin.
cv::Mat1b withoutArrows(const cv::Mat& image) {
    std::vector<cv::Mat1b> channels;
    cv::split(image, channels);
    cv::Mat1b brightest = cv::max(cv::max(channels[0], channels[1]), channels[2]);
    cv::morphologyEx(brightest, brightest, cv::MORPH_OPEN, cv::Mat1b(5, 5, std::uint8_t{1}));
    return brightest;
}

DotTracker trackerOf(const cv::Mat1b& reference, double pitch_px) {
    cv::Mat1f grey;
    reference.convertTo(grey, CV_32F);
    std::vector<TrackedDot> dots;
    const double window_px = 0.4 * pitch_px;
    for (const cv::Point2f& place : detectDots(grey, {}, kDiameter_px)) {
        TrackedDot dot;
        dot.rest_px = {static_cast<double>(place.x), static_cast<double>(place.y)};
        dot.metric = Eigen::Matrix2d::Identity() / (window_px * window_px);
        dot.tolerance = Eigen::Matrix2d::Identity() / (0.4 * pitch_px);
        dots.push_back(dot);
    }
    for (TrackedDot& dot : dots) {
        for (std::size_t k = 0; k < dots.size(); ++k) {
            const double distance_px = (dots[k].rest_px - dot.rest_px).norm();
            if (distance_px > 0.0 && distance_px < 1.6 * pitch_px)
                dot.neighbours.push_back(k);
        }
    }
    return DotTracker(std::move(dots), cv::Mat1b(reference.size(), std::uint8_t{255}),
                      kDiameter_px / window_px);
}

} // namespace

TEST(RecordedMarkers, moveAsTheMakersProgramSays) {
    if (!std::filesystem::exists(std::string(kFolder) + "video_0.avi"))
        GTEST_SKIP() << "the recorded video is not there";
    const auto tracks = publishedTracks();
    ASSERT_EQ(tracks.size(), 38U);
    cv::VideoCapture video(std::string(kFolder) + "video_0.avi");
    cv::Mat image;
    ASSERT_TRUE(video.read(image));
    DotTracker tracker = trackerOf(withoutArrows(image), 32.0);
    const std::size_t dots = tracker.setReference(withoutArrows(image));
    std::vector<double> differences_px, moved_px;
    std::size_t matched = 0;
    std::size_t compared = 0;
    for (const auto& [frame, markers] : tracks) {
        if (frame > 1) {
            if (!video.read(image))
                break;
            (void)tracker.track(withoutArrows(image));
        }
        for (const Marker& marker : markers) {
            ++compared;
            const auto near = std::ranges::min_element(tracker.dots(), {}, [&](const TrackedDot& dot) {
                return (dot.rest_px - marker.rest_px).norm();
            });
            if ((near->rest_px - marker.rest_px).norm() > 6.0 || !near->found)
                continue;
            ++matched;
            const Eigen::Vector2d ours_px = near->now_px - near->rest_px;
            const Eigen::Vector2d theirs_px = marker.now_px - marker.rest_px;
            differences_px.push_back((ours_px - theirs_px).norm());
            moved_px.push_back(theirs_px.norm());
        }
    }
    ASSERT_FALSE(differences_px.empty());
    std::ranges::sort(differences_px);
    std::ranges::sort(moved_px);
    const auto quantile = [](const std::vector<double>& sorted, double share) {
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    std::cout << dots << " dots followed; " << matched << " of " << compared
              << " published markers compared. Difference of the displacements: median "
              << quantile(differences_px, 0.5) << " px, 95 % " << quantile(differences_px, 0.95)
              << " px (published places are whole pixels; displacements up to " << moved_px.back()
              << " px)\n";
    EXPECT_GT(static_cast<double>(matched), 0.8 * static_cast<double>(compared));
    EXPECT_LT(quantile(differences_px, 0.5), 1.0);
}

} // namespace teleta::vision
