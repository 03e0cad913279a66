// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace teleta::view3d {

/// Line icons of the 3-D view's tool bar, drawn in the palette's colour.
enum class ViewIcon {
    front,
    top,
    side,
    isometric,
    reset,
    follow,
    onHand,
    parallel,
    plate,
    cylinder,
    grid,
    axes,
    displacement,
    geometry,
};

[[nodiscard]] QIcon viewIcon(ViewIcon icon);

} // namespace teleta::view3d
