// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/arm_model.h"
#include "backend/core/error.h"
#include "widgets/view3d/robot/triangle_mesh.h"

#include <string>
#include <vector>

namespace teleta::view3d {

/// What the links of a robot look like, in the order of ArmModel::links, each in the frame of its link. Links
/// without a visual have no triangles.
struct RobotShape {
    std::vector<TriangleMesh> links;

    [[nodiscard]] bool isEmpty() const;
};

/// Makes the shapes of all visuals; reads the meshes among them from a folder, see meshPath(). It takes as
/// long as the files are large. Error: of the first mesh that cannot be read, since a robot with holes is
/// none. Thread: any.
[[nodiscard]] core::Expected<RobotShape> loadRobotShape(const arm_model::ArmModel& model,
                                                        const std::string& folder);

} // namespace teleta::view3d
