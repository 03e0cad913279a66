// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/gel_words.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <QColor>
#include <QString>

#include <Eigen/Geometry>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace teleta::view3d {

/// A drawn contact on a gel, in the gel's frame.
struct GelMark {
    int id = 0;
    QColor colour;
    GelWords words;
    Eigen::Vector3d p_Sensor_Foot; ///< on the skin
    Eigen::Vector3d p_Sensor_Tail; ///< far end of the arrow that presses; the foot without one
};

/// A flat gel with markers: the part of its plane that the camera sees, to scale; its markers with their
/// displacements, enlarged; contacts with an arrow that presses as much as the skin spreads under them, one
/// along the shear, and one around them as far as they turn, both enlarged likewise. The middle of the plane
/// is the origin of the world, x along the rows of the picture, y down its columns, z out of the gel.
/// Thread: one.
class GelPart {
public:
    /// Displacements below so many standard deviations of a marker's place have no arrow.
    static constexpr double kLeastArrow = 3.0;

    GelPart();
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);
    void setDisplacementShown(bool shown);
    /// The arrows that press and shear.
    void setForcesShown(bool shown);
    /// Those that turn.
    void setTurnsShown(bool shown);

    /// enlargement: of displacements, shear and turns. words: one a contact. Returns whether the plane is
    /// another one. Nothing is shown before the markers' places at rest are known.
    bool set(const pipeline::GelSnapshot& snapshot, double enlargement, std::span<const GelWords> words);
    void clear();

    [[nodiscard]] bool isShown() const { return m_shown; }
    [[nodiscard]] double enlargement() const { return m_enlargement; }
    /// Lengths of the first row and the first column of the picture on the surface.
    [[nodiscard]] double width_m() const { return (m_corners_m[1] - m_corners_m[0]).norm(); }
    [[nodiscard]] double height_m() const { return (m_corners_m[3] - m_corners_m[0]).norm(); }
    /// By which the skin spreads under the longest arrow that presses.
    [[nodiscard]] double spreadRange_m2() const { return m_spreadRange.high(); }
    [[nodiscard]] const std::vector<GelMark>& marks() const { return m_marks; }
    [[nodiscard]] bool hasDisplacements() const { return !m_displacements.isEmpty() && m_displacementShown; }
    [[nodiscard]] bool hasPresses() const { return !m_presses.isEmpty() && m_forcesShown; }
    [[nodiscard]] const Eigen::Isometry3d& X_World_Sensor() const { return m_X_World_Sensor; }
    /// Around all that may be drawn, world frame; empty when nothing is shown.
    [[nodiscard]] Eigen::AlignedBox3d box_m() const;
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;
    [[nodiscard]] vtkMatrix4x4* pose() const { return m_pose; }

private:
    void rebuild();
    void rebuildBody();
    void drawMarkers();
    void drawContact(const vision::GelContactState& contact, const GelWords& words);
    void setVisible();
    [[nodiscard]] std::array<Mesh*, 7> meshes() {
        return {&m_skin, &m_dots, &m_solids, &m_displacements, &m_presses, &m_turns, &m_lines};
    }

    bool m_shown = false;
    bool m_displacementShown = true;
    bool m_forcesShown = true;
    bool m_turnsShown = true;
    pipeline::GelSnapshot m_snapshot; ///< without its picture
    std::vector<GelWords> m_words;
    double m_enlargement = 1.0;
    std::array<Eigen::Vector2d, 4> m_corners_m{}; ///< in order around the plane
    double m_pitch_m = 0.0;                       ///< of the markers, about
    double m_size_m = 0.0;                        ///< diagonal of the plane
    base::CalmRange m_spreadRange{1.0};
    Eigen::Isometry3d m_X_World_Sensor = Eigen::Isometry3d::Identity();
    std::vector<GelMark> m_marks;
    std::vector<Eigen::Vector3d> m_line;
    SceneColours m_colours;

    vtkNew<vtkMatrix4x4> m_pose;
    Mesh m_skin{Mesh::Shading::flat};
    Mesh m_dots{Mesh::Shading::flat};
    Mesh m_solids{Mesh::Shading::smooth};
    Mesh m_displacements{Mesh::Shading::smooth};
    Mesh m_presses{Mesh::Shading::smooth}; ///< and shears
    Mesh m_turns{Mesh::Shading::smooth};
    Mesh m_lines{Mesh::Shading::none};
};

} // namespace teleta::view3d
