// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/drawn_grid.h"
#include "widgets/view3d/mesh/surface_map.h"

#include <QRgb>

#include <Eigen/Core>
#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <span>
#include <vector>

namespace teleta::view3d {

/// The cells of a taxel array as one mesh of boxes that stand on the surface. The mesh is built once per
/// layout; new heights and colours are written in place. Thread: one.
class TaxelMesh {
public:
    TaxelMesh();

    /// Lets the border of each cell be darkened by a texture, which fades into the colour of the cell where
    /// cells are small on the screen: lines would break into dashes there.
    void borderOn(vtkActor& actor);
    /// hasTaxel: whether anything is drawn of each cell. bordered: false, where a taxel has several cells.
    void rebuild(const DrawnGrid& grid, const SurfaceMap& map, const std::vector<bool>& hasTaxel,
                 bool bordered);
    /// One height (m, finite) and one colour for each cell. Allocates nothing.
    void update(std::span<const float> height_m, std::span<const QRgb> colour);

    [[nodiscard]] vtkPolyData* data() const { return m_data; }
    /// The four corners of the top of a cell at a height, counter-clockwise from (x0, y0).
    [[nodiscard]] Eigen::Vector3d corner(std::size_t cell, int corner, double height_m) const;

private:
    /// Foot of a corner and the direction in which it rises.
    struct Corner {
        Eigen::Vector3f foot;
        Eigen::Vector3f rise;
    };

    std::vector<Corner> m_corners; ///< four for each cell
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkFloatArray> m_positions;
    vtkNew<vtkUnsignedCharArray> m_colours;
    vtkNew<vtkFloatArray> m_places; ///< of the points in the texture
};

} // namespace teleta::view3d
