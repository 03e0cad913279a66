// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/display.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <cmath>

namespace teleta::charts {

double Display::of(double value) const {
    return scale * (root ? std::sqrt(value) : value);
}

QColor curveColour(int colour, const QPalette& palette) {
    if (colour == 0)
        return palette.color(QPalette::PlaceholderText);
    return base::identityColour(colour, base::isDark(palette));
}

} // namespace teleta::charts
