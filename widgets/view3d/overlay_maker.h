// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/numbers/number_format.h"
#include "widgets/view3d/marks/scene_marks.h"
#include "widgets/view3d/scene/touch_scene.h"
#include "widgets/view3d/scene_camera.h"
#include "widgets/view3d/scene_overlay.h"

#include <QCoreApplication>

#include <map>

namespace teleta::view3d {

/// Describes a contact, for its tool tip.
[[nodiscard]] QString wordsFor(const contact::Contact& contact, const QString& unit);
/// Contacts of an array as CSV: time_s and contact::contactColumns(). C locale; NA: not told.
[[nodiscard]] QString contactRows(const TouchScene& scene);

/// Place of a world point in the picture, as shares of its width and height from the top left; empty behind
/// the camera.
[[nodiscard]] std::optional<QPointF> placeInPicture(vtkRenderer& renderer, const Eigen::Vector3d& p_World);

/// Makes the texts over the picture of a scene. Forces change only by a full step of the displayed text.
/// Thread: GUI.
class OverlayMaker {
    Q_DECLARE_TR_FUNCTIONS(OverlayMaker)
public:
    struct Request {
        QFont font;
        base::Provenance provenance = base::Provenance::live;
        QString emptyText;
        QString shapeLabel;
        bool contactLabels = true;
        bool grid = true;
        bool forces = true;
        bool jointLimits = true;
    };

    [[nodiscard]] OverlayContent make(const TouchScene& scene, const SceneMarks& marks,
                                      const SceneCamera& camera, const Request& request);

private:
    void addContacts(const TouchScene& scene, OverlayContent& content);
    static void addObjects(const TouchScene& scene, OverlayContent& content);
    static void addScenery(const TouchScene& scene, const SceneryPart& scenery, OverlayContent& content);
    void addTubeMarks(const TouchScene& scene, OverlayContent& content);
    static void addGelMarks(const TouchScene& scene, OverlayContent& content);
    static void addGelLegend(const GelPart& gel, std::vector<LegendLine>& legend);
    void addWrench(const TouchScene& scene, const WrenchPart& wrench, OverlayContent& content);
    static void addLimits(const TouchScene& scene, const LimitPart& limits, OverlayContent& content);
    [[nodiscard]] static std::vector<LegendLine> legendOf(const TouchScene& scene, const WrenchPart& wrench,
                                                          const Request& request);

    std::map<int, base::SteadyNumber> m_forces; ///< by identity
    std::map<int, base::SteadyNumber> m_deviations_mm;
    base::SteadyNumber m_jointForce_N;
    base::SteadyNumber m_moment; ///< in the unit of its range
};

} // namespace teleta::view3d
