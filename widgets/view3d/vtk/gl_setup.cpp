// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/gl_setup.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace teleta::view3d {

namespace {

constexpr int kOpenGlMajor = 3;
constexpr int kOpenGlMinor = 2;

GlProblem askDriver() {
    if (!platformHasOpenGl())
        return GlProblem::noGlPlatform;
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat::defaultFormat());
    if (!context.create() || context.isOpenGLES())
        return GlProblem::tooOld;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return GlProblem::tooOld;
    const bool recent = context.format().version() >= qMakePair(kOpenGlMajor, kOpenGlMinor);
    context.doneCurrent();
    return recent ? GlProblem::none : GlProblem::tooOld;
}

} // namespace

void configureOpenGlBeforeApplication() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(kOpenGlMajor, kOpenGlMinor);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0); // VTK has its own multisampled buffer
    QSurfaceFormat::setDefaultFormat(format);

    const bool wayland =
        qEnvironmentVariableIsSet("WAYLAND_DISPLAY") || qgetenv("XDG_SESSION_TYPE") == "wayland";
    if (wayland && !qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "xcb");
}

bool platformHasOpenGl() {
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

bool loadOpenGlDriver() {
    QOpenGLContext context; // of the same format as those of the views
    return platformHasOpenGl() && context.create();
}

GlProblem findGlProblem() {
    static const GlProblem problem = askDriver();
    return problem;
}

QString describe(GlProblem problem) {
    switch (problem) {
    case GlProblem::none:
        break;
    case GlProblem::noGlPlatform:
        return QCoreApplication::translate("view3d", "The display platform \"%1\" has no OpenGL widgets.")
            .arg(QGuiApplication::platformName());
    case GlProblem::tooOld:
        return QCoreApplication::translate("view3d", "This display does not support OpenGL %1.%2 or newer.")
            .arg(kOpenGlMajor)
            .arg(kOpenGlMinor);
    case GlProblem::contextRefused:
        return QCoreApplication::translate("view3d", "This display refused an OpenGL context.");
    case GlProblem::driverRefused:
        return QCoreApplication::translate("view3d",
                                           "The OpenGL driver of this display does not work with VTK.");
    }
    return {};
}

} // namespace teleta::view3d
