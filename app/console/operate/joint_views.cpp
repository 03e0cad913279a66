// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/joint_views.h"

#include "app/console/operate/joint_dials.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/arm_report.h"
#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/touch/skin_touches.h"
#include "widgets/base/background.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/robot/robot_shape.h"
#include "widgets/view3d/scene3d_view.h"

#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace teleta::console {

namespace {

/// A drawn link is so thick for each metre of the arm.
constexpr double kThickness = 0.035;
constexpr double kThinnest_m = 0.005;
constexpr double kShortest_m = 1e-3;
/// A joint (rad, m) that is farther from where it was told to be shows the ghost.
constexpr double kGhost_rad = 0.02;
/// A force that was read so long ago is not shown any more.
constexpr std::int64_t kOldWrench_ns = 500'000'000;
/// Time between two places of the tip's trail.
constexpr double kTipStep_s = 0.02;

/// The device says that the joints are not known any more: what moves the arm by them would be blind.
bool readingsAreOld(const pipeline::JointChannel& arm) {
    const core::DeviceStatus status = arm.jointStatus();
    const core::DeviceState state =
        core::observedState(status.state, status.lastData_ns, core::steadyNow_ns(),
                            core::staleAfter_ns(arm.description().nominalRate_Hz));
    return state == core::DeviceState::stale || state == core::DeviceState::lost ||
           state == core::DeviceState::reconnecting;
}

} // namespace

JointViews::JointViews(core::StopSwitch& stop, view3d::Scene3dView& scene, QWidget* parent)
    : QObject(parent)
    , m_stop(stop)
    , m_scene(scene)
    , m_chart(new charts::JointChartView(parent))
    , m_jog(new touch::JogPanel(parent)) {
    connect(m_jog, &touch::JogPanel::jogRequested, this, &JointViews::post);
    connect(m_jog, &touch::JogPanel::programRunRequested, this, &JointViews::setProgramRunning);
    connect(m_jog, &touch::JogPanel::programRestartRequested, this, &JointViews::restartProgram);
    connect(m_chart, &charts::JointChartView::exportFailed, this, &JointViews::exportFailed);
}

void JointViews::addTo(OperateDocks& docks) {
    docks.add(OperateDocks::joints, m_chart);
    if (m_belowJog == nullptr) {
        docks.addScrolling(OperateDocks::jog, m_jog);
        return;
    }
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_jog, 1);
    layout->addWidget(m_belowJog);
    docks.addScrolling(OperateDocks::jog, both);
}

void JointViews::setCompact(bool low, bool narrow) {
    m_jog->setCompact(low, narrow);
}

void JointViews::setArm(std::shared_ptr<pipeline::JointChannel> arm, base::Provenance provenance) {
    // While m_arm is the arm that is moved: the zero that ends it is not for the next one.
    m_jog->letGo();
    if (m_arm)
        m_kept.insert_or_assign(m_arm, m_chart->takeContent());
    clear();
    m_arm = std::move(arm);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    if (!m_arm) {
        m_jog->setArm(std::nullopt);
        return;
    }
    if (const auto chain = m_arm->chain()) {
        m_tipOf = [chain](const core::JointSample& sample) -> Eigen::Vector3d {
            return chain->X_Base_Tip(sample.angle_rad).translation();
        };
        m_dials.emplace(chain);
        loadRobot();
    }
    m_chart->setProvenance(provenance);
    m_chart->setJoints(m_arm->description().joints());
    QStringList names;
    for (std::size_t joint = 0; m_arm->chain() && joint < m_arm->chain()->joints(); ++joint)
        names << QString::fromStdString(m_arm->chain()->joint(joint).name);
    m_chart->setJointNames(names);
    m_jog->setArm(m_arm->description(), m_arm->chain());
    // Nothing new may come: a recording that is paused stands as it was left.
    if (auto kept = m_kept.extract(m_arm))
        m_chart->setContent(std::move(kept.mapped()));
}

void JointViews::keep(const std::shared_ptr<pipeline::JointChannel>& arm) {
    const auto kept = m_kept.find(arm);
    if (!arm || kept == m_kept.end())
        return;
    core::JointSample sample;
    while (arm->popSample(sample))
        charts::JointChartView::append(kept->second.history, arm->description().joints(), {&sample, 1});
}

/// Meshes may be large: until they are read, tubes are drawn between the joints.
void JointViews::loadRobot() {
    using Loaded = core::Expected<view3d::RobotShape>;
    base::runInBackground(
        this,
        [chain = m_arm->chain(), folder = m_arm->meshFolder()] {
            return std::make_shared<Loaded>(view3d::loadRobotShape(chain->model(), folder));
        },
        [this, arm = std::weak_ptr(m_arm),
         folder = m_arm->meshFolder()](const std::shared_ptr<Loaded>& loaded) {
            if (arm.lock() != m_arm || !m_arm)
                return;
            if (*loaded && !(*loaded)->isEmpty()) {
                m_scene.setRobot(std::make_shared<const view3d::RobotShape>(std::move(**loaded)));
                m_hasRobot = true;
                if (m_shown)
                    showRobot(*m_shown);              // no newer reading may come
            } else if (!*loaded && !folder.empty()) { // without a folder nobody expects meshes
                emit meshesFailed(tr("The arm is drawn without its meshes: %1")
                                      .arg(QString::fromStdString(core::describe(loaded->error()))));
            }
        });
}

void JointViews::setTouching(const std::optional<stiffness::TorqueWindow>& window) {
    m_chart->setWindow(window);
    if (!window && m_arm)
        m_chart->setAnglesShown(true);
}

void JointViews::clear() {
    m_chart->clear();
    if (m_arm) {
        m_scene.setArmLinks({});
        m_scene.forgetArm();
    }
    m_tipOf = {};
    m_dials.reset();
    m_hasRobot = false;
    m_shown.reset();
    m_shadow_rad = {};
    m_present = 0;
    m_wrench_ns = 0;
    m_unknownJoints = 0;
    m_jog->setWrench(std::nullopt);
    m_asked = false;
    m_silent = false;
    m_sample_ns = m_sampleCame_ns = 0;
    m_latency_s.reset();
}

void JointViews::setHand(const std::optional<touch::HandMotion>& hand, const QString& text) {
    m_jog->setHandText(text);
    m_jog->setHand(hand);
}

/// An arm that stood still for a fault or STOP moves again only after it was told that the switch was let go.
void JointViews::post(const core::JointVector& rate_radPerS) {
    if (!m_arm)
        return;
    const bool asks = m_jog->isMoving();
    const std::int64_t now_ns = core::steadyNow_ns();
    if (asks && !m_asked) {
        emit movesByHand();
        m_arm->device().post({core::JointVector::zeros(rate_radPerS.size()), now_ns});
    }
    m_asked = asks;
    m_arm->device().post({rate_radPerS, now_ns});
}

void JointViews::letGo() {
    m_jog->letGo();
}

void JointViews::setShadow(const core::JointVector& shadow_rad) {
    if (m_shadow_rad == shadow_rad)
        return;
    m_shadow_rad = shadow_rad;
    if (m_hasRobot && m_shown)
        showRobot(*m_shown);
}

void JointViews::tick() {
    // One that was engaged and released between two ticks lets go of the keys, too.
    const std::uint64_t engagements = m_stop.engagements();
    const bool wasEngaged = std::exchange(m_engagements, engagements) != engagements;
    m_jog->setStopEngaged(m_stop.engaged() || wasEngaged);
    if (m_arm) {
        m_samples.clear();
        core::JointSample sample;
        while (m_arm->popSample(sample))
            m_samples.push_back(sample);
        if (!m_samples.empty()) {
            if (m_sample_ns == 0 && !pipeline::tellsTorques(m_samples.back()))
                m_chart->setAnglesShown(true); // there is nothing else to show
            show(m_samples.back());
        }
        m_chart->append(m_samples);
        followTip();
        showScenery();
        showWrench();
        m_jog->setDrive(m_arm->device().drive());
        showReport();
        m_jog->setHindrance(QString::fromStdString(m_arm->device().hindrance()));
    }
    m_silent = m_arm && (readingsWait() || readingsAreOld(*m_arm));
    m_jog->setReadingsOld(m_silent);
}

void JointViews::showReport() {
    const auto* reporting = dynamic_cast<const core::ReportingArm*>(&m_arm->device());
    const core::ArmReport report = reporting != nullptr ? reporting->report() : core::ArmReport();
    m_jog->setReport(report);
    // Each name is told once.
    QStringList names;
    for (; m_unknownJoints < report.unknownJoints.size(); ++m_unknownJoints)
        names << QString::fromStdString(report.unknownJoints[m_unknownJoints]);
    if (!names.isEmpty())
        emit jointsUnknown(tr("The arm reports joints that its description does not have: %1.")
                               .arg(names.join(QStringLiteral(", "))));
}

void JointViews::show(const core::JointSample& sample) {
    m_latency_s = static_cast<double>(core::steadyNow_ns() - sample.time_ns) * 1e-9;
    if (std::exchange(m_sample_ns, sample.time_ns) != sample.time_ns)
        m_sampleCame_ns = core::steadyNow_ns();
    m_jog->setSample(sample);
    if (m_arm->chain())
        showChain(sample);
}

/// No newer reading is there for longer than the arm may be silent, whatever its device says: they may wait
/// on the way. One that is shown late, but with others behind it, only makes what leads by it slower.
bool JointViews::readingsWait() {
    if (m_sample_ns == 0 || m_arm->description().recorded)
        return false;
    const std::int64_t now_ns = core::steadyNow_ns();
    m_jog->setReadingsAge(static_cast<double>(now_ns - m_sample_ns) * 1e-9);
    return now_ns - m_sampleCame_ns > core::staleAfter_ns(m_arm->description().nominalRate_Hz);
}

/// All that came, however late this tick is: the trail has no gaps where only the screen was slow.
void JointViews::followTip() {
    for (const core::JointSample& sample : m_samples) {
        const bool isDue = !(std::abs(sample.sourceTime_s - m_tip_s) < kTipStep_s);
        if (!m_tipOf || sample.angle_rad.size() != m_arm->description().joints() ||
            !(isDue || &sample == &m_samples.back()))
            continue;
        m_tip_s = sample.sourceTime_s;
        m_scene.setTip(m_tipOf(sample), sample.sourceTime_s);
    }
}

void JointViews::showScenery() {
    const std::uint64_t present = m_arm->device().presentObjects();
    if (std::exchange(m_present, present) == present)
        return;
    std::vector<view3d::SceneryItem> items;
    const std::vector<core::WorldObject>& objects = m_arm->description().objects;
    for (std::size_t i = 0; i < std::min<std::size_t>(objects.size(), 64); ++i) {
        if (((present >> i) & 1U) == 0)
            continue;
        view3d::SceneryItem& item = items.emplace_back();
        item.name = QString::fromStdString(objects[i].name);
        item.z_m = objects[i].z_m;
        for (const auto& [x_m, y_m] : objects[i].outline_m)
            item.outline_m.emplace_back(x_m, y_m);
    }
    m_scene.setScenery(items);
}

/// The force at the tip, along the axes of the base. One that is old is not shown.
void JointViews::showWrench() {
    const std::optional<core::WrenchSample> wrench = m_arm->newestWrench();
    // What a recording shows while it is paused does not grow old.
    const std::int64_t now_ns =
        m_arm->description().recorded && m_shown ? m_shown->time_ns : core::steadyNow_ns();
    const bool isKnown = wrench && m_shown && m_arm->chain() &&
                         m_shown->angle_rad.size() == m_arm->chain()->joints() &&
                         std::abs(now_ns - wrench->time_ns) < kOldWrench_ns;
    if (std::exchange(m_wrench_ns, isKnown ? wrench->time_ns : 0) == m_wrench_ns)
        return;
    if (!isKnown) {
        m_jog->setWrench(std::nullopt);
        m_scene.setForce(std::nullopt);
        return;
    }
    m_jog->setWrench(wrench);
    const Eigen::Isometry3d X_Base_Tip = m_arm->chain()->X_Base_Tip(m_shown->angle_rad);
    m_scene.setForce(
        view3d::DrawnForce{.p_World_m = X_Base_Tip.translation(),
                           .force_N = X_Base_Tip.linear() * Eigen::Vector3d::Map(wrench->force_N.data()),
                           .measured = true,
                           .time_s = 1e-9 * static_cast<double>(wrench->time_ns)});
}

void JointViews::showChain(const core::JointSample& sample) {
    const arm_model::SerialChain& chain = *m_arm->chain();
    if (sample.angle_rad.size() != chain.joints())
        return;
    std::vector<view3d::ArmLink> links;
    double reach_m = 0.0;
    Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point_m : chain.pathPoints_m(sample.angle_rad)) {
        // Several joints may lie in one place.
        const Eigen::Vector3d along_m = point_m - from_m;
        if (along_m.norm() < kShortest_m)
            continue;
        view3d::ArmLink& link = links.emplace_back();
        link.X_World_Link.translation() = from_m;
        link.X_World_Link.linear() =
            Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), along_m).toRotationMatrix();
        link.length_m = along_m.norm();
        reach_m += link.length_m;
        from_m = point_m;
    }
    const double radius_m = std::max(kThinnest_m, kThickness * reach_m);
    for (view3d::ArmLink& link : links)
        link.radius_m = radius_m;
    m_scene.setArmLinks(links);
    m_scene.setJoints(m_dials->at(sample.angle_rad, radius_m));
    m_shown = sample;
    if (m_hasRobot)
        showRobot(sample);
}

/// Where the arm was told to be, or its shadow, stands beside it as a ghost, as long as both can be told
/// apart.
void JointViews::showRobot(const core::JointSample& sample) {
    const arm_model::SerialChain& chain = *m_arm->chain();
    const core::JointVector& commanded = m_shadow_rad.empty() ? sample.reference_rad : m_shadow_rad;
    bool apart = !m_shadow_rad.empty() && m_shadow_rad.size() == chain.joints();
    for (std::size_t i = 0; commanded.size() == chain.joints() && i < commanded.size(); ++i)
        apart = apart || std::abs(commanded[i] - sample.angle_rad[i]) > kGhost_rad;
    m_scene.setRobotPoses(chain.linkPoses(sample.angle_rad),
                          apart ? chain.linkPoses(commanded) : std::vector<Eigen::Isometry3d>());
}

void JointViews::setProgramRunning(bool running) {
    if (!m_arm)
        return;
    // Whatever held the tip was elsewhere when the program has moved it.
    if (running)
        m_jog->letGo();
    m_arm->device().setProgramRunning(running);
}

void JointViews::restartProgram() {
    if (!m_arm)
        return;
    m_jog->letGo();
    m_arm->device().restartProgram();
}

} // namespace teleta::console
