// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/blending_renderer.h"

#include <vtkObjectFactory.h>

namespace teleta::view3d {

vtkStandardNewMacro(BlendingRenderer);

void BlendingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*buffer*/) {
    // Actors blend, and leave the depths as they are.
    UpdateTranslucentPolygonalGeometry();
}

} // namespace teleta::view3d
