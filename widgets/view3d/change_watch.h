// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace teleta::view3d {

class SceneCamera;
class SceneMarks;
class TouchScene;

/// What of a scene moves with its data, in an order that stays while the same things are drawn.
struct MovingState {
    std::vector<Eigen::Vector3d> points_m; ///< in the world
    std::vector<float> loads;              ///< of the full colour and height, 0 to 1; NaN: a dead cell
    float leastLoad = 0.0F;                ///< a load that changes by less is noise
    std::vector<float> shares;             ///< of the length of an arrow, -1 to 1
};

struct MovingView {
    MovingState state;
    double pixelsPerMetre = 0.0; ///< where the camera looks
};

/// Links, robot, array, contacts, forces and trail as they are, and the loads as of the last
/// TouchScene::draw(), in the picture of a widget. Thread: GUI.
[[nodiscard]] MovingView movingView(const TouchScene& scene, const SceneMarks& marks,
                                    const SceneCamera& camera, const QWidget& widget);

/// Whether a change from one state to another can be seen: a point moved by half a pixel, a load changed by
/// more than noise and a hundredth of its range, an arrow by a hundredth, or other things are there. Thread:
/// any (pure).
[[nodiscard]] bool isSeen(const MovingState& before, const MovingState& now, double pixelsPerMetre);

/// Asks for a picture as soon as a change of the data can be seen, and within kLongest_ms if it cannot: a
/// frame in which an arm creeps by a tenth of a pixel is not worth drawing. Compares with the state at the
/// last picture that it asked for. Thread: GUI.
class ChangeWatch {
public:
    static constexpr int kLongest_ms = 200;

    /// look: the view as it would be drawn now. ask: for a picture.
    ChangeWatch(std::function<MovingView()> look, std::function<void()> ask);

    /// Some data changed. They are compared when this thread is back in its event loop: once for all that
    /// changed together.
    void dataChanged();

private:
    void compare();
    void draw(MovingState state);

    std::function<MovingView()> m_look;
    std::function<void()> m_ask;
    MovingState m_drawn;
    QTimer m_comparison; ///< runs until the thread is back in its event loop
    QTimer m_latest;     ///< runs while a change that cannot be seen is waiting
};

} // namespace teleta::view3d
