// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/exclusion.h"

#include "backend/study/analysis/proportion.h"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace teleta::study {

namespace {

/// MAD to standard deviation, for normal values.
constexpr double kMadToSd = 1.4826;

/// A share, counted.
struct Share {
    std::size_t of = 0;
    std::size_t all = 0;

    void add(bool counts) {
        ++all;
        of += counts ? 1 : 0;
    }
    [[nodiscard]] bool isAbove(double value) const {
        return all > 0 && static_cast<double>(of) > value * static_cast<double>(all);
    }
    [[nodiscard]] bool isBelow(double value) const {
        return all > 0 && static_cast<double>(of) < value * static_cast<double>(all);
    }
};

/// P(at least so many right) where each task is guessed with its chance.
double guessProbability(const std::map<double, Share>& byChance) {
    std::vector<double> distribution{1.0};
    std::size_t correct = 0;
    for (const auto& [chance, share] : byChance) {
        const boost::math::binomial guesses(static_cast<double>(share.all), chance);
        std::vector<double> sum(distribution.size() + share.all, 0.0);
        for (std::size_t k = 0; k <= share.all; ++k) {
            const double p = boost::math::pdf(guesses, static_cast<double>(k));
            for (std::size_t i = 0; i < distribution.size(); ++i)
                sum[i + k] += distribution[i] * p;
        }
        distribution = std::move(sum);
        correct += share.of;
    }
    double tail = 0.0;
    for (std::size_t i = distribution.size(); i-- > correct;)
        tail += distribution[i];
    return tail;
}

class RuleBook {
public:
    explicit RuleBook(std::span<const ExcludableTrial> trials)
        : m_trials(trials) {
        m_exclusions.rule.resize(trials.size());
    }

    void apply(const ExclusionRule& rule) {
        m_now = m_exclusions.counts.size();
        m_count = {};
        for (std::size_t i = 0; i < m_trials.size(); ++i)
            m_count.trialsBefore += isLeft(i) ? 1 : 0;
        switch (rule.of()) {
        case ExclusionOf::trial:
            applyToTrials(rule);
            break;
        case ExclusionOf::session:
            applyToSessions(rule);
            break;
        case ExclusionOf::participant:
            applyToParticipant(rule);
            break;
        }
        m_exclusions.counts.push_back(m_count);
    }

    [[nodiscard]] Exclusions take() { return std::move(m_exclusions); }

private:
    [[nodiscard]] bool isLeft(std::size_t i) const { return !m_exclusions.rule[i]; }
    [[nodiscard]] bool isLeftTest(std::size_t i) const {
        return isLeft(i) && m_trials[i].phase == Phase::test;
    }

    void exclude(std::size_t i) {
        m_exclusions.rule[i] = m_now;
        ++m_count.trials;
    }

    void applyToTrials(const ExclusionRule& rule) {
        if (rule.kind == ExclusionKind::responseTimeMad)
            return applyMad(rule.value);
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            if (isLeftTest(i) && isHit(rule, m_trials[i]))
                exclude(i);
        }
    }

    [[nodiscard]] static bool isHit(const ExclusionRule& rule, const ExcludableTrial& trial) {
        const bool hasTime = trial.responseTime_s && !trial.response.empty();
        switch (rule.kind) {
        case ExclusionKind::responseTimeBelow_s:
            return hasTime && *trial.responseTime_s < rule.value;
        case ExclusionKind::responseTimeAbove_s:
            return hasTime && *trial.responseTime_s > rule.value;
        case ExclusionKind::deviceFaults:
            return static_cast<double>(trial.deviceFaults) > rule.value;
        case ExclusionKind::framesMissedAbove:
            return static_cast<double>(trial.framesMissed) > rule.value;
        default:
            return false;
        }
    }

    void applyMad(double value) {
        std::map<std::pair<std::string_view, std::string_view>, std::vector<std::size_t>> cells;
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            const ExcludableTrial& trial = m_trials[i];
            if (isLeftTest(i) && !trial.response.empty() && trial.responseTime_s.value_or(0.0) > 0.0)
                cells[{trial.task, trial.condition}].push_back(i);
        }
        for (const auto& [cell, indices] : cells) {
            std::vector<double> times_s;
            for (const std::size_t i : indices)
                times_s.push_back(*m_trials[i].responseTime_s);
            const std::optional<TimeLimits> limits = madLimits(times_s, value);
            if (!limits) {
                ++m_count.cellsWithoutSpread;
                continue;
            }
            for (const std::size_t i : indices) {
                const double time_s = *m_trials[i].responseTime_s;
                if (time_s < limits->low_s || time_s > limits->high_s)
                    exclude(i);
            }
        }
    }

    void applyToSessions(const ExclusionRule& rule) {
        std::map<std::string_view, std::vector<std::size_t>> sessions;
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            if (isLeft(i))
                sessions[m_trials[i].session].push_back(i);
        }
        for (const auto& [session, indices] : sessions) {
            if (!isHit(rule, indices))
                continue;
            ++m_count.sessions;
            for (const std::size_t i : indices)
                exclude(i);
        }
    }

    [[nodiscard]] bool isHit(const ExclusionRule& rule, const std::vector<std::size_t>& session) const {
        Share share;
        std::map<std::string_view, std::size_t> answers;
        std::size_t answered = 0;
        for (const std::size_t i : session) {
            const ExcludableTrial& trial = m_trials[i];
            if (trial.phase != Phase::test)
                continue;
            if (rule.kind == ExclusionKind::timeoutsShareAbove)
                share.add(trial.response.empty());
            else if (rule.kind == ExclusionKind::catchYesShareAbove && trial.isCatch())
                share.add(trial.response == "yes");
            if (!trial.response.empty()) {
                ++answered;
                ++answers[trial.response];
            }
        }
        if (rule.kind == ExclusionKind::sameAnswerShareAbove) {
            share.all = answered;
            for (const auto& [answer, count] : answers)
                share.of = std::max(share.of, count);
        }
        return share.isAbove(rule.value);
    }

    void applyToParticipant(const ExclusionRule& rule) {
        Share practice;
        std::map<double, Share> tests;
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            const ExcludableTrial& trial = m_trials[i];
            if (!isLeft(i) || !(trial.chance > 0.0))
                continue;
            if (trial.phase == Phase::practice)
                practice.add(trial.isCorrect());
            else
                tests[trial.chance].add(trial.isCorrect());
        }
        const bool isHit = rule.kind == ExclusionKind::practiceAccuracyBelow
                               ? practice.isBelow(rule.value)
                               : !tests.empty() && guessProbability(tests) > rule.value;
        if (!isHit)
            return;
        m_count.participant = true;
        for (std::size_t i = 0; i < m_trials.size(); ++i) {
            if (isLeft(i))
                exclude(i);
        }
    }

    std::span<const ExcludableTrial> m_trials;
    Exclusions m_exclusions;
    std::size_t m_now = 0;
    ExclusionCount m_count;
};

} // namespace

std::optional<TimeLimits> madLimits(std::span<const double> times_s, double value) {
    std::vector<double> logs;
    for (const double time_s : times_s) {
        if (!(time_s > 0.0))
            return std::nullopt;
        logs.push_back(std::log(time_s));
    }
    const std::optional<double> middle = median(logs);
    if (!middle)
        return std::nullopt;
    for (double& one : logs)
        one = std::abs(one - *middle);
    const double mad = median(logs).value_or(0.0);
    if (!(mad > 0.0))
        return std::nullopt;
    const double reach = value * kMadToSd * mad;
    return TimeLimits{std::exp(*middle - reach), std::exp(*middle + reach)};
}

Exclusions applyExclusions(std::span<const ExclusionRule> rules, std::span<const ExcludableTrial> trials) {
    RuleBook book(trials);
    for (const ExclusionRule& rule : rules)
        book.apply(rule);
    return book.take();
}

} // namespace teleta::study
