// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/mesh/mesh_builder.h"
#include "widgets/view3d/scene/first_touch.h"
#include "widgets/view3d/scene/sensor_part.h"

#include <QColor>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

class vtkMatrix4x4;
class vtkRenderer;

namespace teleta::view3d {

/// A contact as it is drawn, in the array's frame.
struct ContactMark {
    contact::Contact contact;
    QColor colour;
    Eigen::Vector3d p_Sensor_Foot; ///< the contact point, on top of the taxel with the peak
    Eigen::Vector3d p_Sensor_Tail; ///< far end of the force arrow; the foot when there is no force
};

/// Contacts on the sensor: a sphere at the contact point, an arrow of the normal force that presses on it,
/// the outline of its region, and the way that it has moved since it began; each in the colour of its
/// identity. Thread: one.
class ContactPart {
public:
    /// At most this many contacts are drawn, the strongest first.
    static constexpr std::size_t kMaximum = 64;

    ContactPart();

    void addTo(vtkRenderer* renderer);
    void setPose(vtkMatrix4x4* X_World_Sensor);
    void setVisible(bool visible);
    void setDisplacementShown(bool shown);
    void applyPixelScale(double scale);

    /// labels: region of each taxel, or empty. loadRange_N, forceRange_N: what fills the range of heights and
    /// of arrows, > 0. onDark: colours for a dark background.
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

    std::vector<ContactMark> m_marks;
    std::vector<Eigen::Vector3d> m_way;
    bool m_visible = true;
    bool m_wayShown = true;
    MeshBuilder m_solids;
    MeshBuilder m_outlines{false};
    MeshBuilder m_ways{false};
    MeshActor m_solidActor;
    MeshActor m_outlineActor;
    MeshActor m_wayActor;
};

} // namespace teleta::view3d
