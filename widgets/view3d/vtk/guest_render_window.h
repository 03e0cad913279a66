// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/vtk/frame_quality.h"

#include <QImage>
#include <qopengl.h>

#include <vtkGenericOpenGLRenderWindow.h>

class QOpenGLContext;
class QSurface;

namespace teleta::view3d {

/// A VTK render window that draws into its own framebuffer in an OpenGL context made by Qt. The context may
/// be replaced; renderers and actors stay.
class GuestRenderWindow : public vtkGenericOpenGLRenderWindow {
public:
    static constexpr int kSamples = 4; ///< per pixel, for smooth edges

    static GuestRenderWindow* New();

    /// context must be current. Returns whether VTK can draw in it.
    bool attach(QOpenGLContext* context, QSurface* surface);
    /// Frees all VTK resources of the context, which must still exist.
    void detach();
    [[nodiscard]] bool attached() const { return m_context != nullptr; }

    void MakeCurrent() override;
    bool IsCurrent() override;
    int SupportsOpenGL() override { return attached() ? 1 : 0; }

    /// How finely the next frames are drawn; edges are smoothed unless the driver takes several samples a
    /// pixel.
    void setQuality(FrameQuality::Level level);
    /// Submits the scene to the driver; saves OpenGL's state before and restores it after. Layer 0 has an
    /// opaque background.
    void renderGuarded();
    /// Whether the driver has finished the frame; does not wait.
    [[nodiscard]] bool isDrawn();
    /// The last frame, opaque; waits until it is finished. Null if it cannot be read.
    [[nodiscard]] QImage frame();

protected:
    GuestRenderWindow();
    ~GuestRenderWindow() override;

private:
    GuestRenderWindow(const GuestRenderWindow&) = delete;
    void operator=(const GuestRenderWindow&) = delete;

    void dropFence();

    QOpenGLContext* m_context = nullptr;
    GLsync m_fence = nullptr; ///< after the last frame
    QSurface* m_surface = nullptr;
};

} // namespace teleta::view3d
