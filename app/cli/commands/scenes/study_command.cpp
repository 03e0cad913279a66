// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_command.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/validators.h"
#include "backend/figure/figure_file.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trial_source.h"
#include "backend/study/report/study_export.h"
#include "backend/study/report/study_figures.h"
#include "backend/study/report/study_report.h"
#include "backend/study/session/pink_noise.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/study_store.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommand)
};

std::string help(const char* text) {
    return StudyText::tr(text).toStdString();
}

template <typename Value>
nlohmann::ordered_json orNull(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json orNull(const std::optional<study::Interval>& ends) {
    return ends ? nlohmann::ordered_json::array({ends->low, ends->high}) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json toJson(const std::vector<study::TaskResults>& results) {
    nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
    for (const study::TaskResults& task : results) {
        nlohmann::ordered_json groups = nlohmann::ordered_json::array();
        for (const study::GroupSummary& group : task.groups) {
            const auto bits = study::informationTransfer(group.matrix);
            groups.push_back(
                {{"condition", group.condition},
                 {"participants", group.participants},
                 {"accuracy", group.accuracy ? orNull(std::optional(group.accuracy->mean)) : nullptr},
                 {"t_interval_95", group.accuracy ? orNull(group.accuracy->interval) : nullptr},
                 {"it_bits", bits ? orNull(std::optional(bits->measured_bit)) : nullptr},
                 {"it_corrected_bits", bits ? orNull(std::optional(bits->corrected_bit)) : nullptr},
                 {"it_bootstrap_95", orNull(group.transferInterval)}});
        }
        nlohmann::ordered_json anova = nlohmann::ordered_json::array();
        for (const study::AnovaLine& line : task.anova)
            anova.push_back(
                {{"effect", line.effect},
                 {"stimulus", line.stimulus.empty() ? nullptr : nlohmann::ordered_json(line.stimulus)},
                 {"f", line.row ? orNull(std::optional(line.row->f)) : nullptr},
                 {"p", line.row ? orNull(std::optional(line.row->p)) : nullptr},
                 {"p_gg", line.row ? orNull(std::optional(line.row->pGg)) : nullptr},
                 {"note", line.note.empty() ? nullptr : nlohmann::ordered_json(line.note)}});
        tasks.push_back({{"task", task.task}, {"groups", std::move(groups)}, {"anova", std::move(anova)}});
    }
    return {{"tasks", std::move(tasks)}};
}

std::vector<std::pair<QString, QString>> toFields(const std::vector<study::TaskResults>& results) {
    std::vector<std::pair<QString, QString>> fields;
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
            if (const auto bits = study::informationTransfer(group.matrix))
                fields.emplace_back(
                    QString(), StudyText::tr("%1 bit, %2 without bias")
                                   .arg(forPeople(bits->measured_bit, 3), forPeople(bits->corrected_bit, 3)));
        }
        for (const study::AnovaLine& line : task.anova) {
            const QString name = QString::fromStdString(task.task + ", " + line.effect +
                                                        (line.stimulus.empty() ? "" : ", " + line.stimulus));
            fields.emplace_back(name, line.row ? StudyText::tr("F(%1, %2) = %3, p = %4")
                                                     .arg(forPeople(line.row->df1), forPeople(line.row->df2),
                                                          forPeople(line.row->f), forPeople(line.row->pGg, 3))
                                               : QString::fromStdString(line.note));
        }
    }
    return fields;
}

} // namespace

QString StudyCommand::summary() const {
    return StudyText::tr("Rehearse a user study with simulated participants, and analyse studies");
}

const char* StudyCommand::example() const {
    return "teleta study rehearse --participants 6 --seed 1 --out study";
}

void StudyCommand::declare(CLI::App& app) {
    app.require_subcommand(1);
    declareRehearse(app);
    declareResume(app);
    declareAnalyze(app);
    declareExport(app);
    declareNoise(app);
}

void StudyCommand::declareStore(CLI::App& app) {
    app.add_option("--store", m_server,
                   help(QT_TRANSLATE_NOOP("StudyCommand",
                                          "PostgreSQL server that has the study, postgresql://USER@HOST/"
                                          "DATABASE?study=NAME; the password comes from PGPASSWORD or "
                                          "~/.pgpass. The folder gets the exports")))
        ->type_name("URL");
}

void StudyCommand::declareRehearse(CLI::App& app) {
    m_rehearse = app.add_subcommand(
        "rehearse",
        help(QT_TRANSLATE_NOOP("StudyCommand", "Run simulated participants through a whole study")));
    m_rehearse
        ->add_option("protocol", m_protocolPath,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Protocol of the study; otherwise the paper's")))
        ->type_name("PROTOCOL.toml");
    m_rehearse
        ->add_option("--participants", m_participants,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Number of participants")))
        ->type_name("N")
        ->capture_default_str()
        ->check(between(1, 10'000));
    m_rehearse
        ->add_option("--seed", m_seed,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Seed of all orders and answers")))
        ->type_name("S")
        ->capture_default_str()
        ->check(seed());
    m_rehearse
        ->add_option(
            "--lapses", m_lapses,
            help(QT_TRANSLATE_NOOP("StudyCommand", "Share of the trials in which nothing is answered")))
        ->type_name("P")
        ->capture_default_str()
        ->check(between(0, 1));
    m_rehearse
        ->add_option("--out", m_outFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "Folder of the new study")))
        ->type_name("DIR")
        ->required();
    declareStore(*m_rehearse);
    declareJson(*m_rehearse, m_json);
}

void StudyCommand::declareResume(CLI::App& app) {
    m_resume = app.add_subcommand(
        "resume", help(QT_TRANSLATE_NOOP("StudyCommand", "Go on with a rehearsal that was interrupted")));
    m_resume
        ->add_option("study", m_studyFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "Folder of the study")))
        ->type_name("DIR")
        ->required();
    declareStore(*m_resume);
    declareJson(*m_resume, m_json);
}

void StudyCommand::declareAnalyze(CLI::App& app) {
    m_analyze = app.add_subcommand(
        "analyze",
        help(QT_TRANSLATE_NOOP("StudyCommand", "Confusion matrices, accuracy, information transfer "
                                               "and ANOVA of studies or trial CSVs")));
    m_analyze
        ->add_option("inputs", m_inputs,
                     help(QT_TRANSLATE_NOOP("StudyCommand",
                                            "Folders of studies, or CSVs with participant_id,task,condition,"
                                            "phase,stimulus,response")))
        ->type_name("DIR|CSV");
    declareStore(*m_analyze);
    m_analyze
        ->add_option("--figures", m_figures,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Formats of the figures, separated by commas")))
        ->type_name("svg|pdf|png")
        ->delimiter(',')
        ->capture_default_str()
        ->check(CLI::IsMember({"svg", "pdf", "png"}).description(""));
    m_analyze
        ->add_option(
            "--mode", m_mode,
            help(QT_TRANSLATE_NOOP("StudyCommand", "Only data of this mode; different modes are not merged")))
        ->type_name("run|pilot|simulated")
        ->check(CLI::IsMember({"run", "pilot", "simulated"}).description(""));
    m_analyze
        ->add_option("--out", m_outFolder,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Folder for report.html, confusion_long.csv, "
                                                            "summary.csv, group.csv, anova.csv, figures")))
        ->type_name("DIR")
        ->required();
    declareJson(*m_analyze, m_json);
}

void StudyCommand::declareExport(CLI::App& app) {
    m_export = app.add_subcommand(
        "export",
        help(QT_TRANSLATE_NOOP("StudyCommand", "Write the trials of a study as files into its folder")));
    m_export
        ->add_option("study", m_studyFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "Folder of the study")))
        ->type_name("DIR")
        ->required();
    m_export
        ->add_option(
            "--format", m_format,
            help(QT_TRANSLATE_NOOP("StudyCommand", "psychds: data/; bids: bids/; excel: excel/, with "
                                                   "semicolons and the decimal sign of the locale")))
        ->type_name("psychds|bids|excel")
        ->capture_default_str()
        ->check(CLI::IsMember({"psychds", "bids", "excel"}).description(""));
    declareStore(*m_export);
    declareJson(*m_export, m_json);
}

void StudyCommand::declareNoise(CLI::App& app) {
    m_noise = app.add_subcommand(
        "noise", help(QT_TRANSLATE_NOOP("StudyCommand", "Write pink noise that can be played in a loop")));
    m_noise->add_option("--out", m_outFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "The sound file")))
        ->type_name("FILE.wav")
        ->required();
    m_noise
        ->add_option(
            "--level", m_level_dBFS,
            help(QT_TRANSLATE_NOOP("StudyCommand",
                                   "Root mean square against full scale, dB; how loud it is at the ear has "
                                   "to be measured")))
        ->type_name("DBFS")
        ->capture_default_str()
        ->check(between(-90, 0));
    m_noise->add_option("--seed", m_seed, help(QT_TRANSLATE_NOOP("StudyCommand", "Seed of the noise")))
        ->type_name("S")
        ->capture_default_str()
        ->check(seed());
    declareJson(*m_noise, m_json);
}

core::Expected<void> StudyCommand::run() {
    if (m_rehearse->parsed())
        return runRehearse();
    if (m_export->parsed())
        return runExport();
    if (m_noise->parsed())
        return runNoise();
    return m_resume->parsed() ? runResume() : runAnalyze();
}

core::Expected<void> StudyCommand::runRehearse() const {
    TELETA_TRY(const study::Protocol protocol,
               m_protocolPath.empty() ? study::paperProtocol() : study::readProtocol(m_protocolPath));
    study::StudyHead head;
    head.protocol = protocol;
    head.seed = m_seed;
    head.mode = study::Mode::simulated;
    head.plannedParticipants = m_participants;
    head.lapses = m_lapses;
    head.created = QDateTime::currentDateTimeUtc();
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    TELETA_TRY(study::StudyStore store, study::StudyStore::create({m_outFolder, m_server}, head));
    return goOn(store);
}

core::Expected<void> StudyCommand::runResume() const {
    TELETA_TRY(study::StudyStore store, study::StudyStore::open({m_studyFolder, m_server}));
    return goOn(store);
}

core::Expected<void> StudyCommand::goOn(study::StudyStore& store) const {
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
    const std::vector<std::pair<QString, QString>> fields{
        {StudyText::tr("Study"), QString::fromStdString(store.folder())},
        {StudyText::tr("Protocol"), QString::fromStdString(head.protocol.name)},
        {StudyText::tr("Seed"), QString::number(head.seed)},
        {StudyText::tr("Simulated participants"), QString::number(progress->participants)},
        {StudyText::tr("Trials"), QString::number(progress->allTrials())},
        {StudyText::tr("Of them kept before"), QString::number(progress->trialsBefore)}};
    return printFields(fields);
}

core::Expected<void> StudyCommand::tallyInputs(study::TrialTally& tally, study::ModeFilter& modes) const {
    const auto tallyStudy = [&](const study::StoreLocation& location) -> core::Expected<void> {
        const core::Expected<study::StudyStore> store = study::StudyStore::openForReading(location);
        return store ? study::tallyStore(*store, modes, tally) : core::Unexpected(store.error());
    };
    if (m_inputs.empty() && m_server.empty())
        return core::Unexpected(
            core::Error{core::ErrorKind::badInput,
                        StudyText::tr("there is nothing to analyze").toStdString(),
                        StudyText::tr("folders of studies, trial CSVs, or a server (--store)").toStdString(),
                        {}});
    if (!m_server.empty()) {
        if (const core::Expected<void> counted = tallyStudy({m_outFolder, m_server}); !counted)
            return counted;
    }
    std::set<QString> seen;
    for (const std::string& input : m_inputs) {
        const QFileInfo info(QString::fromStdString(input));
        if (info.exists() && !seen.insert(info.canonicalFilePath()).second)
            return core::Unexpected(core::Error{core::ErrorKind::badInput,
                                                StudyText::tr("this is named twice").toStdString(),
                                                StudyText::tr("each study and each file once").toStdString(),
                                                {input}});
        core::Expected<void> counted;
        if (info.isDir()) {
            counted = tallyStudy(input);
        } else {
            ProgressBar progress(ProgressBar::Unit::bytes, false);
            counted = study::tallyCsv(input, modes, tally, [&](std::uint64_t bytes) {
                progress.update(static_cast<double>(bytes), static_cast<double>(info.size()));
                return !interrupted();
            });
        }
        if (!counted)
            return core::Unexpected(interrupted() ? interruption() : counted.error());
    }
    if (tally.cells().empty())
        return core::Unexpected(
            core::Error{core::ErrorKind::badInput,
                        StudyText::tr("there are no completed trials").toStdString(),
                        StudyText::tr("trials that were answered or timed out").toStdString(),
                        {m_inputs.empty() ? std::string() : m_inputs.front()}});
    return {};
}

core::Expected<void> StudyCommand::writeAll(const std::vector<study::TaskResults>& results,
                                            const study::ModeFilter& modes,
                                            const study::TrialTally::Frames& frames) const {
    study::ReportHeading heading;
    heading.frames = frames;
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
        .and_then([&] { return study::writeFigures(results, m_outFolder, heading.mode, formats); })
        .and_then([&] { return study::writeReport(results, heading, m_outFolder); });
}

core::Expected<void> StudyCommand::runAnalyze() const {
    study::TrialTally tally;
    study::ModeFilter modes;
    if (!m_mode.empty())
        modes.wanted = study::modeOf(m_mode);
    TELETA_CHECK(tallyInputs(tally, modes));
    const std::vector<study::TaskResults> results = study::studyResults(tally);
    TELETA_CHECK(writeAll(results, modes, tally.frames()));
    const QString report = QDir(QString::fromStdString(m_outFolder)).filePath(QStringLiteral("report.html"));
    if (m_json) {
        nlohmann::ordered_json document = toJson(results);
        document["folder"] = m_outFolder;
        document["report"] = report.toStdString();
        return printDocument(document);
    }
    std::vector<std::pair<QString, QString>> fields = toFields(results);
    fields.emplace_back(StudyText::tr("Report"), report);
    fields.emplace_back(StudyText::tr("Tables and figures"), QString::fromStdString(m_outFolder));
    return printFields(fields);
}

core::Expected<void> StudyCommand::runNoise() const {
    study::PinkNoiseSettings settings;
    settings.level_dBFS = m_level_dBFS;
    settings.seed = m_seed;
    TELETA_TRY(const std::vector<float> samples, study::pinkNoise(settings));
    TELETA_CHECK(study::writeMonoWav(samples, settings.rate_Hz, m_outFolder));
    const double duration_s = static_cast<double>(settings.samples) / settings.rate_Hz;
    if (m_json)
        return printDocument({{"file", m_outFolder},
                              {"duration_s", duration_s},
                              {"rate_hz", settings.rate_Hz},
                              {"level_dbfs", settings.level_dBFS}});
    const std::vector<std::pair<QString, QString>> fields{
        {StudyText::tr("File"), QString::fromStdString(m_outFolder)},
        {StudyText::tr("Period"), StudyText::tr("%1 s").arg(forPeople(duration_s))},
        {StudyText::tr("Level"), StudyText::tr("%1 dBFS").arg(forPeople(settings.level_dBFS))}};
    return printFields(fields);
}

core::Expected<void> StudyCommand::runExport() const {
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading({m_studyFolder, m_server}));
    const study::ExportFormat format = m_format == "bids"    ? study::ExportFormat::bids
                                       : m_format == "excel" ? study::ExportFormat::excel
                                                             : study::ExportFormat::psychds;
    const core::Expected<std::size_t> sessions =
        store.ownFolder().and_then([&] { return study::exportStudy(store, format); });
    TELETA_CHECK(sessions);
    if (m_json)
        return printDocument({{"study", store.folder()}, {"format", m_format}, {"sessions", *sessions}});
    const std::vector<std::pair<QString, QString>> fields{
        {StudyText::tr("Study"), QString::fromStdString(store.folder())},
        {StudyText::tr("Format"), QString::fromStdString(m_format)},
        {StudyText::tr("Sessions"), QString::number(*sessions)}};
    return printFields(fields);
}

} // namespace teleta::cli
