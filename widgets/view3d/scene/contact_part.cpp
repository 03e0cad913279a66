// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/contact_part.h"

#include "widgets/base/colour_maps.h"

#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kContactOutline_px = 2.5;
constexpr double kWay_px = 3.0;
constexpr double kShaft = 0.32; ///< radius of an arrow's shaft in radii of the sphere
constexpr double kHead = 2.2;   ///< length of its head, likewise

int idOf(const ContactMark& mark) {
    return mark.contact.id;
}

bool isDrawable(const contact::Contact& contact) {
    return std::isfinite(contact.x_m) && std::isfinite(contact.y_m) && std::isfinite(contact.force_N);
}

/// To the strongest part of a contact, what the others have.
void addOtherParts(contact::Contact& contact, std::span<const contact::Contact> contacts) {
    for (const contact::Contact& other : contacts) {
        if (other.id != contact.id || other.region == contact.region || !isDrawable(other))
            continue;
        contact.force_N += other.force_N;
        contact.area_m2 += other.area_m2;
        contact.taxels += other.taxels;
        contact.shear.reset(); // along the surface of one part only
    }
}

} // namespace

ContactPart::ContactPart() {
    m_marks.reserve(kMaximum);
}

void ContactPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_solids.actor);
    renderer->AddActor(m_arrows.actor);
    renderer->AddActor(m_outlines.actor);
    renderer->AddActor(m_ways.actor);
}

void ContactPart::setPose(vtkMatrix4x4* X_World_Sensor) {
    m_solids.actor->SetUserMatrix(X_World_Sensor);
    m_arrows.actor->SetUserMatrix(X_World_Sensor);
    m_outlines.actor->SetUserMatrix(X_World_Sensor);
    m_ways.actor->SetUserMatrix(X_World_Sensor);
}

void ContactPart::setVisible(bool visible) {
    m_visible = visible;
    m_solids.actor->SetVisibility(visible);
    m_arrows.actor->SetVisibility(visible && m_forcesShown);
    m_outlines.actor->SetVisibility(visible);
    m_ways.actor->SetVisibility(visible && m_wayShown);
}

void ContactPart::setDisplacementShown(bool shown) {
    m_wayShown = shown;
    setVisible(m_visible);
}

void ContactPart::setForcesShown(bool shown) {
    m_forcesShown = shown;
    setVisible(m_visible);
}

void ContactPart::applyPixelScale(double scale) {
    m_outlines.setLineWidth(kContactOutline_px, scale);
    m_ways.setLineWidth(kWay_px, scale);
}

void ContactPart::clear() {
    m_marks.clear();
    for (Mesh* mesh : {&m_solids, &m_arrows, &m_outlines, &m_ways}) {
        mesh->clear();
        mesh->finish();
    }
}

void ContactPart::update(std::span<const contact::Contact> contacts, std::span<const std::int32_t> labels,
                         const core::ArrayLayout& layout, const SensorPart& sensor, const FirstTouch& touches,
                         double loadRange_N, double forceRange_N, bool onDark) {
    const SensorSize& size = sensor.size();
    const SurfaceMap& map = sensor.map();
    m_marks.clear();
    m_solids.clear();
    m_arrows.clear();
    m_outlines.clear();
    m_ways.clear();
    m_parts.clear();
    for (contact::Contact contact : contacts) {
        if (m_marks.size() == kMaximum)
            break; // contacts are sorted by decreasing force
        if (!isDrawable(contact))
            continue;
        // One mark for the parts of a contact on both sides of the seam, at the strongest.
        if (contact.id > 0) {
            if (const auto mark = std::ranges::find(m_marks, contact.id, idOf); mark != m_marks.end()) {
                m_parts.emplace_back(contact.region, static_cast<std::size_t>(mark - m_marks.begin()));
                continue;
            }
            addOtherParts(contact, contacts);
        }
        const int identity = contact.id > 0 ? contact.id : contact.region;
        const QColor colour = base::identityColour(std::max(1, identity), onDark);
        const double height_m = sensor.heightOf(contact.peak_N / loadRange_N);
        const double share = std::clamp(contact.force_N / forceRange_N, 0.0, 1.0);
        const Eigen::Vector3d foot = map.point(contact.x_m, contact.y_m, height_m);
        // The head of the arrow ends on the sphere.
        const Eigen::Vector3d out = map.normal(contact.y_m);
        const Eigen::Vector3d head = foot + size.mark_m * out;
        const Eigen::Vector3d tail = share > 0.0 ? Eigen::Vector3d(head + share * size.arrow_m * out) : foot;
        m_marks.push_back({contact, colour, foot, tail});
        m_solids.sphere(foot, size.mark_m, colour.rgb());
        if (share > 0.0)
            m_arrows.arrow(tail, head, kShaft * size.mark_m, kHead * size.mark_m, colour.rgb());
        if (const auto start_m = touches.startOf(contact.id))
            drawWay(m_marks.back(), *start_m, height_m, sensor);
    }
    if (labels.size() == layout.taxels() && !m_marks.empty())
        outlineRegions(labels, layout, sensor);
    m_solids.finish();
    m_arrows.finish();
    m_outlines.finish();
    m_ways.finish();
}

const ContactMark* ContactPart::markOf(std::int32_t region) const {
    const auto mark =
        std::ranges::find_if(m_marks, [&](const ContactMark& m) { return m.contact.region == region; });
    if (mark != m_marks.end())
        return &*mark;
    const auto part = std::ranges::find(m_parts, region, &std::pair<std::int32_t, std::size_t>::first);
    return part == m_parts.end() ? nullptr : &m_marks[part->second];
}

void ContactPart::drawWay(const ContactMark& mark, const Eigen::Vector2d& start_m, double height_m,
                          const SensorPart& sensor) {
    Eigen::Vector2d end_m(mark.contact.x_m, mark.contact.y_m);
    // The short way around, also over the seam.
    if (sensor.map().surface() == Surface::cylinder)
        end_m.y() = start_m.y() +
                    std::remainder(end_m.y() - start_m.y(), 2.0 * std::numbers::pi * sensor.map().radius_m());
    if ((end_m - start_m).norm() < sensor.size().mark_m)
        return; // hidden in the sphere
    constexpr int kSteps = 24;
    m_way.clear();
    for (int i = 0; i <= kSteps; ++i) {
        const Eigen::Vector2d p = start_m + (end_m - start_m) * (static_cast<double>(i) / kSteps);
        m_way.push_back(sensor.map().point(p.x(), p.y(), height_m));
    }
    m_ways.polyline(m_way, mark.colour.rgb());
    m_solids.octahedron(m_way.front(), 0.6 * sensor.size().mark_m, mark.colour.rgb());
}

void ContactPart::outlineRegions(std::span<const std::int32_t> labels, const core::ArrayLayout& layout,
                                 const SensorPart& sensor) {
    const auto labelAt = [&](int row, int column) {
        const bool inside = row >= 0 && row < layout.rows && column >= 0 && column < layout.columns;
        return inside ? labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(layout.columns) +
                               static_cast<std::size_t>(column)]
                      : 0;
    };
    // For each side of a taxel: the neighbour across it, and its two ends in taxels from the centre.
    struct Side {
        int rowStep, columnStep;
        double x0, y0, x1, y1;
    };
    static constexpr std::array<Side, 4> kSides = {{{-1, 0, -0.5, -0.5, 0.5, -0.5},
                                                    {0, 1, 0.5, -0.5, 0.5, 0.5},
                                                    {1, 0, 0.5, 0.5, -0.5, 0.5},
                                                    {0, -1, -0.5, 0.5, -0.5, -0.5}}};
    // Beyond the seam the first row follows the last one.
    const auto goesOn = [&](int row, int column, std::int32_t region) {
        const int over = row < 0 ? layout.rows - 1 : row >= layout.rows ? 0 : -1;
        const std::int32_t other = labelAt(over, column);
        return other > 0 && other != region && markOf(other) == markOf(region);
    };
    const double lift_m = sensor.size().tile_m;
    for (int row = 0; row < layout.rows; ++row) {
        for (int column = 0; column < layout.columns; ++column) {
            const std::int32_t region = labelAt(row, column);
            if (region <= 0)
                continue;
            const ContactMark* mark = markOf(region);
            if (mark == nullptr)
                continue;
            const double height_m = sensor.heightOfCell(sensor.grid().cellOf(row, column)) + lift_m;
            for (const Side& side : kSides) {
                const std::int32_t beside = labelAt(row + side.rowStep, column + side.columnStep);
                if (beside == region || (beside == 0 && goesOn(row + side.rowStep, column, region)))
                    continue;
                m_outlines.segment(
                    sensor.map().point(layout.x_m(column + side.x0), layout.y_m(row + side.y0), height_m),
                    sensor.map().point(layout.x_m(column + side.x1), layout.y_m(row + side.y1), height_m),
                    mark->colour.rgb());
            }
        }
    }
}

void ContactPart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    meshes.push_back(m_solids.data());
    if (m_forcesShown)
        meshes.push_back(m_arrows.data());
    meshes.push_back(m_outlines.data());
    if (m_wayShown)
        meshes.push_back(m_ways.data());
}

} // namespace teleta::view3d
