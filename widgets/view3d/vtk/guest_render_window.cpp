// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/guest_render_window.h"

#include <QByteArray>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkRect.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <cmath>
#include <utility>

namespace teleta::view3d {

namespace {

constexpr unsigned kShadeSamples = 32;
constexpr double kShadeReach = 0.02; ///< of ambient occlusion, of the size of the scene
constexpr double kShadeBias = 0.05;  ///< of its reach

/// With a software renderer, antialiasing takes longer than the rest of a frame.
bool drawsInSoftware(const QOpenGLContext& context) {
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray renderer = QByteArray(name).toLower();
    return renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("swrast");
}

/// The reach of ambient occlusion follows the size of the scene, which changes while it is shown.
void fitShades(vtkRenderer& renderer) {
    double box_m[6];
    renderer.ComputeVisiblePropBounds(box_m);
    const double size_m = std::hypot(box_m[1] - box_m[0], box_m[3] - box_m[2], box_m[5] - box_m[4]);
    if (!std::isfinite(size_m) || !(size_m > 0.0))
        return;
    renderer.SetSSAORadius(kShadeReach * size_m);
    renderer.SetSSAOBias(kShadeReach * kShadeBias * size_m);
}

} // namespace

vtkStandardNewMacro(GuestRenderWindow);

GuestRenderWindow::GuestRenderWindow() {
    SetReadyForRendering(false);
    SetOwnContext(0);
    SetFrameBlitModeToNoBlit();
    // A core profile has no wide lines; VTK then draws them with a geometry shader.
    SetForceMaximumHardwareLineWidth(1.0F);
}

GuestRenderWindow::~GuestRenderWindow() {
    detach();
}

bool GuestRenderWindow::attach(QOpenGLContext* context, QSurface* surface) {
    m_context = context;
    m_surface = surface;
    SetReadyForRendering(true);
    OpenGLInitContext();
    if (!GlewInitValid) {
        SetReadyForRendering(false);
        m_context = nullptr;
        m_surface = nullptr;
        return false;
    }
    SetMultiSamples(drawsInSoftware(*context) ? 0 : kSamples);
    return true;
}

void GuestRenderWindow::setQuality(FrameQuality::Level level) {
    vtkCollectionSimpleIterator place;
    GetRenderers()->InitTraversal(place);
    while (vtkRenderer* renderer = GetRenderers()->GetNextRenderer(place)) {
        const bool isShaded = level == FrameQuality::Level::shaded;
        // The pass for ambient occlusion draws into a buffer of its own, with one sample a pixel.
        renderer->SetUseFXAA(level != FrameQuality::Level::plain && (isShaded || GetMultiSamples() == 0));
        renderer->SetUseSSAO(isShaded);
        renderer->SetSSAOBlur(true);
        renderer->SetSSAOKernelSize(kShadeSamples);
    }
}

void GuestRenderWindow::detach() {
    if (!m_context)
        return;
    MakeCurrent();
    dropFence();
    Finalize();
    SetReadyForRendering(false);
    m_context = nullptr;
    m_surface = nullptr;
}

void GuestRenderWindow::MakeCurrent() {
    if (m_context && !IsCurrent())
        m_context->makeCurrent(m_surface);
}

bool GuestRenderWindow::IsCurrent() {
    const QOpenGLContext* current = QOpenGLContext::currentContext();
    return m_context && current == m_context && current->surface() == m_surface;
}

void GuestRenderWindow::renderGuarded() {
    if (!m_context)
        return;
    MakeCurrent();
    vtkCollectionSimpleIterator place;
    GetRenderers()->InitTraversal(place);
    while (vtkRenderer* renderer = GetRenderers()->GetNextRenderer(place)) {
        // A translucent background would be blended with the contents behind the widget.
        renderer->SetBackgroundAlpha(renderer->GetLayer() == 0 ? 1.0 : 0.0);
        if (renderer->GetUseSSAO())
            fitShades(*renderer);
    }
    vtkOpenGLState* state = GetState();
    state->Reset();
    state->Push();
    // Qt leaves GL_LESS; VTK draws coincident surfaces with LEQUAL.
    state->vtkglDepthFunc(GL_LEQUAL);
    Render();
    state->Pop();
    dropFence();
    QOpenGLExtraFunctions& gl = *m_context->extraFunctions();
    m_fence = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.glFlush(); // nothing else flushes before the frame is read
}

bool GuestRenderWindow::isDrawn() {
    if (!m_context || !m_fence)
        return true;
    MakeCurrent();
    return m_context->extraFunctions()->glClientWaitSync(m_fence, 0, 0) != GL_TIMEOUT_EXPIRED;
}

void GuestRenderWindow::dropFence() {
    if (m_fence)
        m_context->extraFunctions()->glDeleteSync(std::exchange(m_fence, nullptr));
}

QImage GuestRenderWindow::frame() {
    if (!m_context)
        return {};
    MakeCurrent();
    const vtkRecti all(0, 0, GetSize()[0], GetSize()[1]);
    QImage image(all.GetWidth(), all.GetHeight(), QImage::Format_RGB32);
    vtkOpenGLState* state = GetState();
    state->Reset();
    state->Push();
    const bool read =
        !image.isNull() && ReadPixels(all, 1, GL_BGRA, GL_UNSIGNED_BYTE, image.bits(), 0) == VTK_OK;
    state->Pop();
    // OpenGL's rows start at the bottom.
    return read ? std::move(image).mirrored() : QImage();
}

} // namespace teleta::view3d
