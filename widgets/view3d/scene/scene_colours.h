// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include <array>

namespace teleta::view3d {

/// Colours of the scene apart from data, from a palette.
struct SceneColours {
    bool dark = false;
    QColor backgroundTop;
    QColor backgroundBottom;
    QColor text;
    QColor faintText;
    QColor grid;
    QColor slab;
    QColor outline;
    QColor dead;
    QColor deadCross;
    QColor cylinder;
    QColor cylinderRing;
    std::array<QColor, 3> axes; ///< x, y, z
    QColor arm;                 ///< shells
    QColor armJoint;            ///< joints and base
    QColor contourPoint;
    QColor contourCurve;
    QColor contourVertex;
    QColor trail;
    QColor nearLimit; ///< of a joint near the end of its range
    QColor atLimit;
    QColor jointForce; ///< force that the joint torques tell
    QColor moment;

    SceneColours() = default;
    explicit SceneColours(const QPalette& palette);
};

} // namespace teleta::view3d
