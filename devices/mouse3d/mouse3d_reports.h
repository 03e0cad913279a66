// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace teleta::mouse3d {

/// What a six-axis mouse last told, in counts and in its own axes: x right, y towards the operator, z down;
/// rotations about them, right-handed.
struct RawAxes {
    std::array<std::int16_t, 3> translation{};
    std::array<std::int16_t, 3> rotation{};
    std::uint32_t buttons = 0; ///< bit i: button i is held

    bool operator==(const RawAxes&) const = default;
};

enum class ReportKind {
    axes,    ///< translation, rotation or both
    buttons, ///< which are held
    other,   ///< a report that is not about motion, such as the battery's
    damaged, ///< shorter than its id says
};

/// Takes an input report, with its id first, into the state:
///   01 + 3 x i16              translation
///   01 + 6 x i16              translation and rotation (merged form)
///   02 + 3 x i16              rotation
///   03 + 1 to 4 bytes         buttons, lowest bit first
/// Numbers are little-endian. A damaged report changes nothing. Thread: any (pure).
[[nodiscard]] ReportKind decodeReport(std::span<const std::uint8_t> report, RawAxes& state);

} // namespace teleta::mouse3d
