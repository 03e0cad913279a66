// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/failure.h"
#include "backend/sweep/sweep_subject.h"

#include <QString>

#include <atomic>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace teleta::test {

/// A subject whose measures are a formula of the settings and the seed, without any simulation:
///   sum = x + seed, later = 2 x from the fourth cell on; with fails, runs of that seed fail.
class SweptNumbers : public sweep::SweepSubject {
public:
    explicit SweptNumbers(std::set<std::uint64_t> fails = {})
        : m_fails(std::move(fails)) {}

    [[nodiscard]] std::unique_ptr<sweep::SweepWorker> makeWorker() const override {
        return std::make_unique<Worker>(*this);
    }
    [[nodiscard]] std::string source() const override { return "numbers"; }
    [[nodiscard]] std::uint64_t runs() const { return m_runs; }

private:
    class Worker : public sweep::SweepWorker {
    public:
        explicit Worker(const SweptNumbers& subject)
            : m_subject(subject) {}
        core::Expected<sweep::RunMeasures>
        run(const sweep::SweepPlan& plan, std::uint64_t cell, std::uint64_t seed,
            const std::function<void(const scene_run::LabelledFrame&)>&) override {
            ++m_subject.m_runs;
            if (m_subject.m_fails.contains(seed))
                return core::failed(core::ErrorKind::refused,
                                    QStringLiteral("seed %1, \"as asked\"").arg(seed));
            const double x = std::get<double>(plan.settingsOf(cell).front().second);
            sweep::RunMeasures measures;
            // A measure that comes up late, before one that was there from the start.
            if (cell >= 3)
                measures.emplace_back("later", 2.0 * x);
            measures.emplace_back("sum", x + static_cast<double>(seed));
            return measures;
        }

    private:
        const SweptNumbers& m_subject;
    };

    std::set<std::uint64_t> m_fails;
    mutable std::atomic<std::uint64_t> m_runs{0};
};

/// A sweep of SweptNumbers over x with so many seeds.
[[nodiscard]] inline sweep::SweepPlan numbersPlan(std::uint64_t seeds = 20) {
    auto plan = sweep::parseSweepPlan("[sweep]\nscene = \"numbers\"\nseeds = \"1:" + std::to_string(seeds) +
                                          "\"\n[sweep.vary]\nx = [0.5, 1.5, 2.5, 3.5, 4.5]\n",
                                      "numbers.toml");
    return std::move(*plan);
}

} // namespace teleta::test
