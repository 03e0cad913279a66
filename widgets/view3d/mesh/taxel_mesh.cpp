// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/taxel_mesh.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>

namespace teleta::view3d {

namespace {

constexpr std::size_t kCornersOfCell = 4;
constexpr std::size_t kPointsOfCell = 2 * kCornersOfCell; ///< feet first, then tops
constexpr std::size_t kColourComponents = 3;
constexpr int kTexture_px = 32;
constexpr int kBorder_px = 2;
constexpr unsigned char kBorderShade = 120; ///< of 255
constexpr float kMiddle = 0.5F;
/// Of the points of a cell in the texture.
constexpr std::array<float, 2 * kPointsOfCell> kPlaces{kMiddle, kMiddle, kMiddle, kMiddle, kMiddle, kMiddle,
                                                       kMiddle, kMiddle, 0.0F,    0.0F,    1.0F,    0.0F,
                                                       1.0F,    1.0F,    0.0F,    1.0F};

} // namespace

TaxelMesh::TaxelMesh() {
    m_positions->SetNumberOfComponents(3);
    m_colours->SetNumberOfComponents(static_cast<int>(kColourComponents));
    m_colours->SetName("colour");
    const vtkNew<vtkPoints> points;
    points->SetData(m_positions);
    m_data->SetPoints(points);
    m_data->GetPointData()->SetScalars(m_colours);
    m_places->SetNumberOfComponents(2);
    m_places->SetName("place");
    m_data->GetPointData()->SetTCoords(m_places);
}

void TaxelMesh::borderOn(vtkActor& actor) {
    const vtkNew<vtkImageData> picture;
    picture->SetDimensions(kTexture_px, kTexture_px, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* shade = static_cast<unsigned char*>(picture->GetScalarPointer());
    for (int y = 0; y < kTexture_px; ++y) {
        for (int x = 0; x < kTexture_px; ++x) {
            const int inside = std::min({x, y, kTexture_px - 1 - x, kTexture_px - 1 - y});
            for (int component = 0; component < 3; ++component)
                *shade++ = inside < kBorder_px ? kBorderShade : 255;
        }
    }
    const vtkNew<vtkTexture> texture;
    texture->SetInputData(picture);
    texture->InterpolateOn();
    texture->MipmapOn();
    // Otherwise a software driver may take a second for a frame, see README.md.
    texture->SetMaximumAnisotropicFiltering(1.0F);
    texture->SetWrap(vtkTexture::ClampToEdge);
    actor.SetTexture(texture);
}

void TaxelMesh::rebuild(const DrawnGrid& grid, const SurfaceMap& map, const std::vector<bool>& hasTaxel,
                        bool bordered) {
    m_corners.clear();
    m_corners.reserve(kCornersOfCell * grid.cells());
    const auto points = static_cast<vtkIdType>(kPointsOfCell * grid.cells());
    m_positions->SetNumberOfTuples(points);
    m_colours->SetNumberOfTuples(points);
    m_colours->Fill(0);
    m_places->SetNumberOfTuples(points);
    float* inTexture = m_places->GetPointer(0);
    const vtkNew<vtkCellArray> faces;
    float* position = m_positions->GetPointer(0);
    for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
            const DrawnGrid::Edges edges = grid.edges(row, column);
            const auto base = static_cast<vtkIdType>(2 * m_corners.size());
            // The feet lie in its middle, so that the sides fade to the colour of the cell.
            inTexture = bordered ? std::ranges::copy(kPlaces, inTexture).out
                                 : std::fill_n(inTexture, kPlaces.size(), kMiddle);
            for (const auto& [x, y] : {std::array{edges.x0_m, edges.y0_m},
                                       {edges.x1_m, edges.y0_m},
                                       {edges.x1_m, edges.y1_m},
                                       {edges.x0_m, edges.y1_m}})
                m_corners.push_back({map.point(x, y, 0.0).cast<float>(), map.normal(y).cast<float>()});
            for (int half = 0; half < 2; ++half) {
                for (std::size_t i = m_corners.size() - kCornersOfCell; i < m_corners.size();
                     ++i, position += 3) {
                    Eigen::Map<Eigen::Vector3f> place(position);
                    place = m_corners[i].foot;
                }
            }
            if (!hasTaxel[m_corners.size() / kCornersOfCell - 1])
                continue;
            faces->InsertNextCell({base + 4, base + 5, base + 6, base + 7});
            for (vtkIdType side = 0; side < 4; ++side) {
                const vtkIdType next = (side + 1) % 4;
                faces->InsertNextCell({base + side, base + next, base + next + 4, base + side + 4});
            }
        }
    }
    m_data->SetPolys(faces);
    m_positions->Modified();
    m_places->Modified();
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
