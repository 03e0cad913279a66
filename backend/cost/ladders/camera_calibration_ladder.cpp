// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladder_camera.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/camera/nominal_camera.h"

#include <memory>
#include <numbers>
#include <numeric>
#include <optional>

namespace teleta::cost {

namespace {

constexpr std::size_t kCalibrated = 30;

struct CalibrationCase {
    vision::CameraParameters truth;
    std::vector<vision::CalibrationPair> pairs;
};

/// The 25 x 10 holes of the paper's shell; pixels with 0.5 px of noise, every tenth one anywhere in the
/// image.
CalibrationCase calibrationCase(std::size_t number) {
    core::RandomStream random(number, "camera calibration ladder");
    constexpr int kAround = 25;
    constexpr int kAlong = 10;
    constexpr double kNoise_px = 0.5;
    constexpr double kWrong = 0.1;
    CalibrationCase made{randomCamera(random), {}};
    for (int i = 0; i < kAround; ++i)
        for (int j = 0; j < kAlong; ++j) {
            const Eigen::Vector3d p_m =
                tubePoint_m(2.0 * std::numbers::pi * i / kAround, 0.002 + 0.096 * j / (kAlong - 1.0));
            const Eigen::Vector2d noise_px(kNoise_px * random.normal(), kNoise_px * random.normal());
            const Eigen::Vector2d anywhere_px(1639.0 * random.uniform(), 1231.0 * random.uniform());
            const bool wrong = random.uniform() < kWrong;
            made.pairs.push_back({wrong ? anywhere_px : exactPixel(made.truth, p_m) + noise_px, p_m});
        }
    return made;
}

/// Adds how far the points of the tube are from where the camera finds their pixels. It may find them a
/// little beyond the ends of the tube.
void compareOnTube(const vision::CameraParameters& truth, const vision::CylinderCamera& camera,
                   Trial& trial) {
    vision::CylinderSurface longer = camera.surface();
    longer.lowest_z_m -= 0.01;
    longer.highest_z_m += 0.1;
    const vision::CylinderCamera found(camera.camera(), longer);
    for (int i = 0; i < 36; ++i)
        for (int j = 0; j <= 10; ++j) {
            const Eigen::Vector3d p_m = tubePoint_m(2.0 * std::numbers::pi * (i + 0.5) / 36.0, 0.01 * j);
            const auto located_m = found.locate_m(exactPixel(truth, p_m));
            trial.error(((located_m ? *located_m : middleOfTube_m()) - p_m).norm());
        }
}

} // namespace

Ladder cameraCalibrationLadder() {
    Ladder ladder;
    ladder.name = "camera-calibration";
    ladder.topic = Topic::camera;
    ladder.title = LadderText::tr("Calibration of the camera in the tube").toStdString();
    ladder.truth =
        LadderText::tr("distance of located points of the tube from the true ones; where the calibration "
                       "is refused the camera of the data sheet stands in")
            .toStdString();
    ladder.errorUnit = "m";
    ladder.trials = kCalibrated;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        auto cases = std::make_shared<std::vector<CalibrationCase>>();
        for (std::size_t i = 0; i < kCalibrated; ++i)
            cases->push_back(calibrationCase(i));
        constexpr std::array<const char*, 4> kWhat{"all pairs, no distortion",
                                                   "pairs off by more than 2 mm left out",
                                                   "squares of all pairs", "wrong pairs found and left out"};
        std::vector<Rung> rungs;
        for (std::size_t i = 0; i < vision::kCalibrationMethods.size(); ++i) {
            const vision::CalibrationMethod method = vision::kCalibrationMethods[i];
            rungs.push_back(
                {vision::toString(method), kWhat[i], [=](Trial& trial) {
                     const CalibrationCase& one = (*cases)[trial.index() % cases->size()];
                     std::optional<tl::expected<vision::Calibration, vision::CalibrationRefusal>> found;
                     trial.timed(1, [&] { found = vision::calibrate(one.pairs, {}, method); });
                     compareOnTube(one.truth, *found ? (*found)->camera : vision::nominalCamera(1640, 1232),
                                   trial);
                 }});
        }
        constexpr std::size_t kCalls = 4;
        rungs.push_back(limitRung("each pair projected once", kCalls, [=](std::size_t index) {
            const CalibrationCase& one = (*cases)[index % cases->size()];
            return std::accumulate(one.pairs.begin(), one.pairs.end(), 0.0,
                                   [&](double sum, const auto& pair) {
                                       const auto seen = vision::projectFreely(one.truth, pair.p_Sensor_m);
                                       return sum + (seen ? seen->pixel.x() : 0.0);
                                   });
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
