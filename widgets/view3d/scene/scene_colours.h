// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

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
    QColor axisX;
    QColor axisY;
    QColor axisZ;
    QColor arm;
    QColor contourPoint;
    QColor contourCurve;
    QColor contourVertex;
    QColor simulated;

    explicit SceneColours(const QPalette& palette);
};

} // namespace teleta::view3d
