// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/power.h"

#include "backend/study/protocol/trial_order.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace teleta::study {

namespace {

/// Studies that a thread takes at a time.
constexpr std::size_t kChunk = 50;
constexpr std::chrono::milliseconds kBetweenQuestions{20};
constexpr std::size_t kMoreStudies = 4;

struct Counts {
    std::size_t studies = 0;
    std::vector<std::size_t> significant;
    std::vector<std::size_t> refused;
};

/// Studies from .. to - 1, at each number of participants.
void drawStudies(const PossibleStudy& study, const PlanSettings& settings,
                 const std::vector<std::size_t>& numbers, std::size_t from, std::size_t to, Counts& counts) {
    const std::size_t most = numbers.back();
    std::vector<std::vector<double>> people(most);
    for (std::size_t s = from; s < to; ++s) {
        const std::uint64_t seed = derivedSeed(settings.seed, s);
        for (std::size_t i = 0; i < most; ++i) {
            core::RandomStream random(derivedSeed(seed, i));
            people[i] = study.participant(random);
        }
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            const std::optional<double> p = study.p(std::span(people).first(numbers[n]));
            counts.refused[n] += p ? 0 : 1;
            counts.significant[n] += p && *p < settings.alpha ? 1 : 0;
        }
        ++counts.studies;
    }
}

/// Adds studies to some points until they have `studies`. All of them have the same number before.
class Round {
public:
    Round(const PossibleStudy& study, const PlanSettings& settings, std::vector<PowerPoint*> points,
          std::size_t studies)
        : m_study(study)
        , m_settings(settings)
        , m_points(std::move(points))
        , m_next(m_points.front()->studies)
        , m_end(studies) {
        for (const PowerPoint* point : m_points)
            m_numbers.push_back(point->participants);
    }

    /// False: cancelled. What was drawn until then counts.
    bool run(const std::function<bool(double)>& goOn) {
        const std::size_t begin = m_next;
        const std::size_t wanted =
            m_settings.threads > 0 ? m_settings.threads : std::max(1U, std::thread::hardware_concurrency());
        const std::size_t threads = std::min(wanted, (m_end - begin) / kChunk + 1);
        std::vector<Counts> counts(threads);
        for (Counts& own : counts) {
            own.significant.resize(m_numbers.size());
            own.refused.resize(m_numbers.size());
        }
        std::vector<std::thread> workers;
        for (std::size_t t = 0; t < threads; ++t)
            workers.emplace_back([this, &own = counts[t]] { work(own); });
        bool isOn = true;
        while (m_finished.load() < threads) {
            std::this_thread::sleep_for(kBetweenQuestions);
            const double done = static_cast<double>(std::min(m_done.load(), m_end - begin)) /
                                static_cast<double>(m_end - begin);
            if (isOn && goOn && !goOn(done)) {
                isOn = false;
                m_stop = true;
            }
        }
        for (std::thread& worker : workers)
            worker.join();
        for (const Counts& own : counts) {
            for (std::size_t n = 0; n < m_points.size(); ++n) {
                m_points[n]->studies += own.studies;
                m_points[n]->significant += own.significant[n];
                m_points[n]->refused += own.refused[n];
            }
        }
        return isOn;
    }

private:
    void work(Counts& own) {
        while (!m_stop.load()) {
            const std::size_t from = m_next.fetch_add(kChunk);
            if (from >= m_end)
                break;
            const std::size_t to = std::min(m_end, from + kChunk);
            drawStudies(m_study, m_settings, m_numbers, from, to, own);
            m_done.fetch_add(to - from);
        }
        m_finished.fetch_add(1);
    }

    const PossibleStudy& m_study;
    const PlanSettings& m_settings;
    std::vector<PowerPoint*> m_points;
    std::vector<std::size_t> m_numbers;
    std::atomic<std::size_t> m_next;
    std::size_t m_end;
    std::atomic<std::size_t> m_done{0};
    std::atomic<std::size_t> m_finished{0};
    std::atomic<bool> m_stop{false};
};

bool holds(const PowerPoint& point, double target) {
    const Interval ends = point.interval();
    return ends.low <= target && target <= ends.high;
}

} // namespace

double PowerPoint::power() const {
    return static_cast<double>(significant) / static_cast<double>(studies);
}

double PowerPoint::standardError() const {
    return std::sqrt(power() * (1.0 - power()) / static_cast<double>(studies));
}

Interval PowerPoint::interval() const {
    return wilsonInterval(static_cast<std::int64_t>(significant), static_cast<std::int64_t>(studies))
        .value_or(Interval{0.0, 1.0});
}

PowerPlan planPower(const PossibleStudy& study, const PlanSettings& settings,
                    const std::function<bool(double)>& goOn) {
    PowerPlan plan;
    std::vector<PowerPoint*> all;
    for (const std::size_t number : settings.participants)
        plan.points.push_back({number});
    for (PowerPoint& point : plan.points)
        all.push_back(&point);
    if (all.empty() || settings.studies == 0)
        return plan;
    plan.cancelled = !Round(study, settings, all, settings.studies).run(goOn);
    while (!plan.cancelled) {
        const auto found = std::ranges::find_if(
            plan.points, [&](const PowerPoint& point) { return point.power() >= settings.target; });
        const bool hasFound = found != plan.points.end();
        const bool hasBefore = found != plan.points.begin();
        // Chance could have the answer one step further up, or one further down.
        const bool isLow = hasFound && holds(*found, settings.target);
        const bool isHigh = hasBefore && holds(*(found - 1), settings.target);
        plan.participants.reset();
        plan.orParticipants.reset();
        if (hasFound)
            plan.participants = found->participants;
        std::vector<PowerPoint*> doubtful;
        if (isHigh) {
            doubtful.push_back(&*(found - 1));
            if (hasFound) {
                plan.participants = (found - 1)->participants;
                plan.orParticipants = found->participants;
            }
        }
        if (isLow) {
            doubtful.push_back(&*found);
            if (!isHigh && found + 1 != plan.points.end())
                plan.orParticipants = (found + 1)->participants;
        }
        std::erase_if(doubtful,
                      [&](const PowerPoint* point) { return point->studies >= settings.mostStudies; });
        if (doubtful.empty())
            break;
        // Both have to have the same studies so far.
        const std::size_t least =
            std::ranges::min(doubtful, {}, [](const PowerPoint* point) { return point->studies; })->studies;
        std::erase_if(doubtful, [&](const PowerPoint* point) { return point->studies != least; });
        plan.cancelled =
            !Round(study, settings, doubtful, std::min(settings.mostStudies, kMoreStudies * least)).run(goOn);
    }
    return plan;
}

} // namespace teleta::study
