// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/simulation/camera/gel/gel_renderer.h"
#include "backend/vision/gel/marker_gel.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>

namespace teleta::cost {

namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr std::size_t kPictures = 36;
constexpr double kScale_mmPerPx = 0.1;
constexpr double kScale_mPerPx = 1e-3 * kScale_mmPerPx;
/// Of the mean over two diameters less that of the marker, of a marker that is drawn with 60.
constexpr double kLeastContrast = 10.0;

struct DragSeries {
    simulation::SimulatedGel gel;
    Places rest_px;
    std::vector<cv::Mat1b> still;
    std::vector<cv::Mat1b> moved;
    std::vector<Places> places_px; ///< of the markers in each picture that moved
};

/// A ball drags the gel to and fro, by more than half the distance of its markers.
DragSeries drawSeries() {
    DragSeries series;
    series.gel.unevenness = 0.2;
    series.gel.printError_px = 0.5;
    series.gel.printScatter = 0.05;
    simulation::GelRenderer renderer(series.gel);
    series.rest_px = renderer.rest_px();
    for (std::size_t i = 0; i < vision::MarkerGel::kReferencePictures; ++i)
        renderer.draw(series.rest_px, series.still.emplace_back());
    for (std::size_t i = 0; i < kPictures; ++i) {
        const double way =
            std::sin(2.0 * std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(kPictures));
        const simulation::GelContact ball{
            .centre_m = {0.5 * series.gel.width_px, 0.5 * series.gel.height_px},
            .radius_m = 0.25 * series.gel.height_px,
            .spread_m = 0.1 * series.gel.pitch_px,
            .slip_m = {0.8 * series.gel.pitch_px * way, 0.3 * series.gel.pitch_px * way},
            .stick = 0.5};
        Places places = series.rest_px;
        for (Eigen::Vector2d& place : places)
            place += ball.displacement_m(place);
        renderer.draw(places, series.moved.emplace_back());
        series.places_px.push_back(std::move(places));
    }
    return series;
}

vision::MarkerGelFile fileOf(const simulation::SimulatedGel& gel) {
    vision::MarkerGelFile file;
    file.grid = vision::MarkerGrid::rectangular;
    file.rows = gel.rows;
    file.columns = gel.columns;
    file.diameter_px = gel.diameter_px;
    file.plane.mmPerPx = kScale_mmPerPx;
    return file;
}

/// Errors of the markers' ways in one picture.
void addErrors(Trial& trial, const DragSeries& series, std::size_t picture,
               std::span<const Eigen::Vector2d> way_m) {
    for (std::size_t k = 0; k < way_m.size(); ++k)
        trial.error((way_m[k] - kScale_mPerPx * (series.places_px[picture][k] - series.rest_px[k])).norm());
}

/// Each marker went to the place that is next to where it was at rest; to none: it did not move.
Places waysToNearest(const Places& rest_px, std::span<const Eigen::Vector2d> found_px, double reach_px) {
    Places way_m;
    for (const Eigen::Vector2d& rest : rest_px) {
        Eigen::Vector2d way_px = Eigen::Vector2d::Zero();
        double nearest_px = reach_px;
        for (const Eigen::Vector2d& place : found_px) {
            if ((place - rest).norm() < nearest_px) {
                nearest_px = (place - rest).norm();
                way_px = place - rest;
            }
        }
        way_m.push_back(kScale_mPerPx * way_px);
    }
    return way_m;
}

/// Places that are found anew in each picture.
Rung foundRung(std::string name, std::string parameter, const std::shared_ptr<const DragSeries>& series,
               const Places& rest_px, std::function<void(const cv::Mat1b&, Places&)> find) {
    return {std::move(name), std::move(parameter), [=, find = std::move(find)](Trial& trial) {
                const std::size_t picture = trial.index() % kPictures;
                Places found_px;
                Places way_m;
                trial.timed(1, [&] {
                    find(series->moved[picture], found_px);
                    way_m = waysToNearest(rest_px, found_px, 0.45 * series->gel.pitch_px);
                });
                addErrors(trial, *series, picture, way_m);
            }};
}

/// Markers that are followed from picture to picture.
core::Expected<Rung> followedRung(std::string name, std::string parameter,
                                  const std::shared_ptr<const DragSeries>& series,
                                  const vision::MarkerGelFile& file, std::size_t references) {
    TELETA_TRY(vision::MarkerGel gel,
               vision::MarkerGel::make(file, std::span(series->still).first(references)));
    // A trial that is timed again begins where it began the first time.
    const auto before = std::make_shared<std::vector<vision::MarkerGel>>();
    for (std::size_t i = 0; i < kPictures; ++i) {
        before->push_back(gel);
        TELETA_CHECK(gel.track(series->moved[i], static_cast<double>(i)));
    }
    return Rung{
        std::move(name), std::move(parameter), [=](Trial& trial) {
            const std::size_t picture = trial.index() % kPictures;
            vision::MarkerGel followed = (*before)[picture];
            trial.timed(1, [&] {
                static_cast<void>(followed.track(series->moved[picture], static_cast<double>(picture)));
            });
            Places way_m;
            for (const vision::GelMotion& motion : followed.motions())
                way_m.push_back(motion.found ? motion.displacement_m : Eigen::Vector2d::Zero().eval());
            addErrors(trial, *series, picture, way_m);
        }};
}

} // namespace

Ladder gelMarkersLadder() {
    Ladder ladder;
    ladder.name = "gel-markers";
    ladder.topic = Topic::camera;
    ladder.title = LadderText::tr("Motion of the markers of a gel").toStdString();
    ladder.truth =
        LadderText::tr("distance from the way that the marker was drawn to have gone; a marker that is "
                       "lost counts as at rest")
            .toStdString();
    ladder.errorUnit = "m";
    ladder.trials = kPictures;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const auto series = std::make_shared<const DragSeries>(drawSeries());
        const vision::MarkerGelFile file = fileOf(series->gel);
        TELETA_TRY(const vision::MarkerGel still, vision::MarkerGel::make(file, series->still));
        Places rest_px;
        for (const vision::GelMarker& marker : still.markers())
            rest_px.push_back(marker.rest_px);
        const auto detector =
            std::make_shared<vision::MarkerDetector>(series->gel.diameter_px, series->gel.pitch_px);
        std::vector<Rung> rungs;
        rungs.push_back(foundRung("spots", "dark spots, whole pixels", series, rest_px,
                                  [detector, spots = std::vector<vision::MarkerSpot>()](
                                      const cv::Mat1b& picture, Places& found_px) mutable {
                                      detector->spots(picture, kLeastContrast, spots);
                                      for (const vision::MarkerSpot& spot : spots)
                                          found_px.push_back(spot.place_px);
                                  }));
        rungs.push_back(foundRung("centres", "centres of the spots, each picture alone", series, rest_px,
                                  [detector](const cv::Mat1b& picture, Places& found_px) {
                                      for (const vision::MarkerCentre& centre : detector->centres(picture))
                                          found_px.push_back(centre.place_px);
                                  }));
        vision::MarkerGelFile anySize = file;
        anySize.diameter_px = 0.0;
        const auto add = [&](const char* name, const char* parameter, const vision::MarkerGelFile& settings,
                             std::size_t references) -> core::Expected<void> {
            TELETA_TRY(Rung rung, followedRung(name, parameter, series, settings, references));
            rungs.push_back(std::move(rung));
            return {};
        };
        TELETA_CHECK(add("followed-1", "followed, rest from 1 picture", file, 1));
        TELETA_CHECK(add("followed-8", "followed, rest from 8 pictures", file, series->still.size()));
        TELETA_CHECK(add("followed-any-size", "followed, diameter found in 8 pictures", anySize,
                         series->still.size()));
        rungs.push_back(limitRung("each pixel read once", 16, [series](std::size_t index) {
            return cv::sum(series->moved[index % kPictures])[0];
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
