// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/procedure_settings.h"

#include "backend/core/words.h"

#include <cmath>
#include <limits>

namespace teleta::study {

namespace {

constexpr core::Words<LevelScale, 2> kLevelScales{{"linear", "log10"}};

} // namespace

const char* toString(LevelScale scale) {
    return kLevelScales.of(scale);
}

std::optional<LevelScale> levelScaleOf(std::string_view word) {
    return kLevelScales.find(word);
}

double onScale(LevelScale scale, double level) {
    if (scale == LevelScale::linear)
        return level;
    return level == 0.0 ? -std::numeric_limits<double>::infinity() : std::log10(level);
}

double fromScale(LevelScale scale, double place) {
    return scale == LevelScale::linear ? place : std::pow(10.0, place);
}

const char* nameOf(const Procedure& procedure) {
    constexpr const char* kNames[] = {"constant", "staircase", "bayes"};
    return kNames[procedure.index()];
}

double targetShare(const StaircaseSettings& settings) {
    return std::pow(settings.stepUp / (settings.stepUp + settings.stepDown),
                    1.0 / static_cast<double>(settings.down));
}

} // namespace teleta::study
