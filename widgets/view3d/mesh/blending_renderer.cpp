// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/blending_renderer.h"

#include <vtkCullerCollection.h>
#include <vtkObjectFactory.h>

namespace teleta::view3d {

vtkStandardNewMacro(BlendingRenderer);

BlendingRenderer::BlendingRenderer() {
    // A scene has few actors, and nearly all of them are seen: to look for the others takes longer.
    GetCullers()->RemoveAllItems();
}

void BlendingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*buffer*/) {
    // Actors blend, and leave the depths as they are.
    UpdateTranslucentPolygonalGeometry();
}

} // namespace teleta::view3d
