// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_writing.h"

#include "backend/figure/figure_file.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/felt/felt_task.h"
#include "backend/study/methods/figures/threshold_figures.h"
#include "backend/study/methods/results/level_trial_store.h"
#include "backend/study/methods/results/threshold_files.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/report/exclusion_report.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/report/study_figures.h"
#include "backend/study/report/study_report.h"

#include <QCoreApplication>
#include <QDir>

#include <utility>

namespace teleta::console {

namespace {

struct WritingText {
    Q_DECLARE_TR_FUNCTIONS(StudyWriting)
};

/// Of the tasks with levels, as far as their stimuli are known.
std::vector<study::FeltTask> feltTasks(const study::StudyHead& head) {
    std::vector<study::FeltTask> felt;
    for (const study::StudyTask& task : head.protocol.tasks) {
        if (task.design == study::Design::identification)
            continue;
        if (const pattern::Pattern* stimulus = head.stimuli.find(study::levelStimulusId(task)))
            felt.push_back(study::feltTask(task, *stimulus));
    }
    return felt;
}

core::Expected<study::LevelResults> levelResultsOf(const study::StudyStore& store, study::ModeFilter& modes) {
    study::LevelTrials trials;
    TELETA_CHECK(study::addLevelTrials(store, modes, trials));
    study::LevelResults results{study::thresholdResults(trials), study::detectionResults(trials),
                                feltTasks(store.head())};
    if (const auto all = trials.withoutRules())
        results.withoutRules = study::thresholdResults(*all);
    return results;
}

core::Expected<StudyResults> resultsOf(const study::StudyStore& store, study::TrialTally& tally) {
    study::ModeFilter modes;
    study::ExclusionBook exclusions;
    TELETA_CHECK(study::tallyStore(store, modes, tally, exclusions));
    TELETA_CHECK(study::settle(exclusions, tally, store.shownName()));
    TELETA_TRY(study::LevelResults levels, levelResultsOf(store, modes));
    StudyResults results;
    results.tasks = study::studyResults(tally);
    results.exclusions = study::exclusionReport(exclusions);
    for (const study::TaskResults& task : results.tasks)
        results.supplements.push_back(study::taskSupplement(task));
    results.levels = std::make_shared<const study::LevelResults>(std::move(levels));
    return results;
}

core::Expected<void> writeLevelResults(const study::LevelResults& levels, const std::string& folder,
                                       study::Mode mode, const std::vector<study::FigureFormat>& formats) {
    std::vector<study::ThresholdFigureFormat> same;
    for (const study::FigureFormat& format : formats)
        same.push_back({format.extension, format.convert});
    TELETA_CHECK(study::writeThresholds(levels.thresholds, levels.detection, folder));
    return study::writeThresholdFigures(levels.thresholds, levels.detection, folder, mode, same);
}

/// Writes tables, figures and report into the study's folder "results", which is returned.
core::Expected<QString> writeAnalysis(const study::StudyStore& store, const QDir& study) {
    study::TrialTally tally;
    TELETA_TRY(const StudyResults found, resultsOf(store, tally));
    const std::vector<study::TaskResults>& tasks = found.tasks;
    const QString results = study.filePath(QStringLiteral("results"));
    const std::string folder = results.toStdString();
    const study::Mode mode = store.head().mode;
    const std::vector<study::FigureFormat> formats = {
        {"svg", {}},
        {"pdf", [](const std::string& svg) { return figure::pdfOf(svg); }},
        {"png", [](const std::string& svg) { return figure::pngOf(svg); }}};
    const bool onServer = !store.location().server.empty();
    const study::ReportHeading heading{WritingText::tr("Results of the study").toStdString(),
                                       mode,
                                       {onServer ? store.shownName() : study.path().toStdString()},
                                       QCoreApplication::applicationVersion().toStdString(),
                                       tally.frames(),
                                       found.exclusions,
                                       found.levels->thresholds,
                                       found.levels->detection};
    return study::writeResults(tasks, folder)
        .and_then([&] { return study::writeExclusions(found.exclusions.lines, folder); })
        .and_then([&] { return study::writeFigures(tasks, folder, mode, formats); })
        .and_then([&] { return writeLevelResults(*found.levels, folder, mode, formats); })
        .and_then([&] { return study::writeReport(tasks, heading, folder); })
        .map([&] { return results; });
}

} // namespace

core::Expected<StudyResults> resultsOf(const study::StoreLocation& location) {
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(location));
    study::TrialTally tally;
    return resultsOf(store, tally);
}

core::Expected<QString> writeStudy(const study::StudyStore& store, const QString& format) {
    const QDir study(QString::fromStdString(store.folder()));
    if (format == QLatin1String("analysis"))
        return writeAnalysis(store, study);
    const bool bids = format == QLatin1String("bids");
    const bool excel = format == QLatin1String("excel");
    return study::exportStudy(store, bids    ? study::ExportFormat::bids
                                     : excel ? study::ExportFormat::excel
                                             : study::ExportFormat::psychds)
        .map([&](std::size_t) {
            return study.filePath(bids    ? QStringLiteral("bids")
                                  : excel ? QStringLiteral("excel")
                                          : QStringLiteral("data"));
        });
}

core::Expected<QString> writeStudy(const study::StoreLocation& location, const QString& format) {
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(location));
    return writeStudy(store, format);
}

} // namespace teleta::console
