// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/study_results.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The tables of the results of a study: their columns, and functions that write the rows of one task.
/// Rows: a type with the members of core::CsvWriter. Thread: any (pure but for the rows).
namespace teleta::study {

namespace detail {

template <typename Rows>
void count(Rows& rows, std::size_t value) {
    rows.integer(static_cast<long long>(value));
}

template <typename Rows>
void textOrNa(Rows& rows, const std::string& text) {
    rows.text(text.empty() ? std::string_view("NA") : std::string_view(text));
}

template <typename Rows>
void interval(Rows& rows, const std::optional<Interval>& ends) {
    rows.number(ends ? std::optional(ends->low) : std::nullopt);
    rows.number(ends ? std::optional(ends->high) : std::nullopt);
}

template <typename Rows>
void transfer(Rows& rows, const std::optional<InformationTransfer>& bits) {
    rows.number(bits ? std::optional(bits->measured_bit) : std::nullopt);
    rows.number(bits ? std::optional(bits->bias_bit) : std::nullopt);
    rows.number(bits ? std::optional(bits->corrected_bit) : std::nullopt);
}

} // namespace detail

/// Each confusion matrix of a task, a row a pair of patterns; a pattern that was never presented has none.
inline constexpr std::array<std::string_view, 8> kConfusionColumns{
    "participant_id", "task", "condition", "phase", "stimulus", "response", "count", "row_total"};

template <typename Rows>
void writeConfusions(const TaskResults& task, Rows& rows) {
    for (const NamedMatrix& named : task.matrices) {
        for (std::size_t i = 0; i < task.patterns.size(); ++i) {
            if (named.matrix.rowTotal(i) == 0)
                continue;
            for (std::size_t j = 0; j < named.matrix.columns(); ++j) {
                rows.text(named.participant.empty() ? "GROUP" : std::string_view(named.participant));
                rows.text(task.task);
                rows.text(named.condition);
                rows.text(toString(named.phase));
                rows.text(task.patterns[i]);
                rows.text(j == named.matrix.noneColumn() ? std::string_view("NONE") : task.patterns[j]);
                rows.integer(named.matrix.count(i, j));
                rows.integer(named.matrix.rowTotal(i));
                rows.endRow();
            }
        }
    }
}

/// Each participant under each condition, test phase.
inline constexpr std::array<std::string_view, 17> kSummaryColumns{
    "participant_id", "task",         "condition",         "n",           "n_correct", "n_timeout",
    "accuracy",       "wilson_lo",    "wilson_hi",         "cp_lo",       "cp_hi",     "p_chance",
    "it_bits",        "it_bias_bits", "it_corrected_bits", "rt_median_s", "rt_n"};

template <typename Rows>
void writeSummary(const TaskResults& task, Rows& rows) {
    for (const ParticipantSummary& person : task.participants) {
        const std::int64_t n = person.matrix.total();
        const std::int64_t correct = person.matrix.correct();
        rows.text(person.participant);
        rows.text(task.task);
        rows.text(person.condition);
        rows.integer(n);
        rows.integer(correct);
        rows.integer(person.matrix.unanswered());
        rows.number(person.matrix.accuracy());
        detail::interval(rows, wilsonInterval(correct, n));
        detail::interval(rows, clopperPearsonInterval(correct, n));
        rows.number(chanceProbability(correct, n, 1.0 / static_cast<double>(task.alternatives())));
        detail::transfer(rows, informationTransfer(person.matrix));
        rows.number(person.medianTime_s);
        detail::count(rows, person.times_s.size());
        rows.endRow();
    }
}

/// All participants under each condition, test phase.
inline constexpr std::array<std::string_view, 17> kGroupColumns{
    "task",        "condition",  "participants", "accuracy_mean",     "accuracy_sd",   "t_lo",  "t_hi",
    "n",           "it_bits",    "it_bias_bits", "it_corrected_bits", "it_few_trials", "it_lo", "it_hi",
    "it_at_least", "it_at_most", "it_note"};

template <typename Rows>
void writeGroups(const TaskResults& task, Rows& rows) {
    for (const GroupSummary& group : task.groups) {
        const std::optional<TransferEstimate>& bits = group.transfer;
        rows.text(task.task);
        rows.text(group.condition);
        detail::count(rows, group.participants);
        rows.number(group.accuracy ? std::optional(group.accuracy->mean) : std::nullopt);
        rows.number(group.accuracy ? group.accuracy->standardDeviation : std::nullopt);
        detail::interval(rows, group.accuracy ? group.accuracy->interval : std::nullopt);
        rows.integer(group.matrix.total());
        rows.number(bits ? std::optional(bits->measured_bit) : std::nullopt);
        rows.number(bits ? std::optional(bits->measured_bit - bits->corrected_bit) : std::nullopt);
        rows.number(bits ? std::optional(bits->corrected_bit) : std::nullopt);
        rows.integer(bits && bits->fewTrials ? 1 : 0);
        detail::interval(rows, bits ? bits->interval : std::nullopt);
        rows.number(bits ? bits->atLeast_bit : std::nullopt);
        rows.number(bits ? bits->atMost_bit : std::nullopt);
        detail::textOrNa(rows, bits ? toString(bits->doubt) : "");
        rows.endRow();
    }
}

/// The ANOVA of the task.
inline constexpr std::array<std::string_view, 18> kAnovaColumns{
    "task",    "effect", "stimulus", "df1",    "df2",  "ss",           "ss_error",         "f",
    "p",       "eps_gg", "p_gg",     "eps_hf", "p_hf", "partial_eta2", "generalized_eta2", "n",
    "dropped", "note"};

template <typename Rows>
void writeAnova(const TaskResults& task, Rows& rows) {
    for (const AnovaLine& line : task.anova) {
        rows.text(task.task);
        rows.text(line.effect);
        detail::textOrNa(rows, line.stimulus);
        const auto value = [&](double AnovaEffect::*member) {
            rows.number(line.row ? std::optional((*line.row).*member) : std::nullopt);
        };
        for (const auto member : {&AnovaEffect::df1, &AnovaEffect::df2, &AnovaEffect::sumOfSquares,
                                  &AnovaEffect::errorSumOfSquares, &AnovaEffect::f, &AnovaEffect::p,
                                  &AnovaEffect::epsilonGg, &AnovaEffect::pGg})
            value(member);
        const std::optional<double> hf = line.row ? line.row->epsilonHf : std::nullopt;
        rows.number(hf ? std::optional(std::min(1.0, *hf)) : std::nullopt);
        rows.number(line.row ? line.row->pHf : std::nullopt);
        value(&AnovaEffect::partialEta2);
        value(&AnovaEffect::generalizedEta2);
        detail::count(rows, line.participants);
        std::string dropped;
        for (const std::string& person : line.dropped)
            dropped += (dropped.empty() ? "" : ";") + person;
        detail::textOrNa(rows, dropped);
        detail::textOrNa(rows, line.note);
        rows.endRow();
    }
}

} // namespace teleta::study
