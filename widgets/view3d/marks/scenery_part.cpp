// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/scenery_part.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace teleta::view3d {

namespace {

constexpr double kOpacity = 0.3;

bool isDrawableItem(const SceneryItem& item) {
    if (!item.axis_m.empty())
        return item.radius_m > 0.0 && std::isfinite(item.radius_m) &&
               std::ranges::all_of(item.axis_m, [](const Eigen::Vector3d& p) { return p.allFinite(); });
    return item.outline_m.size() >= 3 && std::isfinite(item.z_m) &&
           std::ranges::all_of(item.outline_m, [](const Eigen::Vector2d& p) { return p.allFinite(); });
}

Eigen::Vector3d at(const Eigen::Vector2d& p, double z_m) {
    return {p.x(), p.y(), z_m};
}

} // namespace

SceneryPart::SceneryPart() {
    m_solids.actor->GetProperty()->SetOpacity(kOpacity);
}

void SceneryPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_solids.actor);
    renderer->AddActor(m_edges.actor);
    renderer->AddActor(m_rounds.actor);
}

void SceneryPart::setVisible(bool visible) {
    m_solids.actor->SetVisibility(visible);
    m_edges.actor->SetVisibility(visible);
    m_rounds.actor->SetVisibility(visible);
}

void SceneryPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

bool SceneryPart::set(std::span<const SceneryItem> items) {
    std::vector<SceneryItem> drawable;
    std::copy_if(items.begin(), items.end(), std::back_inserter(drawable), isDrawableItem);
    if (drawable == m_items)
        return false;
    m_items = std::move(drawable);
    rebuild();
    return true;
}

Eigen::AlignedBox3d SceneryPart::box_m() const {
    Eigen::AlignedBox3d box;
    if (!isVisible())
        return box;
    for (const SceneryItem& item : m_items) {
        for (const Eigen::Vector3d& p : item.axis_m) {
            box.extend(p + Eigen::Vector3d::Constant(item.radius_m));
            box.extend(p - Eigen::Vector3d::Constant(item.radius_m));
        }
        if (!item.axis_m.empty())
            continue;
        for (const Eigen::Vector2d& corner : item.outline_m) {
            box.extend(at(corner, item.z_m - kHalfHeight_m));
            box.extend(at(corner, item.z_m + kHalfHeight_m));
        }
    }
    return box;
}

Eigen::Vector3d SceneryPart::placeOfName_m(const SceneryItem& item) {
    if (!item.axis_m.empty())
        return item.axis_m.back();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : item.outline_m)
        box.extend(corner);
    return at(box.center(), item.z_m);
}

void SceneryPart::rebuild() {
    m_solids.clear();
    m_edges.clear();
    m_rounds.clear();
    const QRgb colour = m_colours.faintText.rgb();
    for (const SceneryItem& item : m_items) {
        if (!item.axis_m.empty()) {
            m_rounds.sphere(item.axis_m.front(), item.radius_m, colour);
            m_rounds.sphere(item.axis_m.back(), item.radius_m, colour);
            for (std::size_t i = 1; i < item.axis_m.size(); ++i)
                m_rounds.cone(item.axis_m[i - 1], item.axis_m[i], item.radius_m, item.radius_m, colour);
            continue;
        }
        const std::size_t corners = item.outline_m.size();
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& corner : item.outline_m)
            middle += corner / static_cast<double>(corners);
        const double low_m = item.z_m - kHalfHeight_m;
        const double high_m = item.z_m + kHalfHeight_m;
        std::vector<Eigen::Vector3d> top;
        std::vector<Eigen::Vector3d> bottom;
        for (std::size_t i = 0; i < corners; ++i) {
            const Eigen::Vector2d& a = item.outline_m[i];
            const Eigen::Vector2d& b = item.outline_m[(i + 1) % corners];
            m_solids.quad(at(a, low_m), at(b, low_m), at(b, high_m), at(a, high_m), colour);
            m_solids.quad(at(middle, high_m), at(a, high_m), at(0.5 * (a + b), high_m), at(b, high_m),
                          colour);
            m_solids.quad(at(middle, low_m), at(b, low_m), at(0.5 * (a + b), low_m), at(a, low_m), colour);
            top.push_back(at(a, high_m));
            bottom.push_back(at(a, low_m));
        }
        m_edges.polyline(top, colour, true);
        m_edges.polyline(bottom, colour, true);
    }
    m_solids.finish();
    m_edges.finish();
    m_rounds.finish();
}

} // namespace teleta::view3d
