// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/motor_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::pattern {

namespace {

constexpr double kStep_s = 0.002;
/// After this many rise times, each ln 10 time constants, e^-46 of the past is left.
constexpr double kForgottenRises = 20.0;

void widen(std::optional<Span>& span, double begin_s, double end_s) {
    span = span ? Span{std::min(span->begin_s, begin_s), std::max(span->end_s, end_s)} : Span{begin_s, end_s};
}

/// From the last common breakpoint before the change to the first common one after it.
void widenByTrack(std::optional<Span>& span, const Track& a, const Track& b, double end_s) {
    if (a == b)
        return;
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t first = 0;
    while (first < shorter && a[first] == b[first])
        ++first;
    std::size_t last = 0;
    while (last < shorter - first && a[a.size() - 1 - last] == b[b.size() - 1 - last])
        ++last;
    const double from_s = first > 0 ? a[first - 1].time_s : 0.0;
    const double to_s = last > 0 ? a[a.size() - last].time_s : end_s;
    widen(span, from_s, std::max(from_s, to_s));
}

double slowest_s(const MotorProfiles& motors) {
    double slowest_s = 0.0;
    for (const MotorProfile& motor : motors)
        slowest_s = std::max({slowest_s, motor.riseTime_s, motor.fallTime_s});
    return slowest_s;
}

} // namespace

std::optional<Span> changedSpan(const Pattern& before, const Pattern& after) {
    std::optional<Span> span;
    const double end_s = std::max(before.duration_s, after.duration_s);
    if (before.duration_s != after.duration_s)
        widen(span, std::min(before.duration_s, after.duration_s), end_s);
    for (std::size_t i = 0; i < core::kTactors; ++i)
        widenByTrack(span, before.tracks[i], after.tracks[i], end_s);
    const std::size_t most = std::max(before.objects.size(), after.objects.size());
    for (std::size_t k = 0; k < most; ++k) {
        const bool inBoth = k < before.objects.size() && k < after.objects.size();
        if (inBoth && before.objects[k].form == after.objects[k].form)
            continue;
        for (const Pattern* pattern : {&before, &after}) {
            if (k < pattern->objects.size()) {
                const Span its = spanOf(pattern->objects[k].form);
                widen(span, std::clamp(its.begin_s, 0.0, end_s), std::clamp(its.end_s, 0.0, end_s));
            }
        }
    }
    return span;
}

std::optional<MotorPrediction> MotorPrediction::of(const CompiledPattern& pattern,
                                                   const MotorProfiles& motors,
                                                   const std::atomic<bool>& cancelled,
                                                   const MotorPrediction* before, const Span& changed) {
    if (pattern.duration_s() > kLongest_s)
        return std::nullopt;
    MotorPrediction prediction;
    prediction.m_duration_s = pattern.duration_s();
    prediction.m_bin_s = std::max(kFinestBin_s, prediction.m_duration_s / static_cast<double>(kMostBins));
    prediction.m_motors = motors;
    const auto bins = static_cast<std::size_t>(std::ceil(prediction.m_duration_s / prediction.m_bin_s));
    const double forgotten_s = kForgottenRises * slowest_s(motors);
    std::size_t first = 0;
    std::size_t last = bins;
    if (before != nullptr && before->m_duration_s == prediction.m_duration_s && before->m_motors == motors) {
        prediction.m_bins = before->m_bins;
        const auto binOf = [&](double t_s) {
            return std::min(bins, static_cast<std::size_t>(std::max(0.0, t_s) / prediction.m_bin_s));
        };
        first = binOf(changed.begin_s);
        last = std::min(bins, binOf(changed.end_s + forgotten_s) + 1);
    }
    for (auto& track : prediction.m_bins)
        track.resize(bins);
    std::vector<MotorModel> models;
    for (const MotorProfile& motor : motors)
        models.emplace_back(motor);
    const auto stepsPerBin = static_cast<std::size_t>(std::ceil(prediction.m_bin_s / kStep_s));
    const double step_s = prediction.m_bin_s / static_cast<double>(stepsPerBin);
    const auto warmUp = static_cast<std::size_t>(std::ceil(forgotten_s / prediction.m_bin_s));
    for (std::size_t bin = first > warmUp ? first - warmUp : 0; bin < last; ++bin) {
        if (cancelled.load(std::memory_order_relaxed))
            return std::nullopt;
        std::array<Bin, core::kTactors> now;
        now.fill({std::numeric_limits<float>::infinity(), 0.0F, 0.0F});
        for (std::size_t step = 0; step < stepsPerBin; ++step) {
            const core::Intensities asked = pattern.evaluate(static_cast<double>(bin) * prediction.m_bin_s +
                                                             (static_cast<double>(step) + 0.5) * step_s);
            for (std::size_t i = 0; i < core::kTactors; ++i) {
                const double done =
                    intensityOfSpeed(motors[i], models[i].step(driveOf(motors[i], asked[i]), step_s));
                const auto value = static_cast<float>(done);
                now[i].join({value, value, static_cast<float>(std::abs(asked[i] - done))});
            }
        }
        if (bin < first)
            continue;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            prediction.m_bins[i][bin] = now[i];
        ++prediction.m_computed;
    }
    for (std::size_t i = 0; i < core::kTactors; ++i)
        prediction.m_levels[i] =
            RangeLevels<Bin>(bins, [&](std::size_t k) { return prediction.m_bins[i][k]; });
    return prediction;
}

MotorPrediction::Bin MotorPrediction::over(std::size_t tactor, double begin_s, double end_s) const {
    const std::size_t count = bins();
    if (!(end_s >= 0.0 && begin_s <= m_duration_s) || count == 0)
        return {};
    const auto first = std::min(count - 1, static_cast<std::size_t>(std::max(0.0, begin_s) / m_bin_s));
    const auto last = std::min(count, static_cast<std::size_t>(end_s / m_bin_s) + 1);
    Bin all{std::numeric_limits<float>::infinity(), 0.0F, 0.0F};
    m_levels[tactor].join(all, first, last, [&](std::size_t k) { return m_bins[tactor][k]; });
    return all;
}

} // namespace teleta::pattern
