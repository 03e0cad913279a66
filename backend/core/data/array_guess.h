// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <cstddef>
#include <string>

namespace teleta::core {

/// What an array is likely to be of which only the number of taxels is known.
struct ArrayGuess {
    ArrayLayout layout;
    std::string unit; ///< of its values
};

/// A known array with so many taxels, or else the most square layout. The values of one that is not known are
/// counts until somebody says otherwise. Thread: any (pure).
[[nodiscard]] ArrayGuess guessArray(std::size_t taxels);

/// The recording of the unloaded array beside a recording: "array_left1.csv" -> "array_empty*.csv"; empty:
/// none. Looks into the folder. Thread: any but the GUI's.
[[nodiscard]] std::string unloadedBeside(const std::string& path);

} // namespace teleta::core
