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
    double pixelsPerMetre = 0.0;
};

/// Links, robot, array, contacts, loads, forces and trail of a scene. The loads are those that were drawn
/// last.
[[nodiscard]] MovingState movingStateOf(const TouchScene& scene, const SceneMarks& marks);

/// That state, and how many pixels of the widget's screen a metre has where the camera looks.
[[nodiscard]] MovingView movingView(const TouchScene& scene, const SceneMarks& marks,
                                    const SceneCamera& camera, const QWidget& widget);

/// Whether a change from one state to another is seen: a point moved half a pixel, a load changed by more
/// than noise and a hundredth of its range, an arrow by a hundredth, or other things are there.
/// pixelsPerMetre: of the picture, where the scene is. Thread: any (pure).
[[nodiscard]] bool isSeen(const MovingState& before, const MovingState& now, double pixelsPerMetre);

/// Asks for a picture when the data have changed so that it is seen, and otherwise within kLongest_ms: an arm
/// that creeps needs no picture a frame. Compares with the state at the last picture that it asked for.
/// Thread: GUI.
class ChangeWatch {
public:
    static constexpr int kLongest_ms = 200;

    /// look: the view as it would be drawn now. ask: for a picture.
    ChangeWatch(std::function<MovingView()> look, std::function<void()> ask);

    /// Some data changed. Looks at them once when this thread is back in its event loop, so that all that
    /// changes together is seen together.
    void dataChanged();

private:
    void compare();
    void draw(MovingState state);

    std::function<MovingView()> m_look;
    std::function<void()> m_ask;
    MovingState m_drawn;
    QTimer m_comparison; ///< with the event loop
    QTimer m_latest;     ///< for changes that are not seen
};

} // namespace teleta::view3d
