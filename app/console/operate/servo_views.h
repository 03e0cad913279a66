// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/operate_docks.h"
#include "backend/servo/servo_link.h"
#include "widgets/base/badge.h"

#include <QObject>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::servo {
class ServoPanel;
}
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The views of a running servo on the Operate page: its panel, and the arm with the edge that it has
/// followed in the reconstruction. Thread: GUI.
class ServoViews : public QObject {
    Q_OBJECT

public:
    /// Points of the edge that lie nearer to the one before are not kept.
    static constexpr double kSpacing_m = 0.001;

    ServoViews(view3d::Scene3dView& scene, QWidget* parent);

    void addTo(OperateDocks& docks);
    /// The servo that is shown from now on; null: none.
    void setServo(std::shared_ptr<servo::ServoLink> servo, base::Provenance provenance);
    [[nodiscard]] const std::shared_ptr<servo::ServoLink>& servo() const { return m_servo; }
    /// Shows what came since the last tick.
    void tick();

    [[nodiscard]] servo::ServoPanel& panel() { return *m_panel; }
    [[nodiscard]] const std::vector<Eigen::Vector3d>& edge_m() const { return m_edge_m; }

private:
    void forgetEdge();
    void takeContacts();
    void showArm(const servo::ServoReport& report);

    view3d::Scene3dView& m_scene;
    servo::ServoPanel* m_panel;
    std::shared_ptr<servo::ServoLink> m_servo;
    std::vector<Eigen::Vector3d> m_edge_m; ///< in the base
    bool m_edgeChanged = false;
    std::uint64_t m_restarts = 0;
};

} // namespace teleta::console
