// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/scene_colours.h"

#include "widgets/base/theme.h"

namespace teleta::view3d {

SceneColours::SceneColours(const QPalette& palette)
    : dark(base::isDark(palette)) {
    const base::StatusColours& status = base::statusColours(palette);
    const QColor ground = palette.color(QPalette::Base);
    backgroundTop = ground;
    backgroundBottom = palette.color(QPalette::Window);
    text = palette.color(QPalette::Text);
    faintText = palette.color(QPalette::PlaceholderText);
    grid = base::mixed(ground, text, dark ? 0.18 : 0.16);
    cylinderRing = base::mixed(ground, text, 0.4);
    slab = base::mixed(ground, text, dark ? 0.26 : 0.38);
    outline = base::mixed(ground, text, 0.65);
    dead = base::mixed(ground, text, dark ? 0.38 : 0.34);
    deadCross = status.lost;
    cylinder = dark ? QColor(0x9a, 0xae, 0xc0) : QColor(0x4c, 0x66, 0x80);
    axes = dark ? std::array{QColor(0xf0, 0x7c, 0x72), QColor(0x6c, 0xc4, 0x7c), QColor(0x74, 0xae, 0xf0)}
                : std::array{QColor(0xb8, 0x32, 0x2a), QColor(0x2a, 0x7d, 0x3c), QColor(0x22, 0x62, 0xb4)};
    arm = dark ? QColor(0xb4, 0xba, 0xc2) : QColor(0xbc, 0xc2, 0xca);
    armJoint = dark ? QColor(0x5a, 0x62, 0x6c) : QColor(0x4a, 0x52, 0x5c);
    contourPoint = text;
    contourCurve = palette.color(QPalette::Link);
    contourVertex = status.stale;
    simulated = status.simulated;
}

} // namespace teleta::view3d
