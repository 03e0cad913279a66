// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/psychometric_function.h"

#include "backend/core/words.h"

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace teleta::study {

namespace {

constexpr core::Words<RiseShape, 3> kRiseShapes{{"gauss", "logistic", "weibull"}};

} // namespace

const char* toString(RiseShape shape) {
    return kRiseShapes.of(shape);
}

std::optional<RiseShape> riseShapeOf(std::string_view word) {
    return kRiseShapes.find(word);
}

double riseOf(RiseShape shape, double level, double threshold, double spread) {
    switch (shape) {
    case RiseShape::gauss:
        return 0.5 * std::erfc((threshold - level) / (spread * std::numbers::sqrt2));
    case RiseShape::logistic:
        return 1.0 / (1.0 + std::exp((threshold - level) / spread));
    case RiseShape::weibull:
        break;
    }
    if (level <= 0.0)
        return 0.0;
    return -std::expm1(-std::numbers::ln2 * std::pow(level / threshold, spread));
}

std::optional<double> PsychometricFunction::levelOf(double share) const {
    const double rise = (share - guess) / (1.0 - guess - lapse);
    if (!(rise > 0.0 && rise < 1.0))
        return std::nullopt;
    switch (shape) {
    case RiseShape::gauss:
        return threshold - spread * std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * rise);
    case RiseShape::logistic:
        return threshold + spread * (std::log(rise) - std::log1p(-rise));
    case RiseShape::weibull:
        break;
    }
    return threshold * std::pow(-std::log1p(-rise) / std::numbers::ln2, 1.0 / spread);
}

} // namespace teleta::study
