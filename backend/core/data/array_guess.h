// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <cstddef>
#include <string>

namespace teleta::core {

/// What an array is likely to be, given only the number of its taxels.
struct ArrayGuess {
    ArrayLayout layout;
    std::string unit; ///< of its values
};

/// A known array with this many taxels, otherwise the most nearly square layout, with counts as values.
/// Thread: any (pure).
[[nodiscard]] ArrayGuess guessArray(std::size_t taxels);

/// The recording of the unloaded array beside a recording: "array_left1.csv" -> "array_empty*.csv"; empty:
/// none. Looks into the folder. Thread: any but the GUI's.
[[nodiscard]] std::string unloadedBeside(const std::string& path);

} // namespace teleta::core
