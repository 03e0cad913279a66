// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <qopengl.h>

#include <vtkGenericOpenGLRenderWindow.h>

class QOpenGLContext;
class QSurface;

namespace teleta::view3d {

/// A VTK render window that draws into its own framebuffer within an OpenGL context that Qt made. The context
/// may go and another one come; renderers and actors stay.
class GuestRenderWindow : public vtkGenericOpenGLRenderWindow {
public:
    static constexpr int kSamples = 4; ///< of smooth edges

    static GuestRenderWindow* New();

    /// context must be current. Returns whether VTK can draw in it.
    bool attach(QOpenGLContext* context, QSurface* surface);
    /// Frees everything that VTK holds in the context, which must still exist.
    void detach();
    [[nodiscard]] bool attached() const { return m_context != nullptr; }

    void MakeCurrent() override;
    bool IsCurrent() override;
    int SupportsOpenGL() override { return attached() ? 1 : 0; }

    /// Hands the scene of the renderers to the driver, with OpenGL's state saved before and restored after.
    /// Layer 0 is drawn on an opaque background.
    void renderGuarded();
    /// Whether the driver has drawn what it was handed; does not wait for it.
    [[nodiscard]] bool isDrawn();
    /// The last frame, opaque; waits until it is drawn. Null when it cannot be read.
    [[nodiscard]] QImage frame();

protected:
    GuestRenderWindow();
    ~GuestRenderWindow() override;

private:
    GuestRenderWindow(const GuestRenderWindow&) = delete;
    void operator=(const GuestRenderWindow&) = delete;

    void dropFence();

    QOpenGLContext* m_context = nullptr;
    GLsync m_fence = nullptr; ///< behind the last frame
    QSurface* m_surface = nullptr;
};

} // namespace teleta::view3d
