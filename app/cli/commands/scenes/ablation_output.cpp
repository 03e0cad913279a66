// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/ablation_output.h"

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace teleta::cli {

namespace {

constexpr std::array<std::string_view, 12> kColumns{"effect",
                                                    "measure",
                                                    "mean",
                                                    "spread",
                                                    "mean_without",
                                                    "change",
                                                    "change_per_spread",
                                                    "seeds_that_differ",
                                                    "moves",
                                                    "own_time_s",
                                                    "run_s",
                                                    "run_with_all_s"};

std::set<std::string> measuresThatChange(const scene_run::Ablation& ablation) {
    std::set<std::string> names;
    for (const scene_run::EffectAblation& effect : ablation.effects)
        for (const scene_run::MeasureChange& change : effect.changes)
            if (change.differing > 0 || (change.change == change.change && change.change != 0.0))
                names.insert(change.measure);
    return names;
}

} // namespace

core::Expected<void> printAblation(const scene_run::Ablation& ablation, const RowOptions& options) {
    TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, options));
    const std::set<std::string> shown = measuresThatChange(ablation);
    for (const scene_run::EffectAblation& effect : ablation.effects)
        for (const scene_run::MeasureChange& change : effect.changes) {
            if (!shown.contains(change.measure))
                continue;
            rows.text(effect.effect);
            rows.text(change.measure);
            for (const double value : {change.mean, change.spread, change.meanWithout, change.change})
                rows.number(value);
            // A measure without a spread has no such ratio, unless it stays as it is.
            rows.number(change.spread > 0.0    ? std::optional(change.change / change.spread)
                        : change.change == 0.0 ? std::optional(0.0)
                                               : std::nullopt);
            rows.integer(static_cast<long long>(change.differing));
            rows.text(change.moves ? "yes" : "no");
            for (const double time_s : {effect.own_s, effect.run_s, ablation.run_s})
                rows.number(time_s);
            rows.endRow();
        }
    return rows.finish();
}

} // namespace teleta::cli
