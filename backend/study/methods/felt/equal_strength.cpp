// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/felt/equal_strength.h"

#include "backend/core/failure.h"
#include "backend/motors/strength_balance.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::study {

namespace {

struct EqualText {
    Q_DECLARE_TR_FUNCTIONS(EqualStrength)
};

/// Drives of a motor at a level and at the ends of its interval; an open end is an end of the range.
struct Drives {
    double at = 0.0;
    double low = 0.0;
    double high = 0.0;
};

std::optional<Drives> drivesOf(const EqualStrength& equal, std::size_t tactor, double strongest,
                               const pattern::MotorProfiles& motors) {
    const std::optional<double>& level = equal.levels[tactor];
    if (!level)
        return std::nullopt;
    const auto drive = [&](double one) { return pattern::driveOf(motors[tactor], one * strongest); };
    if (tactor == equal.reference)
        return Drives{drive(*level), drive(*level), drive(*level)};
    const OpenInterval& ends = equal.intervals[tactor];
    return Drives{drive(*level), ends.low ? drive(*ends.low) : motors[tactor].startDrive,
                  ends.high ? drive(*ends.high) : motors[tactor].fullDrive};
}

EqualStrength& equalOf(std::vector<std::pair<std::string, EqualStrength>>& found,
                       const std::string& condition, std::size_t reference, double level) {
    const auto same = std::ranges::find_if(found, [&](const auto& one) {
        return one.first == condition && one.second.reference == reference &&
               one.second.referenceLevel == level;
    });
    if (same != found.end())
        return same->second;
    EqualStrength equal;
    equal.reference = reference;
    equal.referenceLevel = level;
    equal.levels[reference] = level;
    found.emplace_back(condition, equal);
    return found.back().second;
}

} // namespace

std::vector<EqualStrength> equalStrengths(const ThresholdResults& results, const FeltTask& felt,
                                          const std::string& participant) {
    std::vector<std::pair<std::string, EqualStrength>> found;
    if (felt.vary != Vary::intensity || felt.design != Design::compare)
        return {};
    const auto add = [&](const std::string& condition, const std::string& track, double reference,
                         const std::optional<double>& level, const OpenInterval& interval) {
        const auto where = felt.tracks.find(track);
        if (where == felt.tracks.end() || where->second.tactors.size() != 1 ||
            where->second.reference.size() != 1 || where->second.tactors == where->second.reference)
            return;
        EqualStrength& equal = equalOf(found, condition, where->second.reference.front(), reference);
        equal.levels[where->second.tactors.front()] = level;
        equal.intervals[where->second.tactors.front()] = interval;
    };
    if (participant.empty()) {
        for (const ThresholdGroup& group : results.groups) {
            if (group.task == felt.task)
                add(group.condition, group.track, group.reference, group.threshold,
                    group.interval ? OpenInterval{group.interval->low, group.interval->high}
                                   : OpenInterval());
        }
    } else {
        for (const ThresholdLine& line : results.lines) {
            if (line.task == felt.task && line.participant == participant)
                add(line.condition, line.track, line.reference, line.fit.threshold,
                    line.fit.thresholdInterval);
        }
    }
    std::vector<EqualStrength> all;
    for (auto& [condition, equal] : found)
        all.push_back(std::move(equal));
    return all;
}

core::Expected<pattern::MotorProfiles> balancedMotors(const EqualStrength& equal, double strongest,
                                                      const pattern::MotorProfiles& motors) {
    core::Intensities drives{};
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        const std::optional<double>& level = equal.levels[tactor];
        if (!level || !(*level > 0.0))
            return core::failed(
                core::ErrorKind::refused,
                EqualText::tr("tactor %1 has no level at which it feels as strong as tactor %2")
                    .arg(tactor + 1)
                    .arg(equal.reference + 1),
                EqualText::tr("a level for each of the six tactors"));
        drives[tactor] = pattern::driveOf(motors[tactor], *level * strongest);
    }
    return motors::balancedByFeel(motors, drives);
}

std::vector<std::size_t> disagreements(const EqualStrength& first, const EqualStrength& second,
                                       double strongest, const pattern::MotorProfiles& motors) {
    std::vector<std::size_t> differing;
    const std::optional<Drives> firstBase = drivesOf(first, second.reference, strongest, motors);
    const std::optional<Drives> secondBase = drivesOf(second, second.reference, strongest, motors);
    if (!firstBase || !secondBase)
        return differing;
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        if (tactor == second.reference)
            continue;
        const std::optional<Drives> a = drivesOf(first, tactor, strongest, motors);
        const std::optional<Drives> b = drivesOf(second, tactor, strongest, motors);
        if (!a || !b)
            continue;
        const double ratioA = a->at / firstBase->at;
        const double ratioB = b->at / secondBase->at;
        const bool outsideA = ratioB < a->low / firstBase->high || ratioB > a->high / firstBase->low;
        const bool outsideB = ratioA < b->low / secondBase->high || ratioA > b->high / secondBase->low;
        if (outsideA && outsideB)
            differing.push_back(tactor);
    }
    return differing;
}

} // namespace teleta::study
