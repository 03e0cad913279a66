// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/range_levels.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <vector>

namespace teleta::pattern {

/// The span outside of which two patterns play the same; empty when they play the same everywhere. Names and
/// other texts are ignored. Thread: any (pure).
[[nodiscard]] std::optional<Span> changedSpan(const Pattern& before, const Pattern& after);

/// Predicted behaviour of the motors over a whole pattern, stored as ranges over equal bins of time, so that
/// hours can be drawn. After an edit only the bins from the edit until the motors have settled again are
/// recomputed. Thread: any (immutable).
class MotorPrediction {
public:
    /// Longer patterns are not predicted.
    static constexpr double kLongest_s = 4.0 * 3600.0;
    static constexpr double kFinestBin_s = 0.02;
    static constexpr std::size_t kMostBins = 1U << 17U;

    struct Bin {
        float low = 0.0F; ///< predicted intensities
        float high = 0.0F;
        float apart = 0.0F; ///< largest |commanded - predicted|

        void join(const Bin& other) {
            low = std::min(low, other.low);
            high = std::max(high, other.high);
            apart = std::max(apart, other.apart);
        }
    };

    /// Empty when cancelled or when the pattern is longer than kLongest_s. motors: valid(). before: an
    /// earlier prediction, with the span that has changed since (changedSpan()); its unaffected bins are
    /// reused.
    [[nodiscard]] static std::optional<MotorPrediction>
    of(const CompiledPattern& pattern, const MotorProfiles& motors, const std::atomic<bool>& cancelled,
       const MotorPrediction* before = nullptr, const Span& changed = {});

    /// Range of one tactor over [begin, end]; zeros outside the pattern.
    [[nodiscard]] Bin over(std::size_t tactor, double begin_s, double end_s) const;
    /// Number of bins that were computed; all others were taken from the earlier prediction.
    [[nodiscard]] std::size_t computedBins() const { return m_computed; }
    [[nodiscard]] std::size_t bins() const { return m_bins[0].size(); }

private:
    double m_duration_s = 0.0;
    double m_bin_s = kFinestBin_s;
    MotorProfiles m_motors;
    std::array<std::vector<Bin>, core::kTactors> m_bins;
    std::array<RangeLevels<Bin>, core::kTactors> m_levels;
    std::size_t m_computed = 0;
};

} // namespace teleta::pattern
