// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/docks/operate_docks.h"
#include "backend/servo/servo_link.h"
#include "widgets/base/controls/badge.h"
#include "widgets/view3d/scene/scene_types.h"

#include <QObject>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace teleta::servo {
class ServoPanel;
class ServoRunsView;
} // namespace teleta::servo
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The views of a running servo on the Operate page: its panel, and the arm with the edge that it has
/// followed in the reconstruction. Thread: GUI.
class ServoViews : public QObject {
    Q_OBJECT

public:
    /// Points closer than this to the previous one are dropped.
    static constexpr double kSpacing_m = 0.001;
    /// Beyond this number every second point is dropped and the spacing doubles.
    static constexpr std::size_t kMostPoints = 4000;

    ServoViews(view3d::Scene3dView& scene, QWidget* parent);

    void addTo(OperateDocks& docks);
    /// Shows another servo; null: none.
    void setServo(std::shared_ptr<servo::ServoLink> servo, const QString& name, base::Provenance provenance);
    [[nodiscard]] const std::shared_ptr<servo::ServoLink>& servo() const { return m_servo; }
    /// Shows what came since the last tick.
    void tick();

    [[nodiscard]] servo::ServoPanel& panel() { return *m_panel; }
    [[nodiscard]] servo::ServoRunsView& runs() { return *m_runs; }
    [[nodiscard]] const std::vector<Eigen::Vector3d>& edge_m() const { return m_edge.points_m; }
    /// The arm as tubes: base to shoulder, to elbow, to wrist, to sensor.
    [[nodiscard]] static std::array<view3d::ArmLink, 4> linksOf(const servo::ServoReport& report);

signals:
    /// A file could not be saved or read.
    void failed(const QString& message);

private:
    /// The edge that a servo has followed.
    struct Edge {
        std::vector<Eigen::Vector3d> points_m; ///< in the base
        double spacing_m = kSpacing_m;
        std::uint64_t run = 0; ///< whose edge it is
    };

    void takeSteps();
    void forgetEdge();
    void addToEdge(const Eigen::Vector3d& p_Base_Contact);
    void show(const servo::ServoReport& report);
    void showArm(const servo::ServoReport& report);
    [[nodiscard]] Eigen::AlignedBox3d handAndBody(const servo::ServoReport& report) const;

    view3d::Scene3dView& m_scene;
    servo::ServoPanel* m_panel;
    servo::ServoRunsView* m_runs;
    std::shared_ptr<servo::ServoLink> m_servo;
    Edge m_edge;
    bool m_edgeChanged = false;
    /// Edges of the other open servos, restored when they are shown again.
    std::map<std::weak_ptr<servo::ServoLink>, Edge, std::owner_less<>> m_kept;
};

} // namespace teleta::console
