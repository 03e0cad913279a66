// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <array>

namespace teleta::base {

inline constexpr int kMapEntries = 256;
using ColourMap = std::array<QRgb, kMapEntries>;

/// Perceptually uniform map for pressure that reads the same with and without colour blindness; dark blue to
/// yellow. Source: Nunez, Anderson, Renslow, PLoS ONE 13(7), 2018 (the 256 published colours).
[[nodiscard]] const ColourMap& cividis();

/// Diverging map for residuals: blue below, light grey at the middle, red above; lightness is symmetric.
/// Source: Moreland, Diverging Color Maps for Scientific Visualization, 2009 (interpolation in Msh).
[[nodiscard]] const ColourMap& diverging();

/// Colour of a share 0..1 of a map's range; clamped; NaN gives the lowest colour.
[[nodiscard]] QRgb colourAt(const ColourMap& map, double share);

/// Number of identities with a colour of their own; further ones reuse the colours and are told apart by
/// their labels.
inline constexpr int kIdentityColours = 8;

/// Colour of an identity (contact, tactor, series), from 1. Any two of the eight can be told apart with
/// protanopia, deuteranopia and tritanopia. onDark: for a dark background.
[[nodiscard]] QColor identityColour(int identity, bool onDark);

} // namespace teleta::base
