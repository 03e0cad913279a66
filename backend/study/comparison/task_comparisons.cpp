// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/task_comparisons.h"

#include "backend/study/analysis/accuracy_cells.h"
#include "backend/study/comparison/effect_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::study {

namespace {

/// One factor of a design: its levels, and a row of values per participant without gaps.
struct ComparedFactor {
    std::string effect;
    std::string stimulus;
    std::vector<std::string> levels;
    ParticipantCells values;
};

ParticipantCells completeRows(ParticipantCells cells) {
    std::erase_if(cells, [](const std::vector<double>& row) {
        return std::ranges::any_of(row, [](double v) { return std::isnan(v); });
    });
    return cells;
}

/// Means over the other factor: level i is the mean of the cells i * step + j * stride, j < count.
ParticipantCells means(const ParticipantCells& cells, std::size_t levels, std::size_t step, std::size_t count,
                       std::size_t stride) {
    ParticipantCells table;
    for (const std::vector<double>& row : cells) {
        std::vector<double>& own = table.emplace_back(levels, 0.0);
        for (std::size_t i = 0; i < levels; ++i) {
            for (std::size_t j = 0; j < count; ++j)
                own[i] += row[i * step + j * stride] / static_cast<double>(count);
        }
    }
    return table;
}

std::vector<double> column(const ParticipantCells& cells, std::size_t index) {
    std::vector<double> values;
    for (const std::vector<double>& row : cells)
        values.push_back(row[index]);
    return values;
}

/// The factor that a line of the table tests; empty for an interaction.
std::optional<ComparedFactor> factorOf(const TaskResults& task, const AccuracyCells& table,
                                       const AnovaLine& line) {
    const std::size_t a = table.conditions.size();
    const std::size_t b = table.patterns.size();
    if (!line.stimulus.empty()) {
        for (std::size_t j = 0; j < b; ++j) {
            if (task.patterns[table.patterns[j]] == line.stimulus)
                return ComparedFactor{line.effect, line.stimulus, table.conditions,
                                      completeRows(table.ofPattern(j))};
        }
        return std::nullopt;
    }
    const ParticipantCells complete = completeRows(table.cells);
    if (line.effect == "condition")
        return ComparedFactor{line.effect, {}, table.conditions, means(complete, a, b, b, 1)};
    if (line.effect != "pattern")
        return std::nullopt;
    std::vector<std::string> letters;
    for (const std::size_t pattern : table.patterns)
        letters.push_back(task.patterns[pattern]);
    return ComparedFactor{line.effect, {}, std::move(letters), means(complete, b, 1, a, b)};
}

void addPairs(const ComparedFactor& factor, std::vector<LevelPair>& pairs) {
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
        for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
            const std::vector<double> first = column(factor.values, i);
            const std::vector<double> second = column(factor.values, j);
            pairs.push_back({factor.effect, factor.stimulus, factor.levels[i], factor.levels[j],
                             comparePaired(first, second), std::nullopt, 0, signedRankTest(first, second),
                             std::nullopt, 0});
        }
    }
}

std::size_t members(const std::vector<std::optional<double>>& p) {
    return static_cast<std::size_t>(
        std::ranges::count_if(p, [](const std::optional<double>& one) { return one.has_value(); }));
}

/// Adjusts the p values of the pairs from here on, which are one family.
void adjust(std::vector<LevelPair>& pairs, std::size_t from) {
    std::vector<std::optional<double>> p;
    std::vector<std::optional<double>> ranked;
    for (std::size_t i = from; i < pairs.size(); ++i) {
        const auto& test = pairs[i].comparison.test;
        p.push_back(test ? std::optional(test->p) : std::nullopt);
        ranked.push_back(pairs[i].ranks ? std::optional(pairs[i].ranks->p) : std::nullopt);
    }
    const auto adjusted = holm(p);
    const auto rankedAdjusted = holm(ranked);
    for (std::size_t i = from; i < pairs.size(); ++i) {
        pairs[i].pHolm = adjusted[i - from];
        pairs[i].family = members(p);
        pairs[i].ranksHolm = rankedAdjusted[i - from];
        pairs[i].ranksFamily = members(ranked);
    }
}

EffectSupplement supplement(const AnovaLine& line, const std::optional<ComparedFactor>& factor) {
    EffectSupplement effect{line.effect, line.stimulus, {}, {}, {}};
    if (!line.row)
        effect.note = line.note;
    else if (line.row->epsilonGg < kLeastSphericity)
        effect.note = "eps GG < 0.75";
    else
        effect.partialEta2 = partialEta2Interval(line.row->f, line.row->df1, line.row->df2);
    if (line.row && effect.note.empty() && !effect.partialEta2)
        effect.note = "not computable";
    if (factor && factor->levels.size() > 2)
        effect.friedman = friedmanTest(factor->values);
    return effect;
}

} // namespace

TaskComparisons taskComparisons(const TaskResults& task) {
    TaskComparisons comparisons;
    if (task.anova.empty())
        return comparisons;
    const AccuracyCells table = accuracyCells(task);
    std::size_t withinPatterns = 0;
    bool isWithin = false;
    for (const AnovaLine& line : task.anova) {
        const std::optional<ComparedFactor> factor = factorOf(task, table, line);
        comparisons.effects.push_back(supplement(line, factor));
        if (!factor)
            continue;
        const std::size_t before = comparisons.pairs.size();
        // The lines within patterns come last and are one family.
        if (!line.stimulus.empty() && !isWithin) {
            isWithin = true;
            withinPatterns = before;
        }
        addPairs(*factor, comparisons.pairs);
        adjust(comparisons.pairs, isWithin ? withinPatterns : before);
    }
    return comparisons;
}

std::optional<double> patternPHolm(const TaskComparisons& comparisons, const std::string& pattern) {
    std::optional<double> p;
    std::size_t found = 0;
    for (const LevelPair& pair : comparisons.pairs) {
        if (pair.stimulus == pattern) {
            p = pair.pHolm;
            ++found;
        }
    }
    return found == 1 ? p : std::nullopt;
}

} // namespace teleta::study
