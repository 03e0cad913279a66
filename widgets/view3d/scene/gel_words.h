// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include <array>

namespace teleta::view3d {

/// How the picture of a gel tells a contact, so that both views say the same.
struct GelWords {
    QString slip;                     ///< "slip 0.42"
    QString all;                      ///< several lines
    std::array<QColor, 2> slipColour; ///< on light, on dark
};

} // namespace teleta::view3d
