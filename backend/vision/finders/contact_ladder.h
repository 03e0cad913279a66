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

/// How the displacement of the pattern on the skin is measured.
enum class FlowMethod {
    dots,         ///< the printed dots only, in the full image
    disUltrafast, ///< dense inverse search with OpenCV's presets
    disFast,
    disMedium,
};

/// One method ("rung") to find contacts; more accurate ones take more time.
struct ContactRung {
    std::string_view name;
    FlowMethod method = FlowMethod::dots;
    double scale = 1.0; ///< scale of the image in which the flow is computed
    bool paper =
        false; ///< the paper's method: 512 x 288, threshold in pixels, mean of the patch in the image
    bool changedOnly = false; ///< compute the flow only where the image differs from the reference
    bool warmStart = false;   ///< start from the flow of the previous frame
};

/// All methods; the first is the default.
[[nodiscard]] std::span<const ContactRung> contactLadder();

/// The method with this name, or null.
[[nodiscard]] const ContactRung* contactRung(std::string_view name);

/// What counts as a contact. Lengths are on the skin, at any distance from the lens.
struct ContactSettings {
    double threshold_m = 0.00012; ///< least displacement; > 0
    double prominence = 0.4; ///< two summits are two contacts when the lower one rises above its saddle by
                             ///< this share of itself
    double dotDiameter_m = 0.0015;  ///< approximate; > 0
    double paperThreshold_px = 0.3; ///< of the paper's method, in its small image
    /// >= 1; that may look for dots in a frame at once, from OpenCV's pool of threads. The contacts are the
    /// same to the last bit. The dense methods do not use it.
    int cores = 1;
};

/// Creates a contact finder. stop: cancels the creation and the first setReference(), which invert the lens
/// for each pixel. Error: refused when the image of the camera is too small for the method, too large for the
/// memory, or does not show the skin; cancelled. Thread: any.
[[nodiscard]] core::Expected<std::unique_ptr<ContactFinder>>
makeContactFinder(const ContactRung& rung, const CylinderCamera& camera, const ContactSettings& settings = {},
                  std::stop_token stop = {});

} // namespace teleta::vision
