// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class vtkPolyData;

namespace teleta::view3d {

/// What the module teleta_geometry_writers exports.
struct GeometryWriters {
    /// Writes a mesh as vtp, ply or stl, and returns VTK's error code. The PLY has the array "colour".
    unsigned long (*write)(const char* format, vtkPolyData* mesh, const char* path);
};

} // namespace teleta::view3d

extern "C" {
[[gnu::visibility("default")]] extern const teleta::view3d::GeometryWriters teleta_geometry_writers;
}
