// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/objects_part.h"

#include "widgets/base/colour_maps.h"

#include <algorithm>

namespace teleta::view3d {

namespace {

constexpr double kPoint_m = 0.004;
constexpr double kMarkedPoint_m = 0.007;

void dropWhatIsNotFinite(std::vector<Eigen::Vector3d>& points_m) {
    std::erase_if(points_m, [](const Eigen::Vector3d& p) { return !p.allFinite(); });
}

} // namespace

void ObjectsPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_points.actor);
    renderer->AddActor(m_curves.actor);
    renderer->AddActor(m_marked.actor);
}

void ObjectsPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

void ObjectsPart::set(std::span<const DrawnObject> objects) {
    m_objects.assign(objects.begin(), objects.end());
    m_box_m.setEmpty();
    for (DrawnObject& object : m_objects) {
        dropWhatIsNotFinite(object.points_m);
        dropWhatIsNotFinite(object.curve_m);
        for (const auto* points : {&object.points_m, &object.curve_m})
            for (const Eigen::Vector3d& p : *points)
                m_box_m.extend(p);
    }
    std::erase_if(m_objects, [](const DrawnObject& object) { return object.points_m.empty(); });
    rebuild();
}

QColor ObjectsPart::colourOf(const DrawnObject& object) const {
    return base::identityColour(static_cast<int>(std::max<std::uint64_t>(1, object.number)), m_colours.dark);
}

void ObjectsPart::rebuild() {
    m_points.clear();
    m_curves.clear();
    m_marked.clear();
    for (const DrawnObject& object : m_objects) {
        if (object.elsewhere && !object.marked)
            continue;
        const QRgb colour = colourOf(object).rgb();
        for (const Eigen::Vector3d& p : object.points_m)
            m_points.sphere(p, object.marked ? kMarkedPoint_m : kPoint_m, colour);
        (object.marked ? m_marked : m_curves).polyline(object.curve_m, colour);
    }
    m_points.finish();
    m_curves.finish();
    m_marked.finish();
}

void ObjectsPart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    meshes.push_back(m_points.data());
    meshes.push_back(m_curves.data());
    meshes.push_back(m_marked.data());
}

} // namespace teleta::view3d
