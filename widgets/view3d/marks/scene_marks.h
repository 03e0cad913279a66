// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/marks/limit_part.h"
#include "widgets/view3d/marks/trail_part.h"
#include "widgets/view3d/marks/wrench_part.h"

namespace teleta::view3d {

/// What is drawn into a scene beside the things themselves. Thread: one.
struct SceneMarks {
    explicit SceneMarks(const TouchScene& scene) {
        trail.addTo(scene.renderer());
        limits.addTo(scene.renderer());
        wrench.addTo(scene.renderer());
        applyColours(scene.colours());
    }

    void applyColours(const SceneColours& colours) {
        trail.applyColours(colours);
        limits.applyColours(colours);
        wrench.applyColours(colours);
    }
    void applyPixelScale(double scale) {
        trail.applyPixelScale(scale);
        limits.applyPixelScale(scale);
    }

    TrailPart trail;
    LimitPart limits;
    WrenchPart wrench;
};

} // namespace teleta::view3d
