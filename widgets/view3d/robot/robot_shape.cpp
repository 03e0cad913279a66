// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/robot/robot_shape.h"

#include "backend/core/failure.h"
#include "widgets/view3d/robot/mesh_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

namespace teleta::view3d {

namespace {

struct RobotShapeText {
    Q_DECLARE_TR_FUNCTIONS(RobotShape)
};

QRgb rgbOf(const Eigen::Vector4f& colour) {
    const auto level = [&](int i) {
        return static_cast<int>(std::lround(255.0F * std::clamp(colour[i], 0.0F, 1.0F)));
    };
    return qRgba(level(0), level(1), level(2), 255);
}

/// The meshes that were read; links often share one.
class Meshes {
public:
    explicit Meshes(const std::string& folder)
        : m_folder(folder) {}

    core::Expected<const TriangleMesh*> find(const std::string& name) {
        const auto known = m_known.find(name);
        if (known != m_known.end())
            return &known->second;
        TELETA_TRY(const std::string path, meshPath(name, m_folder));
        TELETA_TRY(TriangleMesh mesh, readMesh(path));
        return &m_known.emplace(name, std::move(mesh)).first->second;
    }

private:
    const std::string& m_folder;
    std::map<std::string, TriangleMesh> m_known;
};

core::Expected<void> append(TriangleMesh& link, const arm_model::Visual& visual, Meshes& meshes) {
    Eigen::Affine3d X_Link_Shape(visual.X_Link_Shape.matrix());
    TriangleMesh shape;
    switch (visual.kind) {
    case arm_model::ShapeKind::box:
        shape = boxMesh(visual.size);
        break;
    case arm_model::ShapeKind::cylinder:
        shape = cylinderMesh(visual.size.x(), visual.size.y());
        break;
    case arm_model::ShapeKind::sphere:
        shape = sphereMesh(visual.size.x());
        break;
    case arm_model::ShapeKind::mesh: {
        TELETA_TRY(const TriangleMesh* mesh, meshes.find(visual.mesh));
        shape = *mesh;
        X_Link_Shape.scale(visual.size);
        break;
    }
    }
    if (!(std::abs(X_Link_Shape.linear().determinant()) > 0.0))
        return {}; // scaled to nothing
    if (visual.colour)
        shape.colour(rgbOf(*visual.colour));
    link.append(shape, X_Link_Shape);
    return {};
}

} // namespace

bool RobotShape::isEmpty() const {
    return std::ranges::all_of(links, [](const TriangleMesh& link) { return link.corners.empty(); });
}

core::Expected<RobotShape> loadRobotShape(const arm_model::ArmModel& model, const std::string& folder) {
    RobotShape robot;
    robot.links.resize(model.links.size());
    Meshes meshes(folder);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i)
        for (const arm_model::Visual& visual : model.links[i].visuals) {
            const std::size_t before = robot.links[i].triangles();
            TELETA_CHECK(append(robot.links[i], visual, meshes));
            triangles += robot.links[i].triangles() - before;
            if (triangles > kMostTriangles)
                return core::refused(RobotShapeText::tr("the shapes of the arm have more than %1 triangles")
                                         .arg(kMostTriangles));
        }
    return robot;
}

} // namespace teleta::view3d
