// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration of the cylinder camera against OpenCV's calibrateCamera with its rational model, on the same
// pairs of the same random cameras: 250 pairs with 0.5 px of noise, without wrong ones and with a fifth of
// them wrong. OpenCV is told what it cannot find itself: which frames are mirrored, and the data sheet's lens
// as a start. Counters: mean distance of located points from the true ones over the whole surface in mm, and
// cameras for which no calibration was found.
#include "tests/backend/vision/simulated_pairs.h"

#include <benchmark/benchmark.h>
#include <opencv2/calib3d.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace teleta;

constexpr int kCameras = 10;

struct Case {
    vision::CameraParameters truth;
    std::vector<vision::CalibrationPair> pairs;
};

std::vector<Case> cases(double outliers) {
    vision::CameraLottery lottery(77);
    std::vector<Case> made;
    for (int i = 0; i < kCameras; ++i) {
        const vision::CameraParameters truth = lottery.camera();
        made.push_back({truth, vision::simulatePairs(truth, {0.5, outliers}, lottery).pairs});
    }
    return made;
}

std::optional<vision::CylinderCamera> ours(const Case& one) {
    const auto calibration = vision::calibrate(one.pairs, {}, vision::CalibrationMethod::robust);
    return calibration ? std::optional(calibration->camera) : std::nullopt;
}

std::optional<vision::CylinderCamera> openCv(const Case& one) {
    std::vector<cv::Point3f> points;
    std::vector<cv::Point2f> pixels;
    for (const vision::CalibrationPair& pair : one.pairs) {
        const Eigen::Vector3d& p = pair.p_Sensor_m;
        points.emplace_back(static_cast<float>(p.x()),
                            static_cast<float>(one.truth.mirrored ? -p.y() : p.y()),
                            static_cast<float>(p.z()));
        pixels.emplace_back(static_cast<float>(pair.pixel.x()), static_cast<float>(pair.pixel.y()));
    }
    const std::vector<std::vector<cv::Point3f>> allPoints{points};
    const std::vector<std::vector<cv::Point2f>> allPixels{pixels};
    cv::Matx33d k(700.0, 0.0, 819.5, 0.0, 700.0, 615.5, 0.0, 0.0, 1.0);
    const auto lens = vision::fractionLens(vision::kEquidistant);
    cv::Mat distortion =
        (cv::Mat_<double>(8, 1) << lens.k1, lens.k2, 0.0, 0.0, lens.k3, lens.k4, lens.k5, lens.k6);
    std::vector<cv::Mat> rotations, translations;
    try {
        cv::calibrateCamera(allPoints, allPixels, {1640, 1232}, k, distortion, rotations, translations,
                            cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_RATIONAL_MODEL);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
    cv::Matx33d r;
    cv::Rodrigues(rotations.front(), r);
    vision::CameraParameters camera;
    camera.fx_px = k(0, 0);
    camera.fy_px = k(1, 1);
    camera.cx_px = k(0, 2);
    camera.cy_px = k(1, 2);
    const auto d = [&](int i) { return distortion.at<double>(i); };
    camera.distortion = {d(0), d(1), d(4), d(5), d(6), d(7), d(2), d(3)};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            camera.R_Camera_Sensor(row, column) = r(row, column);
    }
    const cv::Vec3d t(translations.front());
    camera.p_Sensor_Camera_m = -camera.R_Camera_Sensor.transpose() * Eigen::Vector3d(t[0], t[1], t[2]);
    camera.mirrored = one.truth.mirrored;
    if (camera.mirrored)
        camera.p_Sensor_Camera_m.y() = -camera.p_Sensor_Camera_m.y();
    const auto model = vision::CameraModel::create(camera);
    if (!model)
        return std::nullopt;
    return vision::CylinderCamera(*model, {});
}

template <typename Calibrate>
void calibrateAll(benchmark::State& state, double outliers, Calibrate find) {
    cv::setNumThreads(1);
    const std::vector<Case> all = cases(outliers);
    std::vector<std::optional<vision::CylinderCamera>> found(all.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < all.size(); ++i)
            found[i] = find(all[i]);
    }
    double sum_m = 0.0;
    int failed = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const vision::SurfaceErrors errors =
            found[i] ? vision::surfaceErrors(all[i].truth, *found[i]) : vision::SurfaceErrors{};
        if (errors.errors_m.empty() || errors.notLocated > 0)
            ++failed;
        else
            sum_m += errors.mean_m();
    }
    state.counters["error_mm"] = failed < kCameras ? 1e3 * sum_m / (kCameras - failed) : std::nan("");
    state.counters["failed"] = failed;
    state.counters["calibrations"] = benchmark::Counter(
        static_cast<double>(kCameras) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

} // namespace

int main(int argc, char** argv) {
    for (const double outliers : {0.0, 0.2}) {
        const std::string what = outliers > 0.0 ? "fifth_wrong" : "all_right";
        benchmark::RegisterBenchmark(("calibration/ours/" + what).c_str(), [outliers](
                                                                               benchmark::State& state) {
            calibrateAll(state, outliers, ours);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("calibration/opencv/" + what).c_str(), [outliers](
                                                                                 benchmark::State& state) {
            calibrateAll(state, outliers, openCv);
        })->Unit(benchmark::kMillisecond);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
