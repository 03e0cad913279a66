// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded soft sensor whose maker's program has tracked its markers: what our tracking makes of the same
// video.
#include "backend/vision/finders/dot_detection.h"
#include "backend/vision/finders/dot_tracker.h"
#include "devices/camera/video_stream.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

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
constexpr double kMoved_px = 2.0; ///< published places are whole pixels

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

/// The markers are dark; the arrows that are drawn over them are bright, and thin.
cv::Mat1b withoutArrows(const cv::Mat1b& image) {
    cv::Mat1b opened;
    cv::morphologyEx(image, opened, cv::MORPH_OPEN, cv::Mat1b(5, 5, std::uint8_t{1}));
    return opened;
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
    auto video = camera::VideoStream::open(std::string(kFolder) + "video_0.avi", {});
    ASSERT_TRUE(video) << describe(video.error());
    cv::Mat1b image;
    double time_s = 0.0;
    const auto next = [&] { return video->next(image, time_s) == camera::VideoStream::Outcome::frame; };
    ASSERT_TRUE(next());
    DotTracker tracker = trackerOf(withoutArrows(image), 32.0);
    const std::size_t dots = tracker.setReference(withoutArrows(image));
    std::vector<double> differences_px; // of markers that the maker's program saw move
    double product_px2 = 0.0;
    double square_px2 = 0.0;
    double largest_px = 0.0;
    std::size_t matched = 0;
    std::size_t compared = 0;
    for (const auto& [frame, markers] : tracks) {
        if (frame > 1) {
            ASSERT_TRUE(next()) << "frame " << frame;
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
            if (theirs_px.norm() <= kMoved_px)
                continue;
            differences_px.push_back((ours_px - theirs_px).norm());
            product_px2 += ours_px.dot(theirs_px);
            square_px2 += theirs_px.squaredNorm();
            largest_px = std::max(largest_px, theirs_px.norm());
        }
    }
    ASSERT_GT(differences_px.size(), 300U);
    std::ranges::sort(differences_px);
    const double slope = product_px2 / square_px2;
    const auto quantile = [](const std::vector<double>& sorted, double share) {
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    std::cout << dots << " dots followed; " << matched << " of " << compared
              << " published markers compared, of which " << differences_px.size()
              << " have moved by more than " << kMoved_px << " px. Difference of these displacements: median "
              << quantile(differences_px, 0.5) << " px, 95 % " << quantile(differences_px, 0.95)
              << " px, slope of ours on theirs " << slope
              << " (published places are whole pixels; displacements up to " << largest_px << " px)\n";
    EXPECT_GT(static_cast<double>(matched), 0.8 * static_cast<double>(compared));
    EXPECT_LT(quantile(differences_px, 0.5), 1.0);
    EXPECT_LT(quantile(differences_px, 0.95), 2.0);
    EXPECT_NEAR(slope, 1.0, 0.1);
}

} // namespace teleta::vision
