// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "widgets/view3d/robot/triangle_mesh.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace teleta::view3d {

inline constexpr std::size_t kMostTriangles = 1'000'000;

/// Where a mesh lies that a robot's description names: package://X/Y is FOLDER/X/Y, and a path without a
/// scheme counts from the folder. A description may come from the network, so that nothing outside of the
/// folder is read. Error: refused, for any other scheme, an absolute path, or one that leaves the folder;
/// notFound, without a folder. Thread: any.
[[nodiscard]] core::Expected<std::string> meshPath(std::string_view name, const std::string& folder);

/// Reads a mesh: STL, DAE or OBJ, by its ending. Collada's unit counts, its direction of up does not: robots'
/// files are in the frame of their link. Error: notFound; badInput, for another ending, a damaged file, or
/// more than kMostTriangles; unavailable, where the reader cannot be loaded. Thread: any.
[[nodiscard]] core::Expected<TriangleMesh> readMesh(const std::string& path);

} // namespace teleta::view3d
