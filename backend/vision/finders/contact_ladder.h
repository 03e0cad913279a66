// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/camera/cylinder_projection.h"
#include "backend/vision/finders/contact_finder.h"

#include <memory>
#include <span>
#include <stop_token>
#include <string_view>

namespace teleta::vision {

/// How the displacement of the skin's pattern is found.
enum class FlowMethod {
    dots,         ///< the printed dots alone, in the full image
    disUltrafast, ///< dense inverse search, OpenCV's presets
    disFast,
    disMedium,
};

/// One way to find contacts: more exact ones take more time.
struct ContactRung {
    std::string_view name;
    FlowMethod method = FlowMethod::dots;
    double scale = 1.0;       ///< of the image that the flow is found in
    bool paper = false;       ///< the paper's: 512 x 288, threshold in pixels, mean of the patch in the image
    bool changedOnly = false; ///< flow only around what differs from the reference
    bool warmStart = false;   ///< from the flow of the frame before
};

/// All rungs; the first is the default.
[[nodiscard]] std::span<const ContactRung> contactLadder();

/// Null for an unknown name.
[[nodiscard]] const ContactRung* contactRung(std::string_view name);

/// What of the skin counts as touched. Lengths on the skin, at any distance from the lens.
struct ContactSettings {
    double threshold_m = 0.00012; ///< of the displacement; > 0
    double prominence = 0.4; ///< two summits are two contacts when the lower one rises by so much of itself
    double dotDiameter_m = 0.0015;  ///< about; > 0
    double paperThreshold_px = 0.3; ///< of the paper's rung, in its small image
};

/// stop: ends the making and the first setReference() before the lens was inverted for each pixel.
/// Error: refused when the camera's image is too small for the rung or too large for the memory, or shows
/// none of the skin; cancelled.
[[nodiscard]] core::Expected<std::unique_ptr<ContactFinder>>
makeContactFinder(const ContactRung& rung, const CylinderCamera& camera, const ContactSettings& settings = {},
                  std::stop_token stop = {});

} // namespace teleta::vision
