// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_writer.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/report/codebook.h"
#include "backend/study/report/study_export.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace teleta::study {

namespace {

using Results = std::vector<TaskResults>;

void count(core::CsvWriter& csv, std::size_t value) {
    csv.integer(static_cast<long long>(value));
}

void textOrNa(core::CsvWriter& csv, const std::string& text) {
    csv.text(text.empty() ? std::string_view("NA") : std::string_view(text));
}

void interval(core::CsvWriter& csv, const std::optional<Interval>& ends) {
    csv.number(ends ? std::optional(ends->low) : std::nullopt);
    csv.number(ends ? std::optional(ends->high) : std::nullopt);
}

void transfer(core::CsvWriter& csv, const std::optional<InformationTransfer>& bits) {
    csv.number(bits ? std::optional(bits->measured_bit) : std::nullopt);
    csv.number(bits ? std::optional(bits->bias_bit) : std::nullopt);
    csv.number(bits ? std::optional(bits->corrected_bit) : std::nullopt);
}

constexpr std::array<std::string_view, 8> kConfusionColumns{
    "participant_id", "task", "condition", "phase", "stimulus", "response", "count", "row_total"};

void writeConfusions(const TaskResults& task, core::CsvWriter& csv) {
    for (const NamedMatrix& named : task.matrices) {
        for (std::size_t i = 0; i < task.patterns.size(); ++i) {
            if (named.matrix.rowTotal(i) == 0)
                continue;
            for (std::size_t j = 0; j < named.matrix.columns(); ++j) {
                csv.text(named.participant.empty() ? "GROUP" : std::string_view(named.participant));
                csv.text(task.task);
                csv.text(named.condition);
                csv.text(toString(named.phase));
                csv.text(task.patterns[i]);
                csv.text(j == named.matrix.noneColumn() ? std::string_view("NONE") : task.patterns[j]);
                csv.integer(named.matrix.count(i, j));
                csv.integer(named.matrix.rowTotal(i));
                csv.endRow();
            }
        }
    }
}

constexpr std::array<std::string_view, 17> kSummaryColumns{
    "participant_id", "task",         "condition",         "n",           "n_correct", "n_timeout",
    "accuracy",       "wilson_lo",    "wilson_hi",         "cp_lo",       "cp_hi",     "p_chance",
    "it_bits",        "it_bias_bits", "it_corrected_bits", "rt_median_s", "rt_n"};

void writeSummary(const TaskResults& task, core::CsvWriter& csv) {
    for (const ParticipantSummary& person : task.participants) {
        const std::int64_t n = person.matrix.total();
        const std::int64_t correct = person.matrix.correct();
        csv.text(person.participant);
        csv.text(task.task);
        csv.text(person.condition);
        csv.integer(n);
        csv.integer(correct);
        csv.integer(person.matrix.unanswered());
        csv.number(person.matrix.accuracy());
        interval(csv, wilsonInterval(correct, n));
        interval(csv, clopperPearsonInterval(correct, n));
        csv.number(chanceProbability(correct, n, 1.0 / static_cast<double>(task.alternatives())));
        transfer(csv, informationTransfer(person.matrix));
        csv.number(person.medianTime_s);
        count(csv, person.times);
        csv.endRow();
    }
}

constexpr std::array<std::string_view, 17> kGroupColumns{
    "task",        "condition",  "participants", "accuracy_mean",     "accuracy_sd",   "t_lo",  "t_hi",
    "n",           "it_bits",    "it_bias_bits", "it_corrected_bits", "it_few_trials", "it_lo", "it_hi",
    "it_at_least", "it_at_most", "it_note"};

void writeGroups(const TaskResults& task, core::CsvWriter& csv) {
    for (const GroupSummary& group : task.groups) {
        const std::optional<TransferEstimate>& bits = group.transfer;
        csv.text(task.task);
        csv.text(group.condition);
        count(csv, group.participants);
        csv.number(group.accuracy ? std::optional(group.accuracy->mean) : std::nullopt);
        csv.number(group.accuracy ? group.accuracy->standardDeviation : std::nullopt);
        interval(csv, group.accuracy ? group.accuracy->interval : std::nullopt);
        csv.integer(group.matrix.total());
        csv.number(bits ? std::optional(bits->measured_bit) : std::nullopt);
        csv.number(bits ? std::optional(bits->measured_bit - bits->corrected_bit) : std::nullopt);
        csv.number(bits ? std::optional(bits->corrected_bit) : std::nullopt);
        csv.integer(bits && bits->fewTrials ? 1 : 0);
        interval(csv, bits ? bits->interval : std::nullopt);
        csv.number(bits ? bits->atLeast_bit : std::nullopt);
        csv.number(bits ? bits->atMost_bit : std::nullopt);
        textOrNa(csv, bits ? toString(bits->doubt) : "");
        csv.endRow();
    }
}

constexpr std::array<std::string_view, 18> kAnovaColumns{
    "task",    "effect", "stimulus", "df1",    "df2",  "ss",           "ss_error",         "f",
    "p",       "eps_gg", "p_gg",     "eps_hf", "p_hf", "partial_eta2", "generalized_eta2", "n",
    "dropped", "note"};

void writeAnova(const TaskResults& task, core::CsvWriter& csv) {
    for (const AnovaLine& line : task.anova) {
        csv.text(task.task);
        csv.text(line.effect);
        textOrNa(csv, line.stimulus);
        const auto value = [&](double AnovaEffect::*member) {
            csv.number(line.row ? std::optional((*line.row).*member) : std::nullopt);
        };
        for (const auto member : {&AnovaEffect::df1, &AnovaEffect::df2, &AnovaEffect::sumOfSquares,
                                  &AnovaEffect::errorSumOfSquares, &AnovaEffect::f, &AnovaEffect::p,
                                  &AnovaEffect::epsilonGg, &AnovaEffect::pGg})
            value(member);
        const std::optional<double> hf = line.row ? line.row->epsilonHf : std::nullopt;
        csv.number(hf ? std::optional(std::min(1.0, *hf)) : std::nullopt);
        csv.number(line.row ? line.row->pHf : std::nullopt);
        value(&AnovaEffect::partialEta2);
        value(&AnovaEffect::generalizedEta2);
        count(csv, line.participants);
        std::string dropped;
        for (const std::string& person : line.dropped)
            dropped += (dropped.empty() ? "" : ";") + person;
        textOrNa(csv, dropped);
        textOrNa(csv, line.note);
        csv.endRow();
    }
}

template <std::size_t Columns>
core::Expected<void> writeTable(const Results& results, const std::string& path,
                                const std::array<std::string_view, Columns>& columns,
                                void (*write)(const TaskResults&, core::CsvWriter&)) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, columns));
    for (const TaskResults& task : results)
        write(task, csv);
    return csv.finish();
}

} // namespace

core::Expected<void> writeResults(const Results& results, const std::string& folder) {
    TELETA_CHECK(core::makeFolder(folder));
    TELETA_TRY(const std::string script, analysisScript());
    TELETA_CHECK(writeTable(results, folder + "/confusion_long.csv", kConfusionColumns, writeConfusions));
    TELETA_CHECK(writeTable(results, folder + "/summary.csv", kSummaryColumns, writeSummary));
    TELETA_CHECK(writeTable(results, folder + "/group.csv", kGroupColumns, writeGroups));
    TELETA_CHECK(writeTable(results, folder + "/anova.csv", kAnovaColumns, writeAnova));
    TELETA_CHECK(core::writeFile(folder + "/codebook.csv", codebookText()));
    return core::writeFile(folder + "/analysis.R", script);
}

} // namespace teleta::study
