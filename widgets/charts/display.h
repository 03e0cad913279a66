// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace teleta::charts {

/// How a channel's SI value becomes the number on the axis.
struct Display {
    double scale = 1.0;
    bool root = false; ///< the square root, then scaled: eigenvalues are shown as standard deviations

    [[nodiscard]] double of(double value) const;
};

/// colour: identity colour of a curve; 0 the colour of faint text.
[[nodiscard]] QColor curveColour(int colour, const QPalette& palette);

} // namespace teleta::charts
