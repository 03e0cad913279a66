// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::console {

/// Result of one method.
struct CameraAnswer {
    std::optional<vision::Calibration> calibration; ///< with residuals of all pairs, including excluded ones
    std::optional<vision::CalibrationRefusal> refusal; ///< why there is none
    std::size_t pairs = 0;                             ///< number of pairs used

    /// The refusal, translated; empty without one.
    [[nodiscard]] QString reason() const;
};
/// One per method, in the order of vision::kCalibrationMethods.
using CameraAnswers = std::array<CameraAnswer, vision::kCalibrationMethods.size()>;

/// Fits with all methods. used: one per pair. Thread: any (pure).
[[nodiscard]] CameraAnswers fitAll(const std::vector<vision::CalibrationPair>& pairs,
                                   const std::vector<bool>& used,
                                   const vision::CalibrationSettings& settings);

/// Applies a camera that was found for one set of pairs to another: new pairs are not marked as wrong. Empty
/// if none of the pairs was in the first set. Thread: any (pure).
[[nodiscard]] std::vector<vision::PairResidual>
carriedOver(const vision::Calibration& calibration, const std::vector<vision::CalibrationPair>& fitted,
            const std::vector<vision::CalibrationPair>& pairs);

} // namespace teleta::console
