// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/mesh/surface_map.h"
#include "widgets/view3d/mesh/taxel_mesh.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

class vtkMatrix4x4;
class vtkRenderer;

namespace teleta::view3d {

/// Dimensions of a drawn array, derived from its size.
struct SensorSize {
    double halfX_m = 0.0;     ///< half extent along the columns
    double halfY_m = 0.0;     ///< along the rows, on the surface
    double thickness_m = 0.0; ///< of the slab under the taxels
    double tile_m = 0.0;      ///< height of an unloaded taxel
    double rise_m = 0.0;      ///< additional height at the full range
    double mark_m = 0.0;      ///< radius of a contact's sphere
    double arrow_m = 0.0;     ///< arrow length at the full range of force

    /// Half of its diagonal.
    [[nodiscard]] double radius_m() const { return std::hypot(halfX_m, halfY_m); }
    static SensorSize of(const core::ArrayLayout& layout, const DrawnGrid& grid, const SurfaceMap& map);
};

/// The sensor's body: taxels raised and coloured by load, the slab below them, crosses on dead taxels, and
/// the tactile cylinder when the array is wrapped around it. In the array's frame. Thread: one.
class SensorPart {
public:
    SensorPart();

    void addTo(vtkRenderer* renderer);
    void setPose(vtkMatrix4x4* X_World_Sensor);
    void setVisible(bool visible);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);

    /// Cells without a taxel show the slab. bordered: each cell shows its border.
    void rebuild(const core::TaxelLayout& layout, const SurfaceMap& map, const CylinderSize& cylinder,
                 bool bordered);
    /// share: load over the range for each drawn cell, clamped to 0..1; NaN: dead.
    void update(std::span<const float> share);

    [[nodiscard]] const DrawnGrid& grid() const { return m_grid; }
    [[nodiscard]] const SurfaceMap& map() const { return m_map; }
    [[nodiscard]] const SensorSize& size() const { return m_size; }
    [[nodiscard]] double heightOfCell(std::size_t cell) const {
        return static_cast<double>(m_height_m[cell]);
    }
    [[nodiscard]] double heightOf(double share) const;
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;

private:
    /// In the order in which they are drawn.
    [[nodiscard]] std::array<const MeshActor*, 6> actors() const {
        return {&m_slab, &m_taxelActor, &m_outline, &m_crosses, &m_rings, &m_tube};
    }
    void rebuildSlab();
    void rebuildCylinder();
    void rebuildCrosses();

    core::ArrayLayout m_layout;
    DrawnGrid m_grid;
    SurfaceMap m_map;
    CylinderSize m_cylinder;
    SensorSize m_size;
    SceneColours m_colours;
    std::vector<float> m_share;
    std::vector<float> m_height_m;
    std::vector<QRgb> m_colour;
    std::vector<std::size_t> m_deadCells;
    std::vector<std::size_t> m_crossedCells;
    bool m_visible = false;

    TaxelMesh m_taxels;
    MeshActor m_taxelActor{m_taxels.data(), MeshActor::Shading::flat};
    Mesh m_slab{Mesh::Shading::smooth};
    Mesh m_outline{Mesh::Shading::none};
    Mesh m_crosses{Mesh::Shading::none};
    Mesh m_tube{Mesh::Shading::smooth};
    Mesh m_rings{Mesh::Shading::none};
};

} // namespace teleta::view3d
