// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/robot/triangle_mesh.h"

#include <cstddef>
#include <string>

namespace teleta::view3d {

/// What the module teleta_mesh_reader exports.
struct MeshReader {
    /// Reads a file of STL, Collada or OBJ with at most so many triangles, all its parts in their places.
    /// False: why not, in the library's English.
    bool (*read)(const char* path, std::size_t mostTriangles, TriangleMesh& mesh, std::string& why);
};

} // namespace teleta::view3d

extern "C" {
[[gnu::visibility("default")]] extern const teleta::view3d::MeshReader teleta_mesh_reader;
}
