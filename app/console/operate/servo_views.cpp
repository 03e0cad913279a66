// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/servo_views.h"

#include "app/console/operate/joint_dials.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/servo/servo_runs_view.h"
#include "widgets/view3d/scene3d_view.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <utility>

namespace teleta::console {

namespace {

constexpr double kLinkRadius_m = 0.05;
constexpr double kWristRadius_m = 0.03;
constexpr double kHand_m = 0.06; ///< around the array

/// A tube from one point to another.
view3d::ArmLink between(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, double radius_m) {
    view3d::ArmLink link;
    const Eigen::Vector3d way_m = to_m - from_m;
    link.X_World_Link.translation() = from_m;
    link.X_World_Link.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), way_m).toRotationMatrix();
    link.length_m = way_m.norm();
    link.radius_m = radius_m;
    return link;
}

} // namespace

ServoViews::ServoViews(view3d::Scene3dView& scene, QWidget* parent)
    : QObject(parent)
    , m_scene(scene)
    , m_panel(new servo::ServoPanel(parent))
    , m_runs(new servo::ServoRunsView(parent)) {
    connect(m_runs, &servo::ServoRunsView::failed, this, &ServoViews::failed);
    connect(m_panel, &servo::ServoPanel::tuningChanged, this, [this](const servo::ServoTuning& tuning) {
        if (m_servo)
            m_servo->tuning.post(tuning);
    });
    connect(m_panel, &servo::ServoPanel::taskRequested, this, [this](std::size_t task) {
        if (m_servo)
            m_servo->task.post(task);
    });
}

void ServoViews::addTo(OperateDocks& docks) {
    docks.addScrolling(OperateDocks::servo, m_panel);
    docks.add(OperateDocks::runs, m_runs);
}

void ServoViews::setServo(std::shared_ptr<servo::ServoLink> servo, const QString& name,
                          base::Provenance provenance) {
    const bool had = m_servo != nullptr;
    if (had)
        m_kept.insert_or_assign(m_servo, std::exchange(m_edge, {}));
    m_servo = std::move(servo);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    m_runs->setSource(name.toStdString(), m_servo.get());
    m_panel->setProvenance(provenance);
    m_panel->setReport(std::nullopt);
    if (!had && !m_servo)
        return;
    if (auto kept = m_kept.extract(m_servo))
        m_edge = std::move(kept.mapped());
    m_edgeChanged = false;
    m_scene.setContour(m_edge.points_m, m_edge.points_m, {}, {});
    m_scene.setArmLinks({});
    m_scene.forgetArm();
    m_scene.setSubject({});
    m_scene.setSensorPose(Eigen::Isometry3d::Identity());
    m_scene.setSurface(view3d::Surface::plate);
    // Nothing new may come: what it said last is said again.
    if (m_servo && m_servo->reports.generation() > 0)
        show(m_servo->reports.front());
}

void ServoViews::tick() {
    if (!m_servo)
        return;
    takeSteps();
    m_runs->refresh();
    const bool news = m_servo->reports.update();
    if (!news)
        return;
    show(m_servo->reports.front());
}

void ServoViews::show(const servo::ServoReport& report) {
    m_panel->setReport(report);
    showArm(report);
}

void ServoViews::takeSteps() {
    servo::ServoStep step;
    while (m_servo->steps.pop(step)) {
        m_runs->append(step);
        if (std::exchange(m_edge.run, step.run) != step.run)
            forgetEdge();
        if (step.p_Base_Contact.allFinite())
            addToEdge(step.p_Base_Contact);
    }
    if (std::exchange(m_edgeChanged, false))
        m_scene.setContour(m_edge.points_m, m_edge.points_m, {}, {});
}

void ServoViews::forgetEdge() {
    m_edgeChanged = m_edgeChanged || !m_edge.points_m.empty();
    m_edge.points_m.clear();
    m_edge.spacing_m = kSpacing_m;
}

void ServoViews::addToEdge(const Eigen::Vector3d& p_Base_Contact) {
    std::vector<Eigen::Vector3d>& points_m = m_edge.points_m;
    if (!points_m.empty() && (p_Base_Contact - points_m.back()).norm() < m_edge.spacing_m)
        return;
    points_m.push_back(p_Base_Contact);
    m_edgeChanged = true;
    if (points_m.size() <= kMostPoints)
        return;
    m_edge.spacing_m *= 2.0;
    const std::size_t left = (points_m.size() + 1) / 2;
    for (std::size_t i = 0; i < left; ++i)
        points_m[i] = points_m[2 * i];
    points_m.resize(left);
}

std::array<view3d::ArmLink, 4> ServoViews::linksOf(const servo::ServoReport& report) {
    const auto& joint = report.p_Base_Joint;
    const Eigen::Vector3d sensor_m = report.X_Base_Sensor.translation();
    return {between(joint[0], joint[1], kLinkRadius_m), between(joint[1], joint[3], kLinkRadius_m),
            between(joint[3], joint[5], kLinkRadius_m), between(joint[5], sensor_m, kWristRadius_m)};
}

/// Around the end of the arm and what it touches: the rest of the arm would make both tiny.
Eigen::AlignedBox3d ServoViews::handAndBody(const servo::ServoReport& report) const {
    const servo::TouchedBody& body = m_servo->body;
    Eigen::AlignedBox3d box_m;
    const auto add = [&box_m](const Eigen::Vector3d& p, double around_m) {
        box_m.extend(p - Eigen::Vector3d::Constant(around_m));
        box_m.extend(p + Eigen::Vector3d::Constant(around_m));
    };
    add(report.X_Base_Sensor.translation(), kHand_m);
    for (const Eigen::Vector3d& p : body.axis_m)
        add(report.X_Base_Object * p, body.radius_m);
    return box_m;
}

void ServoViews::showArm(const servo::ServoReport& report) {
    m_scene.setArmLinks(linksOf(report));
    m_scene.setSensorPose(report.X_Base_Sensor);
    m_scene.setTip(report.X_Base_Sensor.translation(), report.time_s);
    m_scene.setJoints(servoDials(report.angle_rad, kLinkRadius_m));
    m_scene.setSubject(handAndBody(report));
    if (m_servo->body.axis_m.empty())
        return;
    view3d::SceneryItem body;
    body.name = QString::fromStdString(m_servo->body.name);
    body.radius_m = m_servo->body.radius_m;
    for (const Eigen::Vector3d& p : m_servo->body.axis_m)
        body.axis_m.push_back(report.X_Base_Object * p);
    m_scene.setScenery(std::array{body});
}

} // namespace teleta::console
