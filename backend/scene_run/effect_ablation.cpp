// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/effect_ablation.h"

#include "backend/core/failure.h"
#include "backend/scene_run/base/flat_measures.h"
#include "backend/scene_run/paired_tests.h"
#include "backend/scene_run/scene_run.h"
#include "backend/scene_run/study/study_run.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace teleta::scene_run {

namespace {

/// A difference that rounding makes.
constexpr double kRounding = 1e-12;
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
constexpr double kOtherSpread = 2.0;
constexpr double kSignificant = 0.05;

struct AblationText {
    Q_DECLARE_TR_FUNCTIONS(AblationText)
};

/// Measures by name; what could not be determined is not there.
struct NamedMeasures {
    explicit NamedMeasures(const FlatMeasures& flat)
        : numbers(flat.numbers.begin(), flat.numbers.end())
        , texts(flat.texts.begin(), flat.texts.end()) {}

    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
};

/// All seeds of a scene with the same effects.
struct Runs {
    std::vector<NamedMeasures> measures;
    std::vector<double> wall_s;
    std::map<std::string, double> own_s; ///< mean of each effect
};

double standardDeviation(const std::vector<double>& values) {
    const double middle = mean(values);
    double squares = 0.0;
    for (const double value : values)
        squares += (value - middle) * (value - middle);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

using Run = std::function<core::Expected<SceneSummary>(const RunOptions&)>;

/// Runs all seeds; progress counts on from the runs that were done before.
core::Expected<Runs> runSeeds(const Run& runOne, const AblationOptions& options, double doneBefore,
                              double allRuns) {
    Runs runs;
    for (std::uint64_t i = 0; i < options.seeds; ++i) {
        RunOptions run;
        run.seed = options.firstSeed + i;
        run.duration_s = options.duration_s;
        run.goOn = [&](double simulated_s, double duration_s) {
            const double done = doneBefore + static_cast<double>(i) + simulated_s / duration_s;
            return !options.goOn || options.goOn(done, allRuns);
        };
        TELETA_TRY(const SceneSummary summary, runOne(run));
        if (summary.interrupted)
            return core::failed(core::ErrorKind::cancelled,
                                AblationText::tr("interrupted before all runs were done"));
        runs.measures.emplace_back(flatMeasures(summary.measures));
        runs.wall_s.push_back(summary.wall_s);
        for (const SceneSummary::EffectTime& effect : summary.effects)
            runs.own_s[effect.name] += effect.time_s / static_cast<double>(options.seeds);
    }
    return runs;
}

/// Names of a kind of measures in any of the runs.
template <typename Value>
std::vector<std::string> namesOf(const Runs& with, const Runs& without,
                                 std::map<std::string, Value> NamedMeasures::*kind) {
    std::vector<std::string> names;
    for (const Runs* runs : {&with, &without})
        for (const NamedMeasures& run : runs->measures)
            for (const auto& [name, value] : run.*kind)
                names.push_back(name);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

MeasureChange numberChange(const std::string& name, const Runs& with, const Runs& without) {
    MeasureChange change;
    change.measure = name;
    std::vector<double> all;
    std::vector<double> others;
    std::vector<double> differences;
    std::vector<double> pairedWith;
    std::vector<double> pairedWithout;
    for (std::size_t i = 0; i < with.measures.size(); ++i) {
        const auto& a = with.measures[i].numbers;
        const auto& b = without.measures[i].numbers;
        const auto before = a.find(name);
        const auto after = b.find(name);
        if (before != a.end())
            all.push_back(before->second);
        if (after != b.end())
            others.push_back(after->second);
        if (before != a.end() && after != b.end()) {
            differences.push_back(after->second - before->second);
            pairedWith.push_back(before->second);
            pairedWithout.push_back(after->second);
        } else if (before != a.end() || after != b.end())
            ++change.differing;
    }
    change.mean = mean(all);
    // One seed does not show what is chance.
    change.spreadWith = all.size() > 1 ? standardDeviation(all) : kNotMeasured;
    change.spreadWithout = others.size() > 1 ? standardDeviation(others) : kNotMeasured;
    change.meanWithout = mean(others);
    change.change = mean(differences);
    change.pMean = pairedMeanTest(differences);
    change.pSpread = pairedSpreadTest(pairedWith, pairedWithout);
    if (2 * change.differing > with.measures.size()) {
        change.moves = Moves::yes;
        return change;
    }
    // Comparing what is not a number would raise a floating-point exception.
    if (all.size() < 2 || !std::isfinite(change.spreadWith) || !std::isfinite(change.change))
        return change;
    const double size = std::max(std::abs(change.mean), std::abs(change.meanWithout));
    if (std::abs(change.change) > std::max(change.spreadWith, kRounding * size)) {
        change.moves = Moves::yes;
    } else if (std::isfinite(change.spreadWithout) && std::isfinite(change.pSpread)) {
        const auto [narrow, wide] = std::minmax(change.spreadWith, change.spreadWithout);
        if (wide > kRounding * size && wide >= kOtherSpread * narrow && change.pSpread < kSignificant)
            change.moves = Moves::spread;
    }
    return change;
}

MeasureChange textChange(const std::string& name, const Runs& with, const Runs& without) {
    MeasureChange change;
    change.measure = name;
    for (double MeasureChange::*number :
         {&MeasureChange::mean, &MeasureChange::spreadWith, &MeasureChange::meanWithout,
          &MeasureChange::spreadWithout, &MeasureChange::change, &MeasureChange::pMean,
          &MeasureChange::pSpread})
        change.*number = kNotMeasured;
    for (std::size_t i = 0; i < with.measures.size(); ++i) {
        const auto& a = with.measures[i].texts;
        const auto& b = without.measures[i].texts;
        const auto before = a.find(name);
        const auto after = b.find(name);
        const bool known = before != a.end() && after != b.end();
        if (known ? before->second != after->second : before != a.end() || after != b.end())
            ++change.differing;
    }
    change.moves = 2 * change.differing > with.measures.size() ? Moves::yes : Moves::no;
    return change;
}

/// runWithout: of the scene without its effect of that index; all effects for none.
core::Expected<Ablation> ablate(const std::vector<std::string>& effects,
                                const std::function<Run(std::optional<std::size_t>)>& runWithout,
                                const AblationOptions& options) {
    if (options.seeds < 2)
        return core::failed(core::ErrorKind::badInput,
                            AblationText::tr("the spread of a measure needs at least two seeds"));
    const auto perVariant = static_cast<double>(options.seeds);
    const double allRuns = perVariant * static_cast<double>(effects.size() + 1);
    TELETA_TRY(const Runs with, runSeeds(runWithout({}), options, 0.0, allRuns));

    Ablation ablation;
    ablation.run_s = quantile(with.wall_s, 0.5);
    for (std::size_t left = 0; left < effects.size(); ++left) {
        TELETA_TRY(const Runs without,
                   runSeeds(runWithout(left), options, perVariant * static_cast<double>(left + 1), allRuns));
        EffectAblation effect;
        effect.effect = effects[left];
        const auto own = with.own_s.find(effect.effect);
        effect.own_s = own == with.own_s.end() ? 0.0 : own->second;
        effect.run_s = quantile(without.wall_s, 0.5);
        for (const std::string& name : namesOf(with, without, &NamedMeasures::numbers))
            effect.changes.push_back(numberChange(name, with, without));
        for (const std::string& name : namesOf(with, without, &NamedMeasures::texts))
            effect.changes.push_back(textChange(name, with, without));
        ablation.effects.push_back(std::move(effect));
    }
    return ablation;
}

} // namespace

const char* toString(Moves moves) {
    switch (moves) {
    case Moves::no:
        return "no";
    case Moves::yes:
        return "yes";
    case Moves::spread:
        return "spread";
    }
    return "";
}

bool EffectAblation::moves() const {
    return std::ranges::any_of(changes,
                               [](const MeasureChange& change) { return change.moves != Moves::no; });
}

core::Expected<Ablation> ablateEffects(const scene::Scene& scene, const AblationOptions& options) {
    std::vector<std::string> effects;
    for (const scene::Effect& effect : scene.effects)
        effects.emplace_back(nameOf(effect));
    const auto runWithout = [&scene](std::optional<std::size_t> left) -> Run {
        scene::Scene others = scene;
        if (left)
            others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(*left));
        return [others](const RunOptions& run) { return runScene(others, run); };
    };
    return ablate(effects, runWithout, options);
}

core::Expected<Ablation> ablateEffects(const study::StudyScene& scene, const AblationOptions& options) {
    std::vector<std::string> effects;
    for (const study::StudyScene::Effect& effect : scene.effects)
        effects.push_back(effect.name);
    const auto runWithout = [&](std::optional<std::size_t> left) -> Run {
        return [others = left ? scene.without(effects[*left]) : scene](const RunOptions& run) {
            return runStudyScene(others, run);
        };
    };
    return ablate(effects, runWithout, options);
}

} // namespace teleta::scene_run
