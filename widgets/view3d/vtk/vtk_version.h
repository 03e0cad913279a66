// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::view3d {

/// Version of the loaded VTK library: "9.1.0".
[[nodiscard]] QString vtkLibraryVersion();
/// Version of Eigen at compile time.
[[nodiscard]] QString eigenLibraryVersion();

} // namespace teleta::view3d
