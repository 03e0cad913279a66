// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/feature_batch.h"

#include "backend/contact/covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::contact {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// The numbers of a block's frames and of their axes. Where one is undefined, it is any number.
struct BlockFeatures {
    template <typename T>
    using Each = BlockMoments::Each<T>;

    Each<double> copX_m, copY_m, cocX_m, cocY_m, lambda1_m2, lambda2_m2;
    Each<double> lambda1, lambda2;              ///< widths of a cell^2; 0 for less than two taxels
    Each<double> xy, difference, root, rounded; ///< of the covariance; it has an axis when root > rounded
};

/// The formulas of FeatureExtractor and principalAxis(), in loops without a branch, which compilers turn into
/// vector instructions. No divisor is 0, which would raise a floating-point exception.
void describeBlock(const BlockMoments& moments, const core::ArrayLayout& layout, BlockFeatures& out) {
    const double aspect = layout.aspect();
    const double pitch_m = layout.pitchX_m;
    const std::int32_t columns = layout.columns;
    const std::int32_t rows = layout.rows;
    BlockMoments::Each<double> sum, taxels, pairs;
    for (std::size_t i = 0; i < kBlockFrames; ++i) {
        sum[i] = moments.sum[i] > 0.0 ? moments.sum[i] : 1.0;
        taxels[i] = std::max(1, moments.active[i]);
        pairs[i] = std::max(1, moments.active[i] * (moments.active[i] - 1));
    }
    for (std::size_t i = 0; i < kBlockFrames; ++i) {
        const std::int32_t n = moments.active[i];
        out.copX_m[i] = layout.pitchX_m * (moments.sumX[i] / sum[i]);
        out.copY_m[i] = layout.pitchY_m * (moments.sumY[i] / sum[i]);
        out.cocX_m[i] = layout.pitchX_m * ((2 * moments.x[i] - n * (columns - 1)) / (2.0 * taxels[i]));
        out.cocY_m[i] = layout.pitchY_m * ((2 * moments.y[i] - n * (rows - 1)) / (2.0 * taxels[i]));
    }
    for (std::size_t i = 0; i < kBlockFrames; ++i) {
        const double n = moments.active[i];
        const double x = moments.x[i];
        const double y = moments.y[i];
        // All exact where the cells are square: see fitsBlock().
        const double xx = n * moments.xx[i] - x * x;
        const double xy = aspect * (n * moments.xy[i] - x * y);
        const double yy = aspect * aspect * (n * moments.yy[i] - y * y);
        const double trace = xx + yy;
        const double difference = xx - yy;
        const double root = std::sqrt(difference * difference + 4.0 * xy * xy);
        const double larger = 0.5 * (trace + root);
        const double smaller = (xx * yy - xy * xy) / (larger > 0.0 ? larger : 1.0);
        const double scale = 1.0 / pairs[i];
        out.lambda1[i] = larger * scale;
        out.lambda2[i] = smaller * scale;
        out.lambda1_m2[i] = larger * scale * pitch_m * pitch_m;
        out.lambda2_m2[i] = smaller * scale * pitch_m * pitch_m;
        out.xy[i] = xy;
        out.difference[i] = difference;
        out.root[i] = root;
        out.rounded[i] = kIsotropy * trace;
    }
}

} // namespace

FeatureArrays FeatureArrays::from(std::size_t frame) const {
    return {type.subspan(frame),       force_N.subspan(frame),    copX_m.subspan(frame),
            copY_m.subspan(frame),     cocX_m.subspan(frame),     cocY_m.subspan(frame),
            dzmpX_m.subspan(frame),    dzmpY_m.subspan(frame),    alphaZ_rad.subspan(frame),
            lambda1_m2.subspan(frame), lambda2_m2.subspan(frame), threshold_N.subspan(frame),
            active.subspan(frame)};
}

void FeatureArrays::set(std::size_t frame, const TactileFeatures& features) const {
    type[frame] = features.type;
    force_N[frame] = features.force_N;
    copX_m[frame] = features.copX_m.value_or(kUndefined);
    copY_m[frame] = features.copY_m.value_or(kUndefined);
    cocX_m[frame] = features.cocX_m.value_or(kUndefined);
    cocY_m[frame] = features.cocY_m.value_or(kUndefined);
    dzmpX_m[frame] = features.dzmpX_m.value_or(kUndefined);
    dzmpY_m[frame] = features.dzmpY_m.value_or(kUndefined);
    alphaZ_rad[frame] = features.alphaZ_rad.value_or(kUndefined);
    lambda1_m2[frame] = features.lambda1_m2.value_or(kUndefined);
    lambda2_m2[frame] = features.lambda2_m2.value_or(kUndefined);
    threshold_N[frame] = features.threshold_N;
    active[frame] = features.active;
}

FeatureBatch::FeatureBatch(const core::ArrayLayout& layout, ConditioningSettings conditioning,
                           const FeatureSettings& settings)
    : m_layout(layout)
    , m_conditioner(layout.taxels(), std::move(conditioning))
    , m_extractor(layout, settings)
    , m_inBlocks(fitsBlock(layout) && !settings.automaticThreshold &&
                 settings.orientation == OrientationMode::binarised)
    , m_zeros(layout.taxels(), 0.0F)
    , m_load_N(kBlockFrames * layout.taxels())
    , m_dead(layout.taxels())
    , m_lanes(kBlockFrames * layout.taxels()) {
}

void FeatureBatch::compute(std::span<const float> raw, const FeatureArrays& out) {
    const std::size_t taxels = m_layout.taxels();
    const std::size_t frames = raw.size() / taxels;
    for (std::size_t first = 0; first < frames; first += kBlockFrames)
        computeBlock(raw.data() + first * taxels, std::min(kBlockFrames, frames - first), out.from(first));
}

void FeatureBatch::computeBlock(const float* raw, std::size_t frames, const FeatureArrays& out) {
    const std::size_t taxels = m_layout.taxels();
    std::array<const float*, kBlockFrames> together;
    together.fill(m_zeros.data());
    BlockMoments::Each<bool> alone{};
    for (std::size_t i = 0; i < frames; ++i) {
        const float* const frame = raw + i * taxels;
        if (m_inBlocks && m_conditioner.changesNothing()) {
            alone[i] = !isUsable(frame, taxels);
            together[i] = alone[i] ? m_zeros.data() : frame;
        } else if (m_inBlocks) {
            const std::span load_N(m_load_N.data() + i * taxels, taxels);
            alone[i] = m_conditioner.apply({frame, taxels}, load_N, m_dead) > 0;
            together[i] = alone[i] ? m_zeros.data() : load_N.data();
        } else {
            alone[i] = true;
        }
    }

    BlockMoments moments;
    BlockFeatures features;
    if (m_inBlocks) {
        momentsOfBlock(together, m_layout, m_extractor.activeFrom_N(),
                       m_extractor.settings().range == MomentRange::active, m_lanes.data(), moments);
        describeBlock(moments, m_layout, features);
    }
    for (std::size_t i = 0; i < frames; ++i) {
        if (alone[i]) {
            const std::span load_N(m_load_N.data(), taxels);
            const bool anyDead = m_conditioner.apply({raw + i * taxels, taxels}, load_N, m_dead) > 0;
            out.set(i, m_extractor.compute(load_N, anyDead ? m_dead : std::span<const std::uint8_t>()));
            continue;
        }
        const std::int32_t active = moments.active[i];
        out.type[i] = m_extractor.typeOf(active, features.lambda1[i], features.lambda2[i]);
        out.force_N[i] = moments.sum[i];
        const auto ifTouched = [active](double number) { return active > 0 ? number : kUndefined; };
        out.copX_m[i] = ifTouched(features.copX_m[i]);
        out.copY_m[i] = ifTouched(features.copY_m[i]);
        out.cocX_m[i] = ifTouched(features.cocX_m[i]);
        out.cocY_m[i] = ifTouched(features.cocY_m[i]);
        out.dzmpX_m[i] = ifTouched(features.copY_m[i] - features.cocY_m[i]);
        out.dzmpY_m[i] = ifTouched(features.copX_m[i] - features.cocX_m[i]);
        out.alphaZ_rad[i] = active > 1 && features.root[i] > features.rounded[i]
                                ? axisAngle_rad(features.xy[i], features.difference[i])
                                : kUndefined;
        out.lambda1_m2[i] = active > 1 ? features.lambda1_m2[i] : kUndefined;
        out.lambda2_m2[i] = active > 1 ? features.lambda2_m2[i] : kUndefined;
        out.threshold_N[i] = m_extractor.settings().threshold_N;
        out.active[i] = active;
    }
}

} // namespace teleta::contact
