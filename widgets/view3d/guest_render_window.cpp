// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/guest_render_window.h"

#include <QByteArray>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace teleta::view3d {

namespace {

/// Smoothing edges takes a software renderer longer than all the rest of a frame.
bool drawsInSoftware(const QOpenGLContext& context) {
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray renderer = QByteArray(name).toLower();
    return renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("swrast");
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

void GuestRenderWindow::detach() {
    if (!m_context) {
        return;
    }
    MakeCurrent();
    Finalize();
    SetReadyForRendering(false);
    m_context = nullptr;
    m_surface = nullptr;
}

void GuestRenderWindow::MakeCurrent() {
    if (m_context && !IsCurrent()) {
        m_context->makeCurrent(m_surface);
    }
}

bool GuestRenderWindow::IsCurrent() {
    const QOpenGLContext* current = QOpenGLContext::currentContext();
    return m_context && current == m_context && current->surface() == m_surface;
}

void GuestRenderWindow::renderGuarded() {
    if (!m_context) {
        return;
    }
    MakeCurrent();
    vtkCollectionSimpleIterator place;
    GetRenderers()->InitTraversal(place);
    while (vtkRenderer* renderer = GetRenderers()->GetNextRenderer(place)) {
        // A translucent background would be blended with what lies behind the widget.
        renderer->SetBackgroundAlpha(renderer->GetLayer() == 0 ? 1.0 : 0.0);
    }
    vtkOpenGLState* state = GetState();
    state->Reset();
    state->Push();
    // Qt leaves GL_LESS; VTK draws coincident surfaces with LEQUAL.
    state->vtkglDepthFunc(GL_LEQUAL);
    Render();
    state->Pop();
}

void GuestRenderWindow::blitTo(unsigned int target, int width, int height) {
    if (!m_context) {
        return;
    }
    MakeCurrent();
    QOpenGLFunctions* gl = m_context->functions();
    gl->glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl->glDisable(GL_SCISSOR_TEST); // would clip the copy
    vtkOpenGLState* state = GetState();
    state->Reset();
    state->Push();
    BlitDisplayFramebuffer(0, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->Pop();

    gl->glBindFramebuffer(GL_FRAMEBUFFER, target);
    gl->glViewport(0, 0, width, height);
}

} // namespace teleta::view3d
