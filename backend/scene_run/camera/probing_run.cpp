// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/camera_image.h"
#include "backend/scene_run/camera/camera_run.h"
#include "backend/scene_run/camera/simulated_probing.h"
#include "backend/vision/calibration/camera_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::scene_run {

namespace {

constexpr std::uint64_t kProbingFramesBetweenReports = 8;

using TakenPair = SimulatedProbing::Taken;

struct SurfaceErrors {
    std::vector<double> errors_m;
    std::size_t notLocated = 0;
};

/// Points all over the skin: where the calibrated camera locates what the true one sees of them.
SurfaceErrors surfaceErrors(const vision::CylinderCamera& truth, const vision::CylinderCamera& calibrated) {
    // The cylinder goes on beyond its ends, so that a point near an end may be found a little beyond it.
    constexpr double kBeyond_m = 0.01;
    constexpr int kAround = 36;
    constexpr int kAlong = 20;
    vision::CylinderSurface longer = calibrated.surface();
    longer.lowest_z_m -= kBeyond_m;
    longer.highest_z_m += kBeyond_m;
    const vision::CylinderCamera wide(calibrated.camera(), longer);
    const vision::CylinderSurface& skin = truth.surface();
    SurfaceErrors found;
    for (int i = 0; i < kAround; ++i) {
        for (int k = 0; k <= kAlong; ++k) {
            const double angle_rad = 2.0 * std::numbers::pi * (i + 0.5) / kAround;
            const Eigen::Vector3d point_m(
                skin.radius_m * std::cos(angle_rad), skin.radius_m * std::sin(angle_rad),
                skin.lowest_z_m + (skin.highest_z_m - skin.lowest_z_m) * k / kAlong);
            const auto pixel = truth.camera().project(point_m);
            if (!pixel || !truth.camera().sees(*pixel))
                continue;
            if (const auto located_m = wide.locate_m(*pixel))
                found.errors_m.push_back((*located_m - point_m).norm());
            else
                ++found.notLocated;
        }
    }
    return found;
}

void report(const std::vector<TakenPair>& taken, const vision::CylinderCamera& truth,
            const simulation::ProbingPlan& plan, const vision::Calibration& calibration,
            nlohmann::ordered_json& measures) {
    std::size_t mistakenKept = 0;
    std::size_t rightDropped = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        const bool mistaken = plan.holes()[taken[i].hole].mistaken;
        mistakenKept += mistaken && calibration.residuals[i].kept ? 1 : 0;
        rightDropped += !mistaken && !calibration.residuals[i].kept ? 1 : 0;
    }
    const SurfaceErrors surface = surfaceErrors(truth, calibration.camera);
    reportContactErrors(surface.errors_m, measures);
    measures["not_located"] = surface.notLocated;
    measures["uncertainty_m"] = jsonNumber(calibration.uncertainty_m);
    measures["pairs_kept"] = calibration.kept;
    measures["mistaken_kept"] = mistakenKept;
    measures["right_dropped"] = rightDropped;
}

double meanPixelError_px(const std::vector<TakenPair>& taken, const vision::CylinderCamera& truth,
                         const simulation::ProbingPlan& plan) {
    double sum_px = 0.0;
    std::size_t right = 0;
    for (const TakenPair& one : taken) {
        const auto pixel = truth.camera().project(one.pair.p_Sensor_m);
        if (plan.holes()[one.hole].mistaken || !pixel)
            continue;
        sum_px += (one.pair.pixel - *pixel).norm();
        ++right;
    }
    return sum_px / static_cast<double>(right);
}

core::Expected<void> writeFiles(const std::string& folder, const std::vector<vision::CalibrationPair>& pairs,
                                const vision::Calibration* calibration) {
    if (folder.empty())
        return {};
    TELETA_CHECK(vision::writePairs(pairs, folder + "/pairs.csv"));
    if (calibration == nullptr)
        return {};
    TELETA_CHECK(vision::writeResiduals(pairs, *calibration, folder + "/residuals.csv"));
    return vision::writeCamera({calibration->camera, vision::summaryOf(*calibration)},
                               folder + "/camera.json");
}

} // namespace

core::Expected<SceneSummary> runProbingScene(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(auto made, SimulatedProbing::make(scene, options.seed));
    SimulatedProbing& probing = *made;
    simulation::SimulatedTube& tube = probing.tube();
    const simulation::ProbingPlan& plan = probing.plan();
    const vision::CylinderCamera& truth = tube.camera();
    TELETA_CHECK(writeReference(options.outFolder, probing.reference()));

    SceneSummary summary;
    std::vector<TakenPair> taken;
    const double duration_s = options.duration_s.value_or(std::min(scene.duration_s, plan.duration_s()));
    const auto frames = static_cast<std::uint64_t>(std::llround(duration_s * scene.rate_Hz));
    std::uint64_t done = 0;
    for (; done < frames; ++done) {
        summary.interrupted = options.endsAt(done, kProbingFramesBetweenReports, tube.time_s(), duration_s);
        if (summary.interrupted)
            break;
        if (const auto one = probing.next())
            taken.push_back(*one);
    }
    summary.takeTimes(tube);

    std::vector<vision::CalibrationPair> pairs;
    std::size_t mistaken = 0;
    for (const TakenPair& one : taken) {
        pairs.push_back(one.pair);
        mistaken += plan.holes()[one.hole].mistaken ? 1 : 0;
    }
    summary.measures["holes"] = plan.holes().size();
    summary.measures["pairs"] = pairs.size();
    summary.measures["pairs_mistaken"] = mistaken;
    summary.measures["pixel_error_mean_px"] = jsonNumber(meanPixelError_px(taken, truth, plan));
    const auto calibration = vision::calibrate(pairs, probing.settings(), vision::CalibrationMethod::robust);
    if (calibration) {
        report(taken, truth, plan, *calibration, summary.measures);
    } else {
        for (const char* name : {"contact_error_mean_m", "contact_error_p95_m", "not_located",
                                 "uncertainty_m", "pairs_kept", "mistaken_kept", "right_dropped"})
            summary.measures[name] = nullptr;
        summary.measures["refusal"] = vision::toString(calibration.error());
    }
    summary.measures["frames"] = done;
    summary.measures["frames_lost"] = probing.unusable();
    TELETA_CHECK(writeFiles(options.outFolder, pairs, calibration ? &*calibration : nullptr));
    return summary;
}

} // namespace teleta::scene_run
