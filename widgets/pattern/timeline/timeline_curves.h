// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "widgets/pattern/document/pattern_overview.h"

#include <array>
#include <vector>

namespace teleta::editor {

/// A motor that is further from what is asked of it than this does not follow.
inline constexpr double kFollowTolerance = 0.1;
/// Longer stretches are drawn by their ranges (TimelineBands).
inline constexpr double kLongestPrediction_s = PatternOverview::kShortest_s;

/// Samples of a stretch of a pattern, ready to be drawn.
struct TimelineCurves {
    std::vector<double> times_s;
    std::array<std::vector<double>, core::kTactors> commanded;
    std::array<std::vector<double>, core::kTactors> predicted; ///< empty: not predicted

    [[nodiscard]] bool hasPrediction() const { return !predicted[0].empty(); }
};

/// Samples [begin_s, end_s] at least so many times, and on both sides of each breakpoint unless these are too
/// many to be told apart. What is predicted (unless it is not wanted) begins long enough before begin_s to
/// have forgotten its start. Takes time in proportion to what is visible, whatever the length of the pattern.
/// Thread: any (pure).
[[nodiscard]] TimelineCurves sampleCurves(const pattern::Pattern& pattern,
                                          const pattern::CompiledPattern& compiled,
                                          const pattern::MotorProfiles& motors, pattern::Span span,
                                          int samples, bool predicts = true);

/// A stretch of a long pattern as one range a column of pixels.
struct TimelineBands {
    struct Band {
        std::vector<pattern::ValueRange> commanded;
        std::vector<pattern::MotorPrediction::Bin> predicted; ///< empty: not predicted
    };
    double begin_s = 0.0;
    double column_s = 0.0;
    std::array<Band, core::kTactors> tracks;

    [[nodiscard]] bool empty() const { return tracks[0].commanded.empty(); }
    [[nodiscard]] bool hasPrediction() const { return !tracks[0].predicted.empty(); }
};

/// predicted: may be null. columns: >= 1. Thread: any (pure).
[[nodiscard]] TimelineBands bandsOf(const TrackEnvelopes& commanded,
                                    const pattern::MotorPrediction* predicted, pattern::Span span,
                                    int columns);

/// The ranges of samples; a column without one has the value of the sample before it. curves: sampled over
/// span, not empty. columns: >= 1. Thread: any (pure).
[[nodiscard]] TimelineBands bandsOf(const TimelineCurves& curves, pattern::Span span, int columns);

/// Tactors that an object may use, in rising order.
[[nodiscard]] std::vector<std::size_t> tactorsOf(const pattern::ObjectForm& form);

} // namespace teleta::editor
