// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_plan.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/keys.h"
#include "backend/core/keys/toml_table.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace teleta::sweep {

namespace {

using core::TomlTable;
using core::TomlValue;

constexpr long long kMostSteps = 10'000;
constexpr std::size_t kMostSweepBytes = std::size_t{1} << 20U;

struct SweepPlanText {
    Q_DECLARE_TR_FUNCTIONS(SweepPlan)
};

/// FIRST:LAST or one number.
std::optional<std::pair<std::uint64_t, std::uint64_t>> seedsOf(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto number = [](std::string_view part) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && end == part.data() + part.size() ? std::optional(value) : std::nullopt;
    };
    const auto first = number(text.substr(0, colon));
    const auto last = colon == std::string_view::npos ? first : number(text.substr(colon + 1));
    if (!first || !last || *last < *first || *last - *first >= kMostRuns)
        return std::nullopt;
    return std::pair(*first, *last);
}

/// The values of { from, to, steps, scale }; empty after an error.
std::vector<TomlValue> rangeOf(TomlTable table, bool& logarithmic) {
    const double from = table.number("from", core::NumberRange::any());
    const double to = table.number("to", core::NumberRange::any());
    const long long steps = table.integer("steps", 2, kMostSteps);
    logarithmic = table.has("scale") && table.choice("scale", {"linear", "log10"}) == 1;
    if (logarithmic && !(from > 0.0 && to > 0.0)) {
        table.fail(from > 0.0 ? "to" : "from",
                   SweepPlanText::tr("a range with scale \"log10\" reaches 0 or below").toStdString(),
                   core::NumberRange::positive().text());
        return {};
    }
    table.finish();
    std::vector<TomlValue> values;
    for (long long i = 0; i < steps; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(steps - 1);
        // The ends are what the file says, to the last digit.
        values.emplace_back(i == 0           ? from
                            : i == steps - 1 ? to
                            : logarithmic    ? from * std::pow(to / from, share)
                                             : from + share * (to - from));
    }
    return values;
}

/// The keys of a table and of the tables in it, with their values.
struct ReadKey {
    SweepAxis::Key key;
    std::vector<TomlValue> values;
    bool logarithmic = false;
    TomlTable table;
    std::string leaf;
};

void readValues(TomlTable table, const std::string& prefix, std::vector<ReadKey>& keys) {
    for (const std::string& key : table.keys()) {
        const std::string name = prefix + key;
        ReadKey read{{name, table.place(key)}, {}, false, table, key};
        if (!table.isTable(key)) {
            read.values = table.valueList(key);
        } else {
            TomlTable inner = table.table(key);
            const std::vector<std::string> names = inner.keys();
            const bool isRange = std::ranges::any_of(names, [](const std::string& each) {
                return each == "from" || each == "to" || each == "steps" || each == "scale";
            });
            if (!isRange) {
                readValues(inner, name + ".", keys);
                continue;
            }
            read.values = rangeOf(inner, read.logarithmic);
        }
        if (!read.values.empty())
            keys.push_back(std::move(read));
    }
    table.finish();
}

void readAxes(TomlTable& sweep, SweepPlan& plan) {
    std::vector<ReadKey> varied;
    std::vector<ReadKey> pairs;
    if (sweep.has("vary"))
        readValues(sweep.table("vary"), {}, varied);
    if (sweep.has("pairs"))
        readValues(sweep.table("pairs"), {}, pairs);
    std::set<std::string> names;
    for (std::vector<ReadKey>* keys : {&varied, &pairs})
        for (ReadKey& key : *keys)
            if (!names.insert(key.key.name).second)
                key.table.fail(key.leaf,
                               SweepPlanText::tr("the key \"%1\" is varied twice")
                                   .arg(QString::fromStdString(key.key.name))
                                   .toStdString(),
                               SweepPlanText::tr("each key once").toStdString());
    for (ReadKey& key : varied) {
        SweepAxis axis{{std::move(key.key)}, {}, key.logarithmic};
        for (TomlValue& value : key.values)
            axis.values.push_back({std::move(value)});
        plan.axes.push_back(std::move(axis));
    }
    if (pairs.empty())
        return;
    SweepAxis together;
    together.values.resize(pairs.front().values.size());
    for (ReadKey& key : pairs) {
        if (key.values.size() != together.values.size()) {
            key.table.fail(key.leaf,
                           SweepPlanText::tr("keys that go together have unlike numbers of values: %1 and %2")
                               .arg(together.values.size())
                               .arg(key.values.size())
                               .toStdString(),
                           SweepPlanText::tr("%1 values, as the first key has")
                               .arg(together.values.size())
                               .toStdString());
            return;
        }
        for (std::size_t i = 0; i < key.values.size(); ++i)
            together.values[i].push_back(std::move(key.values[i]));
        together.keys.push_back(std::move(key.key));
    }
    plan.axes.push_back(std::move(together));
}

void readSubject(TomlTable& sweep, SweepPlan& plan) {
    const bool scene = sweep.has("scene");
    const bool study = sweep.has("study");
    const bool ladder = sweep.has("ladder");
    if (static_cast<int>(scene) + static_cast<int>(study) + static_cast<int>(ladder) != 1) {
        sweep.fail(study    ? "study"
                   : ladder ? "ladder"
                            : "scene",
                   SweepPlanText::tr("a sweep runs one thing").toStdString(),
                   SweepPlanText::tr("one of: scene, study, ladder").toStdString());
        return;
    }
    plan.kind = scene ? SubjectKind::scene : study ? SubjectKind::study : SubjectKind::ladder;
    plan.subject = sweep.text(scene ? "scene" : study ? "study" : "ladder");
    if (study) {
        plan.truth = sweep.text("truth");
        plan.test = sweep.text("test");
        plan.participants = static_cast<std::uint64_t>(
            sweep.integer("participants", 1, 1000, static_cast<long long>(plan.participants)));
    }
}

} // namespace

bool SweepAxis::isNumeric() const {
    return keys.size() == 1 && std::ranges::all_of(values, [](const std::vector<TomlValue>& value) {
               return std::holds_alternative<double>(value[0]) || std::holds_alternative<long long>(value[0]);
           });
}

std::uint64_t SweepPlan::cells() const {
    std::uint64_t product = 1;
    for (const SweepAxis& axis : axes)
        product *= axis.values.size();
    return product;
}

std::vector<std::size_t> SweepPlan::placeOf(std::uint64_t cell) const {
    std::vector<std::size_t> place(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;) {
        place[i] = static_cast<std::size_t>(cell % axes[i].values.size());
        cell /= axes[i].values.size();
    }
    return place;
}

CellSettings SweepPlan::settingsOf(std::uint64_t cell) const {
    const std::vector<std::size_t> place = placeOf(cell);
    CellSettings settings;
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t k = 0; k < axes[i].keys.size(); ++k)
            settings.emplace_back(axes[i].keys[k].name, axes[i].values[place[i]][k]);
    return settings;
}

std::vector<std::string> SweepPlan::keys() const {
    std::vector<std::string> names;
    for (const SweepAxis& axis : axes)
        for (const SweepAxis::Key& key : axis.keys)
            names.push_back(key.name);
    return names;
}

core::Expected<SweepPlan> parseSweepPlan(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    SweepPlan plan;
    plan.file = file;
    plan.text = text;
    TomlTable root = document.root();
    TomlTable sweep = root.table("sweep");
    root.finish();
    readSubject(sweep, plan);
    if (const auto seeds = seedsOf(sweep.text("seeds", "1")))
        std::tie(plan.firstSeed, plan.lastSeed) = *seeds;
    else
        sweep.fail("seeds", SweepPlanText::tr("these are no seeds").toStdString(),
                   SweepPlanText::tr("\"FIRST:LAST\", such as \"1:200\"").toStdString());
    plan.measures = sweep.textList("measures");
    plan.measuresPlace = sweep.place("measures");
    readAxes(sweep, plan);
    sweep.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    double runs = static_cast<double>(plan.seeds());
    for (const SweepAxis& axis : plan.axes)
        runs *= static_cast<double>(axis.values.size());
    if (runs > static_cast<double>(kMostRuns))
        return core::failed(core::ErrorKind::badInput,
                            SweepPlanText::tr("the sweep has %1 runs").arg(runs, 0, 'g', 6),
                            SweepPlanText::tr("at most %1").arg(kMostRuns), sweep.place());
    return plan;
}

core::Expected<SweepPlan> readSweepPlan(const std::string& path) {
    TELETA_TRY(const std::string text, core::readFile(path, kMostSweepBytes));
    return parseSweepPlan(text, path);
}

} // namespace teleta::sweep
