// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/theme.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <vtkPolyData.h>

namespace teleta::test {

inline view3d::TouchScene emptyScene() {
    return view3d::TouchScene(view3d::SceneColours(base::designedPalette(false)));
}

/// Lines among all meshes.
inline vtkIdType linesIn(const view3d::TouchScene& scene) {
    vtkIdType lines = 0;
    for (const auto& mesh : scene.worldMeshes())
        lines += mesh->GetNumberOfLines();
    return lines;
}

} // namespace teleta::test
