// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/base/controls/badge.h"

#include <QPointF>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::tactile {

/// Taxels that stand on no grid count as the columns of row 0.
struct Taxel {
    int row = 0, column = 0;
    bool operator==(const Taxel&) const = default;
};

/// What is drawn over the taxels; values: loads as numbers, where the taxels are large enough.
/// shear: arrows of the force along the surface, of arrays that tell it.
enum class Overlay { contacts, centreOfPressure, centreOfContact, principalAxis, values, shear };
inline constexpr std::size_t kOverlays = 6;

/// Visible part of the array. centre: in columns and rows from the array's lower left corner.
struct HeatmapZoom {
    double factor = 1.0; ///< 1 shows the whole array
    QPointF centre;
};

/// A load of the whole frame in N or N m, by a calibration of the array.
struct FrameLoad {
    QString name;  ///< translated
    QString value; ///< with its standard error and unit, steadied
};

/// Everything that a heatmap shows: the only input of the painter.
struct HeatmapContent {
    pipeline::TouchSnapshot snapshot;
    bool valid = false; ///< false: emptyText is shown instead
    bool old = false;   ///< the source sends nothing any more; its last frame is shown faded
    std::array<bool, kOverlays> overlays{true, true, true, true, false, true};
    double rangeTop = 1.0; ///< load at the upper end of the colours
    bool rangeFixed = false;
    double shearTop = 1.0; ///< shear whose arrow is as long as a taxel is wide
    HeatmapZoom zoom;
    std::optional<Taxel> cursor;
    base::Provenance provenance = base::Provenance::live;
    QString forceText;            ///< total force, steadied
    QString shearText;            ///< the total along the surface, likewise; of arrays that tell it
    QString angleText;            ///< principal axis in degrees, steadied
    std::vector<FrameLoad> loads; ///< empty: the array has no calibration
    bool extrapolated = false;    ///< the loads lie beyond the presses of the calibration
    QString emptyText;

    [[nodiscard]] bool shows(Overlay overlay) const { return overlays[static_cast<std::size_t>(overlay)]; }
    [[nodiscard]] std::size_t index(const Taxel& taxel) const {
        return static_cast<std::size_t>(taxel.row) *
                   static_cast<std::size_t>(snapshot.layout.grid().columns) +
               static_cast<std::size_t>(taxel.column);
    }
    [[nodiscard]] bool isDead(std::size_t index) const {
        return !snapshot.dead.empty() && snapshot.dead[index] != 0;
    }
    [[nodiscard]] bool hasShear() const { return snapshot.layout.isVector(); }
    /// The contact of a taxel, or null.
    [[nodiscard]] const contact::Contact* contactAt(std::size_t index) const;
    /// Whether another part of the contact lies beyond the seam of the cylinder around which the array lies;
    /// parts have one identity, see pipeline::joinAtSeam().
    [[nodiscard]] bool isPart(const contact::Contact& contact) const;
    /// How many there are; parts of one count once.
    [[nodiscard]] std::size_t contacts() const;
    [[nodiscard]] QString unit() const { return QString::fromStdString(snapshot.loadUnit); }
};

/// Whether a snapshot can be drawn: its vectors fit its layout.
[[nodiscard]] bool isConsistent(const pipeline::TouchSnapshot& snapshot);

/// Describes a taxel: row and column, or its number where it stands on no grid, load and shear with unit,
/// its contact with the shear and friction of it, place in mm. All count from 0 as in files.
[[nodiscard]] QString taxelText(const HeatmapContent& content, const Taxel& taxel);

/// The frame as CSV: row,column,x_m,y_m,load_<unit in lower case>,dead,contact_id; one row per taxel, C
/// locale. contact_id is 0 outside contacts. Of vectors with shear_x_<unit>,shear_y_<unit> behind load; off a
/// grid with taxel in place of row,column. Places of a grid without a taxel are left out.
[[nodiscard]] QString frameCsv(const HeatmapContent& content);

} // namespace teleta::tactile
