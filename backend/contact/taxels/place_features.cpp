// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/place_features.h"

#include "backend/contact/automatic_threshold.h"
#include "backend/contact/covariance.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace teleta::contact {

PlaceFeatures::PlaceFeatures(std::shared_ptr<const core::TaxelPlaces> places, const FeatureSettings& settings)
    : m_places(std::move(places))
    , m_types(core::ArrayLayout{1, 1}, settings) {
}

TactileFeatures PlaceFeatures::compute(std::span<const float> load_N, std::span<const std::uint8_t> dead) {
    const FeatureSettings& settings = m_types.settings();
    TactileFeatures features;
    features.threshold_N = settings.threshold_N;
    if (load_N.size() != m_places->size()) {
        reset();
        return features;
    }
    if (dead.size() != load_N.size())
        dead = {};
    const auto isUsable = [&](std::size_t i) {
        return (dead.empty() || dead[i] == 0) && load_N[i] >= 0.0F &&
               load_N[i] <= std::numeric_limits<float>::max();
    };
    float threshold_N = m_types.activeFrom_N();
    if (settings.automaticThreshold) {
        m_usable.clear();
        for (std::size_t i = 0; i < load_N.size(); ++i)
            if (isUsable(i))
                m_usable.push_back(load_N[i]);
        features.threshold_N = std::max(automaticThreshold(m_usable).value_or(0.0), features.threshold_N);
        threshold_N = std::max(threshold_N, static_cast<float>(features.threshold_N));
    }

    m_active.clear();
    double sumX = 0.0, sumY = 0.0, x_m = 0.0, y_m = 0.0;
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        if (!isUsable(i)) {
            ++features.dead;
            continue;
        }
        const bool isActive = load_N[i] >= threshold_N;
        const auto load = static_cast<double>(load_N[i]);
        const core::TaxelPlace& place = (*m_places)[i];
        features.peak_N = std::max(features.peak_N, load);
        if (isActive || settings.range == MomentRange::image) {
            features.force_N += load;
            sumX += load * place.x_m;
            sumY += load * place.y_m;
        }
        if (isActive) {
            m_active.push_back(i);
            x_m += place.x_m;
            y_m += place.y_m;
        }
    }
    features.active = static_cast<int>(m_active.size());
    if (!m_active.empty()) {
        const auto count = static_cast<double>(m_active.size());
        features.copX_m = sumX / features.force_N;
        features.copY_m = sumY / features.force_N;
        features.cocX_m = x_m / count;
        features.cocY_m = y_m / count;
        features.dzmpX_m = *features.copY_m - *features.cocY_m;
        features.dzmpY_m = *features.copX_m - *features.cocX_m;
    }
    addPrincipalAxis(load_N, features);
    return features;
}

void PlaceFeatures::addPrincipalAxis(std::span<const float> load_N, TactileFeatures& features) {
    if (m_active.size() < 2) {
        features.type = m_types.typeOf(features.active, 0.0, 0.0);
        return;
    }
    const bool weighted = m_types.settings().orientation == OrientationMode::weighted;
    const auto weightOf = [&](std::size_t i) {
        return weighted ? static_cast<double>(load_N[i]) / features.peak_N : 1.0;
    };
    // Without the heaviest taxel, beside which the others may be lost: w^2 - sum w_i^2 = 2 w_h r + r^2 - sum
    // r_i^2.
    const std::size_t heaviest = *std::ranges::max_element(m_active, {}, weightOf);
    double rest = 0.0, restSquares = 0.0, meanX_m = 0.0, meanY_m = 0.0;
    for (const std::size_t i : m_active) {
        if (i != heaviest) {
            rest += weightOf(i);
            restSquares += weightOf(i) * weightOf(i);
        }
        meanX_m += weightOf(i) * (*m_places)[i].x_m;
        meanY_m += weightOf(i) * (*m_places)[i].y_m;
    }
    const double w = weightOf(heaviest) + rest;
    const double freedom = 2.0 * weightOf(heaviest) * rest + std::max(0.0, rest * rest - restSquares);
    meanX_m /= w;
    meanY_m /= w;
    Covariance covariance{.scale = w / freedom};
    for (const std::size_t i : m_active) {
        const double x_m = (*m_places)[i].x_m - meanX_m;
        const double y_m = (*m_places)[i].y_m - meanY_m;
        covariance.xx += weightOf(i) * x_m * x_m;
        covariance.xy += weightOf(i) * x_m * y_m;
        covariance.yy += weightOf(i) * y_m * y_m;
    }
    // Taxels above one another are at the same place of the plane.
    if (!(covariance.xx + covariance.yy > 0.0)) {
        features.type = m_types.typeOf(1, 0.0, 0.0);
        return;
    }
    const PrincipalAxis axis = principalAxis(covariance);
    features.lambda1_m2 = axis.lambda1;
    features.lambda2_m2 = axis.lambda2;
    features.alphaZ_rad = axis.angle_rad;
    features.type = m_types.typeOf(features.active, axis.lambda1, axis.lambda2);
}

} // namespace teleta::contact
