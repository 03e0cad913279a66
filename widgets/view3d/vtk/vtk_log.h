// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::view3d {

/// Sends VTK's messages to Qt's log, category "teleta.view3d". Calling it again does nothing.
/// Thread: main.
void routeVtkMessagesToQtLog();

} // namespace teleta::view3d
