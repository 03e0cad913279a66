// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::simulation {

namespace {

SimulatedGel gelOf(const scene::GelSensor& sensor, std::uint64_t seed) {
    SimulatedGel gel;
    gel.width_px = sensor.width_px;
    gel.height_px = sensor.height_px;
    gel.rows = sensor.rows;
    gel.columns = sensor.columns;
    gel.pitch_px = sensor.pitch_m / sensor.pixel_m;
    gel.diameter_px = sensor.markerDiameter_m / sensor.pixel_m;
    if (sensor.bright) {
        gel.ground = 60.0;
        gel.contrast = -90.0;
    }
    gel.unevenness = sensor.unevenness;
    gel.blur_px = sensor.blur_px;
    gel.noise = sensor.noise;
    gel.printError_px = sensor.printError_m / sensor.pixel_m;
    gel.seed = seed;
    return gel;
}

/// The drag as the place of an indenter.
KeyframeMotion motionOf(const scene::GelBall& ball) {
    std::vector<scene::Keyframe> frames;
    for (const scene::GelKeyframe& frame : ball.keyframes)
        frames.push_back({.time_s = frame.time_s,
                          .x_m = frame.dragX_m,
                          .y_m = frame.dragY_m,
                          .depth_m = frame.depth_m,
                          .angle_rad = frame.turn_rad});
    return {std::move(frames), false};
}

/// The displacement field of a ball, and its truth.
struct PressedBall {
    GelContact field;
    GelBallTruth truth;
};

/// met_m: where the arm was when the ball met the gel.
PressedBall pressed(const scene::GelBall& ball, const Pose& pose, const Eigen::Vector2d& met_m) {
    PressedBall result;
    GelBallTruth& truth = result.truth;
    truth.name = ball.name;
    truth.drag_m = {pose.x_m, pose.y_m};
    truth.turn_rad = pose.angle_rad;
    truth.centre_m = Eigen::Vector2d(ball.x_m, ball.y_m) - met_m;
    if (!(pose.depth_m > 0.0))
        return result;
    truth.touches = true;
    truth.radius_m = std::sqrt(ball.radius_m * pose.depth_m);
    const double drag_m = truth.drag_m.norm();
    const double whole_m = ball.friction * pose.depth_m;
    truth.slipShare = std::min(1.0, drag_m / whole_m);
    const Eigen::Vector2d along =
        drag_m > 0.0 ? Eigen::Vector2d(truth.drag_m / drag_m) : Eigen::Vector2d(Eigen::Vector2d::Zero());
    truth.centre_m += std::max(0.0, drag_m - whole_m) * along;
    result.field = {.centre_m = truth.centre_m,
                    .radius_m = truth.radius_m,
                    .spread_m = ball.spreadPerDepth * pose.depth_m,
                    .slip_m = whole_m * along,
                    .stick = std::sqrt(1.0 - truth.slipShare),
                    .turn_rad = pose.angle_rad};
    return result;
}

} // namespace

core::Expected<std::unique_ptr<GelStage>> GelStage::make(const scene::Scene& scene, std::uint64_t seed) {
    TELETA_CHECK(scene::checkGelScene(scene));
    return std::unique_ptr<GelStage>(new GelStage(scene.gel(), scene.rate_Hz, seed));
}

GelStage::GelStage(const scene::GelWorld& world, double rate_Hz, std::uint64_t seed)
    : m_world(world)
    , m_rate_Hz(rate_Hz)
    , m_renderer(gelOf(world.sensor, seed))
    , m_arm(world.limits)
    , m_met_m(world.balls.size(), Eigen::Vector2d::Zero()) {
    for (const scene::GelBall& ball : m_world.balls)
        m_motions.push_back(motionOf(ball));
    place();
}

void GelStage::place() {
    m_truth.clear();
    std::vector<GelContact> contacts;
    for (std::size_t i = 0; i < m_motions.size(); ++i) {
        Pose pose = m_motions[i].at(time_s());
        pose.depth_m -= m_arm.pose().along_m;
        if (!(pose.depth_m > 0.0))
            m_met_m[i] = m_arm.pose().aside_m;
        pose.x_m -= m_arm.pose().aside_m.x() - m_met_m[i].x();
        pose.y_m -= m_arm.pose().aside_m.y() - m_met_m[i].y();
        PressedBall ball = pressed(m_world.balls[i], pose, m_met_m[i]);
        if (ball.truth.touches)
            contacts.push_back(ball.field);
        m_truth.push_back(std::move(ball.truth));
    }
    m_places_px = m_renderer.rest_px();
    const double pixel_m = m_world.sensor.pixel_m;
    for (Eigen::Vector2d& place_px : m_places_px) {
        const Eigen::Vector2d rest_m = pixel_m * place_px;
        for (const GelContact& contact : contacts)
            place_px += contact.displacement_m(rest_m) / pixel_m;
    }
}

void GelStage::next(const TubeVelocity& asked, cv::Mat1b& picture) {
    ++m_picture;
    m_arm.step(asked, 1.0 / m_rate_Hz);
    place();
    again(picture);
}

void GelStage::again(cv::Mat1b& picture) {
    m_renderer.draw(m_places_px, picture);
}

void GelStage::restart() {
    m_picture = 0;
    m_arm = CarrierArm(m_world.limits);
    place();
}

} // namespace teleta::simulation
