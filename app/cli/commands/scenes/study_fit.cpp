// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_fit.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/failure.h"
#include "backend/figure/figure_file.h"
#include "backend/study/methods/figures/threshold_figures.h"
#include "backend/study/methods/results/bracelet_results.h"
#include "backend/study/methods/results/level_trial_source.h"
#include "backend/study/methods/results/level_trial_store.h"
#include "backend/study/methods/results/threshold_files.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/study_store.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <charconv>
#include <optional>
#include <utility>

namespace teleta::cli {

namespace {

struct FitText {
    Q_DECLARE_TR_FUNCTIONS(StudyFitCommand)
};

nlohmann::ordered_json numberOrNull(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json wordOrNull(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

nlohmann::ordered_json endsOf(const study::OpenInterval& interval) {
    return nlohmann::ordered_json::array({numberOrNull(interval.low), numberOrNull(interval.high)});
}

nlohmann::ordered_json endsOf(const std::optional<study::Interval>& interval) {
    return interval ? nlohmann::ordered_json::array({interval->low, interval->high})
                    : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json levelsJson(const study::ThresholdLine& line) {
    const study::PsychometricFit& fit = line.fit;
    return {
        {"participant", line.participant},
        {"task", line.task},
        {"condition", line.condition},
        {"track", line.track},
        {"function", line.guessIsKnown ? nlohmann::ordered_json(study::toString(line.model.shape)) : nullptr},
        {"n", fit.trials},
        {"threshold", numberOrNull(fit.threshold)},
        {"threshold_interval", endsOf(fit.thresholdInterval)},
        {"unit", wordOrNull(line.facts.unit)},
        {"spread", numberOrNull(fit.spread)},
        {"spread_interval", endsOf(fit.spreadInterval)},
        {"guess", numberOrNull(fit.guess)},
        {"lapse", numberOrNull(fit.lapse)},
        {"deviance", numberOrNull(fit.deviance)},
        {"p_deviance", fit.goodness ? nlohmann::ordered_json(fit.goodness->pDeviance) : nullptr},
        {"jnd", numberOrNull(line.justNoticeable())},
        {"weber", numberOrNull(line.weber())},
        {"pse", numberOrNull(line.equality())},
        {"stair_estimate", numberOrNull(line.procedure.staircase)},
        {"bayes_mean", numberOrNull(line.procedure.bayesMean)},
        {"bayes_sd", numberOrNull(line.procedure.bayesSd)},
        {"note", wordOrNull(line.note())}};
}

nlohmann::ordered_json levelsJson(const LevelAnalysis& analysis) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const study::ThresholdLine& line : analysis.thresholds.lines)
        lines.push_back(levelsJson(line));
    nlohmann::ordered_json groups = nlohmann::ordered_json::array();
    for (const study::ThresholdGroup& group : analysis.thresholds.groups) {
        nlohmann::ordered_json together = nullptr;
        if (const auto& all = group.hierarchical)
            together = {{"participants", all->participants},
                        {"threshold", all->threshold},
                        {"threshold_interval", endsOf(all->interval)},
                        {"participant_sd", all->participantSd},
                        {"guess", all->guess},
                        {"lapse", all->lapse}};
        groups.push_back({{"task", group.task},
                          {"condition", group.condition},
                          {"track", group.track},
                          {"participants", group.participants},
                          {"threshold", numberOrNull(group.threshold)},
                          {"threshold_interval", endsOf(group.interval)},
                          {"jnd", numberOrNull(group.justNoticeable)},
                          {"weber", numberOrNull(group.weber)},
                          {"hierarchical", std::move(together)},
                          {"no_hierarchical", wordOrNull(group.withoutHierarchical)},
                          {"note", wordOrNull(group.note())}});
    }
    nlohmann::ordered_json steps = nlohmann::ordered_json::array();
    for (const study::StepsLine& line : study::intensityStepsOf(analysis.thresholds))
        steps.push_back({{"participant", line.participant},
                         {"task", line.task},
                         {"track", line.track},
                         {"references", line.references},
                         {"steps", line.steps ? nlohmann::ordered_json(*line.steps) : nullptr}});
    nlohmann::ordered_json onsets = nlohmann::ordered_json::array();
    for (const study::OnsetLine& line : study::bestOnsetsOf(analysis.thresholds)) {
        const bool isKnown = line.best.doubt == study::OnsetDoubt::none;
        onsets.push_back(
            {{"participant", line.participant},
             {"task", line.task},
             {"condition", line.condition},
             {"track", line.track},
             {"onset_s", isKnown ? nlohmann::ordered_json(line.best.onset_s) : nullptr},
             {"onset_interval_s", isKnown ? endsOf(study::Interval{line.best.low_s, line.best.high_s})
                                          : nlohmann::ordered_json(nullptr)}});
    }
    nlohmann::ordered_json detection = nlohmann::ordered_json::array();
    for (const study::DetectionLine& line : analysis.detection.lines)
        detection.push_back(
            {{"participant", line.participant},
             {"task", line.task},
             {"condition", line.condition},
             {"track", line.track},
             {"dprime", line.detection ? nlohmann::ordered_json(line.detection->sensitivity) : nullptr},
             {"dprime_interval", line.detection ? endsOf(line.detection->interval) : nullptr},
             {"c", line.detection ? numberOrNull(line.detection->criterion) : nullptr},
             {"method", line.method}});
    return {{"thresholds", std::move(lines)},
            {"groups", std::move(groups)},
            {"intensity_steps", std::move(steps)},
            {"best_onsets", std::move(onsets)},
            {"sdt", std::move(detection)}};
}

QString placeText(const std::string& participant, const std::string& task, const std::string& condition,
                  const std::string& track) {
    QString text = QString::fromStdString(participant + ", " + task);
    if (!condition.empty())
        text += QStringLiteral(", ") + QString::fromStdString(condition);
    if (track != "all")
        text += QStringLiteral(", ") + QString::fromStdString(track);
    return text;
}

Fields levelFields(const LevelAnalysis& analysis) {
    Fields fields;
    for (const study::ThresholdLine& line : analysis.thresholds.lines) {
        QString text = study::thresholdWords(line);
        if (line.fit.goodness && line.fit.goodness->pDeviance < 0.05)
            text += FitText::tr("; the curve does not fit: p of the deviance %1")
                        .arg(forPeople(line.fit.goodness->pDeviance));
        fields.emplace_back(placeText(line.participant, line.task, line.condition, line.track), text);
    }
    for (const study::ThresholdGroup& group : analysis.thresholds.groups) {
        if (!group.threshold || group.participants < 2)
            continue;
        fields.emplace_back(placeText(FitText::tr("Mean of %1").arg(group.participants).toStdString(),
                                      group.task, group.condition, group.track),
                            group.interval
                                ? FitText::tr("%1 (%2 to %3)")
                                      .arg(forPeople(*group.threshold), forPeople(group.interval->low),
                                           forPeople(group.interval->high))
                                : forPeople(*group.threshold));
        if (const auto& all = group.hierarchical)
            fields.emplace_back(placeText(FitText::tr("One fit of %1").arg(all->participants).toStdString(),
                                          group.task, group.condition, group.track),
                                FitText::tr("%1, sd of the participants %2")
                                    .arg(forPeople(all->threshold), forPeople(all->participantSd)));
    }
    for (const study::StepsLine& line : study::intensityStepsOf(analysis.thresholds)) {
        if (line.steps)
            fields.emplace_back(placeText(line.participant, line.task, {}, line.track),
                                FitText::tr("%1 steps of intensity from start to full").arg(*line.steps));
    }
    for (const study::OnsetLine& line : study::bestOnsetsOf(analysis.thresholds)) {
        if (line.best.doubt == study::OnsetDoubt::none)
            fields.emplace_back(placeText(line.participant, line.task, line.condition, line.track),
                                FitText::tr("most yes at %1 s (%2 to %3)")
                                    .arg(forPeople(line.best.onset_s), forPeople(line.best.low_s),
                                         forPeople(line.best.high_s)));
    }
    for (const study::DetectionLine& line : analysis.detection.lines) {
        QString text = FitText::tr("no d': trials of one kind are missing");
        if (line.detection && line.detection->criterion)
            text = FitText::tr("d' %1, c %2")
                       .arg(forPeople(line.detection->sensitivity), forPeople(*line.detection->criterion));
        else if (line.detection)
            text = FitText::tr("d' %1").arg(forPeople(line.detection->sensitivity));
        fields.emplace_back(placeText(line.participant, line.task, line.condition, line.track), text);
    }
    return fields;
}

std::optional<double> shareOf(std::string_view text) {
    double value = 0.0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && stop == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

} // namespace

core::Expected<LevelAnalysis> analyzeLevels(const std::optional<study::StoreLocation>& server,
                                            const std::vector<std::string>& inputs, study::ModeFilter& modes,
                                            const study::FitChoices& choices,
                                            const study::ExclusionBook& exclusions) {
    study::LevelTrials trials;
    const auto addStudy = [&](const study::StoreLocation& location) -> core::Expected<void> {
        TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(location));
        return study::addLevelTrials(store, modes, trials, exclusions.after());
    };
    if (server)
        TELETA_CHECK(addStudy(*server));
    for (const std::string& input : inputs) {
        const QFileInfo info(QString::fromStdString(input));
        if (info.isDir()) {
            TELETA_CHECK(addStudy({input}));
            continue;
        }
        ProgressBar progress(ProgressBar::Unit::bytes, false);
        const core::Expected<void> read = study::addLevelTrials(
            input, modes, trials,
            [&](std::uint64_t bytes) {
                progress.update(static_cast<double>(bytes), static_cast<double>(info.size()));
                return !interrupted();
            },
            [&](long long row) { return exclusions.hasLeftOut(input, row); });
        if (!read)
            return core::Unexpected(interrupted() ? interruption() : read.error());
    }
    ProgressBar progress(ProgressBar::Unit::share, false);
    LevelAnalysis analysis;
    analysis.thresholds = study::thresholdResults(trials, choices, [&](std::size_t done, std::size_t all) {
        progress.update(static_cast<double>(done), static_cast<double>(all));
        return !interrupted();
    });
    if (interrupted())
        return core::Unexpected(interruption());
    analysis.detection = study::detectionResults(trials);
    return analysis;
}

core::Expected<void> writeLevels(const LevelAnalysis& analysis, const std::string& folder,
                                 std::optional<study::Mode> mode, const std::vector<std::string>& formats) {
    std::vector<study::ThresholdFigureFormat> made;
    for (const std::string& format : formats) {
        study::ThresholdFigureFormat one{format, {}};
        if (format == "pdf")
            one.convert = figure::pdfOf;
        else if (format == "png")
            one.convert = [](const std::string& svg) { return figure::pngOf(svg); };
        made.push_back(std::move(one));
    }
    TELETA_CHECK(study::writeThresholds(analysis.thresholds, analysis.detection, folder));
    return study::writeThresholdFigures(analysis.thresholds, analysis.detection, folder, mode, made);
}

void StudyFit::declare(CLI::App& app) {
    addOption(app, "input", m_input,
              FitText::tr(
                  "Folder of a study, or a CSV with participant_id,task,condition,phase,track,level,correct"),
              "DIR|CSV")
        ->required();
    addOption(app, "--store", m_server,
              FitText::tr("PostgreSQL server that has the study, "
                          "postgresql://USER@HOST/DATABASE?study=NAME"),
              "URL");
    addChoice(
        app, "--function", m_function,
        FitText::tr("Function that is fitted; otherwise weibull for detection on a logarithmic scale, else "
                    "gauss"),
        {"gauss", "logistic", "weibull"});
    addOption(app, "--guess", m_guess,
              FitText::tr("Share of right answers without a stimulus; otherwise from the design"),
              between(0, 0.99), "G");
    addOption(
        app, "--lapse", m_lapse,
        FitText::tr("Share of mistakes with any stimulus: fixed, or the range in which it is free; otherwise "
                    "0:0.06"),
        "L|LO:HI");
    addChoice(app, "--interval", m_interval, FitText::tr("How the interval of a threshold is computed"),
              {"profile", "bootstrap"})
        ->capture_default_str();
    addOption(app, "--out", m_outFolder,
              FitText::tr("Folder for thresholds.csv, levels.csv, sdt.csv, analysis.R and figures"), "DIR");
    declareJson(app, m_json);
}

core::Expected<study::FitChoices> StudyFit::choices() const {
    study::FitChoices choices;
    if (!m_function.empty())
        choices.function = study::riseShapeOf(m_function);
    if (m_guess >= 0.0)
        choices.guess = m_guess;
    choices.interval = *study::fitIntervalOf(m_interval);
    if (m_lapse.empty())
        return choices;
    const std::size_t colon = m_lapse.find(':');
    const std::string_view text(m_lapse);
    const std::optional<double> low = shareOf(text.substr(0, colon));
    const std::optional<double> high = colon == std::string::npos ? low : shareOf(text.substr(colon + 1));
    if (!low || !high || *low < 0.0 || *high < *low || *high > 0.4)
        return core::failed(
            core::ErrorKind::badInput,
            FitText::tr("--lapse cannot be \"%1\"").arg(QString::fromStdString(m_lapse)),
            FitText::tr("a share from 0 to 0.4, or two with a colon between them, the lower one "
                        "first"));
    choices.lapse = std::pair(*low, *high);
    return choices;
}

core::Expected<void> StudyFit::run() const {
    TELETA_TRY(const study::FitChoices chosen, choices());
    study::ModeFilter modes;
    std::optional<study::StoreLocation> server;
    std::vector<std::string> inputs;
    if (m_server.empty())
        inputs.push_back(m_input);
    else
        server = {m_input, m_server};
    TELETA_TRY(const LevelAnalysis analysis,
               analyzeLevels(server, inputs, modes, chosen, study::ExclusionBook()));
    if (analysis.thresholds.empty())
        return core::failed(core::ErrorKind::badInput, FitText::tr("there are no test trials with a level"),
                            FitText::tr("trials of a design with levels, or a column level"), {m_input});
    for (const study::ThresholdLine& line : analysis.thresholds.lines) {
        if (!line.guessIsKnown)
            return core::failed(
                core::ErrorKind::badInput,
                FitText::tr("nothing says how often guessing is right in task %1")
                    .arg(QString::fromStdString(line.task)),
                FitText::tr("--guess (0.5 for two intervals, 0.02 for yes and no), or a column design "
                            "or n_alternatives"),
                {m_input});
    }
    if (!m_outFolder.empty()) {
        const core::PrivateFiles forOwner;
        TELETA_CHECK(core::makeFolder(m_outFolder));
        TELETA_TRY(const std::string script, study::analysisScript());
        TELETA_CHECK(writeLevels(analysis, m_outFolder, modes.seen, {"svg"}));
        TELETA_CHECK(core::writeFile(m_outFolder + "/analysis.R", script));
    }
    if (m_json) {
        nlohmann::ordered_json document = levelsJson(analysis);
        document["folder"] = wordOrNull(m_outFolder);
        return printDocument(document);
    }
    Fields fields = levelFields(analysis);
    if (!m_outFolder.empty())
        fields.emplace_back(FitText::tr("Tables and figures"), QString::fromStdString(m_outFolder));
    return printFields(fields);
}

} // namespace teleta::cli
