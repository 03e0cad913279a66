// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace teleta::pattern {

/// The devices of .tact files for the forearm, and their common layout.
inline constexpr const char* kTactLeft = "ForearmL";
inline constexpr const char* kTactRight = "ForearmR";
inline constexpr const char* kTactLayout = "Tactosy2";

/// Place of a motor in the layout, 0..1 each: two rows (y) of three motors (x).
struct TactPlace {
    double x = 0.0;
    double y = 0.0;
};

[[nodiscard]] constexpr TactPlace tactPlace(std::size_t motor) {
    return {0.5 * static_cast<double>(motor % 3), static_cast<double>(motor / 3)};
}

} // namespace teleta::pattern
