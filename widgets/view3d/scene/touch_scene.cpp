// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/touch_scene.h"

#include <vtkLight.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::view3d {

namespace {

/// A range is at least this many thresholds wide, so that noise is not magnified.
constexpr double kRangeInThresholds = 5.0;
constexpr double kSmallestRange_N = 1e-30;
constexpr double kEmptySceneHalf_m = 0.05;
constexpr double kArrowOfArm = 0.15; ///< longest, of the arm's size

bool isDrawable(const pipeline::TouchSnapshot& snapshot) {
    const core::ArrayLayout& layout = snapshot.layout.grid();
    const auto side = [](int n) { return n >= 1 && n <= core::ArrayLayout::kMaximumSide; };
    const auto pitch = [](double pitch_m) { return std::isfinite(pitch_m) && pitch_m > 0.0; };
    return (!snapshot.layout.isGrid() || (side(layout.rows) && side(layout.columns))) &&
           pitch(layout.pitchX_m) && pitch(layout.pitchY_m) && snapshot.load_N.size() == layout.taxels() &&
           (snapshot.labels.empty() || snapshot.labels.size() == layout.taxels()) &&
           (snapshot.dead.empty() || snapshot.dead.size() == layout.taxels());
}

} // namespace

TouchScene::TouchScene(const SceneColours& colours)
    : m_colours(colours) {
    m_arm.addTo(m_renderer); // its shadow is below what else is translucent
    m_sensor.addTo(m_renderer);
    m_contacts.addTo(m_renderer);
    m_ground.addTo(m_renderer);
    m_axes.addTo(m_renderer);
    m_contour.addTo(m_renderer);
    m_objects.addTo(m_renderer);
    m_tube.addTo(m_renderer);
    m_gel.addTo(m_renderer);
    m_sensor.setPose(m_poseMatrix);
    m_contacts.setPose(m_poseMatrix);
    m_axes.setPose(m_poseMatrix);
    m_axes.setVisible(false);

    // Light from above shows a load in the same colour from every side; a weak light from the camera keeps
    // faces turned away from it visible.
    m_renderer->AutomaticLightCreationOff();
    const vtkNew<vtkLight> above;
    above->SetLightTypeToSceneLight();
    above->SetPosition(0.25, -0.45, 1.0);
    above->SetFocalPoint(0.0, 0.0, 0.0);
    above->SetIntensity(0.75);
    m_renderer->AddLight(above);
    const vtkNew<vtkLight> camera;
    camera->SetLightTypeToHeadlight();
    camera->SetIntensity(0.4);
    m_renderer->AddLight(camera);

    applyColours(colours);
    coverGround(true);
}

TouchScene::Taken TouchScene::take(const pipeline::TouchSnapshot& snapshot) {
    if (!isDrawable(snapshot))
        return Taken::refused;
    const bool sameLayout = m_hasSensor && snapshot.layout == m_layout;
    if (sameLayout && snapshot.frame == m_snapshot.frame && snapshot.time_ns == m_snapshot.time_ns &&
        snapshot.framesProcessed == m_snapshot.framesProcessed)
        return Taken::same;
    if (!sameLayout) {
        m_layout = snapshot.layout;
        m_raster.reset();
        if (!m_layout.isGrid())
            m_raster.emplace(*m_layout.places());
        m_bodyStale = true;
        m_touches.clear();
    }
    if (!sameLayout || snapshot.threshold_N != m_rangeThreshold_N) {
        m_rangeThreshold_N = snapshot.threshold_N;
        const double least_N = std::max(kRangeInThresholds * snapshot.threshold_N, kSmallestRange_N);
        m_loadRange = base::CalmRange(least_N);
        m_forceRange = base::CalmRange(least_N);
    }
    m_hasSensor = true;
    m_frameStale = true;
    m_snapshot = m_raster ? m_raster->drawn(snapshot) : snapshot;
    // Where there is no taxel, none is dead.
    for (std::size_t taxel = 0; taxel < m_snapshot.dead.size(); ++taxel)
        if (m_snapshot.layout.isAbsent(taxel)) {
            m_snapshot.dead[taxel] = 0;
            m_snapshot.load_N[taxel] = 0.0F;
        }
    m_touches.update(snapshot.contacts, snapshot.sourceTime_s);

    double peak_N = 0.0;
    for (std::size_t taxel = 0; taxel < snapshot.load_N.size(); ++taxel) {
        const auto load_N = static_cast<double>(snapshot.load_N[taxel]);
        if (std::isfinite(load_N) && (snapshot.dead.empty() || snapshot.dead[taxel] == 0))
            peak_N = std::max(peak_N, load_N);
    }
    m_loadRange.update(0.0, peak_N, snapshot.sourceTime_s);
    double force_N = m_otherForce_N;
    for (const contact::Contact& contact : snapshot.contacts)
        if (std::isfinite(contact.force_N))
            force_N = std::max(force_N, contact.force_N);
    m_forceRange.update(0.0, force_N, snapshot.sourceTime_s);
    return Taken::fresh;
}

void TouchScene::clear() {
    m_hasSensor = false;
    m_snapshot = {};
    m_touches.clear();
    m_sensor.setVisible(false);
    m_contacts.clear();
    m_axes.setVisible(false);
    m_bodyStale = false;
    m_frameStale = false;
    coverGround(true);
}

bool TouchScene::draw() {
    const bool newBody = m_bodyStale;
    if (m_bodyStale) {
        m_bodyStale = false;
        m_frameStale = m_hasSensor;
        rebuildSensor();
    }
    if (!m_frameStale)
        return newBody;
    m_frameStale = false;
    m_sensor.grid().pool(m_snapshot.load_N, m_snapshot.dead, m_cell_N);
    const double range_N = loadRange_N();
    for (float& cell : m_cell_N) {
        // The quotient of two loads is in range whatever their unit.
        cell =
            std::isnan(cell) ? cell : static_cast<float>(std::min(1.0, static_cast<double>(cell) / range_N));
    }
    m_sensor.update(m_cell_N);
    m_contacts.update(m_snapshot.contacts, m_snapshot.labels, m_snapshot.layout.grid(), m_sensor, m_touches,
                      range_N, m_forceRange.high(), m_colours.dark);
    return newBody;
}

void TouchScene::rebuildSensor() {
    if (!m_hasSensor)
        return;
    const SurfaceMap map(m_surface, cylinder().radius_m);
    m_sensor.rebuild(m_snapshot.layout, map, cylinder(), /*bordered=*/!m_raster);
    m_sensor.setVisible(true);
    m_cell_N.assign(m_sensor.grid().cells(), 0.0F);
    const Eigen::Vector3d body = sensorBox_m().max();
    const SensorSize& size = m_sensor.size();
    const bool flat = m_surface == Surface::plate;
    m_axes.rebuild({body.x(), flat ? size.halfY_m : body.y() - size.rise_m, flat ? 0.0 : map.radius_m()},
                   std::max(0.55 * size.arrow_m, 0.12 * body.maxCoeff()), m_colours);
    m_axes.setVisible(m_axesShown);
    coverGround(true);
}

CylinderSize TouchScene::cylinder() const {
    return m_hasSensor ? cylinderThatFits(m_wantedCylinder, m_snapshot.layout.grid()) : m_wantedCylinder;
}

void TouchScene::setSurface(Surface surface) {
    m_bodyStale = m_bodyStale || surface != m_surface;
    m_surface = surface;
}

void TouchScene::setCylinder(const CylinderSize& cylinder) {
    m_bodyStale = m_bodyStale || !(cylinder == m_wantedCylinder);
    m_wantedCylinder = cylinder;
}

void TouchScene::setSensorPose(const Eigen::Isometry3d& X_World_Sensor) {
    if (!X_World_Sensor.matrix().allFinite())
        return;
    m_X_World_Sensor = X_World_Sensor;
    setMatrix(*m_poseMatrix, X_World_Sensor);
    coverGround(false);
}

void TouchScene::setContour(std::span<const Eigen::Vector3d> points_m,
                            std::span<const Eigen::Vector3d> curve_m,
                            std::span<const Eigen::Vector3d> vertices_m) {
    m_contour.set(points_m, curve_m, vertices_m);
    coverGround(false);
}

void TouchScene::setObjects(std::span<const DrawnObject> objects) {
    m_objects.set(objects);
    coverGround(false);
}

void TouchScene::setArmLinks(std::span<const ArmLink> links) {
    m_arm.set(links);
    coverGround(false);
}

void TouchScene::setRobot(std::shared_ptr<const RobotShape> shape) {
    m_robot.setShape(std::move(shape));
    m_arm.setShellsShown(!m_robot.isShown());
    coverGround(false);
}

void TouchScene::setRobotPoses(std::span<const Eigen::Isometry3d> X_World_Link,
                               std::span<const Eigen::Isometry3d> commanded) {
    m_robot.setPoses(X_World_Link);
    m_robot.setGhost(commanded);
    m_arm.setShellsShown(!m_robot.isShown());
    coverGround(false);
}

bool TouchScene::setTube(const pipeline::CameraSnapshot* snapshot) {
    const bool was = m_tube.isShown();
    bool other = was;
    if (snapshot == nullptr)
        m_tube.clear();
    else
        other = m_tube.set(*snapshot);
    coverGround(other);
    return other || was != m_tube.isShown();
}

bool TouchScene::setGel(const pipeline::GelSnapshot* snapshot, double enlargement,
                        std::span<const GelWords> words) {
    const bool was = m_gel.isShown();
    bool other = was;
    if (snapshot == nullptr)
        m_gel.clear();
    else
        other = m_gel.set(*snapshot, enlargement, words);
    coverGround(other);
    return other || was != m_gel.isShown();
}

void TouchScene::setAxesShown(bool shown) {
    m_axesShown = shown;
    m_axes.setVisible(axesShown());
}

void TouchScene::applyColours(const SceneColours& colours) {
    m_colours = colours;
    m_renderer->GradientBackgroundOn();
    m_renderer->SetBackground(colours.backgroundBottom.redF(), colours.backgroundBottom.greenF(),
                              colours.backgroundBottom.blueF());
    m_renderer->SetBackground2(colours.backgroundTop.redF(), colours.backgroundTop.greenF(),
                               colours.backgroundTop.blueF());
    m_sensor.applyColours(colours);
    m_ground.applyColours(colours);
    m_contour.applyColours(colours);
    m_objects.applyColours(colours);
    m_arm.applyColours(colours);
    m_robot.applyColours(colours);
    m_tube.applyColours(colours);
    m_gel.applyColours(colours);
    m_bodyStale = m_bodyStale || m_hasSensor;
}

void TouchScene::applyPixelScale(double scale) {
    m_sensor.applyPixelScale(scale);
    m_contacts.applyPixelScale(scale);
    m_ground.applyPixelScale(scale);
    m_contour.applyPixelScale(scale);
    m_objects.applyPixelScale(scale);
    m_tube.applyPixelScale(scale);
    m_gel.applyPixelScale(scale);
}

Eigen::AlignedBox3d TouchScene::sensorBox_m() const {
    const SensorSize& size = m_sensor.size();
    if (m_surface == Surface::plate) {
        return {Eigen::Vector3d(-size.halfX_m, -size.halfY_m, -size.thickness_m),
                Eigen::Vector3d(size.halfX_m, size.halfY_m, size.tile_m + size.rise_m)};
    }
    const CylinderSize body = cylinder();
    const double radius_m = body.radius_m + size.rise_m;
    return {Eigen::Vector3d(-0.5 * body.length_m, -radius_m, -body.radius_m),
            Eigen::Vector3d(0.5 * body.length_m, radius_m, radius_m)};
}

void TouchScene::setForce(const std::optional<DrawnForce>& force) {
    m_otherForce_N = force && force->force_N.allFinite() ? force->force_N.norm() : 0.0;
    m_armForceAt_m.reset();
    if (force && force->measured && !m_hasSensor)
        m_armForceAt_m = force->p_World_m;
}

double TouchScene::armArrow_m() const {
    return armBox_m().isEmpty() ? 0.0 : kArrowOfArm * armBox_m().diagonal().norm();
}

std::vector<Eigen::Vector3d> TouchScene::corners() const {
    std::vector<Eigen::Vector3d> corners;
    const auto add = [&](const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& X_World_Box) {
        for (int i = 0; i < 8 && !box.isEmpty(); ++i)
            corners.emplace_back(X_World_Box * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    };
    if (m_hasSensor) {
        Eigen::AlignedBox3d box = sensorBox_m();
        box.extend(box.max() + Eigen::Vector3d(0.0, 0.0, 0.4 * m_sensor.size().arrow_m));
        add(box, m_X_World_Sensor);
    }
    add(m_contour.box_m(), Eigen::Isometry3d::Identity());
    add(m_objects.box_m(), Eigen::Isometry3d::Identity());
    add(armBox_m(), Eigen::Isometry3d::Identity());
    if (m_armForceAt_m && !armBox_m().isEmpty()) {
        const Eigen::Vector3d arrow = Eigen::Vector3d::Constant(armArrow_m());
        add({*m_armForceAt_m - arrow, *m_armForceAt_m + arrow}, Eigen::Isometry3d::Identity());
    }
    add(m_tube.box_m(), Eigen::Isometry3d::Identity());
    add(m_gel.box_m(), Eigen::Isometry3d::Identity());
    if (corners.empty()) {
        const Eigen::Vector3d half = Eigen::Vector3d::Constant(kEmptySceneHalf_m);
        add({-half, half}, Eigen::Isometry3d::Identity());
    }
    return corners;
}

void TouchScene::coverGround(bool always) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners())
        box.extend(corner);
    m_ground.cover(box, always);
    m_arm.setGround(m_ground.height_m());
}

std::vector<vtkSmartPointer<vtkPolyData>> TouchScene::worldMeshes() const {
    std::vector<vtkSmartPointer<vtkPolyData>> copies;
    const auto add = [&](const std::vector<vtkPolyData*>& meshes, vtkMatrix4x4* X_World_Mesh) {
        const vtkNew<vtkTransform> transform;
        transform->SetMatrix(X_World_Mesh);
        for (vtkPolyData* mesh : meshes) {
            if (mesh->GetNumberOfCells() == 0)
                continue;
            const vtkNew<vtkTransformPolyDataFilter> moved;
            moved->SetInputData(mesh);
            moved->SetTransform(transform);
            moved->Update();
            copies.emplace_back(moved->GetOutput());
        }
    };
    std::vector<vtkPolyData*> meshes;
    if (m_hasSensor) {
        m_sensor.appendMeshes(meshes);
        m_contacts.appendMeshes(meshes);
    }
    add(meshes, m_poseMatrix);
    meshes.clear();
    m_tube.appendMeshes(meshes);
    add(meshes, m_tube.pose());
    meshes.clear();
    m_gel.appendMeshes(meshes);
    add(meshes, m_gel.pose());
    meshes.clear();
    m_contour.appendMeshes(meshes);
    m_objects.appendMeshes(meshes);
    m_arm.appendMeshes(meshes);
    const vtkNew<vtkMatrix4x4> identity;
    add(meshes, identity);
    m_robot.forEachMesh([&](vtkPolyData* mesh, vtkMatrix4x4* pose) { add({mesh}, pose); });
    return copies;
}

} // namespace teleta::view3d
