// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include <cstddef>

namespace teleta::charts {

/// Conversion of a channel's SI value to the number on the axis.
struct Display {
    double scale = 1.0;
    bool root = false; ///< take the square root before scaling: eigenvalues are shown as standard deviations

    [[nodiscard]] double of(double value) const;
};

/// How a column of a history is drawn.
struct CurveStyle {
    std::size_t column = 0;
    Display display;
    int colour = 1;      ///< identity colour; 0 the colour of faint text
    bool dashed = false; ///< a reference, not a measurement
    double period = 0.0; ///< of the SI value, for angles
    bool whole = false;  ///< a count
};

/// colour: identity colour of a curve; 0 the colour of faint text.
[[nodiscard]] QColor curveColour(int colour, const QPalette& palette);

} // namespace teleta::charts
