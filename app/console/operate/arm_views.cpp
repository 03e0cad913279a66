// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/arm_views.h"

#include "app/console/operate/arm_servo_views.h"
#include "app/console/operate/joint_dials.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "widgets/bracelet/bracelet_view.h"
#include "widgets/touch/contour_view.h"
#include "widgets/touch/run_sheet.h"
#include "widgets/touch/stiffness_gauge.h"
#include "widgets/touch/touch_table.h"
#include "widgets/touch/touch_texts.h"
#include "widgets/view3d/scene3d_view.h"

#include <QItemSelectionModel>
#include <QTableView>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

std::vector<Eigen::Vector3d> atHeight(const std::vector<contour::Point>& points_m, double height_m) {
    std::vector<Eigen::Vector3d> lifted;
    lifted.reserve(points_m.size());
    for (const contour::Point& p : points_m)
        lifted.emplace_back(p.x(), p.y(), height_m);
    return lifted;
}

void keepTouch(std::vector<pipeline::TouchRecord>& touches, const pipeline::TouchRecord& record) {
    // A recording that is played again tells its touches again.
    std::erase_if(touches, [&](const auto& kept) { return kept.number == record.number; });
    if (touches.size() >= touch::TouchTable::kCapacity)
        touches.erase(touches.begin());
    touches.push_back(record);
}

} // namespace

ArmViews::ArmViews(core::StopSwitch& stop, BraceletService& bracelet, view3d::Scene3dView& scene,
                   QWidget* parent)
    : QObject(parent)
    , m_bracelet(bracelet)
    , m_scene(scene)
    , m_joints(new JointViews(stop, scene, parent))
    , m_gauge(new touch::StiffnessGauge(parent))
    , m_touches(new touch::TouchTable(parent))
    , m_sheet(new touch::RunSheet(parent))
    , m_contour(new touch::ContourView(parent))
    , m_picture(new bracelet::BraceletView(parent))
    , m_feedback(new FeedbackPanel(bracelet, parent))
    , m_servo(new ArmServoViews(stop, *m_joints, parent)) {
    connect(m_picture, &bracelet::BraceletView::held, &m_bracelet, &BraceletService::hold);
    connect(m_touches, &touch::TouchTable::touchActivated, this,
            [this](std::uint64_t touch) { m_joints->chart().showTouch(touch); });
    connect(m_gauge, &touch::StiffnessGauge::exportFailed, this, &ArmViews::exportFailed);
    connect(m_touches, &touch::TouchTable::exportFailed, this, &ArmViews::exportFailed);
    connect(m_sheet, &touch::RunSheet::exportFailed, this, &ArmViews::exportFailed);
    const touch::RunSheetModel& objects = m_sheet->model();
    connect(&objects, &QAbstractItemModel::dataChanged, this, &ArmViews::showObjects);
    connect(&objects, &QAbstractItemModel::modelReset, this, &ArmViews::showObjects);
    connect(&objects, &QAbstractItemModel::rowsInserted, this, &ArmViews::showObjects);
    connect(&objects, &QAbstractItemModel::rowsRemoved, this, &ArmViews::showObjects);
    connect(m_sheet->view()->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ArmViews::showObjects);
    connect(&m_scene, &view3d::Scene3dView::objectPicked, m_sheet, &touch::RunSheet::select);
    connect(m_contour, &touch::ContourView::exportFailed, this, &ArmViews::exportFailed);
    connect(m_contour, &touch::ContourView::forgetRequested, this, &ArmViews::forgetContour);
    connect(m_joints, &JointViews::exportFailed, this, &ArmViews::exportFailed);
    connect(m_joints, &JointViews::meshesFailed, this, &ArmViews::meshesFailed);
    connect(m_joints, &JointViews::jointsUnknown, this, &ArmViews::jointsUnknown);
}

void ArmViews::addTo(OperateDocks& docks) {
    docks.add(OperateDocks::stiffness, m_gauge);
    docks.add(OperateDocks::bracelet, m_picture);
    m_joints->addTo(docks);
    docks.add(OperateDocks::touches, m_touches);
    docks.add(OperateDocks::objects, m_sheet);
    docks.add(OperateDocks::contour, m_contour);
    docks.addScrolling(OperateDocks::feedback, m_feedback);
}

void ArmViews::setArm(const std::shared_ptr<pipeline::JointChannel>& arm, base::Provenance provenance) {
    if (m_arm) {
        m_arm->setFeedback(nullptr);
        m_kept.insert_or_assign(
            m_arm, Kept{m_sheet->model().takeNotes(), std::exchange(m_shownTouches, {}), m_begun_ns});
    }
    clear();
    m_servo->setArm(nullptr);
    m_joints->setArm(arm, provenance);
    m_arm = std::dynamic_pointer_cast<pipeline::ArmChannel>(arm);
    m_servo->setArm(m_arm);
    m_joints->setTouching(m_arm ? std::optional(m_arm->settings().touch.window) : std::nullopt);
    std::erase_if(m_kept, [](const auto& entry) { return entry.first.expired(); });
    if (!m_arm)
        return;
    if (m_feltOf.lock() != m_arm) { // what was felt belongs to the other arm
        m_bracelet.forgetFeedback();
        m_feedback->forgetLast();
    }
    m_feltOf = m_arm;
    if (!m_arm->pad())
        wearBentSkin();
    m_gauge->setProvenance(provenance);
    m_touches->setProvenance(provenance);
    m_sheet->setProvenance(provenance);
    m_contour->setProvenance(provenance);
    // Nothing new may come: a recording that is paused stands as it was left.
    if (auto kept = m_kept.extract(m_arm)) {
        m_sheet->model().setNotes(std::move(kept.mapped().notes));
        m_begun_ns = kept.mapped().begun_ns;
        for (const pipeline::TouchRecord& record : kept.mapped().touches)
            showTouch(record);
    }
    if (m_arm->generation() > 0) {
        m_joints->show(m_arm->snapshot().newest);
        show(m_arm->snapshot());
    }
    m_arm->setFeedback(m_bracelet.feedback());
}

void ArmViews::wearBentSkin() {
    const core::ArmDescription& description = m_arm->description();
    m_kinematics = arm::Arm4Kinematics({.upperArmLength_m = description.upperArmLength_m,
                                        .forearmLength_m = description.forearmLength_m,
                                        .halfThickness_m = description.halfThickness_m});
    m_joints->setTip([this, tip = Eigen::Vector3d(description.forearmLength_m, 0.0, 0.0)](
                         const core::JointSample& sample) -> Eigen::Vector3d {
        return m_kinematics.p_Base_Point(arm::Link::forearm, arm::JointVector(sample.angle_rad.data()), tip);
    });
    const core::ArrayLayout& skin = m_arm->skin()->description().layout.grid();
    m_scene.setSurface(view3d::Surface::cylinder);
    m_scene.setArrayBent(true);
    m_scene.setCylinder({.radius_m = description.skin.radius_m, .length_m = skin.columns * skin.pitchX_m});
}

void ArmViews::clear() {
    m_gauge->setTouch(std::nullopt);
    m_judged.reset();
    m_touches->clear();
    m_shownTouches.clear();
    m_sheet->clear();
    m_contour->clear();
    m_scene.setArrayBent(false);
    m_scene.setContour({}, {}, {}, {});
    m_scene.setObjects({});
    m_scene.setSensorPose(Eigen::Isometry3d::Identity());
    if (m_arm)
        m_scene.setSurface(view3d::Surface::plate);
    m_contourRevision = 0;
    m_objectsRevision = 0;
    m_begun_ns = 0;
    m_wasSilent = false;
    m_drawsForce = false;
}

void ArmViews::tick() {
    m_joints->tick();
    // What is felt of an arm that tells nothing any more is no news of it.
    const bool silent = m_arm && m_joints->isSilent();
    if (silent && !m_wasSilent)
        m_bracelet.endFeedback();
    m_wasSilent = silent;
    m_picture->setIntensities(m_bracelet.given());
    m_picture->setNote(m_bracelet.note());
    m_picture->setHoldable(m_bracelet.isFree());
    m_picture->setProvenance(m_bracelet.isSimulated() ? base::Provenance::simulated : base::Provenance::live);
    m_picture->setTitle(m_feedback->lastText());
    if (m_arm) {
        takeTouches();
        if (m_arm->update())
            show(m_arm->snapshot());
        showAge();
    }
    m_servo->tick();
    m_joints->refresh();
}

void ArmViews::show(const pipeline::ArmSnapshot& snapshot) {
    if (std::exchange(m_begun_ns, snapshot.begun_ns) != snapshot.begun_ns)
        beginAnew(snapshot.begun_ns);
    showArm(snapshot);
    if (snapshot.contour.revision != m_contourRevision)
        showContour(snapshot.contour);
    if (snapshot.objectsRevision != m_objectsRevision) {
        m_objectsRevision = snapshot.objectsRevision;
        m_sheet->setObjects(snapshot.objects);
    }
}

void ArmViews::takeTouches() {
    pipeline::TouchRecord record;
    while (m_arm->popTouch(record)) {
        m_joints->chart().addTouch(record);
        showTouch(record);
    }
}

void ArmViews::keep(const std::shared_ptr<pipeline::ArmChannel>& arm) {
    pipeline::TouchRecord record;
    while (arm && arm->popTouch(record))
        keepTouch(m_kept[arm].touches, record);
}

void ArmViews::showTouch(const pipeline::TouchRecord& record) {
    m_touches->append(record);
    keepTouch(m_shownTouches, record);
    judge(record);
}

void ArmViews::judge(const pipeline::TouchRecord& record) {
    if (record.stiffness)
        m_gauge->setTouch(record.stiffness);
    else if (record.refusal)
        m_gauge->setRefusal(*record.refusal);
    if (record.stiffness || record.refusal)
        m_judged = Judged{record.arrived_ns != 0 ? record.arrived_ns : record.ready_ns, record.ready_s};
}

/// A recording has a time of its own, which may be paused; an arm that has fallen silent grows old, too.
void ArmViews::showAge() {
    if (m_arm->description().recorded)
        judgeAt(m_arm->snapshot().newest.sourceTime_s);
    if (!m_judged)
        return;
    const double age_s = m_arm->description().recorded
                             ? m_arm->snapshot().newest.sourceTime_s - m_judged->time_s
                             : core::elapsed_s(m_judged->time_ns, core::steadyNow_ns());
    m_gauge->setAge(std::max(0.0, age_s));
}

void ArmViews::judgeAt(double time_s) {
    if (!m_judged || m_judged->time_s <= time_s)
        return;
    m_judged.reset();
    m_gauge->setTouch(std::nullopt);
    const pipeline::TouchRecord* newest = nullptr;
    for (const pipeline::TouchRecord& record : m_shownTouches)
        if ((record.stiffness || record.refusal) && record.ready_s <= time_s &&
            (newest == nullptr || record.ready_s > newest->ready_s))
            newest = &record;
    if (newest != nullptr)
        judge(*newest);
}

void ArmViews::beginAnew(std::int64_t begun_ns) {
    m_gauge->setTouch(std::nullopt);
    m_judged.reset();
    m_touches->clear();
    m_sheet->clear();
    m_bracelet.forgetFeedback();
    m_feedback->forgetLast();
    for (const pipeline::TouchRecord& record : std::exchange(m_shownTouches, {})) {
        // Those that came in the same tick are of the new run.
        if (record.ready_ns > begun_ns)
            showTouch(record);
    }
}

void ArmViews::showArm(const pipeline::ArmSnapshot& snapshot) {
    if (m_arm->pad())
        showPad(snapshot.newest.angle_rad);
    else
        showBentSkin(snapshot.newest.angle_rad);
    // What a direction without a lever hides is not known: no arrow rather than a wrong one.
    const auto& contact = snapshot.contact;
    const bool known = contact && contact->force && contact->force->observedDirections == 3;
    if (known)
        m_scene.setForce(view3d::DrawnForce{contact->p_Base_Contact_m, -contact->force->force_N});
    else if (m_drawsForce)
        m_scene.setForce(std::nullopt);
    m_drawsForce = known;
}

void ArmViews::showBentSkin(const core::JointVector& angles_rad) {
    const core::ArmDescription& description = m_arm->description();
    const arm::JointVector angle_rad(angles_rad.data());
    const Eigen::Isometry3d X_Base_Forearm = m_kinematics.X_Base_Link(arm::Link::forearm, angle_rad);
    const std::array<view3d::ArmLink, 2> links{
        view3d::ArmLink{m_kinematics.X_Base_Link(arm::Link::upperArm, angle_rad),
                        description.upperArmLength_m, description.halfThickness_m},
        view3d::ArmLink{X_Base_Forearm, description.forearmLength_m, description.halfThickness_m}};
    m_scene.setArmLinks(links);
    // The sheet's z points out of the skin: at its centre that is +z of the forearm, turned by the side.
    m_scene.setSensorPose(X_Base_Forearm * Eigen::Translation3d(description.skin.centreDistance_m, 0.0, 0.0) *
                          Eigen::AngleAxisd(description.skin.centreSide_rad, Eigen::Vector3d::UnitX()));
    m_scene.setJoints(armDials(m_kinematics, description, angle_rad));
}

/// The arm itself is drawn by JointViews.
void ArmViews::showPad(const core::JointVector& angle_rad) {
    const arm_model::SerialChain& chain = *m_arm->chain();
    const core::PadPlacement& pad = *m_arm->pad();
    const auto link = chain.model().findLink(pad.link);
    if (link && angle_rad.size() == chain.joints())
        m_scene.setSensorPose(chain.linkPoses(angle_rad)[*link] * pipeline::X_Link_Sensor(pad));
}

void ArmViews::showContour(const pipeline::ExploredContour& contour) {
    m_contourRevision = contour.revision;
    m_contour->setContour(contour);
    std::vector<contour::Point> vertices_m;
    QString label;
    if (contour.recognition) {
        vertices_m = contour.recognition->vertices_m;
        // The other candidates would hide the scene; the contour's dock has them.
        label = touch::TouchTexts::shape(contour.recognition->shape, contour.recognition->confidence);
    }
    m_scene.setContour(atHeight(contour.points_m, contour.height_m),
                       atHeight(contour.curve_m, contour.height_m), atHeight(vertices_m, contour.height_m),
                       label);
    showObjects();
}

void ArmViews::showObjects() {
    std::vector<view3d::DrawnObject> drawn;
    const touch::RunSheetModel& sheet = m_sheet->model();
    const bool hasContour = m_arm && m_arm->generation() > 0;
    const QItemSelectionModel& selection = *m_sheet->view()->selectionModel();
    for (int row = 0; row < sheet.rowCount(); ++row) {
        const pipeline::FoundObject& object = sheet.object(row);
        const pipeline::ExploredContour& contour = object.contour;
        const QString name = sheet.nameOf(object.number);
        drawn.push_back({object.number,
                         name.isEmpty() ? QString::number(object.number)
                                        : QStringLiteral("%1 %2").arg(object.number).arg(name),
                         atHeight(contour.points_m, contour.height_m),
                         atHeight(contour.curve_m, contour.height_m), selection.isRowSelected(row),
                         hasContour && contour.points_m == m_arm->snapshot().contour.points_m});
    }
    m_scene.setObjects(drawn);
}

void ArmViews::retranslate() {
    if (m_arm && m_arm->generation() > 0)
        showContour(m_arm->snapshot().contour);
}

void ArmViews::forgetContour() {
    if (m_arm)
        m_arm->resetContour();
}

} // namespace teleta::console
