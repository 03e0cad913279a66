// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_block.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

/// Features of consecutive frames, an array for each of TactileFeatures. A number that is undefined is NaN.
struct FeatureArrays {
    std::span<ContactType> type;
    std::span<double> force_N, copX_m, copY_m, cocX_m, cocY_m, dzmpX_m, dzmpY_m, alphaZ_rad, lambda1_m2,
        lambda2_m2, threshold_N;
    std::span<std::int64_t> active;

    [[nodiscard]] FeatureArrays from(std::size_t frame) const;
    void set(std::size_t frame, const TactileFeatures& features) const;
};

/// The features of a stream of raw frames, many at a time: FrameConditioner and FeatureExtractor, computed
/// for eight frames side by side where the settings and the array's size allow it (fitsBlock(), a fixed
/// threshold, binarised orientation). A frame with dead, negative or infinite loads is computed alone. The
/// features are those of FeatureExtractor; force, CoP and DZMP differ by rounding (momentsOfBlock()). What a
/// frame gives depends on the frames around it only by the memory of its type. Thread: one; compute()
/// allocates nothing.
class FeatureBatch {
public:
    FeatureBatch(const core::ArrayLayout& layout, ConditioningSettings conditioning,
                 const FeatureSettings& settings = {});

    /// raw: whole frames, after those of the last call. out: as many entries or more.
    void compute(std::span<const float> raw, const FeatureArrays& out);

    void reset() { m_extractor.reset(); }

private:
    void computeBlock(const float* raw, std::size_t frames, const FeatureArrays& out);

    core::ArrayLayout m_layout;
    FrameConditioner m_conditioner;
    FeatureExtractor m_extractor;
    bool m_inBlocks = false;

    // Working memory of one block.
    std::vector<float> m_zeros; ///< a frame without load
    std::vector<float> m_load_N;
    std::vector<std::uint8_t> m_dead;
    std::vector<float> m_lanes;
};

} // namespace teleta::contact
