// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladder_camera.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/vision/camera/undistortion.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <numbers>
#include <optional>

namespace teleta::cost {

namespace {

constexpr std::size_t kPixelsPerTrial = 128;
constexpr std::size_t kSeenPoints = 2048;

struct SeenPoint {
    Eigen::Vector2d pixel;
    Eigen::Vector3d direction; ///< in the camera's frame
};

struct UndistortionInput {
    vision::CameraModel camera;
    std::vector<SeenPoint> points;
};

/// Where a pixel looks; empty: no answer.
using LookUp = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& pixel)>;

std::optional<Eigen::Vector3d> directionOf(const std::optional<Eigen::Vector2d>& point) {
    if (!point)
        return std::nullopt;
    return Eigen::Vector3d(point->x(), point->y(), 1.0);
}

double angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    // What overflows on the way is no direction.
    return std::isfinite(angle) ? angle : std::atan2(b.head<2>().norm(), b.z());
}

Rung undistortionRung(std::string name, std::string parameter,
                      const std::shared_ptr<const UndistortionInput>& input, LookUp lookUp) {
    return {std::move(name), std::move(parameter), [input, lookUp = std::move(lookUp)](Trial& trial) {
                std::array<std::optional<Eigen::Vector3d>, kPixelsPerTrial> found;
                const auto pointAt = [&](std::size_t i) -> const SeenPoint& {
                    return input->points[(trial.index() * kPixelsPerTrial + i) % input->points.size()];
                };
                trial.timed(kPixelsPerTrial, [&] {
                    for (std::size_t i = 0; i < kPixelsPerTrial; ++i)
                        found[i] = lookUp(pointAt(i).pixel);
                });
                // Without an answer the camera is taken to look straight ahead.
                for (std::size_t i = 0; i < kPixelsPerTrial; ++i)
                    trial.error(angle_rad(found[i].value_or(Eigen::Vector3d::UnitZ()), pointAt(i).direction));
            }};
}

} // namespace

Ladder undistortionLadder() {
    Ladder ladder;
    ladder.name = "undistortion";
    ladder.topic = Topic::camera;
    ladder.title = LadderText::tr("Direction in which a pixel of the wide lens looks").toStdString();
    ladder.truth = LadderText::tr("angle from the direction of the point of the tube that the pixel shows")
                       .toStdString();
    ladder.errorUnit = "rad";
    ladder.trials = 64;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        core::RandomStream random(1, "undistortion ladder");
        const vision::CameraParameters parameters = randomCamera(random);
        auto made = std::make_shared<UndistortionInput>(
            UndistortionInput{vision::CameraModel::create(parameters).value(), {}});
        while (made->points.size() < kSeenPoints) {
            const Eigen::Vector3d p_m =
                tubePoint_m(2.0 * std::numbers::pi * random.uniform(), 0.1 * random.uniform());
            const Eigen::Vector2d pixel = exactPixel(parameters, p_m);
            // The part of the image that every table covers.
            if (pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= parameters.width_px - 1 &&
                pixel.y() <= parameters.height_px - 1)
                made->points.push_back({pixel, exactDirection(parameters, p_m)});
        }
        const std::shared_ptr<const UndistortionInput> input = made;
        std::vector<Rung> rungs;
        for (const int iterations : {1, 5, 20})
            rungs.push_back(undistortionRung(
                "fixed-" + std::to_string(iterations),
                std::to_string(iterations) + (iterations == 1 ? " iteration" : " iterations"), input,
                [=](const Eigen::Vector2d& pixel) {
                    return directionOf(
                        vision::undistortByIteration(input->camera.parameters(), pixel, iterations));
                }));
        for (const int step_px : {32, 16, 8}) {
            const auto table = std::make_shared<const vision::DirectionTable>(input->camera, step_px);
            rungs.push_back(undistortionRung(
                "table-" + std::to_string(step_px), "every " + std::to_string(step_px) + " px", input,
                [=](const Eigen::Vector2d& pixel) { return table->direction(pixel); }));
        }
        rungs.push_back(undistortionRung("newton", "to 5e-10 px", input, [=](const Eigen::Vector2d& pixel) {
            const auto point = input->camera.undistort(pixel);
            return directionOf(point ? std::optional(*point) : std::nullopt);
        }));
        constexpr std::size_t kCalls = 4096;
        rungs.push_back(limitRung("each pixel read once", kCalls, [=](std::size_t index) {
            return input->points[index % input->points.size()].pixel.sum();
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
