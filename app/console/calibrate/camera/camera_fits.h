// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::console {

/// What one method makes of pairs.
struct CameraAnswer {
    std::optional<vision::Calibration> calibration;    ///< residuals of all pairs, also of excluded ones
    std::optional<vision::CalibrationRefusal> refusal; ///< why there is none
    std::size_t pairs = 0;                             ///< that were used

    /// The refusal in the language of the program; empty without one.
    [[nodiscard]] QString reason() const;
};
/// One a method, in the order of vision::kCalibrationMethods.
using CameraAnswers = std::array<CameraAnswer, vision::kCalibrationMethods.size()>;

/// Asks all methods. used: one a pair. Thread: any (pure).
[[nodiscard]] CameraAnswers fitAll(const std::vector<vision::CalibrationPair>& pairs,
                                   const std::vector<bool>& used,
                                   const vision::CalibrationSettings& settings);

/// What a camera that was found for one state makes of the pairs of another: nothing says that a pair that
/// was not there is wrong. Empty when no pair was there. Thread: any (pure).
[[nodiscard]] std::vector<vision::PairResidual>
carriedOver(const vision::Calibration& calibration, const std::vector<vision::CalibrationPair>& fitted,
            const std::vector<vision::CalibrationPair>& pairs);

} // namespace teleta::console
