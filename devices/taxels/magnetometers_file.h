// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"
#include "devices/taxels/frames/frame_format.h"
#include "devices/taxels/taxels_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace teleta::taxels {

inline constexpr int kFewestChips = 1;
inline constexpr int kMostChips = 64;

/// Skins of magnetometers, AnySkin and ReSkin, as described arrays: the field of each chip in uT, as a
/// vector, the temperatures as other numbers, in degC, at rest the median of 50 frames. Formats: "binary",
/// per chip four float32 t, x, y, z, then 0D 0A; "reskin_text", per chip x, y, z, t between tabs. Sources:
/// raunaqbhirangi/anyskin at cb13b5b, raunaqbhirangi/reskin_sensor at b82de2a.
struct MagnetometersFile {
    TaxelsFile taxels;

    void describeKeys(core::Keys& keys);
};

/// Frames of so many chips as both skins send them in binary. Believed with finite values, |B| < 1e6 uT and
/// -40 <= t <= 125 degC.
[[nodiscard]] BinaryFormat magnetometerFrames(std::size_t chips);

/// How many chips, 4 to kMostChips, the board has that sent these bytes, by the distances of the ends of
/// frames; nothing: no three frames in a row of any. Thread: any (pure).
[[nodiscard]] std::optional<int> chipsOf(std::span<const std::uint8_t> bytes);

} // namespace teleta::taxels
