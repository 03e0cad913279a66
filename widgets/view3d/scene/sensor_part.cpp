// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/sensor_part.h"

#include "widgets/base/colour_maps.h"

#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kSensorOutline_px = 1.5;
constexpr double kRing_px = 1.0;
constexpr double kTubeOpacity = 0.22;
constexpr double kRingSpacing_m = 0.010;

} // namespace

SensorSize SensorSize::of(const core::ArrayLayout& layout, const DrawnGrid& grid, const SurfaceMap& map) {
    SensorSize size;
    size.halfX_m = 0.5 * layout.columns * layout.pitchX_m;
    size.halfY_m = 0.5 * layout.rows * layout.pitchY_m;
    const double cell_m = std::min(layout.pitchX_m, layout.pitchY_m) * grid.block();
    const double diagonal_m = 2.0 * std::hypot(size.halfX_m, size.halfY_m);
    const double reach_m =
        map.surface() == Surface::cylinder ? std::min(diagonal_m, 2.0 * map.radius_m()) : diagonal_m;
    size.thickness_m = 0.5 * cell_m;
    size.tile_m = 0.06 * cell_m;
    size.rise_m = 0.15 * reach_m;
    size.mark_m = std::max(0.4 * std::min(layout.pitchX_m, layout.pitchY_m), 0.011 * diagonal_m);
    size.arrow_m = 0.28 * diagonal_m;
    return size;
}

SensorPart::SensorPart() {
    m_taxels.borderOn(*m_taxelActor.actor);
    m_taxelActor.hideInside();
    m_slab.hideInside();
    m_tube.actor->GetProperty()->SetOpacity(kTubeOpacity);
    setVisible(false);
}

void SensorPart::addTo(vtkRenderer* renderer) {
    for (const MeshActor* part : actors())
        renderer->AddActor(part->actor);
}

void SensorPart::setPose(vtkMatrix4x4* X_World_Sensor) {
    for (const MeshActor* part : actors())
        part->actor->SetUserMatrix(X_World_Sensor);
}

void SensorPart::setVisible(bool visible) {
    m_visible = visible;
    for (const MeshActor* part : actors())
        part->actor->SetVisibility(visible);
    const bool tube = visible && m_map.surface() == Surface::cylinder;
    m_rings.actor->SetVisibility(tube);
    m_tube.actor->SetVisibility(tube);
}

void SensorPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    if (m_grid.cells() > 0) {
        rebuildSlab();
        rebuildCylinder();
        m_crossedCells.clear();
        update(std::vector<float>(m_share));
    }
}

void SensorPart::applyPixelScale(double scale) {
    m_outline.setLineWidth(kSensorOutline_px, scale);
    m_crosses.setLineWidth(kSensorOutline_px, scale);
    m_rings.setLineWidth(kRing_px, scale);
}

void SensorPart::rebuild(const core::TaxelLayout& layout, const SurfaceMap& map, const CylinderSize& cylinder,
                         bool bordered) {
    m_layout = layout.grid();
    m_grid = DrawnGrid(m_layout);
    m_map = map;
    m_cylinder = cylinder;
    m_size = SensorSize::of(m_layout, m_grid, map);
    m_share.assign(m_grid.cells(), 0.0F);
    m_height_m.assign(m_grid.cells(), 0.0F);
    m_colour.assign(m_grid.cells(), 0);
    m_deadCells.reserve(m_grid.cells());
    m_crossedCells.clear();
    std::vector<bool> hasTaxel(m_grid.cells());
    for (std::size_t taxel = 0; taxel < layout.taxels(); ++taxel) {
        const auto place = std::div(static_cast<long>(taxel), static_cast<long>(m_layout.columns));
        if (!layout.isAbsent(taxel))
            hasTaxel[m_grid.cellOf(static_cast<int>(place.quot), static_cast<int>(place.rem))] = true;
    }
    m_taxels.rebuild(m_grid, map, hasTaxel, bordered);
    rebuildSlab();
    rebuildCylinder();
    update(std::vector<float>(m_share));
    setVisible(m_visible);
}

double SensorPart::heightOf(double share) const {
    return m_size.tile_m + m_size.rise_m * std::clamp(share, 0.0, 1.0);
}

void SensorPart::update(std::span<const float> share) {
    const base::ColourMap& map = base::cividis();
    const QRgb dead = m_colours.dead.rgb();
    m_deadCells.clear();
    for (std::size_t cell = 0; cell < share.size(); ++cell) {
        m_share[cell] = share[cell];
        if (std::isnan(share[cell])) {
            m_deadCells.push_back(cell);
            m_height_m[cell] = static_cast<float>(m_size.tile_m);
            m_colour[cell] = dead;
        } else {
            m_height_m[cell] = static_cast<float>(heightOf(static_cast<double>(share[cell])));
            m_colour[cell] = base::colourAt(map, static_cast<double>(share[cell]));
        }
    }
    m_taxels.update(m_height_m, m_colour);
    if (m_deadCells != m_crossedCells)
        rebuildCrosses();
}

void SensorPart::rebuildCrosses() {
    m_crossedCells = m_deadCells;
    m_crosses.clear();
    const double above_m = 1.5 * m_size.tile_m;
    for (const std::size_t cell : m_crossedCells) {
        m_crosses.segment(m_taxels.corner(cell, 0, above_m), m_taxels.corner(cell, 2, above_m),
                          m_colours.deadCross.rgb());
        m_crosses.segment(m_taxels.corner(cell, 1, above_m), m_taxels.corner(cell, 3, above_m),
                          m_colours.deadCross.rgb());
    }
    m_crosses.finish();
}

void SensorPart::rebuildSlab() {
    // Strips along x, narrow enough to follow the cylinder.
    const int strips = m_map.surface() == Surface::cylinder ? std::clamp(2 * m_layout.rows, 32, 256) : 1;
    const QRgb colour = m_colours.slab.rgb();
    const double low_m = -m_size.thickness_m;
    const double x_m = m_size.halfX_m;
    const auto y_m = [&](int i) { return m_size.halfY_m * (2.0 * i / strips - 1.0); };
    const auto at = [&](double x, int i, double h) { return m_map.point(x, y_m(i), h); };
    m_slab.clear();
    for (int i = 0; i < strips; ++i) {
        m_slab.quad(at(-x_m, i, 0), at(x_m, i, 0), at(x_m, i + 1, 0), at(-x_m, i + 1, 0), colour);
        m_slab.quad(at(-x_m, i + 1, low_m), at(x_m, i + 1, low_m), at(x_m, i, low_m), at(-x_m, i, low_m),
                    colour);
        m_slab.quad(at(x_m, i, low_m), at(x_m, i + 1, low_m), at(x_m, i + 1, 0), at(x_m, i, 0), colour);
        m_slab.quad(at(-x_m, i + 1, low_m), at(-x_m, i, low_m), at(-x_m, i, 0), at(-x_m, i + 1, 0), colour);
    }
    m_slab.quad(at(-x_m, 0, low_m), at(x_m, 0, low_m), at(x_m, 0, 0), at(-x_m, 0, 0), colour);
    m_slab.quad(at(x_m, strips, low_m), at(-x_m, strips, low_m), at(-x_m, strips, 0), at(x_m, strips, 0),
                colour);
    m_slab.finish();

    m_outline.clear();
    std::vector<Eigen::Vector3d> border;
    for (int i = 0; i <= strips; ++i)
        border.push_back(at(-x_m, i, 0));
    for (int i = strips; i >= 0; --i)
        border.push_back(at(x_m, i, 0));
    m_outline.polyline(border, m_colours.outline.rgb(), true);
    m_outline.finish();
}

void SensorPart::rebuildCylinder() {
    m_tube.clear();
    m_rings.clear();
    if (m_map.surface() == Surface::cylinder) {
        const double half_m = 0.5 * m_cylinder.length_m;
        const double radius_m = m_cylinder.radius_m - m_size.thickness_m;
        constexpr int kStrips = 72;
        const auto at = [&](double x, int i, double r) {
            const double angle = 2.0 * std::numbers::pi * i / kStrips;
            return Eigen::Vector3d(x, r * std::sin(angle), r * std::cos(angle));
        };
        for (int i = 0; i < kStrips; ++i) {
            m_tube.quad(at(-half_m, i, radius_m), at(half_m, i, radius_m), at(half_m, i + 1, radius_m),
                        at(-half_m, i + 1, radius_m), m_colours.cylinder.rgb());
        }
        const int rings = static_cast<int>(std::floor(half_m / kRingSpacing_m));
        std::vector<double> places = {-half_m, half_m};
        // Not below the array: they would lie over its cells like a second grid.
        for (int ring = -rings; ring <= rings; ++ring)
            if (std::abs(ring * kRingSpacing_m) > m_size.halfX_m)
                places.push_back(ring * kRingSpacing_m);
        std::array<Eigen::Vector3d, kStrips> circle;
        for (const double x : places) {
            for (int i = 0; i < kStrips; ++i)
                circle[static_cast<std::size_t>(i)] = at(x, i, radius_m);
            m_rings.polyline(circle, m_colours.cylinderRing.rgb(), true);
        }
    }
    m_tube.finish();
    m_rings.finish();
}

void SensorPart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    meshes.push_back(m_taxels.data());
    meshes.push_back(m_slab.data());
    meshes.push_back(m_outline.data());
    if (m_map.surface() == Surface::cylinder)
        meshes.push_back(m_tube.data());
}

} // namespace teleta::view3d
