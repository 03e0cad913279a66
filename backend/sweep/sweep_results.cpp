// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_results.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/quantile.h"
#include "backend/study/analysis/proportion.h"
#include "backend/sweep/sweep_parts.h"

#include <QDir>
#include <QFile>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <unordered_map>

namespace teleta::sweep {

namespace {

/// A row with its measures as places in a list of names.
struct MergedRow {
    RunRow row;
    std::vector<std::pair<std::uint32_t, double>> values;
};

struct MergedRuns {
    std::vector<std::string> names; ///< in the order of the parts; those that no run has come last
    std::vector<MergedRow> rows;    ///< sorted by run, each once
};

core::Expected<MergedRuns> mergedRuns(const SweepPlan& plan, const std::string& folder) {
    MergedRuns merged;
    std::unordered_map<std::string, std::uint32_t> places;
    std::set<std::string> columns;
    TELETA_CHECK(readParts(
        folder,
        [&](RunRow&& row) {
            if (row.run >= plan.runs())
                return;
            MergedRow& added = merged.rows.emplace_back();
            for (const auto& [name, value] : row.measures) {
                const auto [place, isNew] =
                    places.try_emplace(name, static_cast<std::uint32_t>(merged.names.size()));
                if (isNew)
                    merged.names.push_back(name);
                added.values.emplace_back(place->second, value);
            }
            row.measures.clear();
            added.row = std::move(row);
        },
        &columns));
    // A list that could not be determined in some runs has columns of its own in others.
    std::set<std::string> lists;
    for (const std::string& name : merged.names)
        lists.insert(baseName(name));
    for (const std::string& column : columns)
        if (!places.contains(column) && !lists.contains(column))
            merged.names.push_back(column);
    // Of the same run the first part's row comes first and stays.
    std::ranges::stable_sort(merged.rows, {}, [](const MergedRow& each) { return each.row.run; });
    merged.rows.erase(
        std::unique(merged.rows.begin(), merged.rows.end(),
                    [](const MergedRow& a, const MergedRow& b) { return a.row.run == b.row.run; }),
        merged.rows.end());
    return merged;
}

/// Places of the names in the order in which the sorted runs bring them up, or of the plan's measures. Each
/// part has its names in this order, so it does not depend on the parts.
std::vector<std::uint32_t> orderOf(const SweepPlan& plan, const MergedRuns& merged) {
    std::vector<bool> seen(merged.names.size(), false);
    std::vector<std::uint32_t> order;
    for (const MergedRow& row : merged.rows)
        for (const auto& [place, value] : row.values)
            if (!seen[place]) {
                seen[place] = true;
                order.push_back(place);
            }
    for (std::uint32_t place = 0; place < seen.size(); ++place)
        if (!seen[place])
            order.push_back(place);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t place) {
        const std::string& name = merged.names[place];
        return std::ranges::find_if(
                   plan.measures,
                   [&](const std::string& wanted) { return wanted == name || wanted == baseName(name); }) -
               plan.measures.begin();
    });
    return order;
}

SweepResults resultsOf(const SweepPlan& plan, const MergedRuns& merged,
                       const std::vector<std::uint32_t>& order) {
    SweepResults results;
    results.all = plan.runs();
    std::vector<std::size_t> column(merged.names.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        column[order[i]] = i;
        results.measures.push_back(merged.names[order[i]]);
    }
    std::vector<std::vector<double>> all(order.size());
    for (const MergedRow& row : merged.rows)
        for (const auto& [place, value] : row.values)
            all[column[place]].push_back(value);
    for (std::size_t i = 0; i < order.size(); ++i)
        results.shares.push_back(isShare(results.measures[i], all[i]));

    std::vector<std::vector<double>> values(order.size());
    std::size_t next = 0;
    for (std::uint64_t cell = 0; cell < plan.cells(); ++cell) {
        CellResult& result = results.cells.emplace_back();
        result.cell = cell;
        for (std::vector<double>& each : values)
            each.clear();
        for (; next < merged.rows.size() && plan.cellOf(merged.rows[next].row.run) == cell; ++next) {
            const MergedRow& row = merged.rows[next];
            ++result.runs;
            result.failed += row.row.failed() ? 1 : 0;
            result.processor_s += row.row.processor_s;
            for (const auto& [place, value] : row.values)
                values[column[place]].push_back(value);
        }
        for (std::size_t i = 0; i < order.size(); ++i)
            result.measures.push_back(cellMeasure(values[i], results.shares[i]));
        results.done += result.runs;
        results.failed += result.failed;
    }
    return results;
}

std::vector<std::string_view> columnsOf(std::initializer_list<std::string_view> first,
                                        const std::vector<std::string>& keys,
                                        std::initializer_list<std::string_view> then) {
    std::vector<std::string_view> columns(first);
    columns.insert(columns.end(), keys.begin(), keys.end());
    columns.insert(columns.end(), then);
    return columns;
}

std::vector<std::string> settingTexts(const SweepPlan& plan, std::uint64_t cell) {
    std::vector<std::string> texts;
    for (const auto& [key, value] : plan.settingsOf(cell))
        texts.push_back(core::plainText(value));
    return texts;
}

core::Expected<void> writeRuns(const SweepPlan& plan, const MergedRuns& merged,
                               const std::vector<std::uint32_t>& order, const SweepResults& results,
                               const std::string& path) {
    const std::vector<std::string> keys = plan.keys();
    std::vector<std::string_view> columns = columnsOf({"run", "cell", "seed"}, keys, {"status", "reason"});
    columns.insert(columns.end(), results.measures.begin(), results.measures.end());
    columns.insert(columns.end(), {"wall_s", "processor_s"});
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, columns));
    std::vector<std::size_t> column(merged.names.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i)
        column[order[i]] = i;
    std::vector<std::optional<double>> values(order.size());
    std::vector<std::string> settings;
    std::optional<std::uint64_t> settingsCell;
    for (const MergedRow& row : merged.rows) {
        const std::uint64_t cell = plan.cellOf(row.row.run);
        if (settingsCell != cell)
            settings = settingTexts(plan, cell);
        settingsCell = cell;
        std::ranges::fill(values, std::nullopt);
        for (const auto& [place, value] : row.values)
            values[column[place]] = value;
        csv.row(row.row.run, cell, plan.seedOf(row.row.run), settings, row.row.failed() ? "failed" : "ok",
                row.row.reason, values, row.row.wall_s, row.row.processor_s);
    }
    return csv.finish();
}

core::Expected<void> writeCells(const SweepPlan& plan, const SweepResults& results, const std::string& path) {
    const std::vector<std::string> keys = plan.keys();
    TELETA_TRY(
        core::CsvWriter csv,
        core::CsvWriter::create(path, columnsOf({"cell"}, keys,
                                                {"measure", "runs", "failed", "n", "mean", "sd", "median",
                                                 "p05", "p95", "interval", "low95", "high95"})));
    for (const CellResult& cell : results.cells) {
        const std::vector<std::string> settings = settingTexts(plan, cell.cell);
        for (std::size_t i = 0; i < results.measures.size(); ++i) {
            const CellMeasure& measure = cell.measures[i];
            csv.row(cell.cell, settings, results.measures[i], cell.runs, cell.failed, measure.n, measure.mean,
                    measure.sd, measure.median, measure.p05, measure.p95, results.shares[i] ? "wilson" : "t",
                    measure.low95, measure.high95);
        }
    }
    return csv.finish();
}

/// complete: no writer is at work for a run that has no row yet.
core::Expected<void> writeFrames(const MergedRuns& merged, const std::string& folder, bool complete) {
    const QDir dir(QString::fromStdString(folder + "/frames"));
    const QStringList found = dir.entryList({QStringLiteral("*.npz")}, QDir::Files);
    const std::set<QString> there(found.begin(), found.end());
    std::set<QString> named;
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(folder + "/frames.csv",
                                                            std::array<std::string_view, 2>{"run", "file"}));
    for (const MergedRow& row : merged.rows) {
        const QString file = QString::fromStdString(partName(row.row.part) + ".npz");
        // A run that failed has none, nor has one of a world without an array.
        if (row.row.failed() || !there.contains(file))
            continue;
        csv.row(row.row.run, "frames/" + file.toStdString());
        named.insert(file);
    }
    TELETA_CHECK(csv.finish());
    for (const QString& file : found)
        if (complete && !named.contains(file))
            QFile::remove(dir.filePath(file)); // another that merges may have done it
    return {};
}

} // namespace

bool isShare(const std::string& measure, const std::vector<double>& values) {
    constexpr std::array<std::string_view, 4> kShares{"completed", "significant", "refused",
                                                      "stopped_without_bump"};
    const bool named = std::ranges::find(kShares, measure) != kShares.end() ||
                       measure.ends_with("_covered") || measure.ends_with("_share");
    return named && !values.empty() &&
           std::ranges::all_of(values, [](double value) { return value >= 0.0 && value <= 1.0; });
}

CellMeasure cellMeasure(const std::vector<double>& values, bool share) {
    CellMeasure measure;
    measure.n = values.size();
    if (values.empty())
        return measure;
    const auto group = study::groupMean(values);
    if (group) {
        measure.mean = group->mean;
        measure.sd = group->standardDeviation;
        if (const auto ends = share ? study::wilsonShareInterval(std::clamp(group->mean, 0.0, 1.0),
                                                                 static_cast<std::int64_t>(values.size()))
                                    : group->interval) {
            measure.low95 = ends->low;
            measure.high95 = ends->high;
        }
    }
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    measure.median = core::quantileOf(sorted, 0.5);
    measure.p05 = core::quantileOf(sorted, 0.05);
    measure.p95 = core::quantileOf(sorted, 0.95);
    return measure;
}

core::Expected<SweepResults> readResults(const SweepPlan& plan, const std::string& folder) {
    TELETA_TRY(const MergedRuns merged, mergedRuns(plan, folder));
    return resultsOf(plan, merged, orderOf(plan, merged));
}

core::Expected<SweepResults> mergeParts(const SweepPlan& plan, const std::string& folder, bool frames) {
    TELETA_TRY(const MergedRuns merged, mergedRuns(plan, folder));
    const std::vector<std::uint32_t> order = orderOf(plan, merged);
    SweepResults results = resultsOf(plan, merged, order);
    TELETA_CHECK(writeRuns(plan, merged, order, results, folder + "/runs.csv"));
    TELETA_CHECK(writeCells(plan, results, folder + "/cells.csv"));
    if (frames)
        TELETA_CHECK(writeFrames(merged, folder, results.done == results.all));
    return results;
}

} // namespace teleta::sweep
