// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene3d_view.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/mesh/geometry_export.h"
#include "widgets/view3d/scene3d_parts.h"

#include <QEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QToolBar>
#include <QToolTip>
#include <QVBoxLayout>

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>

namespace teleta::view3d {

namespace {

constexpr double kPictureScale = 2.0;

} // namespace

base::Figure Scene3dView::Parts::figure() {
    // For paper, the scene is drawn once in light colours.
    const SceneColours shown = scene.colours();
    applyColours(SceneColours(base::designedPalette(false)));
    scene.draw();
    const QImage picture = vtk->picture(kPictureScale, VtkWidget::PictureOverlay::without);
    const OverlayContent content = overlay();
    applyColours(shown);
    scene.draw();
    return {.name = Scene3dView::tr("touch 3-D"),
            .size_px = vtk->size(),
            .paint =
                [picture, content, size = QSizeF(vtk->size())](QPainter& painter) {
                    painter.drawImage(QRectF(QPointF(), size), picture);
                    paintOverlay(painter, size, content);
                },
            .csv = [text = contactRows(scene)] { return text; }};
}

Scene3dView::Scene3dView(QWidget* parent)
    : QWidget(parent)
    , m_parts(std::make_unique<Parts>(this)) {
    Parts& parts = *m_parts;
    makeActions();
    makeToolBar();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(parts.toolBar);
    layout->addWidget(parts.vtk, 1);
    setFocusProxy(parts.vtk);

    parts.vtk->renderWindow()->AddRenderer(parts.scene.renderer());
    parts.vtk->interactor()->SetInteractorStyle(parts.style);
    parts.style->setCamera(&parts.camera);
    parts.camera.onChange([this] { m_parts->vtk->requestRender(); });
    parts.vtk->setOverlay(
        [this](QPainter& painter, const QSizeF& size) { paintOverlay(painter, size, m_parts->overlay()); });
    connect(parts.vtk, &VtkWidget::pixelScaleChanged, this, [this](double scale) {
        m_parts->scene.applyPixelScale(scale);
        m_parts->marks.applyPixelScale(scale);
    });
    connect(parts.vtk, &VtkWidget::menuRequested, this, [this](const QPoint& position) {
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fillMenu(*menu);
        menu->popup(position);
    });
    connect(parts.vtk, &VtkWidget::clicked, this, [this](const QPoint& position) {
        if (const auto object = objectAt(m_parts->scene, m_parts->pointAt(position)))
            emit objectPicked(*object);
    });
    connect(&parts.figures, &base::FigureExport::saved, this, &Scene3dView::saved);
    connect(&parts.figures, &base::FigureExport::failed, this, &Scene3dView::failed);
    base::keepTranslated(this, &Scene3dView::retranslate);
    base::onChange(this, &Scene3dView::applyPalette, {QEvent::PaletteChange});
    base::onChange(this,
                   [this] {
                       m_parts->toolBar->setIconSize(QSize(1, 1) * base::em(this, Parts::kTool_em));
                       m_parts->vtk->requestRender();
                   },
                   {QEvent::FontChange});
    sceneMoved(true);
}

Scene3dView::~Scene3dView() {
    // The widget draws the scene and must be destroyed first.
    m_parts->camera.onChange({});
    m_parts->vtk->setOverlay({});
    m_parts->vtk->renderWindow()->RemoveRenderer(m_parts->scene.renderer());
    delete m_parts->vtk;
}

void Scene3dView::setSnapshot(const pipeline::TouchSnapshot& snapshot) {
    Parts& parts = *m_parts;
    if (!parts.vtk->canRender())
        return;
    const TouchScene::Taken taken = parts.scene.take(snapshot);
    if (taken == TouchScene::Taken::same)
        return;
    if (taken == TouchScene::Taken::refused)
        return clear();
    parts.marks.wrench.take(snapshot);
    if (isVisible())
        refresh();
}

void Scene3dView::refresh() {
    Parts& parts = *m_parts;
    if (parts.scene.draw()) {
        sceneMoved(true);
        parts.vtk->requestRender();
    }
    const auto& contacts = parts.scene.marks();
    const double time_s = parts.scene.snapshot().sourceTime_s;
    if (parts.follow->isChecked() && (!contacts.empty() || !armBox_m().isEmpty())) { // else the hand
        const Eigen::Vector3d p = contacts.empty() ? Eigen::Vector3d::Zero() : contacts.front().p_Sensor_Foot;
        parts.camera.follow(parts.scene.toWorld(p), time_s - parts.lastTime_s);
    }
    parts.lastTime_s = time_s;
    parts.dataChanged();
}

void Scene3dView::sceneMoved(bool refit) {
    std::vector<Eigen::Vector3d> corners = m_parts->scene.corners();
    const std::vector<Eigen::Vector3d> scenery = cornersOf(m_parts->marks.scenery.box_m());
    corners.insert(corners.end(), scenery.begin(), scenery.end());
    m_parts->camera.setScene(std::move(corners), refit);
    if (m_parts->onHand->isChecked())
        m_parts->camera.standOnHand(sensorPose(), m_parts->scene.sensorSize().radius_m());
    m_parts->dataChanged();
}

void Scene3dView::clear() {
    if (m_parts->scene.hasSensor()) {
        m_parts->scene.clear();
        sceneMoved(true);
        m_parts->vtk->requestRender();
    }
}

void Scene3dView::setProvenance(base::Provenance provenance) {
    if (provenance != m_parts->provenance) {
        base::showProvenance(this, provenance);
        m_parts->provenance = provenance;
        m_parts->vtk->requestRender();
    }
}

void Scene3dView::setSurface(Surface surface) {
    (surface == Surface::plate ? m_parts->plate : m_parts->cylinder)->setChecked(true);
    if (surface != m_parts->scene.surface()) {
        m_parts->scene.setSurface(surface);
        refresh();
    }
}

Surface Scene3dView::surface() const {
    return m_parts->scene.surface();
}

void Scene3dView::setCylinder(const CylinderSize& cylinder) {
    const auto usable = [](double length_m) { return std::isfinite(length_m) && length_m > 0.0; };
    if (usable(cylinder.radius_m) && usable(cylinder.length_m)) {
        m_parts->scene.setCylinder(cylinder);
        refresh();
    }
}

void Scene3dView::setSensorPose(const Eigen::Isometry3d& X_World_Sensor) {
    m_parts->scene.setSensorPose(X_World_Sensor);
    sceneMoved(false);
}

const Eigen::Isometry3d& Scene3dView::sensorPose() const {
    return m_parts->scene.X_World_Sensor();
}

const Eigen::AlignedBox3d& Scene3dView::armBox_m() const {
    return m_parts->scene.armBox_m();
}

void Scene3dView::setContour(std::span<const Eigen::Vector3d> points_m,
                             std::span<const Eigen::Vector3d> curve_m,
                             std::span<const Eigen::Vector3d> vertices_m, const QString& label) {
    const bool wasEmpty = m_parts->scene.contourBox_m().isEmpty();
    m_parts->shapeLabel = label;
    m_parts->scene.setContour(points_m, curve_m, vertices_m);
    sceneMoved(wasEmpty != m_parts->scene.contourBox_m().isEmpty());
    m_parts->vtk->requestRender();
}

void Scene3dView::setObjects(std::span<const DrawnObject> objects) {
    const bool wasEmpty = m_parts->scene.objects().objects().empty();
    m_parts->scene.setObjects(objects);
    sceneMoved(wasEmpty != m_parts->scene.objects().objects().empty());
    m_parts->vtk->requestRender();
}

void Scene3dView::setArmLinks(std::span<const ArmLink> links) {
    const bool wasEmpty = m_parts->scene.armBox_m().isEmpty();
    m_parts->scene.setArmLinks(links);
    sceneMoved(wasEmpty != m_parts->scene.armBox_m().isEmpty());
}

void Scene3dView::setRobot(std::shared_ptr<const RobotShape> shape) {
    m_parts->scene.setRobot(std::move(shape));
    sceneMoved(false);
    m_parts->vtk->requestRender();
}

void Scene3dView::setRobotPoses(std::span<const Eigen::Isometry3d> X_World_Link,
                                std::span<const Eigen::Isometry3d> commanded) {
    m_parts->scene.setRobotPoses(X_World_Link, commanded);
    sceneMoved(false);
}

void Scene3dView::setTip(const Eigen::Vector3d& p_World_m, double time_s) {
    if (m_parts->marks.trail.add(p_World_m, time_s))
        m_parts->dataChanged();
}

void Scene3dView::setJoints(std::span<const JointDial> dials) {
    if (m_parts->marks.limits.set(dials))
        m_parts->dataChanged();
}

void Scene3dView::setForce(const std::optional<DrawnForce>& force) {
    m_parts->marks.wrench.setForce(force);
    m_parts->scene.setForce(force);
    m_parts->dataChanged();
}

const std::optional<DrawnForce>& Scene3dView::force() const {
    return m_parts->marks.wrench.force();
}

void Scene3dView::setScenery(std::span<const SceneryItem> items) {
    if (!m_parts->marks.scenery.set(items))
        return;
    sceneMoved(false);
    m_parts->vtk->requestRender();
}

const std::vector<SceneryItem>& Scene3dView::scenery() const {
    return m_parts->marks.scenery.items();
}

void Scene3dView::forgetArm() {
    m_parts->scene.setRobot(nullptr);
    setScenery({});
    m_parts->marks.trail.clear();
    m_parts->marks.limits.set({});
    setForce(std::nullopt);
    m_parts->vtk->requestRender();
}

void Scene3dView::setArrayBent(bool bent) {
    m_parts->marks.wrench.setArrayBent(bent);
    m_parts->vtk->requestRender();
}

void Scene3dView::showLayers() {
    Parts& parts = *m_parts;
    const SceneLayers& layers = *parts.layers;
    parts.scene.setGridShown(layers.shows(SceneLayers::grid));
    parts.scene.setAxesShown(layers.shows(SceneLayers::axes));
    parts.scene.setDisplacementShown(layers.shows(SceneLayers::displacement));
    parts.scene.setForcesShown(layers.shows(SceneLayers::forces));
    parts.marks.trail.setVisible(layers.shows(SceneLayers::trail));
    parts.marks.limits.setVisible(layers.shows(SceneLayers::jointLimits));
    parts.marks.wrench.setForcesShown(layers.shows(SceneLayers::forces));
    parts.scene.setTurnsShown(layers.shows(SceneLayers::moments));
    parts.marks.wrench.setMomentsShown(layers.shows(SceneLayers::moments));
    parts.marks.scenery.setVisible(layers.shows(SceneLayers::scenery));
    parts.vtk->requestRender();
}

QStringList Scene3dView::hiddenLayers() const {
    return m_parts->layers->hidden();
}

void Scene3dView::setHiddenLayers(const QStringList& names) {
    m_parts->layers->setHidden(names);
}

void Scene3dView::setTube(const pipeline::CameraSnapshot* snapshot) {
    sceneMoved(m_parts->scene.setTube(snapshot));
    m_parts->vtk->requestRender();
}

void Scene3dView::setGel(const pipeline::GelSnapshot* snapshot, double enlargement,
                         std::span<const GelWords> words) {
    sceneMoved(m_parts->scene.setGel(snapshot, enlargement, words));
    m_parts->vtk->requestRender();
}

void Scene3dView::setSubject(const Eigen::AlignedBox3d& box_m) {
    m_parts->camera.setSubject(box_m);
}

void Scene3dView::look(CameraPreset preset) {
    m_parts->camera.look(preset);
    m_parts->onHand->setChecked(false);
}

const Orbit& Scene3dView::orbit() const {
    return m_parts->camera.orbit();
}

void Scene3dView::resetView() {
    m_parts->follow->setChecked(false);
    look(CameraPreset::isometric);
}

void Scene3dView::frame() {
    m_parts->follow->setChecked(false);
    m_parts->camera.frame();
    m_parts->onHand->setChecked(false);
}

core::Expected<void> Scene3dView::saveGeometry(const QString& path) const {
    m_parts->scene.draw();
    return exportGeometry(m_parts->scene.worldMeshes(), path);
}

bool Scene3dView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QPoint place = m_parts->vtk->mapFromGlobal(help->globalPos());
        const QString text = wordsAt(m_parts->scene, m_parts->pointAt(place));
        text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), text, this);
        return true;
    }
    return QWidget::event(event);
}

void Scene3dView::applyPalette() {
    m_parts->applyColours(SceneColours(palette()));
    refresh();
}

void Scene3dView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh(); // catches up on changes made while hidden
}

void Scene3dView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    if (!m_parts->vtk->size().isEmpty())
        m_parts->camera.setAspect(static_cast<double>(m_parts->vtk->width()) / m_parts->vtk->height());
}

} // namespace teleta::view3d
