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
    const base::SpaceColours& space = base::spaceColours(dark);
    cylinder = space.tube;
    axes = space.axes;
    arm = space.shell;
    armJoint = space.joint;
    contourPoint = text;
    contourCurve = palette.color(QPalette::Link);
    contourVertex = status.stale;
    trail = base::mixed(ground, text, 0.75);
    nearLimit = status.stale;
    atLimit = status.lost;
    jointForce = text;
    moment = text;
}

} // namespace teleta::view3d
