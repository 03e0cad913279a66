// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

namespace teleta::view3d {

/// Writes meshes (m) for other programs, in mm as they expect; the format by extension: .vtp (VTK, with
/// colours, lines, and the unit as field data), .ply (triangles with colours), .stl (triangles). The file is
/// written under another name and then renamed, so it is never incomplete. Error: badInput for another
/// extension or nothing to write; ioFailed with the path.
[[nodiscard]] core::Expected<void> exportGeometry(std::span<const vtkSmartPointer<vtkPolyData>> meshes_m,
                                                  const QString& path);

} // namespace teleta::view3d
