// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/calibration_work.h"

#include "backend/vision/calibration/camera_file.h"

#include <algorithm>
#include <utility>

namespace teleta::console {

using vision::CalibrationPair;

namespace {

/// Assigns the residuals to all pairs and adds those of the excluded ones.
void spreadResiduals(vision::Calibration& calibration, const std::vector<CalibrationPair>& pairs,
                     const std::vector<bool>& used) {
    std::vector<vision::PairResidual> all;
    std::size_t next = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        all.push_back(used[i] ? calibration.residuals[next++]
                              : vision::residualOf(calibration.camera, pairs[i]));
    }
    calibration.residuals = std::move(all);
}

} // namespace

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

QString CameraAnswer::reason() const {
    return refusal ? QString::fromStdString(vision::describe(*refusal, pairs).message) : QString();
}

CameraAnswers fitAll(const std::vector<CalibrationPair>& pairs, const std::vector<bool>& used,
                     const vision::CalibrationSettings& settings) {
    std::vector<CalibrationPair> chosen;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (used[i])
            chosen.push_back(pairs[i]);
    }
    CameraAnswers answers;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        answers[i].pairs = chosen.size();
        auto calibration = vision::calibrate(chosen, settings, vision::kCalibrationMethods[i]);
        if (!calibration) {
            answers[i].refusal = calibration.error();
            continue;
        }
        spreadResiduals(*calibration, pairs, used);
        answers[i].calibration = std::move(*calibration);
    }
    return answers;
}

std::vector<vision::PairResidual> carriedOver(const vision::Calibration& calibration,
                                              const std::vector<CalibrationPair>& fitted,
                                              const std::vector<CalibrationPair>& pairs) {
    std::vector<vision::PairResidual> residuals;
    bool any = false;
    for (const CalibrationPair& pair : pairs) {
        const auto same = std::ranges::find_if(fitted, [&](const CalibrationPair& other) {
            return other.pixel == pair.pixel && other.p_Sensor_m == pair.p_Sensor_m;
        });
        if (same != fitted.end()) {
            residuals.push_back(calibration.residuals[static_cast<std::size_t>(same - fitted.begin())]);
            any = true;
            continue;
        }
        residuals.push_back(vision::residualOf(calibration.camera, pair));
        residuals.back().kept = true;
    }
    return any ? residuals : std::vector<vision::PairResidual>();
}

} // namespace teleta::console
