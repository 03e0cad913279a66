// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/track_envelope.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

#include <atomic>
#include <optional>
#include <vector>

namespace teleta::pattern {

/// Where two patterns may do something else; empty: they do the same. Names and the like do not count.
/// Thread: any (pure).
[[nodiscard]] std::optional<Span> changedSpan(const Pattern& before, const Pattern& after);

/// What the motors do with a whole pattern, kept as ranges over even stretches of time, so that hours of it
/// can be drawn. It is computed once and, after an edit, only from there until the motors have forgotten it.
/// Thread: any, it does not change after construction.
class MotorPrediction {
public:
    /// Longer patterns are not predicted as a whole.
    static constexpr double kLongest_s = 4.0 * 3600.0;
    static constexpr double kFinestBin_s = 0.02;
    static constexpr std::size_t kMostBins = 1U << 17U;

    struct Bin {
        float low = 0.0F; ///< predicted intensities
        float high = 0.0F;
        float apart = 0.0F; ///< largest |commanded - predicted|
    };

    /// Nothing when it was cancelled or the pattern is longer than kLongest_s. motors: valid().
    /// before, with the span that changed since (changedSpan()): is used as far as it holds.
    [[nodiscard]] static std::optional<MotorPrediction>
    of(const CompiledPattern& pattern, const MotorProfiles& motors, const std::atomic<bool>& cancelled,
       const MotorPrediction* before = nullptr, const Span& changed = {});

    /// Of one tactor over [begin, end]; zeros outside of the pattern.
    [[nodiscard]] Bin over(std::size_t tactor, double begin_s, double end_s) const;
    /// Bins that the last computation went through; all others were taken over.
    [[nodiscard]] std::size_t computedBins() const { return m_computed; }
    [[nodiscard]] std::size_t bins() const { return m_bins[0].size(); }

private:
    static constexpr std::size_t kBlock = 32;

    void makeLevels();

    double m_duration_s = 0.0;
    double m_bin_s = kFinestBin_s;
    MotorProfiles m_motors;
    std::array<std::vector<Bin>, core::kTactors> m_bins;
    /// Joined bins: each level of kBlock of the level below.
    std::array<std::vector<std::vector<Bin>>, core::kTactors> m_levels;
    std::size_t m_computed = 0;
};

} // namespace teleta::pattern
