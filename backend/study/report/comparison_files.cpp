// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/comparison_files.h"

#include "backend/core/data/csv_writer.h"
#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/comparison/time_comparisons.h"
#include "backend/study/model/accuracy_model.h"

#include <optional>
#include <string_view>

namespace teleta::study {

namespace {

using Word = std::optional<std::string_view>;
using Number = std::optional<double>;
using Whole = std::optional<long long>;

Word word(const std::string& text) {
    return text.empty() ? Word() : Word(text);
}

Whole whole(std::size_t value) {
    return static_cast<long long>(value);
}

Number lowOf(const std::optional<Interval>& ends) {
    return ends ? Number(ends->low) : Number();
}

Number highOf(const std::optional<Interval>& ends) {
    return ends ? Number(ends->high) : Number();
}

constexpr std::string_view kComparisonColumns =
    "task,effect,stimulus,first,second,n,difference,lo,hi,t,df,p,p_holm,family,dz,dz_lo,dz_hi,dav,hedges_j,"
    "gz,partial_eta2,partial_eta2_lo,partial_eta2_hi,note";

/// An effect as a whole, then the pairs of its levels.
void writePairs(const TaskResults& task, core::CsvWriter& csv) {
    const TaskComparisons comparisons = taskComparisons(task);
    const Number none;
    for (std::size_t i = 0; i < comparisons.effects.size(); ++i) {
        const EffectSupplement& effect = comparisons.effects[i];
        const AnovaLine& line = task.anova[i];
        csv.row(task.task, effect.effect, word(effect.stimulus), Word(), Word(), line.participants, none,
                none, none, none, none, none, none, Whole(), none, none, none, none, none, none,
                line.row ? Number(line.row->partialEta2) : none, lowOf(effect.partialEta2),
                highOf(effect.partialEta2), word(effect.note));
    }
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.comparison.test;
        const auto value = [&](double PairedTest::*member) { return test ? Number((*test).*member) : none; };
        csv.row(task.task, pair.effect, word(pair.stimulus), pair.first, pair.second,
                pair.comparison.participants, pair.comparison.difference,
                test ? Number(test->interval.low) : none, test ? Number(test->interval.high) : none,
                value(&PairedTest::t), value(&PairedTest::df), value(&PairedTest::p), pair.pHolm,
                whole(pair.family), value(&PairedTest::dz), test ? lowOf(test->dzInterval) : none,
                test ? highOf(test->dzInterval) : none, test ? test->dav : none, test ? test->hedges : none,
                test ? test->gz() : none, none, none, none, test ? Word() : Word(toString(test.error())));
    }
}

constexpr std::string_view kRankColumns =
    "task,effect,stimulus,test,first,second,n,zeros,w_plus,w_minus,chi2,df,p,p_holm,family,exact,"
    "rank_biserial,kendall_w,note";

void writeRanks(const TaskResults& task, core::CsvWriter& csv) {
    const TaskComparisons comparisons = taskComparisons(task);
    const Number none;
    for (const EffectSupplement& effect : comparisons.effects) {
        if (!effect.friedman)
            continue;
        const auto& test = *effect.friedman;
        const auto value = [&](double FriedmanTest::*member) {
            return test ? Number((*test).*member) : none;
        };
        csv.row(task.task, effect.effect, word(effect.stimulus), "friedman", Word(), Word(),
                test ? whole(test->participants) : Whole(), Whole(), none, none, value(&FriedmanTest::chi2),
                value(&FriedmanTest::df), value(&FriedmanTest::p), none, Whole(), Whole(), none,
                value(&FriedmanTest::w), test ? Word() : Word(toString(test.error())));
    }
    for (const LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.ranks;
        const auto value = [&](double SignedRankTest::*member) {
            return test ? Number((*test).*member) : none;
        };
        csv.row(task.task, pair.effect, word(pair.stimulus), "wilcoxon", pair.first, pair.second,
                test ? whole(test->participants) : Whole(), test ? whole(test->zeros) : Whole(),
                value(&SignedRankTest::positive), value(&SignedRankTest::negative), none, none,
                value(&SignedRankTest::p), pair.ranksHolm, whole(pair.ranksFamily),
                test ? Whole(test->isExact ? 1 : 0) : Whole(), value(&SignedRankTest::rankBiserial), none,
                test ? Word() : Word(toString(test.error())));
    }
}

constexpr std::string_view kModelColumns =
    "task,term,level,reference,estimate,se,lo,hi,sd_participants,log_likelihood,lr_chi2,lr_df,lr_p,"
    "participants,trials,note";

void writeModel(const TaskResults& task, core::CsvWriter& csv) {
    const Number none;
    if (task.groups.empty())
        return;
    const auto model = accuracyModel(task);
    if (!model) {
        csv.row(task.task, "model", Word(), Word(), none, none, none, none, none, none, none, none, none,
                Whole(), Whole(), toString(model.error()));
        return;
    }
    for (std::size_t i = 0; i < model->fit.b.size(); ++i) {
        const Interval ends = model->fit.interval(i);
        csv.row(task.task, i == 0 ? "intercept" : "condition", i == 0 ? Word() : Word(model->terms[i - 1]),
                model->reference, model->fit.b[i], model->fit.standardError(i), ends.low, ends.high,
                model->fit.s, model->fit.logLikelihood, none, none, none, model->fit.participants,
                model->trials, Word());
    }
    if (model->condition)
        csv.row(task.task, "condition", Word(), Word(), none, none, none, none, none, none,
                model->condition->chi2, model->condition->df, model->condition->p, model->fit.participants,
                model->trials, Word());
}

constexpr std::string_view kTimeColumns =
    "participant_id,task,condition,against,n,geometric_mean_s,median_s,ratio,lo,hi,t,df,p,p_holm,note";

void writeTimes(const TaskResults& task, core::CsvWriter& csv) {
    const TimeComparisons times = timeComparisons(task);
    const Number none;
    for (const ParticipantTimes& person : times.participants)
        csv.row(person.participant, task.task, person.condition, Word(), person.n, person.geometricMean_s,
                person.median_s, none, none, none, none, none, none, none, Word());
    for (const TimePair& pair : times.pairs) {
        const auto& test = pair.logs.test;
        const auto value = [&](double PairedTest::*member) { return test ? Number((*test).*member) : none; };
        csv.row("GROUP", task.task, pair.first, pair.second, pair.logs.participants, none, none, pair.ratio(),
                lowOf(pair.ratioInterval()), highOf(pair.ratioInterval()), value(&PairedTest::t),
                value(&PairedTest::df), value(&PairedTest::p), pair.pHolm,
                test ? Word() : Word(toString(test.error())));
    }
}

core::Expected<void> writeComparisonTable(const std::vector<TaskResults>& results, const std::string& path,
                                          std::string_view columns,
                                          void (*write)(const TaskResults&, core::CsvWriter&)) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, columns));
    for (const TaskResults& task : results)
        write(task, csv);
    return csv.finish();
}

} // namespace

core::Expected<void> writeComparisons(const std::vector<TaskResults>& results, const std::string& folder) {
    TELETA_CHECK(writeComparisonTable(results, folder + "/comparisons.csv", kComparisonColumns, writePairs));
    TELETA_CHECK(writeComparisonTable(results, folder + "/ranks.csv", kRankColumns, writeRanks));
    TELETA_CHECK(writeComparisonTable(results, folder + "/binomial_model.csv", kModelColumns, writeModel));
    return writeComparisonTable(results, folder + "/response_times.csv", kTimeColumns, writeTimes);
}

} // namespace teleta::study
