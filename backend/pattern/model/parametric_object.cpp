// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/parametric_object.h"

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/easing.h"
#include "backend/pattern/model/laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::pattern {

namespace {

constexpr int kRing = static_cast<int>(core::kTactors);
constexpr int kMostTurns = 100'000'000; ///< what can be counted; the next onset would be no time away

void raise(core::Intensities& intensities, int tactor, double value) {
    double& intensity = intensities[core::wrappedTactor(tactor)];
    intensity = std::max(intensity, limitedIntensity(value));
}

/// Raises the tactors whose bursts [k onset, k onset + burst) contain the time. tactorOf(k): that of burst k.
template <typename TactorOf>
core::Intensities burstsAt(double time_s, double onset_s, double burst_s, int count, double intensity,
                           const TactorOf& tactorOf) {
    core::Intensities intensities{};
    int first = 0;
    int last = count;
    if (onset_s > 0.0 && std::isfinite(onset_s) && std::isfinite(burst_s)) {
        // One more on either side, since the quotients are rounded.
        const auto index = [&](double k) { return static_cast<int>(std::clamp(k, 0.0, 1.0 * count)); };
        first = index(std::floor((time_s - burst_s) / onset_s) - 1.0);
        last = index(std::floor(time_s / onset_s) + 2.0);
    }
    for (int k = first; k < last; ++k) {
        const double begin_s = k * onset_s;
        if (time_s >= begin_s && time_s < begin_s + burst_s)
            raise(intensities, tactorOf(k), intensity);
    }
    return intensities;
}

core::Intensities valueOf(const Sweep& sweep, double t_s) {
    return burstsAt(t_s - sweep.start_s, onsetOf_s(sweep), sweep.burst_s,
                    static_cast<int>(sweep.tactors.size()), sweep.intensity,
                    [&](int k) { return sweep.tactors[static_cast<std::size_t>(k)]; });
}

core::Intensities valueOf(const Ring& ring, double t_s) {
    const int direction = ring.counterClockwise ? 1 : -1;
    const int turns = std::clamp(ring.turns, 0, kMostTurns);
    return burstsAt(t_s - ring.start_s, onsetOf_s(ring), burstOf_s(ring), kRing * turns, ring.intensity,
                    [&](int k) { return ring.firstTactor % kRing + direction * (k % kRing); });
}

core::Intensities valueOf(const Phantom& phantom, double t_s) {
    core::Intensities intensities{};
    const double share = (t_s - phantom.start_s) / phantom.duration_s;
    const auto [first, second] = phantomIntensities(
        phantom.balanceFrom + share * (phantom.balanceTo - phantom.balanceFrom), phantom.intensity);
    raise(intensities, phantom.first, first);
    raise(intensities, phantom.second, second);
    return intensities;
}

core::Intensities valueOf(const Ramp& ramp, double t_s) {
    core::Intensities intensities{};
    const double share = eased(ramp.easing, (t_s - ramp.start_s) / ramp.duration_s);
    for (const int tactor : ramp.tactors)
        raise(intensities, tactor, ramp.from + share * (ramp.to - ramp.from));
    return intensities;
}

core::Intensities valueOf(const PulseTrain& train, double t_s) {
    core::Intensities intensities{};
    const double time_s = t_s - train.start_s;
    const double phase_s =
        train.period_s > 0.0 ? time_s - std::floor(time_s / train.period_s) * train.period_s : time_s;
    if (phase_s < train.width_s) {
        for (const int tactor : train.tactors)
            raise(intensities, tactor, train.intensity);
    }
    return intensities;
}

core::Intensities valueOf(const Stroke& stroke, double t_s) {
    const double time_s = t_s - stroke.start_s;
    const auto next = std::ranges::upper_bound(stroke.points, time_s, {}, &StrokePoint::time_s);
    if (next == stroke.points.begin() || next == stroke.points.end())
        return {};
    const StrokePoint& a = *(next - 1);
    const StrokePoint& b = *next;
    const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
    return strokeIntensities(a.angle_rad + share * (b.angle_rad - a.angle_rad),
                             a.along + share * (b.along - a.along), stroke.intensity);
}

Span spanOf(const Sweep& sweep) {
    if (sweep.tactors.empty())
        return {sweep.start_s, sweep.start_s};
    const auto intervals = static_cast<double>(sweep.tactors.size() - 1);
    return {sweep.start_s, sweep.start_s + intervals * onsetOf_s(sweep) + sweep.burst_s};
}

Span spanOf(const Stroke& stroke) {
    if (stroke.points.empty())
        return {stroke.start_s, stroke.start_s};
    return {stroke.start_s + stroke.points.front().time_s, stroke.start_s + stroke.points.back().time_s};
}

template <typename Form>
Span spanOf(const Form& form) {
    return {form.start_s, form.start_s + form.duration_s};
}

} // namespace

Span spanOf(const ObjectForm& form) {
    return std::visit([](const auto& object) { return spanOf(object); }, form);
}

std::vector<int> listedTactors(const ObjectForm& form) {
    if (const auto* sweep = std::get_if<Sweep>(&form))
        return sweep->tactors;
    if (const auto* ramp = std::get_if<Ramp>(&form))
        return ramp->tactors;
    if (const auto* train = std::get_if<PulseTrain>(&form))
        return train->tactors;
    if (const auto* phantom = std::get_if<Phantom>(&form))
        return {phantom->first, phantom->second};
    return {0, 1, 2, 3, 4, 5};
}

core::Intensities evaluate(const ObjectForm& form, double t_s) {
    const Span span = spanOf(form);
    if (!(t_s >= span.begin_s && t_s < span.end_s))
        return {};
    return std::visit([t_s](const auto& object) { return valueOf(object, t_s); }, form);
}

core::Intensities strokeIntensities(double angle_rad, double along, double intensity) {
    core::Intensities intensities{};
    if (!std::isfinite(angle_rad) || std::isnan(along))
        return intensities;
    const double turns = angle_rad / (2.0 * std::numbers::pi);
    const double x = (turns - std::floor(turns)) * kRing;
    const int k = static_cast<int>(x);
    const double u = x - k;
    const double limitedAlong = std::clamp(along, 0.0, 1.0);
    const double y = k % 2 == 0 ? limitedAlong : 1.0 - limitedAlong; // 0 at the row of tactor k
    const auto put = [&](int tactor, double weight) {
        raise(intensities, tactor, std::sqrt(std::max(weight, 0.0)) * intensity);
    };
    put(k, y < u ? 1.0 - 0.5 * (u + y) : 1.0 - y);
    put(k + 1, y < u ? y : 0.5 * (u + y));
    put(y < u ? k + 2 : k - 1, 0.5 * std::abs(u - y));
    return intensities;
}

double onsetOf_s(const Sweep& sweep) {
    return sweep.onset_s ? *sweep.onset_s : apparentMotionOnset_s(sweep.burst_s);
}

double onsetOf_s(const Ring& ring) {
    return ring.turns > 0 ? ring.duration_s / (static_cast<double>(kRing) * ring.turns) : 0.0;
}

double burstOf_s(const Ring& ring) {
    if (ring.burst_s)
        return *ring.burst_s;
    const std::optional<double> lawful_s = ringBurst_s(ring.turns, ring.duration_s);
    return lawful_s ? *lawful_s : onsetOf_s(ring);
}

} // namespace teleta::pattern
