// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::view3d {

/// Version of the VTK library that is loaded: "9.1.0".
[[nodiscard]] QString vtkLibraryVersion();
/// Version of Eigen that was compiled in.
[[nodiscard]] QString eigenLibraryVersion();

} // namespace teleta::view3d
