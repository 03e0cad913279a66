// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/scenes/scene_commands.h"
#include "app/cli/commands/scenes/study_fit.h"
#include "app/cli/commands/scenes/study_noise.h"
#include "app/cli/commands/scenes/study_papers.h"
#include "app/cli/commands/scenes/study_people.h"
#include "app/cli/commands/scenes/study_plan.h"
#include "backend/core/failure.h"
#include "backend/figure/figure_file.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trial_tally.h"
#include "backend/study/analysis/trials/exclusion_book.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/methods/results/level_trial_source.h"
#include "backend/study/report/exclusion_report.h"
#include "backend/study/report/exports/shared_files.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/report/study_figures.h"
#include "backend/study/report/study_report.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/session/simulated_observer.h"
#include "backend/study/store/study_store.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommand)
};

nlohmann::ordered_json endsOrNull(const std::optional<study::Interval>& ends) {
    return ends ? nlohmann::ordered_json::array({ends->low, ends->high}) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json pairsJson(const study::TaskComparisons& comparisons) {
    nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
    for (const study::LevelPair& pair : comparisons.pairs) {
        const auto& test = pair.comparison.test;
        pairs.push_back(
            {{"effect", pair.effect},
             {"stimulus", pair.stimulus.empty() ? nullptr : nlohmann::ordered_json(pair.stimulus)},
             {"first", pair.first},
             {"second", pair.second},
             {"difference", orNull(pair.comparison.difference)},
             {"t", test ? orNull(test->t) : nullptr},
             {"p", test ? orNull(test->p) : nullptr},
             {"p_holm", orNull(pair.pHolm)},
             {"dz", test ? orNull(test->dz) : nullptr},
             {"note", test ? nlohmann::ordered_json(nullptr)
                           : nlohmann::ordered_json(study::toString(test.error()))}});
    }
    return pairs;
}

nlohmann::ordered_json exclusionsJson(const std::vector<study::ExclusionLine>& lines) {
    nlohmann::ordered_json rules = nlohmann::ordered_json::array();
    for (const study::ExclusionLine& line : lines) {
        if (line.participant.empty())
            rules.push_back({{"id", line.rule},
                             {"after_the_data", line.afterTheData},
                             {"trials", line.trials},
                             {"sessions", line.sessions},
                             {"participants", line.participants}});
    }
    return rules;
}

void addExclusions(const std::vector<study::ExclusionLine>& lines, Fields& fields) {
    for (const study::ExclusionLine& line : lines) {
        if (!line.participant.empty())
            continue;
        QString text = StudyText::tr("%1 of %2 trials left out").arg(line.trials).arg(line.trialsBefore);
        if (line.afterTheData)
            text = StudyText::tr("%1; rule made after the data").arg(text);
        if (line.cellsWithoutSpread > 0)
            text = StudyText::tr("%1; no spread of the times, so nothing was left out, in %2 case(s)")
                       .arg(text)
                       .arg(line.cellsWithoutSpread);
        fields.emplace_back(QString::fromStdString(line.rule), text);
    }
}

nlohmann::ordered_json toJson(const std::vector<study::TaskResults>& results) {
    nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
    for (const study::TaskResults& task : results) {
        nlohmann::ordered_json groups = nlohmann::ordered_json::array();
        for (const study::GroupSummary& group : task.groups) {
            const std::optional<study::TransferEstimate>& bits = group.transfer;
            groups.push_back(
                {{"condition", group.condition},
                 {"participants", group.participants},
                 {"accuracy", group.accuracy ? orNull(group.accuracy->mean) : nullptr},
                 {"t_interval_95", group.accuracy ? endsOrNull(group.accuracy->interval) : nullptr},
                 {"it_bits", bits ? orNull(bits->measured_bit) : nullptr},
                 {"it_corrected_bits", bits ? orNull(bits->corrected_bit) : nullptr},
                 {"it_interval_95", bits ? endsOrNull(bits->interval) : nullptr},
                 {"it_at_least_bits", bits ? orNull(bits->atLeast_bit) : nullptr},
                 {"it_at_most_bits", bits ? orNull(bits->atMost_bit) : nullptr},
                 {"it_note", bits && bits->doubt != study::TransferDoubt::none
                                 ? nlohmann::ordered_json(study::toString(bits->doubt))
                                 : nlohmann::ordered_json(nullptr)}});
        }
        const study::TaskComparisons comparisons = study::taskComparisons(task);
        nlohmann::ordered_json anova = nlohmann::ordered_json::array();
        for (const study::AnovaLine& line : task.anova)
            anova.push_back(
                {{"effect", line.effect},
                 {"stimulus", line.stimulus.empty() ? nullptr : nlohmann::ordered_json(line.stimulus)},
                 {"f", line.row ? orNull(line.row->f) : nullptr},
                 {"p", line.row ? orNull(line.row->p) : nullptr},
                 {"p_gg", line.row ? orNull(line.row->pGg) : nullptr},
                 {"p_holm", orNull(study::patternPHolm(comparisons, line.stimulus))},
                 {"note", line.note.empty() ? nullptr : nlohmann::ordered_json(line.note)}});
        tasks.push_back({{"task", task.task},
                         {"groups", std::move(groups)},
                         {"anova", std::move(anova)},
                         {"pairs", pairsJson(comparisons)}});
    }
    return {{"tasks", std::move(tasks)}};
}

/// The measured value, the corrected one with its interval or a bound, and why there is only a bound.
QStringList transferLines(const study::TransferEstimate& transfer) {
    const QString corrected = forPeople(transfer.corrected_bit, 3);
    QStringList lines{StudyText::tr("%1 bit measured").arg(forPeople(transfer.measured_bit, 3))};
    if (transfer.interval)
        lines << StudyText::tr("%1 bit without bias (95 %: %2 to %3)")
                     .arg(corrected, forPeople(transfer.interval->low, 3),
                          forPeople(transfer.interval->high, 3));
    else if (transfer.atLeast_bit)
        lines << StudyText::tr("%1 bit without bias (95 %: at least %2)")
                     .arg(corrected, forPeople(*transfer.atLeast_bit, 3));
    else if (transfer.atMost_bit)
        lines << StudyText::tr("%1 bit without bias (95 %: at most %2)")
                     .arg(corrected, forPeople(*transfer.atMost_bit, 3));
    if (transfer.doubt != study::TransferDoubt::none)
        lines << QString::fromStdString(study::explain(transfer.doubt));
    return lines;
}

Fields toFields(const std::vector<study::TaskResults>& results) {
    Fields fields;
    for (const study::TaskResults& task : results) {
        for (const study::GroupSummary& group : task.groups) {
            const QString name = QString::fromStdString(task.task + ", " + group.condition);
            const auto percent = [](double share) { return forPeople(100.0 * share, 3); };
            if (group.accuracy && group.accuracy->interval)
                fields.emplace_back(name, StudyText::tr("%1 % correct (95 %: %2 to %3, %4 participants)")
                                              .arg(percent(group.accuracy->mean),
                                                   percent(group.accuracy->interval->low),
                                                   percent(group.accuracy->interval->high))
                                              .arg(group.participants));
            else if (group.accuracy)
                fields.emplace_back(
                    name, StudyText::tr("%1 % correct (one participant)").arg(percent(group.accuracy->mean)));
            if (group.transfer)
                for (const QString& line : transferLines(*group.transfer))
                    fields.emplace_back(QString(), line);
        }
        const study::TaskComparisons comparisons = study::taskComparisons(task);
        for (const study::AnovaLine& line : task.anova) {
            const QString name = QString::fromStdString(task.task + ", " + line.effect +
                                                        (line.stimulus.empty() ? "" : ", " + line.stimulus));
            QString text = line.row ? StudyText::tr("F(%1, %2) = %3, p = %4")
                                          .arg(forPeople(line.row->df1), forPeople(line.row->df2),
                                               forPeople(line.row->f), forPeople(line.row->pGg, 3))
                                    : QString::fromStdString(line.note);
            if (const auto p = study::patternPHolm(comparisons, line.stimulus))
                text = StudyText::tr("%1, Holm over the patterns %2", "F and p").arg(text, forPeople(*p, 3));
            fields.emplace_back(name, text);
        }
    }
    return fields;
}

class StudyCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        declareRehearse(addPart(app, "rehearse",
                                StudyText::tr("Run simulated participants through a whole study"),
                                [this] { return rehearse(); }));
        CLI::App& resumes =
            addPart(app, "resume", StudyText::tr("Go on with a rehearsal that was interrupted"),
                    [this] { return resume(); });
        takeStudy(resumes);
        declareStore(resumes);
        declareJson(resumes, m_json);
        declareAnalyze(
            addPart(app, "analyze",
                    StudyText::tr("Confusion matrices, accuracy, information transfer and ANOVA of "
                                  "studies or trial CSVs"),
                    [this] { return analyze(); }));
        m_fit.declare(addPart(app, "fit",
                              StudyText::tr("Thresholds, slopes and d' of tasks with levels, by maximum "
                                            "likelihood"),
                              [this] { return m_fit.run(); }));
        declareExport(addPart(app, "export",
                              StudyText::tr("Write the trials of a study as files into its folder"),
                              [this] { return exportTrials(); }));
        m_people.declareList(addPart(app, "participants",
                                     StudyText::tr("List the participants of a study, and who was deleted"),
                                     [this] { return m_people.list(); }));
        m_people.declareEnrol(addPart(app, "enrol", StudyText::tr("Enrol a participant under a pseudonym"),
                                      [this] { return m_people.enrol(); }));
        m_people.declareDelete(addPart(app, "delete",
                                       StudyText::tr("Delete a participant with everything that was kept"),
                                       [this] { return m_people.remove(); }));
        m_papers.declareReport(addPart(app, "report",
                                       StudyText::tr("Write one participant's results as a page"),
                                       [this] { return m_papers.writeReport(); }));
        m_papers.declareCodebook(addPart(app, "codebook",
                                         StudyText::tr("What the columns of all files of studies mean"),
                                         [this] { return m_papers.writeCodebook(); }));
        m_papers.declareTrigger(addPart(app, "trigger",
                                        StudyText::tr("Send one trial's triggers to another recorder"),
                                        [this] { return m_papers.testTrigger(); }));
        m_plan.declare(addPart(
            app, "plan", StudyText::tr("How many participants a test needs: power by simulated studies"),
            [this] { return m_plan.run(); }));
        m_noise.declare(addPart(app, "noise", StudyText::tr("Write pink noise that can be played in a loop"),
                                [this] { return m_noise.write(); }));
    }

private:
    void takeStudy(CLI::App& app) {
        addOption(app, "study", m_studyFolder, StudyText::tr("Folder of the study"), "DIR")->required();
    }

    void declareStore(CLI::App& app) {
        addOption(
            app, "--store", m_server,
            StudyText::tr("PostgreSQL server that has the study, "
                          "postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD "
                          "or ~/.pgpass. The folder gets the exports"),
            "URL");
    }

    void declareRehearse(CLI::App& app) {
        addOption(app, "protocol", m_protocolPath,
                  StudyText::tr("Protocol of the study, or the name of one that comes with the program: "
                                "tactor-detection, intensity-steps, equal-strength, two-or-one, "
                                "motion-timing; otherwise the paper's"),
                  "PROTOCOL.toml|NAME");
        addOption(app, "--participants", m_participants, StudyText::tr("Number of participants"),
                  between(1, 10'000), "N");
        addOption(app, "-s,--seed", m_seed, StudyText::tr("Seed of all orders and answers"), seed(), "S");
        addOption(app, "--lapses", m_lapses,
                  StudyText::tr("Share of the trials in which nothing is answered"), between(0, 1), "P");
        addOption(app, "--observer", m_observer,
                  StudyText::tr("Simulated participants in tasks with levels: threshold t and slope of their "
                                "psychometric function, lapse rate, and sd of the threshold between them, in "
                                "the scale of the levels"),
                  "t=..,slope=..,lapse=..,sd=..");
        addOption(app, "-o,--out", m_outFolder, StudyText::tr("Folder of the new study"), "DIR")->required();
        declareStore(app);
        declareJson(app, m_json);
    }

    void declareAnalyze(CLI::App& app) {
        addOption(app, "inputs", m_inputs,
                  StudyText::tr("Folders of studies, or CSVs with "
                                "participant_id,task,condition,phase,stimulus,response"),
                  "DIR|CSV");
        declareStore(app);
        addChoice(app, "--figures", m_figures, StudyText::tr("Formats of the figures, separated by commas"),
                  {"svg", "pdf", "png"})
            ->delimiter(',')
            ->capture_default_str();
        addChoice(app, "--mode", m_mode,
                  StudyText::tr("Only data of this mode; different modes are not merged"),
                  {"run", "pilot", "simulated"});
        addOption(app, "--exclude", m_exclude,
                  StudyText::tr("Rule of what does not count, besides those of the protocol; marked as made "
                                "after the data, for example response_time_below_s=0.2"),
                  "RULE=VALUE");
        addOption(
            app, "-o,--out", m_outFolder,
            StudyText::tr("Folder for report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, "
                          "thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, "
                          "binomial_model.csv, response_times.csv, exclusions.csv, figures"),
            "DIR")
            ->required();
        declareShared(app);
        declareJson(app, m_json);
    }

    void declareShared(CLI::App& app) {
        addFlag(app, "--shared", m_shared,
                StudyText::tr(
                    "Let others read what is written, as the umask allows; otherwise it is for you alone"));
    }

    void declareExport(CLI::App& app) {
        takeStudy(app);
        addChoice(app, "--format", m_format,
                  StudyText::tr("psychds: data/; bids: bids/; excel: excel/, with semicolons and the decimal "
                                "sign of the locale"),
                  {"psychds", "bids", "excel"})
            ->capture_default_str();
        declareShared(app);
        declareStore(app);
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> rehearse() const {
        TELETA_TRY(const study::Protocol protocol, m_protocolPath.empty()
                                                       ? study::paperProtocol()
                                                       : study::readNamedProtocol(m_protocolPath));
        study::StudyHead head;
        head.protocol = protocol;
        head.seed = m_seed;
        head.mode = study::Mode::simulated;
        head.plannedParticipants = m_participants;
        head.lapses = m_lapses;
        TELETA_CHECK(study::SimulatedObserver::parse(m_observer));
        head.observer = m_observer;
        head.created = QDateTime::currentDateTimeUtc();
        head.appVersion = QCoreApplication::applicationVersion().toStdString();
        TELETA_TRY(study::StudyStore store, study::StudyStore::create({m_outFolder, m_server}, head));
        return goOn(store);
    }

    [[nodiscard]] core::Expected<void> resume() const {
        TELETA_TRY(study::StudyStore store, study::StudyStore::open({m_studyFolder, m_server}));
        return goOn(store);
    }

    [[nodiscard]] core::Expected<void> goOn(study::StudyStore& store) const {
        ProgressBar bar(ProgressBar::Unit::trials, false);
        const std::size_t all = study::plannedTrials(store.head());
        const core::Expected<study::RehearsalProgress> progress =
            study::rehearse(store, {.goOn = [&](const study::RehearsalProgress& now) {
                                bar.update(static_cast<double>(now.allTrials()), static_cast<double>(all));
                                return !interrupted();
                            }});
        bar.erase();
        TELETA_CHECK(progress);
        if (progress->interrupted)
            return core::Unexpected(interruption());
        const study::StudyHead& head = store.head();
        if (m_json)
            return printDocument({{"study", store.folder()},
                                  {"store", store.shownName()},
                                  {"protocol", head.protocol.name},
                                  {"mode", study::toString(head.mode)},
                                  {"seed", std::to_string(head.seed)},
                                  {"participants", progress->participants},
                                  {"trials", progress->allTrials()},
                                  {"trials_before", progress->trialsBefore}});
        return printFields(
            {{StudyText::tr("Study"), QString::fromStdString(store.folder())},
             {StudyText::tr("Protocol"), QString::fromStdString(head.protocol.name)},
             {StudyText::tr("Seed"), QString::number(head.seed)},
             {StudyText::tr("Simulated participants"), QString::number(progress->participants)},
             {StudyText::tr("Trials"), QString::number(progress->allTrials())},
             {StudyText::tr("Of them kept before"), QString::number(progress->trialsBefore)}});
    }

    [[nodiscard]] core::Expected<void> tallyInputs(study::TrialTally& tally, study::ModeFilter& modes,
                                                   study::ExclusionBook& exclusions) const {
        const auto tallyStudy = [&](const study::StoreLocation& location) -> core::Expected<void> {
            TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(location));
            return study::tallyStore(store, modes, tally, exclusions);
        };
        if (m_inputs.empty() && m_server.empty())
            return core::failed(core::ErrorKind::badInput, StudyText::tr("there is nothing to analyze"),
                                StudyText::tr("folders of studies, trial CSVs, or a server (--store)"));
        if (!m_server.empty()) {
            TELETA_CHECK(tallyStudy({m_outFolder, m_server}));
        }
        std::set<QString> seen;
        bool onlyLevels = false;
        for (const std::string& input : m_inputs) {
            const QFileInfo info(QString::fromStdString(input));
            if (info.exists() && !seen.insert(info.canonicalFilePath()).second)
                return core::failed(core::ErrorKind::badInput, StudyText::tr("this is named twice"),
                                    StudyText::tr("each study and each file once"), {input});
            if (info.isFile()) { // a pipe is read only once
                TELETA_TRY(const bool hasNoPatterns, study::hasOnlyLevels(input));
                onlyLevels = onlyLevels || hasNoPatterns;
                if (hasNoPatterns && !m_exclude.empty())
                    return core::failed(core::ErrorKind::badInput,
                                        StudyText::tr("--exclude cannot be applied to this file"),
                                        StudyText::tr("the columns stimulus and response"), {input});
                if (hasNoPatterns)
                    continue;
            }
            core::Expected<void> counted;
            if (info.isDir()) {
                counted = tallyStudy(input);
            } else {
                ProgressBar progress(ProgressBar::Unit::bytes, false);
                counted = study::tallyCsv(input, modes, tally, exclusions, [&](std::uint64_t bytes) {
                    progress.update(static_cast<double>(bytes), static_cast<double>(info.size()));
                    return !interrupted();
                });
            }
            if (!counted)
                return core::Unexpected(interrupted() ? interruption() : counted.error());
        }
        TELETA_CHECK(study::settle(exclusions, tally, m_inputs.empty() ? m_server : m_inputs.front()));
        if (tally.cells().empty() && exclusions.isUsed())
            return core::failed(core::ErrorKind::refused,
                                StudyText::tr("the exclusion rules leave no completed trial"),
                                StudyText::tr("rules that leave some"),
                                {m_inputs.empty() ? std::string() : m_inputs.front()});
        if (tally.cells().empty() && !onlyLevels)
            return core::failed(core::ErrorKind::badInput, StudyText::tr("there are no completed trials"),
                                StudyText::tr("trials that were answered or timed out"),
                                {m_inputs.empty() ? std::string() : m_inputs.front()});
        if (!tally.hasTestTrials())
            warn(StudyText::tr("there are no test trials, only practice: the report has no results"));
        for (const auto& [answer, pattern] : tally.answersInOtherCase())
            warn(StudyText::tr("the answer \"%1\" counts as wrong: the pattern is \"%2\"")
                     .arg(QString::fromStdString(answer), QString::fromStdString(pattern)));
        return {};
    }

    [[nodiscard]] core::Expected<void> writeAll(const std::vector<study::TaskResults>& results,
                                                const study::ModeFilter& modes,
                                                const study::TrialTally::Frames& frames,
                                                const study::ExclusionReport& exclusions,
                                                const study::ExclusionBook& book) const {
        study::ReportHeading heading;
        heading.frames = frames;
        heading.exclusions = exclusions;
        heading.title = StudyText::tr("Results of the study").toStdString();
        heading.mode = modes.wanted ? modes.wanted : modes.seen;
        heading.sources = m_inputs;
        if (!m_server.empty())
            heading.sources.push_back(study::shownServer(m_server));
        heading.appVersion = QCoreApplication::applicationVersion().toStdString();
        std::vector<study::FigureFormat> formats;
        for (const std::string& format : m_figures) {
            study::FigureFormat made{format, {}};
            if (format == "pdf")
                made.convert = [](const std::string& svg) { return figure::pdfOf(svg); };
            else if (format == "png")
                made.convert = [](const std::string& svg) { return figure::pngOf(svg); };
            formats.push_back(std::move(made));
        }
        return study::writeResults(results, m_outFolder)
            .and_then([&] { return study::writeExclusions(exclusions.lines, m_outFolder); })
            .and_then([&] { return study::writeFigures(results, m_outFolder, heading.mode, formats); })
            .and_then([&] { return writeLevelResults(modes, book, heading); })
            .and_then([&] { return study::writeReport(results, heading, m_outFolder); });
    }

    /// Thresholds and sensitivity, where the inputs have tasks with levels; the report gets them too.
    [[nodiscard]] core::Expected<void> writeLevelResults(const study::ModeFilter& modes,
                                                         const study::ExclusionBook& exclusions,
                                                         study::ReportHeading& heading) const {
        study::ModeFilter same{modes.wanted, {}};
        std::optional<study::StoreLocation> server;
        if (!m_server.empty())
            server = {m_outFolder, m_server};
        std::vector<std::string> again;
        for (const std::string& input : m_inputs) {
            const QFileInfo info(QString::fromStdString(input));
            if (info.isDir() || info.isFile())
                again.push_back(input);
        }
        TELETA_TRY(LevelAnalysis levels, analyzeLevels(server, again, same, {}, exclusions));
        TELETA_CHECK(writeLevels(levels, m_outFolder, same.wanted ? same.wanted : same.seen, m_figures));
        heading.thresholds = std::move(levels.thresholds);
        heading.detection = std::move(levels.detection);
        return {};
    }

    [[nodiscard]] core::Expected<study::ExclusionBook> exclusionBook() const {
        std::vector<study::ExclusionRule> rules;
        for (const std::string& text : m_exclude) {
            TELETA_TRY(study::ExclusionRule rule, study::parseExclusion(text));
            rules.push_back(std::move(rule));
        }
        return study::ExclusionBook(std::move(rules));
    }

    [[nodiscard]] core::Expected<void> analyze() const {
        study::TrialTally tally;
        study::ModeFilter modes;
        if (!m_mode.empty())
            modes.wanted = study::modeOf(m_mode);
        TELETA_TRY(study::ExclusionBook exclusions, exclusionBook());
        TELETA_CHECK(tallyInputs(tally, modes, exclusions));
        const std::vector<study::TaskResults> results = study::studyResults(tally);
        const study::ExclusionReport excluded = study::exclusionReport(exclusions);
        TELETA_CHECK(writeAll(results, modes, tally.frames(), excluded, exclusions));
        if (m_shared) {
            std::vector<std::string> written = study::resultFiles();
            written.insert(written.end(), {"codebook.csv", "analysis.R"});
            TELETA_CHECK(study::shareFiles(m_outFolder, written));
        }
        const QString report =
            QDir(QString::fromStdString(m_outFolder)).filePath(QStringLiteral("report.html"));
        if (m_json) {
            nlohmann::ordered_json document = toJson(results);
            document["exclusions"] = exclusionsJson(excluded.lines);
            document["folder"] = m_outFolder;
            document["report"] = report.toStdString();
            return printDocument(document);
        }
        Fields fields = toFields(results);
        addExclusions(excluded.lines, fields);
        fields.emplace_back(StudyText::tr("Report"), report);
        fields.emplace_back(StudyText::tr("Tables and figures"), QString::fromStdString(m_outFolder));
        return printFields(fields);
    }

    [[nodiscard]] core::Expected<void> exportTrials() const {
        TELETA_TRY(const study::StudyStore store,
                   study::StudyStore::openForReading({m_studyFolder, m_server}));
        const study::ExportFormat format = m_format == "bids"    ? study::ExportFormat::bids
                                           : m_format == "excel" ? study::ExportFormat::excel
                                                                 : study::ExportFormat::psychds;
        const core::Expected<std::size_t> sessions =
            store.ownFolder().and_then([&] { return study::exportStudy(store, format); });
        TELETA_CHECK(sessions);
        if (m_shared)
            TELETA_CHECK(study::shareFiles(store.folder(), {m_format == "psychds" ? "data" : m_format,
                                                            "dataset_description.json", "analysis.R",
                                                            "codebook.csv", "questionnaire_scores.csv"}));
        if (m_json)
            return printDocument({{"study", store.folder()}, {"format", m_format}, {"sessions", *sessions}});
        return printFields({{StudyText::tr("Study"), QString::fromStdString(store.folder())},
                            {StudyText::tr("Format"), QString::fromStdString(m_format)},
                            {StudyText::tr("Sessions"), QString::number(*sessions)}});
    }

    StudyPeople m_people;
    StudyNoise m_noise;
    StudyPapers m_papers;
    StudyPlan m_plan;
    std::string m_server;
    StudyFit m_fit;
    std::string m_protocolPath;
    std::size_t m_participants = 6;
    std::uint64_t m_seed = 1;
    double m_lapses = 0.0;
    std::string m_observer;
    std::string m_outFolder;
    std::string m_studyFolder;
    std::vector<std::string> m_inputs;
    std::string m_mode;
    std::vector<std::string> m_exclude;
    std::vector<std::string> m_figures = {"svg"};
    std::string m_format = "psychds";
    bool m_shared = false;
    bool m_json = false;
};

} // namespace

Command studyCommand() {
    return makeCommand<StudyCommand>(
        "study", StudyText::tr("Rehearse a user study with simulated participants, and analyse studies"),
        "teleta study rehearse --participants 6 --seed 1 --out study");
}

} // namespace teleta::cli
