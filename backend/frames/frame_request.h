// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::frames {

/// Which dimension of an array counts the frames.
enum class FrameAxis {
    automatic, ///< the last if only that one is as long as time_s, else the first
    first,     ///< frames x rows x columns, or frames x taxels
    last,      ///< rows x columns x frames, or taxels x frames
};

/// Columns of a table, counted from 1; both ends belong to it.
struct ColumnRange {
    std::size_t first = 1;
    std::size_t last = 1;
};

/// An array whose places and components a file of its own describes.
struct KnownArray {
    core::TaxelLayout layout{};
    std::size_t numbers = 0; ///< of a frame, as the sensor tells it
    /// From these numbers to a frame of the layout, layout.values() entries.
    std::function<void(std::span<const float> numbers, std::span<float> frame)> place{};
    std::string unit{}; ///< of the values, where the frames do not tell it
};

/// What is known of a file of frames. What is left out follows from the file.
struct FrameRequest {
    std::string path{};        ///< of the file
    std::optional<int> rows{}; ///< of the array
    std::optional<int> columns{};
    /// Where neither the file nor rows and columns say the shape: the likely array of so many taxels;
    /// otherwise 6 x 14.
    bool guessesShape = false;
    /// Instead of rows, columns and pitch. Frames in the order of the layout stay as they are: those of our
    /// own tables, of arrays with positions_m beside, and of rows x columns of a grid of loads.
    std::optional<KnownArray> known{};
    std::string knownPath{}; ///< of the layout file from which the caller makes `known`; not read here
    std::optional<double> pitch_m{}; ///< instead of the file's
    std::optional<double> rate_Hz{}; ///< frames per second, of files without times
    bool needsTimes = true;          ///< false: frames without times are a second apart
    std::string array{};             ///< name of the frames among several arrays
    FrameAxis axis = FrameAxis::automatic;
    std::vector<ColumnRange> taxelColumns{}; ///< of a table of another program
    std::string timeColumn{};                ///< of such a table: its name, or its number from 1
    std::string timeUnit{};                  ///< s, ms, us, ns, or iso; empty: as the name says
    /// Load from which a taxel is in contact, in the unit of the values. Reading does not heed it.
    std::optional<double> threshold{};
};

/// The load from which a taxel is in contact where nobody says it: 0.2 N, a single count, and the same for
/// values whose unit is not known. Nothing for other units: noise may be far above it there. Thread: any
/// (pure).
[[nodiscard]] std::optional<double> usualThreshold(std::string_view unit);

/// Columns of a table as text, "2..85" or "2..10,12"; nothing for another text. Thread: any (pure).
[[nodiscard]] std::optional<std::vector<ColumnRange>> columnRangesOf(std::string_view text);

/// The other way round; empty for none. Thread: any (pure).
[[nodiscard]] std::string textOf(const std::vector<ColumnRange>& ranges);

/// What the files have in common that one program writes in one way: what a file is, and of a text the names
/// or the number of its columns. What was said about one of them may be right for the next. Empty for a file
/// that cannot be read. Reads its first bytes. Thread: any.
[[nodiscard]] std::string familyOf(const std::string& path);

} // namespace teleta::frames
