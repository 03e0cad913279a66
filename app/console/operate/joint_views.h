// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/joint_dials.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/stiffness/joint_sample.h"
#include "widgets/base/controls/badge.h"
#include "widgets/charts/joint_chart_view.h"

#include <QObject>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::touch {
class JogPanel;
struct HandMotion;
} // namespace teleta::touch
namespace teleta::view3d {
class Scene3dView;
}

namespace teleta::console {

/// The views of an arm's joints on the Operate page: the chart of them, jogging, and, where its links are
/// described, the arm in the reconstruction. An arm with a tactile skin has more, see ArmViews. Thread: GUI.
class JointViews : public QObject {
    Q_OBJECT

public:
    JointViews(core::StopSwitch& stop, view3d::Scene3dView& scene, QWidget* parent);

    /// Something else that moves the arm, below jogging; before addTo().
    void putBelowJog(QWidget* panel) { m_belowJog = panel; }
    void addTo(OperateDocks& docks);
    /// Shows another arm; null: none. The previous one is no longer moved. What the chart has of it is shown
    /// again when it comes back.
    void setArm(std::shared_ptr<pipeline::JointChannel> arm, base::Provenance provenance);
    [[nodiscard]] const std::shared_ptr<pipeline::JointChannel>& arm() const { return m_arm; }
    /// Stores samples of an open arm that is not shown, for its chart when it is shown again; null: none.
    void keep(const std::shared_ptr<pipeline::JointChannel>& arm);
    /// Motion of a 3D mouse, and a line about its state.
    void setHand(const std::optional<touch::HandMotion>& hand, const QString& text);
    /// See JogPanel::setCompact().
    void setCompact(bool low, bool narrow);
    /// The arm is no longer moved by hand; what is held counts again once it was let go.
    void letGo();
    /// Where a shadow of the arm is, which is drawn in place of the ghost at the commanded position; empty:
    /// there is none.
    void setShadow(const core::JointVector& shadow_rad);
    /// Takes what came since the last tick; refresh() shows it.
    void tick();
    void refresh() { m_chart->refresh(); }
    /// Shows where the joints are.
    void show(const core::JointSample& sample);
    /// Where the tip of the arm is in the base, of which the 3-D view draws the trail; empty: it is not
    /// known.
    using TipOf = std::function<Eigen::Vector3d(const core::JointSample&)>;
    void setTip(TipOf tipOf) { m_tipOf = std::move(tipOf); }
    /// The torques in which touches are evaluated, which the chart shows; nothing: none are, and it shows the
    /// angles.
    void setTouching(const std::optional<stiffness::TorqueWindow>& window);
    /// The arm tells nothing any more.
    [[nodiscard]] bool isSilent() const { return m_silent; }
    /// Time from the read of the newest joint sample to its picture; empty without one.
    [[nodiscard]] std::optional<double> latency_s() const { return m_latency_s; }
    [[nodiscard]] charts::JointChartView& chart() { return *m_chart; }

    void setProgramRunning(bool running);
    void restartProgram();

signals:
    void exportFailed(const QString& message);
    /// Somebody begins to jog the arm.
    void movesByHand();
    /// The arm's meshes cannot be shown; a sentence.
    void meshesFailed(const QString& message);
    /// The arm tells joints that its description does not have; a sentence.
    void jointsUnknown(const QString& message);

private:
    void followTip();
    void loadRobot();
    void showChain(const core::JointSample& sample);
    void showRobot(const core::JointSample& sample);
    void showScenery();
    void showWrench();
    void showReport();
    void post(const core::JointVector& rate_radPerS);
    bool readingsWait();
    void clear();

    core::StopSwitch& m_stop;
    std::uint64_t m_engagements = 0; ///< of STOP, that a tick has seen
    view3d::Scene3dView& m_scene;
    charts::JointChartView* m_chart;
    touch::JogPanel* m_jog;

    std::shared_ptr<pipeline::JointChannel> m_arm;
    /// Charts of the other open arms.
    std::map<std::weak_ptr<pipeline::JointChannel>, charts::JointChartView::Content, std::owner_less<>>
        m_kept;
    std::vector<core::JointSample> m_samples; ///< of a tick
    TipOf m_tipOf;
    std::optional<ChainDials> m_dials;        ///< of an arm with a chain
    bool m_hasRobot = false;                  ///< its shape is in the 3-D view
    std::optional<core::JointSample> m_shown; ///< of an arm with a chain
    std::uint64_t m_present = 0;              ///< ArmSource::presentObjects(), as drawn
    std::int64_t m_wrench_ns = 0;             ///< of the force that is shown; 0: none
    std::size_t m_unknownJoints = 0;          ///< names of ArmReport::unknownJoints that were told
    double m_tip_s = 0.0;                     ///< of the arm, when the tip was told last
    bool m_asked = false;                     ///< the last command was to move
    bool m_silent = false;
    std::int64_t m_sample_ns = 0;     ///< of the newest reading that was seen; 0: none
    std::int64_t m_sampleCame_ns = 0; ///< when it was seen first
    std::optional<double> m_latency_s;
    QWidget* m_belowJog = nullptr;  ///< see putBelowJog()
    core::JointVector m_shadow_rad; ///< see setShadow()
};

} // namespace teleta::console
