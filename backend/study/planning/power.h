// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/study/analysis/proportion.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// A study as it could be: how a participant comes out, and the test of interest. Thread: any; several call
/// it at once.
class PossibleStudy {
public:
    virtual ~PossibleStudy() = default;
    /// Values of one participant in the cells of the design, drawn from the stream.
    [[nodiscard]] virtual std::vector<double> participant(core::RandomStream& random) const = 0;
    /// p of the test; empty: the analysis is refused.
    [[nodiscard]] virtual std::optional<double>
    p(std::span<const std::vector<double>> participants) const = 0;
};

/// Power at one number of participants, as counted.
struct PowerPoint {
    std::size_t participants = 0;
    std::size_t studies = 0;
    std::size_t significant = 0;
    std::size_t refused = 0; ///< analyses that were refused; not significant

    /// Share of significant studies. Only with studies.
    [[nodiscard]] double power() const;
    /// sqrt(p (1-p) / studies).
    [[nodiscard]] double standardError() const;
    /// Wilson, 95 %.
    [[nodiscard]] Interval interval() const;
};

/// The most studies that are usually drawn to decide between two numbers of participants.
inline constexpr std::size_t kMostStudies = 160'000;

struct PlanSettings {
    std::vector<std::size_t> participants; ///< rising, at least one, each at least 1
    std::size_t studies = 10'000;
    std::uint64_t seed = 1;
    double alpha = 0.05;
    double target = 0.9;                    ///< power that is wanted
    std::size_t mostStudies = kMostStudies; ///< drawn to decide between two numbers of participants
    std::size_t threads = 0;                ///< 0: as many as the machine has
};

struct PowerPlan {
    std::vector<PowerPoint> points;          ///< one per number of participants
    std::optional<std::size_t> participants; ///< the smallest number that reaches the target; empty: none
    std::optional<std::size_t>
        orParticipants;     ///< the next larger one, where chance cannot tell the two apart
    bool cancelled = false; ///< points have the studies done so far
};

/// Draws studies and counts how often the test is significant. Participant i of study s has the stream
/// derivedSeed(derivedSeed(seed, s), i): the numbers do not depend on the threads, and a larger study has the
/// participants of the smaller one. Where the interval of the power holds the target, more studies are drawn,
/// up to mostStudies. goOn: called now and then with the share that is done, on the calling thread; false
/// cancels. Thread: any; makes its own.
[[nodiscard]] PowerPlan planPower(const PossibleStudy& study, const PlanSettings& settings,
                                  const std::function<bool(double done)>& goOn = {});

} // namespace teleta::study
