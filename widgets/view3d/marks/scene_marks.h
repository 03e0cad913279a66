// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/marks/limit_part.h"
#include "widgets/view3d/marks/scenery_part.h"
#include "widgets/view3d/marks/trail_part.h"
#include "widgets/view3d/marks/wrench_part.h"

#include <vtkCommand.h>

namespace teleta::view3d {

/// What is drawn into a scene beside the things themselves: once for each picture, just before it is
/// rendered. Thread: one.
class SceneMarks {
public:
    /// scene: is there as long as its marks.
    explicit SceneMarks(const TouchScene& scene)
        : m_scene(scene)
        , m_onRender(scene.renderer()->AddObserver(vtkCommand::StartEvent, this, &SceneMarks::draw)) {
        trail.addTo(scene.renderer());
        limits.addTo(scene.renderer());
        wrench.addTo(scene.renderer());
        scenery.addTo(scene.renderer());
        applyColours(scene.colours());
    }
    ~SceneMarks() { m_scene.renderer()->RemoveObserver(m_onRender); }
    SceneMarks(const SceneMarks&) = delete;
    SceneMarks& operator=(const SceneMarks&) = delete;

    void applyColours(const SceneColours& colours) {
        trail.applyColours(colours);
        limits.applyColours(colours);
        wrench.applyColours(colours);
        scenery.applyColours(colours);
    }
    void applyPixelScale(double scale) {
        trail.applyPixelScale(scale);
        limits.applyPixelScale(scale);
        scenery.applyPixelScale(scale);
    }

    TrailPart trail;
    LimitPart limits;
    WrenchPart wrench;
    SceneryPart scenery;

private:
    /// The arrows lie in the world: they move with what they act on.
    void draw() {
        trail.draw();
        wrench.draw(m_scene);
    }

    const TouchScene& m_scene;
    unsigned long m_onRender;
};

} // namespace teleta::view3d
