// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "widgets/pattern/document/pattern_overview.h"

#include <array>
#include <vector>

namespace teleta::pattern {

/// A motor whose predicted intensity differs more than this from the commanded one cannot follow.
inline constexpr double kFollowTolerance = 0.1;
/// Longer spans are drawn as ranges (TimelineBands).
inline constexpr double kLongestPrediction_s = PatternOverview::kShortest_s;

/// Samples of a span of a pattern, ready for drawing.
struct TimelineCurves {
    std::vector<double> times_s;
    std::array<std::vector<double>, core::kTactors> commanded;
    std::array<std::vector<double>, core::kTactors> predicted; ///< empty: not predicted

    [[nodiscard]] bool hasPrediction() const { return !predicted[0].empty(); }
};

/// Samples a span at `samples` times or more, and on both sides of each breakpoint unless there are too many
/// to distinguish. The prediction (if `predicts`) starts early enough before the span for the motors to have
/// settled. The time depends on the visible part only, not on the length of the pattern. Thread: any (pure).
[[nodiscard]] TimelineCurves sampleCurves(const Pattern& pattern, const CompiledPattern& compiled,
                                          const MotorProfiles& motors, Span span, int samples,
                                          bool predicts = true);

/// A span of a long pattern as one range per column of pixels.
struct TimelineBands {
    struct Band {
        std::vector<ValueRange> commanded;
        std::vector<MotorPrediction::Bin> predicted; ///< empty: not predicted
    };
    double begin_s = 0.0;
    double column_s = 0.0;
    std::array<Band, core::kTactors> tracks;

    [[nodiscard]] bool empty() const { return tracks[0].commanded.empty(); }
    [[nodiscard]] bool hasPrediction() const { return !tracks[0].predicted.empty(); }
};

/// predicted: may be null. columns: >= 1. Thread: any (pure).
[[nodiscard]] TimelineBands bandsOf(const TrackEnvelopes& commanded, const MotorPrediction* predicted,
                                    Span span, int columns);

/// Ranges from samples; a column without a sample has the value of the previous one. curves: sampled over
/// span, not empty. columns: >= 1. Thread: any (pure).
[[nodiscard]] TimelineBands bandsOf(const TimelineCurves& curves, Span span, int columns);

/// Tactors that an object can use, in ascending order.
[[nodiscard]] std::vector<std::size_t> tactorsOf(const ObjectForm& form);

} // namespace teleta::pattern
