// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/time_comparisons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace teleta::study {

std::optional<double> TimePair::ratio() const {
    return logs.difference ? std::optional(std::exp(*logs.difference)) : std::nullopt;
}

std::optional<Interval> TimePair::ratioInterval() const {
    if (!logs.test)
        return std::nullopt;
    return Interval{std::exp(logs.test->interval.low), std::exp(logs.test->interval.high)};
}

std::optional<double> geometricMean(std::span<const double> values) {
    if (values.empty() ||
        std::ranges::any_of(values, [](double v) { return !(v > 0.0 && std::isfinite(v)); }))
        return std::nullopt;
    double sum = 0.0;
    for (const double v : values)
        sum += std::log(v);
    return std::exp(sum / static_cast<double>(values.size()));
}

TimeComparisons timeComparisons(const TaskResults& task) {
    TimeComparisons times;
    std::set<std::string> people;
    for (const ParticipantSummary& person : task.participants) {
        people.insert(person.participant);
        times.participants.push_back({person.participant, person.condition, person.times_s.size(),
                                      geometricMean(person.times_s), person.medianTime_s});
    }
    const auto logsOf = [&](const std::string& condition) {
        std::vector<double> logs;
        for (const std::string& id : people) {
            const auto own = std::ranges::find_if(times.participants, [&](const ParticipantTimes& one) {
                return one.participant == id && one.condition == condition;
            });
            const bool has = own != times.participants.end() && own->geometricMean_s;
            logs.push_back(has ? std::log(*own->geometricMean_s) : std::numeric_limits<double>::quiet_NaN());
        }
        return logs;
    };
    std::vector<std::optional<double>> p;
    for (std::size_t i = 0; i < task.groups.size(); ++i) {
        for (std::size_t j = i + 1; j < task.groups.size(); ++j) {
            const std::string& first = task.groups[i].condition;
            const std::string& second = task.groups[j].condition;
            times.pairs.push_back({first, second, comparePaired(logsOf(first), logsOf(second)), {}});
            const auto& test = times.pairs.back().logs.test;
            p.push_back(test ? std::optional(test->p) : std::nullopt);
        }
    }
    const auto adjusted = holm(p);
    for (std::size_t i = 0; i < adjusted.size(); ++i)
        times.pairs[i].pHolm = adjusted[i];
    return times;
}

} // namespace teleta::study
