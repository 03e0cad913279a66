// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::console {

/// Pairs and the settings of their calibration. Thread: one.
struct CalibrationWork {
    std::vector<vision::CalibrationPair> pairs;
    std::vector<bool> used; ///< one per pair
    vision::CalibrationSettings settings;
    bool simulated = false;  ///< pairs of a simulated tube
    double holeFactor = 1.0; ///< scales x and y of the pairs' points to the surface; > 0

    /// Input of the calibration: the pairs with their points on the surface.
    [[nodiscard]] std::vector<vision::CalibrationPair> onSurface() const;
    /// Whether pairs probed with these settings may be added: these pairs are real, of the same tube and
    /// image, and on its surface.
    [[nodiscard]] bool isJoinedBy(const vision::CalibrationSettings& probed) const;

    void add(const vision::CalibrationPair& pair);
    /// Replaces the pair of the same point, or adds a new one.
    void put(const vision::CalibrationPair& pair);
    /// Returns how many were removed; unknown pairs are ignored.
    int remove(const std::vector<std::size_t>& numbers);
    /// Returns how many changed.
    int setUsed(const std::vector<std::size_t>& numbers, bool use);
};

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
