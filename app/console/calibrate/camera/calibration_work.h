// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <cstddef>
#include <vector>

namespace teleta::console {

/// Pairs and what they are calibrated with. Thread: one.
struct CalibrationWork {
    std::vector<vision::CalibrationPair> pairs;
    std::vector<bool> used; ///< one a pair
    vision::CalibrationSettings settings;
    bool simulated = false;  ///< pairs of a simulated tube
    double holeFactor = 1.0; ///< of x and y: from the pairs' points to the surface; > 0

    /// What is calibrated with: the pairs with their points on the surface.
    [[nodiscard]] std::vector<vision::CalibrationPair> onSurface() const;
    /// Whether touches of a tube may join the pairs: real ones, of this tube and image, on its surface.
    [[nodiscard]] bool isJoinedBy(const vision::CalibrationSettings& probed) const;

    void add(const vision::CalibrationPair& pair);
    /// In place of the pair of the same point, or as a new one.
    void put(const vision::CalibrationPair& pair);
    /// Returns how many there were; pairs that do not exist are ignored.
    int remove(const std::vector<std::size_t>& numbers);
    /// Returns how many it changed.
    int setUsed(const std::vector<std::size_t>& numbers, bool use);
};

} // namespace teleta::console
