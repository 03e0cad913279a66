// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::view3d {

/// Why no OpenGL view can be shown.
enum class GlProblem {
    none,
    noGlPlatform,   ///< the display platform has no OpenGL (offscreen, minimal)
    tooOld,         ///< no OpenGL 3.2 core context can be made
    contextRefused, ///< a context could be made, but not for the widget
    driverRefused,  ///< VTK cannot use the context
};

/// Sets what OpenGL views need and what cannot be changed once the application object exists: the default
/// surface format (OpenGL 3.2 core) and the xcb platform on a Wayland desktop with an X server, because
/// Debian's VTK loads OpenGL through GLX. A platform that the user chose, by QT_QPA_PLATFORM or -platform,
/// stays. Thread: main, before QApplication.
void configureOpenGlBeforeApplication();

/// Whether an OpenGL view can be shown in this process: noGlPlatform, tooOld or none. Asks the driver once,
/// by making a 3.2 core context; later calls return the same answer. Thread: main, after QApplication.
[[nodiscard]] GlProblem findGlProblem();

/// A sentence for the user, translated; empty for none.
[[nodiscard]] QString describe(GlProblem problem);

} // namespace teleta::view3d
