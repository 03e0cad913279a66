// SPDX-License-Identifier: GPL-3.0-or-later
// Markers of a flat gel, followed from frame to frame, against OpenCV's pyramid of Lucas and Kanade (windows
// of 15 pixels, 3 levels) on the same drawn frames, both on one core. Ours also finds each marker again,
// keeps identities and makes contacts; Lucas-Kanade only moves places on. Counters: distance from the true
// places (root of the mean square along an axis, in px) and time of a frame in ms.
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/simulation/camera/gel/gel_renderer.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel.h"

#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>
#include <opencv2/video/tracking.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace {

using namespace teleta;

constexpr std::size_t kFrames = 40;

struct Frames {
    simulation::SimulatedGel gel;
    std::vector<cv::Mat1b> still, moved;
    std::vector<std::vector<Eigen::Vector2d>> places_px; ///< of each frame that moved
};

/// A ball drags the gel to and fro.
Frames drawn(const simulation::SimulatedGel& gel) {
    Frames frames;
    frames.gel = gel;
    simulation::GelRenderer renderer(gel);
    for (std::size_t i = 0; i < vision::MarkerGel::kReferencePictures; ++i)
        renderer.draw(renderer.rest_px(), frames.still.emplace_back());
    for (std::size_t i = 0; i < kFrames; ++i) {
        const double way = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / kFrames);
        const simulation::GelContact ball{.centre_m = {0.5 * gel.width_px, 0.5 * gel.height_px},
                                          .radius_m = 0.25 * gel.height_px,
                                          .spread_m = 0.1 * gel.pitch_px,
                                          .slip_m = {0.8 * gel.pitch_px * way, 0.3 * gel.pitch_px * way},
                                          .stick = 0.5};
        std::vector<Eigen::Vector2d> places = renderer.rest_px();
        for (Eigen::Vector2d& place : places)
            place += ball.displacement_m(place);
        renderer.draw(places, frames.moved.emplace_back());
        frames.places_px.push_back(places);
    }
    return frames;
}

const Frames& framesOf(bool large) {
    static const Frames small = drawn({});
    static const Frames big = drawn({.width_px = 640,
                                     .height_px = 480,
                                     .rows = 10,
                                     .columns = 13,
                                     .pitch_px = 45.0,
                                     .diameter_px = 12.0});
    return large ? big : small;
}

vision::MarkerGelFile fileOf(const simulation::SimulatedGel& gel) {
    vision::MarkerGelFile file;
    file.grid = vision::MarkerGrid::rectangular;
    file.rows = gel.rows;
    file.columns = gel.columns;
    file.diameter_px = gel.diameter_px;
    file.plane.mmPerPx = 0.1;
    return file;
}

class Error {
public:
    void add(const Eigen::Vector2d& off_px) {
        m_squares += off_px.squaredNorm();
        m_count += 2.0;
    }
    [[nodiscard]] double px() const { return std::sqrt(m_squares / std::max(1.0, m_count)); }

private:
    double m_squares = 0.0, m_count = 0.0;
};

void report(benchmark::State& state, const Error& error) {
    state.counters["error_px"] = error.px();
}

void followMarkers(benchmark::State& state, bool large, bool contacts) {
    cv::setNumThreads(1);
    const Frames& frames = framesOf(large);
    auto gel = vision::MarkerGel::make(fileOf(frames.gel), frames.still);
    if (!gel) {
        state.SkipWithError("the gel is refused");
        return;
    }
    vision::GelContacts found;
    Error error;
    std::size_t i = 0;
    for (auto _ : state) {
        (void)gel->track(frames.moved[i], 0.04 * static_cast<double>(i));
        if (contacts)
            benchmark::DoNotOptimize(found.next(*gel).size());
        for (std::size_t k = 0; k < gel->markers().size(); ++k) {
            if (gel->motions()[k].found)
                error.add(gel->motions()[k].place_px - frames.places_px[i][k]);
        }
        i = (i + 1) % kFrames;
    }
    report(state, error);
}

void lucasKanade(benchmark::State& state, bool large) {
    cv::setNumThreads(1);
    const Frames& frames = framesOf(large);
    const auto pointsOf = [&](std::size_t frame) {
        std::vector<cv::Point2f> points;
        for (const Eigen::Vector2d& place : frames.places_px[frame])
            points.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()));
        return points;
    };
    std::vector<cv::Point2f> points = pointsOf(0), next;
    std::vector<std::uint8_t> status;
    std::vector<float> residual;
    Error error;
    std::size_t i = 1;
    for (auto _ : state) {
        cv::calcOpticalFlowPyrLK(frames.moved[(i + kFrames - 1) % kFrames], frames.moved[i], points, next,
                                 status, residual, {15, 15}, 2);
        for (std::size_t k = 0; k < next.size(); ++k)
            error.add(Eigen::Vector2d(static_cast<double>(next[k].x), static_cast<double>(next[k].y)) -
                      frames.places_px[i][k]);
        points = next;
        i = (i + 1) % kFrames;
    }
    report(state, error);
}

} // namespace

BENCHMARK_CAPTURE(followMarkers, 320x240_80, false, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(followMarkers, 320x240_80_contacts, false, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lucasKanade, 320x240_80, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(followMarkers, 640x480_130, true, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(followMarkers, 640x480_130_contacts, true, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lucasKanade, 640x480_130, true)->Unit(benchmark::kMillisecond);
