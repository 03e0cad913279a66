// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/view3d/change_watch.h"
#include "widgets/view3d/marks/scene_marks.h"
#include "widgets/view3d/overlay_maker.h"
#include "widgets/view3d/scene/touch_scene.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/scene_camera.h"
#include "widgets/view3d/scene_layers.h"
#include "widgets/view3d/scene_picker.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QAction>
#include <QActionGroup>
#include <QToolBar>

#include <vtkNew.h>

namespace teleta::view3d {

/// What a Scene3dView is made of. Thread: GUI.
struct Scene3dView::Parts {
    static constexpr double kTool_em = 1.25;
    static constexpr double kReach_em = 1.2; ///< of what the mouse points at

    explicit Parts(Scene3dView* view)
        : scene(SceneColours(view->palette()))
        , camera(scene.renderer())
        , vtk(new VtkWidget(view))
        , toolBar(new QToolBar(view))
        , layers(new SceneLayers(view))
        , figures(view, [this] { return figure(); }) {}

    [[nodiscard]] OverlayContent overlay() {
        return overlayMaker.make(scene, marks, camera,
                                 {.font = vtk->font(),
                                  .provenance = provenance,
                                  .emptyText = emptyText,
                                  .shapeLabel = shapeLabel,
                                  .contactLabels = layers->shows(SceneLayers::contactLabels),
                                  .grid = layers->shows(SceneLayers::grid),
                                  .forces = layers->shows(SceneLayers::forces),
                                  .jointLimits = layers->shows(SceneLayers::jointLimits)});
    }

    void applyColours(const SceneColours& colours) {
        scene.applyColours(colours);
        marks.applyColours(colours);
    }

    /// A new frame where it is seen.
    void dataChanged() {
        vtk->noteChange();
        watch.dataChanged();
    }

    [[nodiscard]] base::Figure figure();
    [[nodiscard]] PicturePoint pointAt(const QPointF& position) const {
        return {position, vtk->size(), kReach_em * vtk->fontMetrics().height()};
    }

    TouchScene scene;
    SceneMarks marks{scene};
    SceneCamera camera;
    ChangeWatch watch{[this] { return movingView(scene, marks, camera, *vtk); },
                      [this] { vtk->requestRender(); }};
    OverlayMaker overlayMaker;
    vtkNew<OrbitStyle> style;
    VtkWidget* vtk;
    QToolBar* toolBar;
    SceneLayers* layers;
    base::FigureExport figures;

    base::Provenance provenance = base::Provenance::live;
    QString emptyText;
    QString shapeLabel;
    double lastTime_s = 0.0;

    QActionGroup* surfaces = nullptr;
    QAction* plate = nullptr;
    QAction* cylinder = nullptr;
    QList<QAction*> presets;
    QAction* reset = nullptr;
    QAction* follow = nullptr;
    QAction* onHand = nullptr;
    QAction* parallel = nullptr;
    QAction* copyPicture = nullptr;
    QAction* saveGeometry = nullptr;
};

} // namespace teleta::view3d
