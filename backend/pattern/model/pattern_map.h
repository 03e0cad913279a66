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

/// Shapes that can be recognised; names and order as contour::Shape.
inline constexpr std::array<std::string_view, 7> kRecognisedShapes{"circle", "rectangle", "triangle", "arc",
                                                                   "line",   "point",     "unknown"};

/// Which pattern tells the wearer what was recognised. An empty id plays nothing.
struct PatternMap {
    std::array<std::string, kStiffnessLevels> stiffness;     ///< level 1 (softest) first
    std::array<std::string, kRecognisedShapes.size()> shape; ///< as kRecognisedShapes
    std::string unknownStiffness;                            ///< of a touch whose stiffness is not reliable

    bool operator==(const PatternMap&) const = default;

    /// The built-in dynamic patterns, which wearers distinguish better than the static ones (TeleTA, 6); none
    /// for an unknown shape.
    [[nodiscard]] static PatternMap defaults();

    /// Id of the pattern for a level 1..5 or a name of kRecognisedShapes; empty for any other.
    [[nodiscard]] const std::string& ofStiffness(int level) const;
    [[nodiscard]] const std::string& ofShape(std::string_view name) const;
};

} // namespace teleta::pattern
