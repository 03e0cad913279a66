// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/taxel_mesh.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <array>

namespace teleta::view3d {

namespace {

constexpr std::size_t kCornersOfCell = 4;
constexpr std::size_t kPointsOfCell = 2 * kCornersOfCell; ///< feet first, then tops
constexpr std::size_t kColourComponents = 3;

} // namespace

TaxelMesh::TaxelMesh() {
    m_positions->SetNumberOfComponents(3);
    m_colours->SetNumberOfComponents(static_cast<int>(kColourComponents));
    m_colours->SetName("colour");
    const vtkNew<vtkPoints> points;
    points->SetData(m_positions);
    m_data->SetPoints(points);
    m_data->GetPointData()->SetScalars(m_colours);
}

void TaxelMesh::rebuild(const DrawnGrid& grid, const SurfaceMap& map, double gap) {
    m_corners.clear();
    m_corners.reserve(kCornersOfCell * grid.cells());
    const auto points = static_cast<vtkIdType>(kPointsOfCell * grid.cells());
    m_positions->SetNumberOfTuples(points);
    m_colours->SetNumberOfTuples(points);
    m_colours->Fill(0);
    const vtkNew<vtkCellArray> faces;
    float* position = m_positions->GetPointer(0);
    for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
            const DrawnGrid::Edges edges = grid.edges(row, column);
            const double insetX_m = 0.5 * gap * (edges.x1_m - edges.x0_m);
            const double insetY_m = 0.5 * gap * (edges.y1_m - edges.y0_m);
            const double x0 = edges.x0_m + insetX_m;
            const double x1 = edges.x1_m - insetX_m;
            const double y0 = edges.y0_m + insetY_m;
            const double y1 = edges.y1_m - insetY_m;
            const auto base = static_cast<vtkIdType>(2 * m_corners.size());
            for (const auto& [x, y] : {std::array{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
                m_corners.push_back({map.point(x, y, 0.0).cast<float>(), map.normal(y).cast<float>()});
            for (int half = 0; half < 2; ++half) {
                for (std::size_t i = m_corners.size() - kCornersOfCell; i < m_corners.size();
                     ++i, position += 3) {
                    Eigen::Map<Eigen::Vector3f> place(position);
                    place = m_corners[i].foot;
                }
            }
            faces->InsertNextCell({base + 4, base + 5, base + 6, base + 7});
            for (vtkIdType side = 0; side < 4; ++side) {
                const vtkIdType next = (side + 1) % 4;
                faces->InsertNextCell({base + side, base + next, base + next + 4, base + side + 4});
            }
        }
    }
    m_data->SetPolys(faces);
    m_positions->Modified();
    m_data->GetPoints()->Modified();
    m_colours->Modified();
}

void TaxelMesh::update(std::span<const float> height_m, std::span<const QRgb> colour) {
    float* position = m_positions->GetPointer(0);
    unsigned char* shade = m_colours->GetPointer(0);
    const Corner* corner = m_corners.data();
    for (std::size_t cell = 0; cell < height_m.size(); ++cell) {
        position += 3 * kCornersOfCell; // skips the feet
        for (std::size_t i = 0; i < kCornersOfCell; ++i, ++corner, position += 3) {
            Eigen::Map<Eigen::Vector3f> place(position);
            place = corner->foot + height_m[cell] * corner->rise;
        }
        for (std::size_t i = 0; i < kPointsOfCell; ++i, shade += kColourComponents) {
            shade[0] = static_cast<unsigned char>(qRed(colour[cell]));
            shade[1] = static_cast<unsigned char>(qGreen(colour[cell]));
            shade[2] = static_cast<unsigned char>(qBlue(colour[cell]));
        }
    }
    m_positions->Modified();
    m_data->GetPoints()->Modified();
    m_colours->Modified();
}

Eigen::Vector3d TaxelMesh::corner(std::size_t cell, int corner, double height_m) const {
    const Corner& c = m_corners[kCornersOfCell * cell + static_cast<std::size_t>(corner)];
    return c.foot.cast<double>() + height_m * c.rise.cast<double>();
}

} // namespace teleta::view3d
