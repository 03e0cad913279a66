// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/charts/feature_history.h"
#include "widgets/charts/polyline.h"

#include <QString>

#include <array>
#include <cstddef>
#include <vector>

namespace teleta::charts {

/// One chart in the stack.
enum class Strip {
    force,
    positionX,
    positionY,
    dzmp,
    orientation,
    spread,
    ratio,
    active,
    shear, ///< of arrays of vectors, as the next one
    friction
};
inline constexpr std::size_t kStrips = 10;
/// From top to bottom.
inline constexpr std::array<Strip, kStrips> kAllStrips{
    Strip::force, Strip::shear,       Strip::friction, Strip::positionX, Strip::positionY,
    Strip::dzmp,  Strip::orientation, Strip::spread,   Strip::ratio,     Strip::active};

/// A text to translate, and what its translators need to know.
struct StripText {
    const char* text = nullptr;
    const char* comment = nullptr;
};

/// Constant description of a strip.
struct StripDefinition {
    Strip strip = Strip::force;
    StripText title;
    const char* unit = ""; ///< on the axis; empty for forces, which have that of the load
    std::vector<CurveStyle> curves;
    double minimumSpan = 1.0;               ///< of the automatic axis, in displayed units
    bool fromZero = false;                  ///< the automatic axis contains 0
    double fixedLow = 0.0, fixedHigh = 0.0; ///< the axis when fixedLow < fixedHigh
    double fixedStep = 0.0;                 ///< of its ticks
    bool shownAtFirst = true;
    bool ofVectors = false; ///< only arrays of vectors have it
};

[[nodiscard]] const StripDefinition& definitionOf(Strip strip);

/// Texts of the strips, translated on every call.
[[nodiscard]] QString titleOf(Strip strip);
[[nodiscard]] QString nameOf(Channel channel);

} // namespace teleta::charts
