// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/base/long_work.h"
#include "app/python/base/table_rows.h"
#include "app/python/core/core_bindings.h"
#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/study_rows.h"
#include "backend/study/analysis/trial_tally.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/study_figures.h"
#include "backend/study/report/study_report.h"
#include "backend/study/store/study_store.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

using Results = std::vector<study::TaskResults>;

/// Counts the trials of studies (folders) and trial CSVs.
core::Expected<void> tallyPaths(const std::vector<std::string>& paths, study::ModeFilter& modes,
                                study::TrialTally& tally, LongWork& work) {
    for (const std::string& path : paths) {
        if (QFileInfo(QString::fromStdString(path)).isDir()) {
            TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading({path, {}}));
            TELETA_CHECK(study::tallyStore(store, modes, tally));
        } else {
            TELETA_CHECK(study::tallyCsv(path, modes, tally, [&work](std::uint64_t) { return work.goOn(); }));
        }
    }
    return {};
}

std::vector<std::string> column(const py::dict& table, const char* name) {
    const py::object values = table[name];
    std::vector<std::string> texts;
    for (const py::handle value : values)
        texts.emplace_back(py::str(value));
    return texts;
}

/// Counts the trials of a table.
void tallyTable(const py::dict& table, study::TrialTally& tally) {
    const std::vector<std::string> participants = column(table, "participant_id");
    const std::vector<std::string> tasks = column(table, "task");
    const std::vector<std::string> conditions = column(table, "condition");
    const std::vector<std::string> stimuli = column(table, "stimulus");
    const std::vector<std::string> responses = column(table, "response");
    const bool phased = table.contains("phase");
    const std::vector<std::string> phases = phased ? column(table, "phase") : std::vector<std::string>();
    const bool timed = table.contains("response_time_s");
    const std::vector<double> times_s =
        timed ? numbers(table["response_time_s"], "response_time_s") : std::vector<double>();
    const auto sameLength = [&](const char* name, std::size_t length) {
        if (length != participants.size())
            throw wrongValue(name, "as many values as participant_id, " + std::to_string(participants.size()),
                             std::to_string(length));
    };
    sameLength("task", tasks.size());
    sameLength("condition", conditions.size());
    sameLength("stimulus", stimuli.size());
    sameLength("response", responses.size());
    if (phased)
        sameLength("phase", phases.size());
    if (timed)
        sameLength("response_time_s", times_s.size());
    for (std::size_t i = 0; i < participants.size(); ++i) {
        const std::string& given = responses[i];
        study::TalliedTrial trial;
        trial.participant = participants[i];
        trial.task = tasks[i];
        trial.condition = conditions[i];
        if (phased) {
            const std::optional<study::Phase> phase = study::phaseOf(phases[i]);
            if (!phase)
                throw wrongValue("phase", "'practice' or 'test'", phases[i]);
            trial.phase = *phase;
        }
        trial.stimulus = stimuli[i];
        trial.response = given == "NA" || given == "NONE" || given == "None" || given == "nan"
                             ? std::string_view()
                             : std::string_view(given);
        if (timed && std::isfinite(times_s[i]))
            trial.responseTime_s = times_s[i];
        if (!tally.add(trial))
            throw wrongValue(
                "stimulus", "at most " + std::to_string(study::TrialTally::kMostNames) + " names of patterns",
                "more");
    }
}

core::Expected<void> write(const Results& results, const study::ModeFilter& modes,
                           const study::TrialTally::Frames& frames, const std::vector<std::string>& sources,
                           const std::string& folder) {
    study::ReportHeading heading;
    heading.frames = frames;
    heading.title = "Results of the study";
    heading.mode = modes.wanted ? modes.wanted : modes.seen;
    heading.sources = sources;
    heading.appVersion = TELETA_VERSION;
    TELETA_CHECK(study::writeResults(results, folder));
    TELETA_CHECK(study::writeFigures(results, folder, heading.mode));
    return study::writeReport(results, heading, folder);
}

template <std::size_t kColumns>
py::dict toTable(const Results& results, const std::array<std::string_view, kColumns>& columns,
                 std::string_view kinds, void (*writeRows)(const study::TaskResults&, TableRows&)) {
    TableRows rows(columns, kinds);
    for (const study::TaskResults& task : results)
        writeRows(task, rows);
    return std::move(rows).table();
}

py::dict analyze(const py::object& input, const py::object& out, const std::optional<std::string>& mode) {
    study::TrialTally tally;
    study::ModeFilter modes;
    if (mode) {
        modes.wanted = study::modeOf(*mode);
        if (!modes.wanted)
            throw wrongValue("mode", "'run', 'pilot' or 'simulated'", std::string(py::repr(py::str(*mode))));
    }
    const std::string folder = out.is_none() ? std::string() : pathOf(out);
    std::vector<std::string> paths;
    LongWork work;
    core::Expected<void> done;
    if (py::isinstance<py::dict>(input)) {
        tallyTable(input.cast<py::dict>(), tally);
    } else {
        for (const py::handle path : input)
            paths.push_back(pathOf(path));
        const py::gil_scoped_release released;
        done = tallyPaths(paths, modes, tally, work);
    }
    work.rethrow();
    valueOf(done);
    if (tally.cells().empty())
        throw Failure({core::ErrorKind::badInput,
                       "there are no completed trials",
                       "trials that were answered or timed out",
                       {paths.empty() ? "" : paths.front()}});
    Results results;
    {
        const py::gil_scoped_release released;
        results = study::studyResults(tally);
        if (!folder.empty())
            done = write(results, modes, tally.frames(), paths, folder);
    }
    valueOf(done);
    py::dict tables;
    tables["summary"] =
        toTable(results, study::kSummaryColumns, "sssiiiffffffffffi", &study::writeSummary<TableRows>);
    tables["group"] =
        toTable(results, study::kGroupColumns, "ssiffffifffiffffs", &study::writeGroups<TableRows>);
    tables["confusion"] =
        toTable(results, study::kConfusionColumns, "ssssssii", &study::writeConfusions<TableRows>);
    tables["anova"] =
        toTable(results, study::kAnovaColumns, "sssffffffffffffiss", &study::writeAnova<TableRows>);
    return tables;
}

/// Counts (patterns, patterns) or, with a last column of trials without an answer, (patterns, patterns + 1).
study::ConfusionMatrix matrixOf(const py::object& counts) {
    const auto array = realArray<double>(counts, "matrix");
    const py::ssize_t rows = array.ndim() == 2 ? array.shape(0) : 0;
    if (array.ndim() != 2 || rows < 1 || (array.shape(1) != rows && array.shape(1) != rows + 1))
        throw wrongValue("matrix", "(k, k) or (k, k + 1)", shapeText(array));
    const auto patterns = static_cast<std::size_t>(rows);
    study::ConfusionMatrix matrix(patterns);
    for (std::size_t i = 0; i < patterns; ++i) {
        for (std::size_t j = 0; j < static_cast<std::size_t>(array.shape(1)); ++j) {
            const double count = array.data()[i * static_cast<std::size_t>(array.shape(1)) + j];
            if (!(count >= 0.0 && count <= 1e15) || count != std::floor(count))
                throw wrongValue("matrix", "whole counts of 0 or more",
                                 std::string(py::repr(py::float_(count))));
            matrix.add(i, j == patterns ? std::nullopt : std::optional(j), static_cast<std::int64_t>(count));
        }
    }
    return matrix;
}

py::dict informationTransfer(const py::object& counts, std::size_t alternatives) {
    const auto transfer = study::informationTransfer(matrixOf(counts), alternatives);
    if (!transfer)
        throw Failure({core::ErrorKind::refused, "the matrix has no trials", "at least one trial", {}});
    py::dict fields;
    fields["it_bits"] = transfer->measured_bit;
    fields["it_bias_bits"] = transfer->bias_bit;
    fields["it_corrected_bits"] = transfer->corrected_bit;
    fields["it_few_trials"] = transfer->fewTrials;
    return fields;
}

template <auto kInterval>
py::tuple interval(std::int64_t successes, std::int64_t trials, double confidence) {
    const std::optional<study::Interval> ends = kInterval(successes, trials, confidence);
    if (!ends)
        throw py::value_error(
            "k: expected 0 <= k <= n, n of 1 or more and a confidence between 0 and 1, got k = " +
            std::to_string(successes) + ", n = " + std::to_string(trials) +
            ", confidence = " + std::string(py::repr(py::float_(confidence))));
    return py::make_tuple(ends->low, ends->high);
}

void addEffect(TableRows& rows, const std::string& effect, const study::AnovaRow& row,
               std::size_t participants, std::size_t dropped) {
    rows.text(effect);
    const auto value = [&](double study::AnovaEffect::*member) {
        rows.number(row ? std::optional((*row).*member) : std::nullopt);
    };
    using study::AnovaEffect;
    for (const auto member :
         {&AnovaEffect::df1, &AnovaEffect::df2, &AnovaEffect::sumOfSquares, &AnovaEffect::errorSumOfSquares,
          &AnovaEffect::f, &AnovaEffect::p, &AnovaEffect::epsilonGg, &AnovaEffect::pGg})
        value(member);
    const std::optional<double> hf = row ? row->epsilonHf : std::nullopt;
    rows.number(hf ? std::optional(std::min(1.0, *hf)) : std::nullopt);
    rows.number(row ? row->pHf : std::nullopt);
    value(&AnovaEffect::partialEta2);
    value(&AnovaEffect::generalizedEta2);
    rows.integer(static_cast<long long>(participants));
    rows.integer(static_cast<long long>(dropped));
    rows.text(row ? "" : study::toString(row.error()));
    rows.endRow();
}

/// cells: (participants, levels) or (participants, levels of the first, levels of the second factor).
py::dict repeatedAnova(const py::object& cells, const std::string& first, const std::string& second) {
    const auto array = realArray<double>(cells, "cells");
    if (array.ndim() != 2 && array.ndim() != 3)
        throw wrongValue("cells", "(participants, levels) or (participants, levels, levels)",
                         shapeText(array));
    const auto people = static_cast<std::size_t>(array.shape(0));
    const std::size_t columns = people > 0 ? static_cast<std::size_t>(array.size()) / people : 0;
    study::ParticipantCells rows;
    for (std::size_t i = 0; i < people; ++i)
        rows.emplace_back(array.data() + i * columns, array.data() + (i + 1) * columns);
    constexpr std::array<std::string_view, 16> kColumns{
        "effect", "df1",    "df2",  "ss",           "ss_error",         "f", "p",       "eps_gg",
        "p_gg",   "eps_hf", "p_hf", "partial_eta2", "generalized_eta2", "n", "dropped", "note"};
    TableRows table(kColumns, "sffffffffffffiis");
    const auto refused = [](study::Refusal refusal) {
        return Failure({core::ErrorKind::refused,
                        std::string("there is no analysis of variance: ") + study::toString(refusal),
                        "at least two participants and two levels, and finite values",
                        {}});
    };
    if (array.ndim() == 2) {
        const auto anova = study::oneWayAnova(rows);
        if (!anova)
            throw refused(anova.error());
        addEffect(table, first, anova->effect, anova->participants, anova->dropped.size());
    } else {
        const auto anova = study::twoWayAnova(rows, static_cast<std::size_t>(array.shape(1)),
                                              static_cast<std::size_t>(array.shape(2)));
        if (!anova)
            throw refused(anova.error());
        const std::size_t dropped = anova->dropped.size();
        addEffect(table, first, anova->first, anova->participants, dropped);
        addEffect(table, second, anova->second, anova->participants, dropped);
        addEffect(table, first + ":" + second, anova->interaction, anova->participants, dropped);
    }
    return std::move(table).table();
}

} // namespace

void bindStudy(py::module_& module) {
    module.def("study_analyze", &analyze);
    module.def("study_information_transfer", &informationTransfer);
    module.def("study_wilson", &interval<study::wilsonInterval>);
    module.def("study_clopper_pearson", &interval<study::clopperPearsonInterval>);
    module.def("study_repeated_anova", &repeatedAnova);
}

} // namespace teleta::python
