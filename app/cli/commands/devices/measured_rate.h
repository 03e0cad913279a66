// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace teleta::core {
class CameraSource;
class TactileSource;
} // namespace teleta::core

namespace teleta::cli {

/// Starts a source and stops it again. Its frames a second, over a second from its first frame on; empty:
/// fewer than two came. An interruption ends it. Thread: one.
[[nodiscard]] std::optional<double> measuredRate_Hz(core::TactileSource& array);

/// The same; and how large the last picture was.
struct SeenPictures {
    std::optional<double> rate_Hz;
    int width_px = 0;
    int height_px = 0;
};
[[nodiscard]] SeenPictures lookAt(core::CameraSource& camera);

} // namespace teleta::cli
