// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkOpenGLRenderer.h>

namespace teleta::view3d {

/// Draws what is translucent over what is opaque, in the order in which it was added, without sorting it by
/// depth. VTK's own way, which sorts, copies the depths and fills two more pictures, whatever is translucent:
/// half of a frame's processor time with a software driver. Thread: the GUI's.
class BlendingRenderer : public vtkOpenGLRenderer {
public:
    static BlendingRenderer* New();
    vtkTypeMacro(BlendingRenderer, vtkOpenGLRenderer) BlendingRenderer(const BlendingRenderer&) = delete;
    BlendingRenderer& operator=(const BlendingRenderer&) = delete;
    BlendingRenderer(BlendingRenderer&&) = delete;
    BlendingRenderer& operator=(BlendingRenderer&&) = delete;

    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* buffer) override;

protected:
    BlendingRenderer();
    ~BlendingRenderer() override = default;
};

} // namespace teleta::view3d
