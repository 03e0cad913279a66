// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/certificate/certificate.h"

#include "backend/core/quantile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <functional>

namespace teleta::certificate {

namespace {

FaultTally tallyOf(const Certificate& certificate, FaultKind kind,
                   const std::function<bool(const FaultOutcome&)>& counts) {
    FaultTally tally{.kind = kind};
    std::vector<double> times_s;
    for (const FaultOutcome& outcome : certificate.outcomes) {
        if (!counts(outcome))
            continue;
        ++tally.faults;
        tally.notZero += outcome.zero_s ? 0 : 1;
        tally.overBound += outcome.zero_s && *outcome.zero_s <= certificate.bound_s ? 0 : 1;
        tally.restarted += outcome.restarted ? 1 : 0;
        tally.framesLost += outcome.framesLost;
        tally.filesDamaged += outcome.fileDamaged ? 1 : 0;
        if (outcome.zero_s)
            times_s.push_back(*outcome.zero_s);
    }
    if (!times_s.empty()) {
        std::ranges::sort(times_s);
        tally.median_s = core::quantileOf(times_s, 0.5);
        tally.p99_s = core::quantileOf(times_s, 0.99);
        tally.longest_s = times_s.back();
    }
    return tally;
}

template <typename Value>
nlohmann::ordered_json orNull(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json toJson(const FaultTally& tally) {
    return {{"faults", tally.faults},
            {"zero_median_s", orNull(tally.median_s)},
            {"zero_p99_s", orNull(tally.p99_s)},
            {"zero_longest_s", orNull(tally.longest_s)},
            {"not_zero", tally.notZero},
            {"over_bound", tally.overBound},
            {"share_over_bound_at_most", shareOverBoundAtMost(tally)},
            {"restarted", tally.restarted},
            {"frames_lost", tally.framesLost},
            {"files_damaged", tally.filesDamaged}};
}

nlohmann::ordered_json toJson(const CertifiedSystem& system) {
    return {
        {"version", system.version},     {"actuator", system.actuator == Actuator::arm ? "arm" : "motors"},
        {"driver", system.driver},       {"simulated", system.simulated},
        {"started", system.started},     {"kernel", system.kernel},
        {"processor", system.processor}, {"cores", system.cores},
        {"load", system.load},           {"resolution_s", system.resolution_s}};
}

} // namespace

std::vector<FaultTally> Certificate::tallies() const {
    std::vector<FaultTally> tallies;
    for (const FaultKind kind : kFaultKinds) {
        const FaultTally tally =
            tallyOf(*this, kind, [kind](const FaultOutcome& outcome) { return outcome.kind == kind; });
        if (tally.faults > 0)
            tallies.push_back(tally);
    }
    return tallies;
}

FaultTally Certificate::total() const {
    return tallyOf(*this, FaultKind::stop, [](const FaultOutcome&) { return true; });
}

bool Certificate::passes() const {
    const FaultTally all = total();
    return all.faults > 0 && all.overBound == 0 && all.restarted == 0 && all.framesLost == 0 &&
           all.filesDamaged == 0;
}

double shareOverBoundAtMost(const FaultTally& tally) {
    if (tally.faults == 0 || tally.overBound == tally.faults)
        return 1.0;
    constexpr double kRisk = 0.05;
    return boost::math::binomial_distribution<>::find_upper_bound_on_p(
        static_cast<double>(tally.faults), static_cast<double>(tally.overBound), kRisk);
}

nlohmann::ordered_json toJson(const Certificate& certificate) {
    nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
    for (const FaultTally& tally : certificate.tallies()) {
        nlohmann::ordered_json row{{"kind", toString(tally.kind)}};
        row.update(toJson(tally));
        kinds.push_back(std::move(row));
    }
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const FaultOutcome& outcome : certificate.outcomes)
        faults.push_back({{"kind", toString(outcome.kind)},
                          {"zero_s", orNull(outcome.zero_s)},
                          {"restarted", outcome.restarted},
                          {"frames_lost", outcome.framesLost},
                          {"file_damaged", outcome.fileDamaged}});
    return {{"passes", certificate.passes()},
            {"bound_s", certificate.bound_s},
            {"seed", certificate.seed},
            {"system", toJson(certificate.system)},
            {"total", toJson(certificate.total())},
            {"kinds", std::move(kinds)},
            {"remarks", certificate.remarks},
            {"faults", std::move(faults)}};
}

} // namespace teleta::certificate
