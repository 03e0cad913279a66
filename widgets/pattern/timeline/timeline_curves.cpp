// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/timeline_curves.h"

#include "backend/core/bracelet/tactors.h"
#include "widgets/pattern/document/edit_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace teleta::pattern {

namespace {

constexpr double kModelStep_s = 0.002;
/// A motor settles by e^-1 per time constant; after this many rise times e^-46 is left.
constexpr double kWarmUpRises = 20.0;
constexpr std::size_t kBreakpointsPerSample = 2;

std::vector<double> timesIn(const Pattern& pattern, Span span, int samples) {
    std::vector<double> times_s;
    const int count = std::max(samples, 2);
    times_s.reserve(static_cast<std::size_t>(count) * 2);
    for (int k = 0; k < count; ++k)
        times_s.push_back(span.begin_s + (span.end_s - span.begin_s) * k / (count - 1));
    std::size_t visible = 0;
    for (const Track& track : pattern.tracks)
        visible += firstFrom(track, span.end_s) - firstFrom(track, span.begin_s);
    const auto corner = [&](double time_s) {
        if (time_s >= span.begin_s && time_s <= span.end_s) {
            times_s.push_back(std::nextafter(time_s, -std::numeric_limits<double>::infinity()));
            times_s.push_back(time_s);
        }
    };
    if (visible <= kBreakpointsPerSample * static_cast<std::size_t>(count)) {
        for (const Track& track : pattern.tracks)
            for (std::size_t i = firstFrom(track, span.begin_s);
                 i < track.size() && track[i].time_s <= span.end_s; ++i)
                corner(track[i].time_s);
    }
    for (const PatternObject& object : pattern.objects) {
        const Span its = spanOf(object.form);
        corner(its.begin_s);
        corner(its.end_s);
    }
    corner(pattern.duration_s);
    std::sort(times_s.begin(), times_s.end());
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    return times_s;
}

void predict(TimelineCurves& curves, const CompiledPattern& compiled, const MotorProfiles& motors,
             Span span) {
    double slowest_s = 0.0;
    std::vector<MotorModel> models;
    for (const MotorProfile& motor : motors) {
        slowest_s = std::max({slowest_s, motor.riseTime_s, motor.fallTime_s});
        models.emplace_back(motor);
    }
    double now_s = std::max(0.0, span.begin_s - kWarmUpRises * slowest_s);
    const auto goTo = [&](double time_s) {
        while (now_s < time_s) {
            const double step_s = std::min(kModelStep_s, time_s - now_s);
            const core::Intensities asked = compiled.evaluate(now_s + 0.5 * step_s);
            for (std::size_t i = 0; i < core::kTactors; ++i)
                (void)models[i].step(driveOf(motors[i], asked[i]), step_s);
            now_s = step_s < kModelStep_s ? time_s : now_s + step_s;
        }
    };
    for (const double time_s : curves.times_s) {
        goTo(time_s);
        for (std::size_t i = 0; i < core::kTactors; ++i)
            curves.predicted[i].push_back(intensityOfSpeed(motors[i], models[i].speed_Hz()));
    }
}

} // namespace

TimelineCurves sampleCurves(const Pattern& pattern, const CompiledPattern& compiled,
                            const MotorProfiles& motors, Span span, int samples, bool predicts) {
    TimelineCurves curves;
    curves.times_s = timesIn(pattern, span, samples);
    for (auto& values : curves.commanded)
        values.reserve(curves.times_s.size());
    for (const double time_s : curves.times_s) {
        const core::Intensities intensities = compiled.evaluate(time_s);
        for (std::size_t i = 0; i < core::kTactors; ++i)
            curves.commanded[i].push_back(intensities[i]);
    }
    if (predicts && span.end_s - span.begin_s <= kLongestPrediction_s)
        predict(curves, compiled, motors, span);
    return curves;
}

TimelineBands bandsOf(const TrackEnvelopes& commanded, const MotorPrediction* predicted, Span span,
                      int columns) {
    TimelineBands bands;
    bands.begin_s = span.begin_s;
    bands.column_s = (span.end_s - span.begin_s) / columns;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        TimelineBands::Band& band = bands.tracks[i];
        band.commanded.reserve(static_cast<std::size_t>(columns));
        for (int k = 0; k < columns; ++k) {
            const double begin_s = span.begin_s + k * bands.column_s;
            band.commanded.push_back(commanded[i].over(begin_s, begin_s + bands.column_s));
            if (predicted)
                band.predicted.push_back(predicted->over(i, begin_s, begin_s + bands.column_s));
        }
    }
    return bands;
}

TimelineBands bandsOf(const TimelineCurves& curves, Span span, int columns) {
    TimelineBands bands;
    bands.begin_s = span.begin_s;
    bands.column_s = (span.end_s - span.begin_s) / columns;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        auto& ranges = bands.tracks[i].commanded;
        ranges.reserve(static_cast<std::size_t>(columns));
        std::size_t k = 0;
        for (int column = 0; column < columns; ++column) {
            const double before = curves.commanded[i][k > 0 ? k - 1 : 0];
            ValueRange range{before, before};
            const double end_s = span.begin_s + (column + 1) * bands.column_s;
            for (; k < curves.times_s.size() && curves.times_s[k] < end_s; ++k) {
                const double value = curves.commanded[i][k];
                range = {std::min(range.low, value), std::max(range.high, value)};
            }
            ranges.push_back(range);
        }
    }
    return bands;
}

std::vector<std::size_t> tactorsOf(const ObjectForm& form) {
    std::set<std::size_t> tactors;
    for (const int tactor : listedTactors(form))
        tactors.insert(core::wrappedTactor(tactor));
    return {tactors.begin(), tactors.end()};
}

} // namespace teleta::pattern
