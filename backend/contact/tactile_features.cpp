// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/tactile_features.h"

#include "backend/contact/automatic_threshold.h"
#include "backend/contact/covariance.h"

#include <algorithm>
#include <array>
#include <limits>

namespace teleta::contact {

namespace {

float usableThreshold(double threshold_N) {
    const auto threshold = static_cast<float>(threshold_N);
    return threshold > 0.0F ? threshold : std::numeric_limits<float>::denorm_min();
}

bool anySet(std::span<const std::uint8_t> mask) {
    std::uint8_t any = 0;
    for (const std::uint8_t value : mask)
        any |= value;
    return any != 0;
}

} // namespace

const char* toString(ContactType type) {
    static constexpr std::array kNames{"none", "point", "edge"};
    return kNames[static_cast<std::size_t>(type)];
}

FeatureExtractor::FeatureExtractor(const core::ArrayLayout& layout, const FeatureSettings& settings)
    : m_layout(layout)
    , m_settings(settings)
    , m_stride(static_cast<std::size_t>(std::max(layout.columns, kMomentLanes)))
    , m_clean(static_cast<std::size_t>(layout.rows) * m_stride, 0.0F) {
    m_usable.reserve(layout.taxels());
}

/// Fills m_clean and m_usable and returns the number of dead taxels.
int FeatureExtractor::clean(std::span<const float> load_N, std::span<const std::uint8_t> dead) {
    const auto columns = static_cast<std::size_t>(m_layout.columns);
    m_usable.clear();
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        const bool usable = load_N[i] >= 0.0F && load_N[i] <= std::numeric_limits<float>::max() &&
                            (dead.empty() || dead[i] == 0);
        m_clean[i / columns * m_stride + i % columns] = usable ? load_N[i] : 0.0F;
        if (usable)
            m_usable.push_back(load_N[i]);
    }
    return static_cast<int>(load_N.size() - m_usable.size());
}

float FeatureExtractor::activeFrom_N() const {
    return usableThreshold(m_settings.threshold_N);
}

TactileFeatures FeatureExtractor::compute(std::span<const float> load_N, std::span<const std::uint8_t> dead) {
    TactileFeatures features;
    features.threshold_N = m_settings.threshold_N;
    if (load_N.size() != m_layout.taxels()) {
        reset();
        return features;
    }
    if (dead.size() != load_N.size())
        dead = {};

    const bool activeOnly = m_settings.range == MomentRange::active;
    const bool plain = m_stride == static_cast<std::size_t>(m_layout.columns) &&
                       !m_settings.automaticThreshold && !anySet(dead);
    float threshold_N = activeFrom_N();
    FrameShape shape{m_layout.rows, m_layout.columns, m_layout.columns};
    std::span<const float> values = load_N;
    FrameMoments moments;
    if (plain)
        moments = momentsOf(values.data(), shape, threshold_N, activeOnly);
    if (!plain || moments.unusable) {
        features.dead = clean(load_N, dead);
        if (m_settings.automaticThreshold) {
            features.threshold_N = std::max(automaticThreshold(m_usable).value_or(0.0), features.threshold_N);
            threshold_N = usableThreshold(features.threshold_N);
        }
        shape.stride = static_cast<int>(m_stride);
        values = m_clean;
        moments = momentsOf(values.data(), shape, threshold_N, activeOnly);
    }

    features.force_N = moments.sum;
    features.peak_N = static_cast<double>(moments.peak);
    features.active = static_cast<int>(moments.active);
    // Without a contact the sum, and therefore its centre, is only noise.
    if (moments.active > 0) {
        features.copX_m = m_layout.pitchX_m * (moments.sumX / moments.sum);
        features.copY_m = m_layout.pitchY_m * (moments.sumY / moments.sum);
        // Twice the distance from the centre is a whole number, so a symmetric contact gives exactly 0.
        const auto twice = 2.0 * static_cast<double>(moments.active);
        features.cocX_m =
            m_layout.pitchX_m *
            (static_cast<double>(2 * moments.x - moments.active * (m_layout.columns - 1)) / twice);
        features.cocY_m = m_layout.pitchY_m *
                          (static_cast<double>(2 * moments.y - moments.active * (m_layout.rows - 1)) / twice);
        features.dzmpX_m = *features.copY_m - *features.cocY_m;
        features.dzmpY_m = *features.copX_m - *features.cocX_m;
    }
    PrincipalAxis axis;
    if (moments.active > 1) {
        const bool weighted = m_settings.orientation == OrientationMode::weighted;
        Covariance covariance =
            weighted ? weightedCovariance(values, shape, threshold_N) : binarisedCovariance(moments);
        covariance.xy *= m_layout.aspect();
        covariance.yy *= m_layout.aspect() * m_layout.aspect();
        axis = principalAxis(covariance);
        features.lambda1_m2 = axis.lambda1 * m_layout.pitchX_m * m_layout.pitchX_m;
        features.lambda2_m2 = axis.lambda2 * m_layout.pitchX_m * m_layout.pitchX_m;
        features.alphaZ_rad = axis.angle_rad;
    }
    features.type = typeOf(moments.active, axis.lambda1, axis.lambda2);
    return features;
}

} // namespace teleta::contact
