// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::pattern {

inline constexpr std::size_t kStiffnessLevels = 5;

/// What may have been recognised of a shape, with the names and in the order of the recogniser of contours.
inline constexpr std::array<std::string_view, 7> kRecognisedShapes{"circle", "rectangle", "triangle", "arc",
                                                                   "line",   "point",     "unknown"};

/// Which pattern tells the wearer what was recognised. Empty id: nothing is played.
struct PatternMap {
    std::array<std::string, kStiffnessLevels> stiffness;     ///< level 1 (softest) first
    std::array<std::string, kRecognisedShapes.size()> shape; ///< as kRecognisedShapes

    bool operator==(const PatternMap&) const = default;

    /// The built-in dynamic patterns, which wearers tell apart better than the static ones (TeleTA, 6);
    /// nothing for an unknown shape.
    [[nodiscard]] static PatternMap defaults();

    /// Id of the pattern for a level 1..5 or a name of kRecognisedShapes; empty for all others.
    [[nodiscard]] const std::string& ofStiffness(int level) const;
    [[nodiscard]] const std::string& ofShape(std::string_view name) const;
};

} // namespace teleta::pattern
