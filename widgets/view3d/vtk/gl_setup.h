// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::view3d {

/// Why OpenGL views cannot be shown.
enum class GlProblem {
    none,
    noGlPlatform,   ///< the display platform has no OpenGL (offscreen, minimal)
    tooOld,         ///< no OpenGL 3.2 core context can be created
    contextRefused, ///< a context can be created, but not for the widget
    driverRefused,  ///< VTK cannot use the context
};

/// Settings for OpenGL views that must be made before the application object: the default surface format
/// (OpenGL 3.2 core), and the xcb platform on a Wayland desktop with an X server, because Debian's VTK loads
/// OpenGL through GLX. A platform chosen by the user, with QT_QPA_PLATFORM or -platform, is kept. Thread:
/// main, before QApplication.
void configureOpenGlBeforeApplication();

/// Whether the display platform has OpenGL at all; asks no driver. Thread: main, after QApplication.
[[nodiscard]] bool platformHasOpenGl();

/// Whether OpenGL views can be shown in this process: noGlPlatform, tooOld or none. The first call asks the
/// driver by creating a 3.2 core context, which loads it: that takes long. Thread: main, after QApplication.
[[nodiscard]] GlProblem findGlProblem();

/// Loads the driver, so that the first picture of a view need not wait for it. Returns whether there is one.
/// Thread: any, after QApplication and before its end.
bool loadOpenGlDriver();

/// A sentence for the user, translated; empty for none.
[[nodiscard]] QString describe(GlProblem problem);

} // namespace teleta::view3d
