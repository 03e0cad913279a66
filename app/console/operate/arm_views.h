// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/bracelet/feedback_panel.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/joint_views.h"
#include "backend/arm/arm4_kinematics.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/arm_channel.h"
#include "widgets/base/controls/badge.h"
#include "widgets/touch/run_sheet_model.h"
#include "widgets/view3d/scene/scene_types.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::touch {
class ContourView;
struct HandMotion;
class StiffnessGauge;
class RunSheet;
class TouchTable;
} // namespace teleta::touch
namespace teleta::bracelet {
class BraceletView;
}
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

class ArmServoViews;

/// The views of a remote arm on the Operate page: its joints (JointViews), and of one with a tactile skin
/// stiffness, touches, the bracelet and what it is told, and the explored contour in the reconstruction.
/// Thread: GUI.
class ArmViews : public QObject {
    Q_OBJECT

public:
    ArmViews(core::StopSwitch& stop, BraceletService& bracelet, view3d::Scene3dView& scene, QWidget* parent);

    void addTo(OperateDocks& docks);
    /// Shows another arm; null: none. The previous one is no longer moved, and its touches are no longer
    /// felt.
    void setArm(const std::shared_ptr<pipeline::JointChannel>& arm, base::Provenance provenance);
    /// Null also where an arm without a skin is shown.
    [[nodiscard]] const std::shared_ptr<pipeline::ArmChannel>& arm() const { return m_arm; }
    /// With or without a skin.
    [[nodiscard]] const std::shared_ptr<pipeline::JointChannel>& joints() const { return m_joints->arm(); }
    /// Motion of a 3D mouse, and a line about its state.
    void setHand(const std::optional<touch::HandMotion>& hand, const QString& text) {
        m_joints->setHand(hand, text);
    }
    /// Shows what came since the last tick.
    void tick();
    /// See JogPanel::setCompact().
    void setCompact(bool low, bool narrow) { m_joints->setCompact(low, narrow); }
    /// Time from the read of the newest joint sample to its picture; empty without one.
    [[nodiscard]] std::optional<double> latency_s() const { return m_joints->latency_s(); }

    void setProgramRunning(bool running) { m_joints->setProgramRunning(running); }
    /// Restarts the program; earlier findings are dropped once it has restarted.
    void restartProgram() { m_joints->restartProgram(); }
    /// Keeps what an arm that is not shown has touched until it is shown.
    void keep(const std::shared_ptr<pipeline::ArmChannel>& arm);
    void keepJoints(const std::shared_ptr<pipeline::JointChannel>& arm) { m_joints->keep(arm); }
    /// Translates the labels in the reconstruction anew.
    void retranslate();
    /// Starts a new object with the next touch.
    void forgetContour();
    [[nodiscard]] ArmServoViews& servo() { return *m_servo; }
    [[nodiscard]] FeedbackPanel& feedbackPanel() { return *m_feedback; }

signals:
    void exportFailed(const QString& message);
    void meshesFailed(const QString& message);
    void jointsUnknown(const QString& message);

private:
    /// When the touch that the gauge shows was complete, in two clocks.
    struct Judged {
        std::int64_t time_ns;
        double time_s; ///< in the arm's own time
    };
    /// State kept for an arm that is not shown.
    struct Kept {
        touch::RunSheetModel::Notes notes;
        std::vector<pipeline::TouchRecord> touches;
        std::int64_t begun_ns = 0;
    };

    void takeTouches();
    void showTouch(const pipeline::TouchRecord& record);
    void judge(const pipeline::TouchRecord& record);
    /// After a recording was set back: shows the newest touch up to this time in the gauge.
    void judgeAt(double time_s);
    void show(const pipeline::ArmSnapshot& snapshot);
    /// The surface and the tip of such an arm.
    void wearBentSkin();
    void showContour(const pipeline::ExploredContour& contour);
    void showArm(const pipeline::ArmSnapshot& snapshot);
    /// Where the skin of an arm with a bent skin, or with a pad, is now.
    void showBentSkin(const core::JointVector& angle_rad);
    void showPad(const core::JointVector& angle_rad);
    /// Draws the objects of the run sheet, but for the one whose contour is drawn.
    void showObjects();
    void clear();
    /// Drops the touches of the previous run.
    void beginAnew(std::int64_t begun_ns);
    void showAge();

    BraceletService& m_bracelet;
    view3d::Scene3dView& m_scene;
    JointViews* m_joints;
    touch::StiffnessGauge* m_gauge;
    touch::TouchTable* m_touches;
    touch::RunSheet* m_sheet;
    touch::ContourView* m_contour;
    bracelet::BraceletView* m_picture;
    FeedbackPanel* m_feedback;

    std::shared_ptr<pipeline::ArmChannel> m_arm;
    std::weak_ptr<pipeline::ArmChannel> m_feltOf; ///< whose touches *Feedback* tells of
    /// State of the other open arms, restored when they are shown again.
    std::map<std::weak_ptr<pipeline::ArmChannel>, Kept, std::owner_less<>> m_kept;
    std::vector<pipeline::TouchRecord> m_shownTouches; ///< of this arm, the oldest first
    arm::Arm4Kinematics m_kinematics;
    std::optional<Judged> m_judged;
    std::uint64_t m_contourRevision = 0;
    std::uint64_t m_objectsRevision = 0;
    std::int64_t m_begun_ns = 0; ///< as in the snapshot that is shown
    bool m_wasSilent = false;
    bool m_drawsForce = false; ///< of a touch; a force sensor's is drawn by JointViews
    ArmServoViews* m_servo;
};

} // namespace teleta::console
