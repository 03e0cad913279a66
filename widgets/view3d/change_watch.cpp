// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/change_watch.h"

#include "widgets/view3d/marks/scene_marks.h"
#include "widgets/view3d/scene/touch_scene.h"
#include "widgets/view3d/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::view3d {

namespace {

constexpr double kLeast_px = 0.5;
constexpr float kNoticedShare = 0.01F;
/// Points so far from the origin of a frame show how it turns.
constexpr double kArm_m = 0.1;

void addFrame(std::vector<Eigen::Vector3d>& points_m, const Eigen::Isometry3d& X_World, double arm_m) {
    points_m.emplace_back(X_World.translation());
    points_m.emplace_back(X_World * Eigen::Vector3d(arm_m, 0.0, 0.0));
    points_m.emplace_back(X_World * Eigen::Vector3d(0.0, arm_m, 0.0));
}

void addShares(std::vector<float>& shares, const Eigen::Vector3d& vector, double range) {
    for (const double value : vector)
        shares.push_back(static_cast<float>(value / range));
}

MovingState movingStateOf(const TouchScene& scene, const SceneMarks& marks) {
    MovingState state;
    for (const ArmLink& link : scene.armLinks())
        addFrame(state.points_m, link.X_World_Link, link.length_m);
    scene.robot().forEachPose(
        [&state](const Eigen::Isometry3d& X_World_Link) { addFrame(state.points_m, X_World_Link, kArm_m); });
    if (scene.hasSensor())
        addFrame(state.points_m, scene.X_World_Sensor(), kArm_m);
    for (const ContactMark& mark : scene.marks()) {
        state.points_m.push_back(scene.toWorld(mark.p_Sensor_Foot));
        state.points_m.push_back(scene.toWorld(mark.p_Sensor_Tail));
    }
    if (const Trail& trail = marks.trail.trail(); !trail.isEmpty())
        state.points_m.push_back(trail.places().back().p_m);
    const auto loads = scene.loadShares();
    state.loads.assign(loads.begin(), loads.end());
    state.leastLoad = static_cast<float>(scene.snapshot().threshold_N / scene.loadRange_N());
    if (const auto& force = marks.wrench.force()) {
        state.points_m.push_back(force->p_World_m);
        addShares(state.shares, force->force_N, marks.wrench.forceRange_N(scene));
    }
    if (const auto moment_Nm = momentOf_Nm(scene.snapshot().features))
        addShares(state.shares, *moment_Nm, marks.wrench.momentRange_Nm());
    return state;
}

} // namespace

MovingView movingView(const TouchScene& scene, const SceneMarks& marks, const SceneCamera& camera,
                      const QWidget& widget) {
    return {movingStateOf(scene, marks),
            widget.height() * widget.devicePixelRatioF() / camera.visibleHeight_m()};
}

bool isSeen(const MovingState& before, const MovingState& now, double pixelsPerMetre) {
    const auto differ = [](const auto& a, const auto& b, const auto& hasChanged) {
        return !std::ranges::equal(a, b, std::not_fn(hasChanged));
    };
    const auto hasMoved = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return pixelsPerMetre * (a - b).norm() > kLeast_px;
    };
    const auto changedBy = [](float least) {
        return
            [least](float a, float b) { return std::isnan(a) != std::isnan(b) || std::abs(a - b) >= least; };
    };
    return differ(before.points_m, now.points_m, hasMoved) ||
           differ(before.loads, now.loads, changedBy(std::max(now.leastLoad, kNoticedShare))) ||
           differ(before.shares, now.shares, changedBy(kNoticedShare));
}

ChangeWatch::ChangeWatch(std::function<MovingView()> look, std::function<void()> ask)
    : m_look(std::move(look))
    , m_ask(std::move(ask)) {
    m_comparison.setSingleShot(true);
    m_comparison.callOnTimeout([this] { compare(); });
    m_latest.setSingleShot(true);
    m_latest.setInterval(kLongest_ms);
    m_latest.callOnTimeout([this] { draw(m_look().state); });
}

void ChangeWatch::dataChanged() {
    if (!m_comparison.isActive())
        m_comparison.start(0);
}

void ChangeWatch::compare() {
    MovingView view = m_look();
    if (isSeen(m_drawn, view.state, view.pixelsPerMetre))
        draw(std::move(view.state));
    else if (!m_latest.isActive())
        m_latest.start();
}

void ChangeWatch::draw(MovingState state) {
    m_latest.stop();
    m_drawn = std::move(state);
    m_ask();
}

} // namespace teleta::view3d
