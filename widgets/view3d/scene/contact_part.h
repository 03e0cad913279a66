// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/first_touch.h"
#include "widgets/view3d/scene/sensor_part.h"

#include <QColor>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

class vtkMatrix4x4;
class vtkRenderer;

namespace teleta::view3d {

/// A drawn contact, in the array's frame.
struct ContactMark {
    contact::Contact contact;
    QColor colour;
    Eigen::Vector3d p_Sensor_Foot; ///< the contact point, on top of the taxel with the peak
    Eigen::Vector3d p_Sensor_Tail; ///< far end of the force arrow; the foot when there is no force
};

/// Contacts on the sensor: a sphere at the contact point, an arrow for the normal force, the outline of the
/// region, and the path since the contact began; each in the colour of its identity. Thread: one.
class ContactPart {
public:
    /// Only this many contacts are drawn, the strongest ones.
    static constexpr std::size_t kMaximum = 64;

    ContactPart();

    void addTo(vtkRenderer* renderer);
    void setPose(vtkMatrix4x4* X_World_Sensor);
    void setVisible(bool visible);
    void setDisplacementShown(bool shown);
    void setForcesShown(bool shown);
    void applyPixelScale(double scale);

    /// labels: region of each taxel, or empty. loadRange_N, forceRange_N: load of the full height and force
    /// of the longest arrow, > 0. onDark: colours for a dark background.
    void update(std::span<const contact::Contact> contacts, std::span<const std::int32_t> labels,
                const core::ArrayLayout& layout, const SensorPart& sensor, const FirstTouch& touches,
                double loadRange_N, double forceRange_N, bool onDark);
    void clear();

    [[nodiscard]] const std::vector<ContactMark>& marks() const { return m_marks; }
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;

private:
    void outlineRegions(std::span<const std::int32_t> labels, const core::ArrayLayout& layout,
                        const SensorPart& sensor);
    void drawWay(const ContactMark& mark, const Eigen::Vector2d& start_m, double height_m,
                 const SensorPart& sensor);

    /// The mark of a region; null: it has none.
    [[nodiscard]] const ContactMark* markOf(std::int32_t region) const;

    std::vector<ContactMark> m_marks;
    std::vector<std::pair<std::int32_t, std::size_t>> m_parts; ///< other regions of a mark, and its index
    std::vector<Eigen::Vector3d> m_way;
    bool m_visible = true;
    bool m_wayShown = true;
    bool m_forcesShown = true;
    Mesh m_solids{Mesh::Shading::smooth};
    Mesh m_arrows{Mesh::Shading::smooth};
    Mesh m_outlines{Mesh::Shading::none};
    Mesh m_ways{Mesh::Shading::none};
};

} // namespace teleta::view3d
