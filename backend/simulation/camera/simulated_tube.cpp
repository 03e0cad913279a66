// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"

#include "backend/core/failure.h"
#include "backend/simulation/base/listed_effects.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::simulation {

namespace {

struct TubeText {
    Q_DECLARE_TR_FUNCTIONS(SimulatedTube)
};

constexpr int kArmSteps = 5; ///< a frame

std::vector<scene::Keyframe> keyframes(const scene::Finger& finger) {
    std::vector<scene::Keyframe> frames;
    for (const scene::FingerKeyframe& frame : finger.keyframes)
        frames.push_back({.time_s = frame.time_s,
                          .x_m = frame.z_m,
                          .depth_m = frame.depth_m,
                          .angle_rad = frame.angle_rad});
    return frames;
}

vision::CameraParameters ideal(const scene::TubeCamera& camera) {
    vision::CameraParameters parameters;
    parameters.width_px = camera.width_px;
    parameters.height_px = camera.height_px;
    parameters.fx_px = parameters.fy_px = camera.focalLength_px;
    parameters.cx_px = 0.5 * (camera.width_px - 1);
    parameters.cy_px = 0.5 * (camera.height_px - 1);
    parameters.p_Sensor_Camera_m = {camera.offsetX_m, camera.offsetY_m, -camera.behind_m};
    parameters.mirrored = true;
    return parameters;
}

/// Parts that overlap become one, so that nothing is drawn twice.
void addPart(std::vector<cv::Rect>& parts, cv::Rect part) {
    for (auto other = parts.begin(); other != parts.end();) {
        if ((*other & part).empty()) {
            ++other;
            continue;
        }
        part |= *other;
        parts.erase(other);
        other = parts.begin();
    }
    parts.push_back(part);
}

} // namespace

core::Expected<std::unique_ptr<SimulatedTube>> SimulatedTube::make(const scene::Scene& scene,
                                                                   std::uint64_t seed) {
    TELETA_CHECK(checkCameraScene(scene));
    std::unique_ptr<SimulatedTube> tube(new SimulatedTube(scene, seed));
    if (!tube->m_renderer)
        return core::failed(core::ErrorKind::badInput,
                            TubeText::tr("the lens folds the image over itself: no camera has such a lens"));
    return tube;
}

SimulatedTube::SimulatedTube(const scene::Scene& scene, std::uint64_t seed)
    : m_world(scene.camera())
    , m_rate_Hz(scene.rate_Hz)
    , m_effects(makeEffects<scene::ActsOn::camera>(scene, seed))
    , m_arm(m_world.limits) {
    if (m_world.probing) {
        m_probing.emplace(*m_world.probing, m_world.skin, seed);
        m_world.fingers.push_back(m_probing->stick());
    }
    for (const scene::Finger& finger : m_world.fingers)
        m_motions.emplace_back(keyframes(finger), false);
    vision::CameraParameters parameters = ideal(m_world.camera);
    PrintedDots dots(m_world.skin);
    m_effects.apply([&](CameraEffect& effect) {
        if (effect.changeLens)
            effect.changeLens(parameters);
        if (effect.changePrint)
            effect.changePrint(dots);
        m_changesRows = m_changesRows || effect.changeRows;
        if (!effect.before_s.empty())
            m_before_s = effect.before_s;
    });
    const auto camera = vision::CameraModel::create(parameters);
    if (!camera)
        return;
    m_renderer = std::make_unique<SkinRenderer>(
        vision::CylinderCamera(*camera, {.radius_m = m_world.skin.radius_m,
                                         .lowest_z_m = m_world.skin.begin_m,
                                         .highest_z_m = m_world.skin.begin_m + m_world.skin.length_m}),
        m_world.skin, std::move(dots));
    cv::Mat1f light(parameters.height_px, parameters.width_px, 1.0F);
    m_effects.apply([](const CameraEffect& effect) { return bool(effect.changeLight); },
                    [&](CameraEffect& effect) { effect.changeLight(light, m_renderer->places()); });
    m_renderer->setLight(light);
    m_image = m_renderer->atRest().clone();
    for (std::size_t i = 0; i < m_motions.size(); ++i)
        m_truth.push_back(fingerAt(i, 0.0));
}

FingerTruth SimulatedTube::fingerAt(std::size_t finger, double time_s) const {
    const scene::Finger& spec = m_world.fingers[finger];
    const Pose pose = m_motions[finger].at(time_s);
    const TubePose& tube = m_arm.pose();
    const double radius_m = m_world.skin.radius_m;
    // The ball in the base, then beside the tube's axis where it is now.
    const double outside_m = radius_m - pose.depth_m + spec.radius_m;
    const Eigen::Vector2d ball_m =
        outside_m * Eigen::Vector2d(std::cos(pose.angle_rad), std::sin(pose.angle_rad)) - tube.aside_m;
    FingerTruth truth;
    truth.name = spec.name;
    truth.inBase = {pose.angle_rad, pose.x_m};
    truth.press.ballRadius_m = spec.radius_m;
    truth.press.depth_m = radius_m + spec.radius_m - ball_m.norm();
    truth.press.centre = {
        std::remainder(std::atan2(ball_m.y(), ball_m.x()) - tube.turn_rad, 2.0 * std::numbers::pi),
        pose.x_m - tube.along_m};
    truth.contactRadius_m =
        SphereImprint::contactRadius_m(spec.radius_m, truth.press.depth_m, m_world.skin.reach_m);
    truth.touches = truth.contactRadius_m > 0.0 && truth.press.centre.z_m >= m_world.skin.begin_m &&
                    truth.press.centre.z_m <= m_world.skin.begin_m + m_world.skin.length_m;
    truth.p_Sensor_Centre_m = {radius_m * std::cos(truth.press.centre.angle_rad),
                               radius_m * std::sin(truth.press.centre.angle_rad), truth.press.centre.z_m};
    return truth;
}

void SimulatedTube::drag(FingerTruth& now, const FingerTruth& before) const {
    if (!now.touches || !before.touches)
        return;
    const double radius_m = m_world.skin.radius_m;
    Eigen::Vector2d drag_m(before.press.dragAround_m +
                               radius_m *
                                   std::remainder(now.press.centre.angle_rad - before.press.centre.angle_rad,
                                                  2.0 * std::numbers::pi),
                           before.press.dragAlong_m + now.press.centre.z_m - before.press.centre.z_m);
    // It sticks until the friction is used up, then it slides.
    if (const double most_m = m_world.skin.dragPerDepth * now.press.depth_m; drag_m.norm() > most_m)
        drag_m *= most_m / drag_m.norm();
    now.press.dragAround_m = drag_m.x();
    now.press.dragAlong_m = drag_m.y();
}

void SimulatedTube::next(const TubeVelocity& asked, cv::Mat1b& frame) {
    for (int i = 0; i < kArmSteps; ++i)
        m_arm.step(asked, 1.0 / (m_rate_Hz * kArmSteps));
    ++m_frame;
    std::vector<std::vector<SkinPress>> moments(m_before_s.size());
    for (std::size_t i = 0; i < m_motions.size(); ++i) {
        FingerTruth now = fingerAt(i, time_s());
        drag(now, m_truth[i]);
        for (std::size_t moment = 0; moment < m_before_s.size(); ++moment) {
            FingerTruth then = fingerAt(i, time_s() - m_before_s[moment]);
            then.press.dragAround_m = now.press.dragAround_m;
            then.press.dragAlong_m = now.press.dragAlong_m;
            if (then.touches)
                moments[moment].push_back(then.press);
        }
        m_truth[i] = std::move(now);
    }
    expose(moments, frame);
}

void SimulatedTube::restart() {
    m_frame = 0;
    m_arm = CarrierArm(m_world.limits);
    for (std::size_t i = 0; i < m_motions.size(); ++i)
        m_truth[i] = fingerAt(i, 0.0);
}

void SimulatedTube::untouched(cv::Mat1b& frame) {
    expose({{}}, frame);
}

void SimulatedTube::pressed(const std::vector<SkinPress>& presses, cv::Mat1b& frame) {
    expose({presses}, frame);
}

void SimulatedTube::expose(const std::vector<std::vector<SkinPress>>& moments, cv::Mat1b& frame) {
    for (const cv::Rect& part : m_drawn)
        m_renderer->atRest()(part).copyTo(m_image(part));
    std::vector<SkinDeformation> deformations;
    m_drawn.clear();
    for (const std::vector<SkinPress>& presses : moments) {
        deformations.emplace_back(m_world.skin.radius_m, m_world.skin.reach_m);
        deformations.back().set(presses);
        for (const cv::Rect& part : m_renderer->reach(deformations.back()))
            addPart(m_drawn, part);
    }
    for (const cv::Rect& part : m_drawn) {
        if (moments.size() == 1) {
            m_renderer->draw(deformations.front(), part, m_image);
            continue;
        }
        const auto blurs = [](const CameraEffect& effect) { return !effect.before_s.empty(); };
        m_effects.apply(blurs, [&](CameraEffect&) {
            m_part.create(m_image.size());
            m_sum.create(part.size());
            m_sum.setTo(0.0F);
            for (const SkinDeformation& deformation : deformations) {
                m_renderer->draw(deformation, part, m_part);
                m_sum += m_part(part);
            }
            m_sum *= 1.0 / static_cast<double>(deformations.size());
            m_sum.copyTo(m_image(part));
        });
    }
    finish(frame);
}

void SimulatedTube::finish(cv::Mat1b& frame) {
    if (!m_changesRows) {
        m_image.convertTo(frame, CV_8U);
        return;
    }
    // A few rows at a time stay in the processor's cache from one step to the next.
    constexpr int kRows = 16;
    frame.create(m_image.size());
    for (int v = 0; v < m_image.rows; v += kRows) {
        const cv::Range rows(v, std::min(v + kRows, m_image.rows));
        m_image.rowRange(rows).copyTo(m_rows);
        m_effects.apply([](const CameraEffect& effect) { return bool(effect.changeRows); },
                        [this](CameraEffect& effect) { effect.changeRows(m_rows); });
        cv::Mat1b finished = frame.rowRange(rows);
        m_rows.convertTo(finished, CV_8U);
    }
}

} // namespace teleta::simulation
