// SPDX-License-Identifier: GPL-3.0-or-later
// Actions, keys, menu and names of the 3-D view.
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene3d_parts.h"
#include "widgets/view3d/view_icons.h"

#include <QKeyEvent>
#include <QMenu>

#include <array>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kTurnStep_rad = 15.0 * std::numbers::pi / 180.0;
constexpr double kPanStep = 0.08;
constexpr double kZoomStep = 1.2;

struct PresetAction {
    CameraPreset preset;
    ViewIcon icon;
    Qt::Key key;
};
constexpr std::array<PresetAction, 4> kPresets = {
    {{CameraPreset::front, ViewIcon::front, Qt::Key_1},
     {CameraPreset::top, ViewIcon::top, Qt::Key_2},
     {CameraPreset::side, ViewIcon::side, Qt::Key_3},
     {CameraPreset::isometric, ViewIcon::isometric, Qt::Key_4}}};

} // namespace

void Scene3dView::makeActions() {
    Parts& parts = *m_parts;
    const auto make = [this](ViewIcon icon, const QList<QKeySequence>& keys, bool checkable) {
        auto* action = new QAction(viewIcon(icon), {}, this);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        action->setCheckable(checkable);
        addAction(action);
        return action;
    };
    parts.surfaces = new QActionGroup(this);
    parts.plate = make(ViewIcon::plate, {}, true);
    parts.cylinder = make(ViewIcon::cylinder, {}, true);
    parts.surfaces->addAction(parts.plate);
    parts.surfaces->addAction(parts.cylinder);
    parts.plate->setChecked(true);
    connect(parts.plate, &QAction::triggered, this, [this] { setSurface(Surface::plate); });
    connect(parts.cylinder, &QAction::triggered, this, [this] { setSurface(Surface::cylinder); });
    for (const PresetAction& preset : kPresets) {
        parts.presets << make(preset.icon, {QKeySequence(preset.key)}, false);
        connect(parts.presets.back(), &QAction::triggered, this, [this, preset] { look(preset.preset); });
    }
    parts.reset = make(ViewIcon::reset, {QKeySequence(Qt::Key_Home), QKeySequence(Qt::Key_R)}, false);
    connect(parts.reset, &QAction::triggered, this, &Scene3dView::resetView);
    parts.follow = make(ViewIcon::follow, {QKeySequence(Qt::Key_F)}, true);
    parts.follow->setObjectName(QStringLiteral("follow"));
    parts.onHand = make(ViewIcon::onHand, {QKeySequence(Qt::Key_6)}, true);
    parts.onHand->setObjectName(QStringLiteral("onHand"));
    connect(parts.onHand, &QAction::toggled, this, [this](bool on) {
        if (on)
            sceneMoved(false);
        else if (m_parts->camera.isOnHand())
            resetView();
    });
    parts.parallel = make(ViewIcon::parallel, {QKeySequence(Qt::Key_5)}, true);
    parts.parallel->setObjectName(QStringLiteral("parallel"));
    connect(parts.parallel, &QAction::toggled, this, [this](bool on) { m_parts->camera.setParallel(on); });
    connect(parts.layers, &SceneLayers::changed, this, &Scene3dView::showLayers);
    connect(parts.layers, &SceneLayers::changed, this, &Scene3dView::layersChanged);
    parts.copyPicture = new QAction(this);
    parts.copyPicture->setShortcut(QKeySequence::Copy);
    parts.copyPicture->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(parts.copyPicture);
    connect(parts.copyPicture, &QAction::triggered, this, [this] { base::copyPicture(m_parts->figure()); });
    parts.saveGeometry = make(ViewIcon::geometry, {}, false);
    connect(parts.saveGeometry, &QAction::triggered, this, &Scene3dView::askForGeometryFile);
}

void Scene3dView::makeToolBar() {
    Parts& parts = *m_parts;
    parts.toolBar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    parts.toolBar->setIconSize(QSize(1, 1) * base::em(this, Parts::kTool_em));
    parts.toolBar->addActions({parts.plate, parts.cylinder});
    parts.toolBar->addSeparator();
    parts.toolBar->addActions(parts.presets);
    parts.toolBar->addAction(parts.reset);
    parts.toolBar->addSeparator();
    parts.toolBar->addActions({parts.follow, parts.onHand, parts.parallel});
    parts.toolBar->addSeparator();
    for (const SceneLayers::Layer layer : {SceneLayers::grid, SceneLayers::axes, SceneLayers::displacement})
        parts.toolBar->addAction(parts.layers->action(layer));
}

void Scene3dView::retranslate() {
    Parts& parts = *m_parts;
    const auto name = [](QAction* action, const QString& text, const QString& help) {
        action->setText(text);
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(key.isEmpty() ? help : tr("%1 (%2)").arg(help, key));
        action->setWhatsThis(help);
    };
    name(parts.plate, tr("Flat array"), tr("Show the array flat, as it is"));
    name(parts.cylinder, tr("Wrapped on the cylinder"), tr("Wrap the array around the tactile cylinder"));
    name(parts.presets[0], tr("Front"), tr("Look from the front"));
    name(parts.presets[1], tr("Top"), tr("Look from above"));
    name(parts.presets[2], tr("Side"), tr("Look from the right"));
    name(parts.presets[3], tr("Isometric"), tr("Look from a corner"));
    name(parts.reset, tr("Initial view"), tr("Back to the view of the beginning, from a corner"));
    name(parts.follow, tr("Follow contact"),
         tr("Keep the strongest contact in the middle, or the arm's hand while nothing is touched"));
    name(parts.onHand, tr("From the hand"),
         tr("Look along with the tactile array: the camera moves and turns with the hand that carries it"));
    name(parts.parallel, tr("Orthographic"), tr("Parallel lines stay parallel: no perspective"));
    parts.layers->retranslate();
    name(parts.copyPicture, tr("Copy picture"), tr("Copy the picture"));
    name(parts.saveGeometry, tr("Export geometry…"), tr("Save the scene for other programs: VTP, PLY, STL"));
    parts.toolBar->setAccessibleName(tr("3-D view"));
    parts.vtk->setAccessibleName(tr("Touch in 3-D"));
    if (QWidget* canvas = parts.vtk->focusProxy())
        canvas->setAccessibleName(parts.vtk->accessibleName());
    parts.vtk->setWhatsThis(
        tr("The tactile array with its loads as heights and colours, contacts with force "
           "arrows, the arm and the explored contour. Drag with the left button to turn, with "
           "the middle button to move, turn the wheel to zoom."));
    parts.emptyText = tr("No touch to show yet.");
    parts.vtk->requestRender();
}

void Scene3dView::fillMenu(QMenu& menu) {
    Parts& parts = *m_parts;
    menu.addActions(parts.presets);
    menu.addAction(parts.reset);
    menu.addSeparator();
    menu.addActions({parts.plate, parts.cylinder});
    menu.addSeparator();
    menu.addActions({parts.follow, parts.onHand, parts.parallel});
    menu.addSeparator();
    menu.addActions(parts.layers->actions());
    menu.addSeparator();
    parts.figures.addActions(menu);
    menu.addAction(parts.saveGeometry);
}

void Scene3dView::askForGeometryFile() {
    base::askToSave(this,
                    {.title = tr("Export geometry (in mm)"),
                     .filters = {tr("VTK, with colours and lines (*.vtp)"),
                                 tr("Triangles with colours (*.ply)"), tr("Triangles (*.stl)")},
                     .suffix = QStringLiteral("vtp")},
                    [this](const QString& path) {
                        if (const auto written = saveGeometry(path))
                            emit saved(path);
                        else
                            emit failed(QString::fromStdString(core::describe(written.error())));
                    });
}

void Scene3dView::keyPressEvent(QKeyEvent* event) {
    SceneCamera& camera = m_parts->camera;
    const bool move = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto step = [&](double right, double up) {
        move ? camera.pan(kPanStep * right, kPanStep * up)
             : camera.turn(-kTurnStep_rad * right, -kTurnStep_rad * up);
    };
    switch (event->key()) {
    case Qt::Key_Left:
        step(-1.0, 0.0);
        break;
    case Qt::Key_Right:
        step(1.0, 0.0);
        break;
    case Qt::Key_Up:
        step(0.0, 1.0);
        break;
    case Qt::Key_Down:
        step(0.0, -1.0);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
        camera.zoom(event->key() == Qt::Key_Minus ? 1.0 / kZoomStep : kZoomStep);
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    event->accept();
}

} // namespace teleta::view3d
