// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/calibration_work.h"

#include <algorithm>
#include <utility>

namespace teleta::console {

std::vector<vision::CalibrationPair> CalibrationWork::onSurface() const {
    std::vector<vision::CalibrationPair> moved = pairs;
    for (vision::CalibrationPair& pair : moved)
        pair.p_Sensor_m.head<2>() *= holeFactor;
    return moved;
}

bool CalibrationWork::isJoinedBy(const vision::CalibrationSettings& probed) const {
    return !simulated && holeFactor == 1.0 && settings == probed;
}

void CalibrationWork::add(const vision::CalibrationPair& pair) {
    pairs.push_back(pair);
    used.push_back(true);
}

void CalibrationWork::put(const vision::CalibrationPair& pair) {
    const auto same = std::ranges::find(pairs, pair.p_Sensor_m, &vision::CalibrationPair::p_Sensor_m);
    if (same == pairs.end())
        return add(pair);
    same->pixel = pair.pixel;
    used[static_cast<std::size_t>(same - pairs.begin())] = true;
}

int CalibrationWork::remove(const std::vector<std::size_t>& numbers) {
    CalibrationWork left{{}, {}, settings, simulated, holeFactor};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (std::ranges::find(numbers, i) != numbers.end())
            continue;
        left.pairs.push_back(pairs[i]);
        left.used.push_back(used[i]);
    }
    const auto count = static_cast<int>(pairs.size() - left.pairs.size());
    *this = std::move(left);
    return count;
}

int CalibrationWork::setUsed(const std::vector<std::size_t>& numbers, bool use) {
    int count = 0;
    for (const std::size_t pair : numbers) {
        if (pair >= used.size() || used[pair] == use)
            continue;
        used[pair] = use;
        ++count;
    }
    return count;
}

} // namespace teleta::console
