// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace teleta::test {

/// Of one pass.
constexpr std::size_t kFrames = 256;

/// Of this thread, so that other programs on the machine do not count.
inline double processorTime_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// One iteration is one pass over all frames, so that none of them is still in the first cache from the last
/// time. prepare runs before each pass and is not timed.
template <typename Prepare, typename Work>
void registerRun(const std::string& name, const Prepare& prepare, const Work& work) {
    benchmark::RegisterBenchmark(name.c_str(), [prepare, work](benchmark::State& state) {
        for (auto _ : state) {
            prepare();
            const double begin_s = processorTime_s();
            for (std::size_t i = 0; i < kFrames; ++i)
                work(i);
            state.SetIterationTime(processorTime_s() - begin_s);
        }
        state.counters["frame"] = benchmark::Counter(kFrames, benchmark::Counter::kIsIterationInvariantRate |
                                                                  benchmark::Counter::kInvert);
    })->UseManualTime();
}

template <typename Work>
void registerRun(const std::string& name, const Work& work) {
    registerRun(
        name, [] {}, work);
}

struct Comparison {
    std::string what;
    std::string ours;
    std::string alternative;
    double toReach;
};

/// Prints medians and variation and keeps the time of every repetition.
class KeepingReporter : public benchmark::ConsoleReporter {
public:
    KeepingReporter()
        : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& reports) override {
        std::vector<Run> aggregates;
        for (const Run& run : reports) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred)
                m_frame_ns[run.run_name.function_name].push_back(run.GetAdjustedRealTime() / kFrames);
            else if (run.aggregate_name == "median" || run.aggregate_name == "cv")
                aggregates.push_back(run);
        }
        ConsoleReporter::ReportRuns(aggregates);
    }

    /// Time of a run in ns per frame; NaN when it did not run.
    [[nodiscard]] double quantile_ns(const std::string& run, double share) {
        auto& times_ns = m_frame_ns[run];
        if (times_ns.empty())
            return std::nan("");
        std::sort(times_ns.begin(), times_ns.end());
        return times_ns[static_cast<std::size_t>(share * static_cast<double>(times_ns.size() - 1) + 0.5)];
    }

    /// Between the quartiles, as a share of the median.
    [[nodiscard]] double spread(const std::string& run) {
        return (quantile_ns(run, 0.75) - quantile_ns(run, 0.25)) / quantile_ns(run, 0.5);
    }

private:
    std::map<std::string, std::vector<double>> m_frame_ns;
};

inline void printTable(KeepingReporter& results, std::span<const Comparison> comparisons) {
    std::printf("\n%-58s %12s %16s %8s %9s %8s %8s\n", "what", "ours ns", "alternative ns", "ratio",
                "to reach", "reached", "spread");
    for (const Comparison& comparison : comparisons) {
        const double ours_ns = results.quantile_ns(comparison.ours, 0.5);
        const double alternative_ns = results.quantile_ns(comparison.alternative, 0.5);
        if (std::isnan(ours_ns) || std::isnan(alternative_ns))
            continue;
        const double ratio = alternative_ns / ours_ns;
        std::printf("%-58s %12.1f %16.1f %8.1f %9.0f %8s %6.1f %%\n", comparison.what.c_str(), ours_ns,
                    alternative_ns, ratio, comparison.toReach, ratio >= comparison.toReach ? "yes" : "no",
                    100.0 *
                        std::max(results.spread(comparison.ours), results.spread(comparison.alternative)));
    }
}

} // namespace teleta::test
