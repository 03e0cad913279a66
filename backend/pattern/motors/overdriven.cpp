// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/overdriven.h"

#include "backend/core/failure.h"
#include "backend/pattern/model/bake.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace teleta::pattern {

namespace {

struct OverdrivenText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

using Boosts = std::array<std::vector<Span>, core::kTactors>;

/// Where each motor is overdriven; adjacent spans are merged.
Boosts boostsOf(const Pattern& pattern, const MotorProfiles& profiles) {
    const CompiledPattern compiled(pattern);
    std::vector<Overdrive> motors;
    for (MotorProfile profile : profiles) {
        // An intensity of 1 is the full drive, and the player never exceeds it.
        profile.overdrive = std::min(profile.overdrive, profile.fullDrive);
        motors.emplace_back(profile);
    }
    Boosts boosts;
    const auto steps = static_cast<std::uint64_t>(std::ceil(pattern.duration_s / kOverdriveStep_s));
    const auto timeOf = [](std::uint64_t k) { return static_cast<double>(k) * kOverdriveStep_s; };
    std::array<std::uint64_t, core::kTactors> nextOf{};
    for (std::uint64_t k = 0; k < steps; ++k) {
        const core::Intensities wanted = compiled.evaluate(timeOf(k));
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            if (!(motors[i].step(wanted[i], kOverdriveStep_s) > driveOf(profiles[i], wanted[i])))
                continue;
            const double end_s = std::min(timeOf(k + 1), pattern.duration_s);
            if (!boosts[i].empty() && nextOf[i] == k)
                boosts[i].back().end_s = end_s;
            else
                boosts[i].push_back({timeOf(k), end_s});
            nextOf[i] = k + 1;
        }
    }
    return boosts;
}

/// Value just before or just after a time; a tactor is off outside its breakpoints.
double between(Track::const_iterator first, Track::const_iterator second, const Track& lines, double t_s) {
    if (first == lines.end() || second == lines.end())
        return 0.0;
    const double share = (t_s - first->time_s) / (second->time_s - first->time_s);
    return first->intensity + share * (second->intensity - first->intensity);
}

double justBefore(const Track& lines, double t_s) {
    const auto next = std::ranges::lower_bound(lines, t_s, {}, &Breakpoint::time_s);
    return between(next == lines.begin() ? lines.end() : std::prev(next), next, lines, t_s);
}

double justAfter(const Track& lines, double t_s) {
    const auto next = std::ranges::upper_bound(lines, t_s, {}, &Breakpoint::time_s);
    return between(next == lines.begin() ? lines.end() : std::prev(next), next, lines, t_s);
}

Track withBoosts(const Track& lines, const std::vector<Span>& boosts) {
    Track result;
    auto point = lines.begin();
    for (const Span& boost : boosts) {
        while (point != lines.end() && point->time_s < boost.begin_s)
            result.push_back(*point++);
        while (point != lines.end() && point->time_s <= boost.end_s)
            ++point;
        result.insert(result.end(), {{boost.begin_s, justBefore(lines, boost.begin_s)},
                                     {boost.begin_s, 1.0},
                                     {boost.end_s, 1.0},
                                     {boost.end_s, justAfter(lines, boost.end_s)}});
    }
    result.insert(result.end(), point, lines.end());
    return trimmed(simplified(result));
}

} // namespace

core::Expected<Pattern> overdriven(const Pattern& pattern, const MotorProfiles& profiles) {
    if (!(pattern.duration_s <= kLongestOverdriven_s))
        return core::refused(OverdrivenText::tr("the pattern is too long for overdrive"),
                             OverdrivenText::tr("at most %1 s").arg(kLongestOverdriven_s));
    const Boosts boosts = boostsOf(pattern, profiles);
    if (std::ranges::all_of(boosts, [](const std::vector<Span>& spans) { return spans.empty(); }))
        return pattern;
    core::Expected<Pattern> result = bake(pattern);
    if (!result)
        return result;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (boosts[i].empty())
            continue;
        TELETA_TRY(const Track lines, linearised(*result, i));
        result->tracks[i] = withBoosts(lines, boosts[i]);
        if (result->tracks[i].size() > Pattern::kMostBreakpoints)
            return core::refused(OverdrivenText::tr("the pattern has too many corners"),
                                 OverdrivenText::tr("at most %1 breakpoints").arg(Pattern::kMostBreakpoints));
    }
    return result;
}

} // namespace teleta::pattern
