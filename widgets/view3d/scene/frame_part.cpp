// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/frame_part.h"

#include "widgets/base/numbers/calm_range.h"

#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace teleta::view3d {

void GridPart::applyColours(const SceneColours& colours) {
    m_colour = colours.grid.rgb();
    rebuild();
}

bool GridPart::cover(const Eigen::AlignedBox3d& box_m, bool always) {
    constexpr double kMuchTooLarge = 2.5;
    constexpr double kCells = 6.0;
    const double spacing_m = base::niceStep(std::max(box_m.sizes().maxCoeff(), 1e-6) / kCells);
    const bool covers = !m_box_m.isEmpty() && m_box_m.contains(box_m);
    const bool oversized = covers && m_box_m.sizes().head<2>().maxCoeff() >
                                         kMuchTooLarge * box_m.sizes().head<2>().maxCoeff() + 4.0 * spacing_m;
    if (!always && covers && !oversized)
        return false;
    m_spacing_m = spacing_m;
    const Eigen::Vector3d margin(m_spacing_m, m_spacing_m, 0.0);
    Eigen::Vector3d low = box_m.min() - margin;
    Eigen::Vector3d high = box_m.max() + margin;
    for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::floor(low[axis] / m_spacing_m) * m_spacing_m;
        high[axis] = std::ceil(high[axis] / m_spacing_m) * m_spacing_m;
    }
    high.z() += box_m.sizes().z();
    m_box_m = {low, high};
    rebuild();
    return true;
}

void GridPart::rebuild() {
    m_lines.clear();
    if (!m_box_m.isEmpty()) {
        const Eigen::Vector3d low = m_box_m.min();
        const Eigen::Vector3d high = m_box_m.max();
        const auto columns = std::lround((high.x() - low.x()) / m_spacing_m);
        const auto rows = std::lround((high.y() - low.y()) / m_spacing_m);
        for (long i = 0; i <= columns; ++i) {
            const double x = low.x() + static_cast<double>(i) * m_spacing_m;
            m_lines.segment({x, low.y(), low.z()}, {x, high.y(), low.z()}, m_colour);
        }
        for (long i = 0; i <= rows; ++i) {
            const double y = low.y() + static_cast<double>(i) * m_spacing_m;
            m_lines.segment({low.x(), y, low.z()}, {high.x(), y, low.z()}, m_colour);
        }
    }
    m_lines.finish();
}

void AxesPart::rebuild(const Eigen::Vector3d& body_m, double length_m, const SceneColours& colours) {
    m_arrows.clear();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<Eigen::Index>(axis);
        const Eigen::Vector3d along = Eigen::Vector3d::Unit(at);
        m_tips[axis] = (body_m[at] + length_m) * along;
        m_arrows.arrow(body_m[at] * along, m_tips[axis], 0.035 * length_m, 0.3 * length_m,
                       colours.axes[axis].rgb());
    }
    m_arrows.finish();
}

} // namespace teleta::view3d
