// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/simulate_command.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/validators.h"
#include "app/cli/commands/scenes/ablation_output.h"
#include "app/common/scene_file.h"
#include "backend/core/data/output_file.h"
#include "backend/figure/figure_file.h"
#include "backend/scene_run/effect_ablation.h"
#include "backend/scene_run/scene_run.h"
#include "backend/scene_run/study/study_run.h"
#include "backend/servo_figure/servo_figure.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include <CLI/CLI.hpp>

#include <utility>
#include <variant>
#include <vector>

namespace teleta::cli {

namespace {

using nlohmann::ordered_json;

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(SimulateCommand)
};

QString valueText(const ordered_json& value) {
    if (value.is_null())
        return QStringLiteral("NA");
    if (value.is_string())
        return QString::fromStdString(value.get<std::string>());
    if (value.is_number_float())
        return forPeople(value.get<double>());
    if (value.is_array()) {
        QStringList parts;
        for (const ordered_json& part : value)
            parts << valueText(part);
        return parts.join(QStringLiteral(", "));
    }
    return QString::fromStdString(value.dump());
}

core::Expected<void> printTable(const scene_run::SceneSummary& summary) {
    std::vector<std::pair<QString, QString>> fields{
        {SimulateText::tr("Scene"), QString::fromStdString(summary.scene)},
        {SimulateText::tr("Seed"), QString::number(summary.seed)},
        {SimulateText::tr("Simulated"), SimulateText::tr("%1 s").arg(forPeople(summary.simulated_s))},
        {SimulateText::tr("Computed in"),
         SimulateText::tr("%1 s (%2 x real time)")
             .arg(forPeople(summary.wall_s), forPeople(summary.simulated_s / summary.wall_s, 3))}};
    for (const scene_run::SceneSummary::EffectTime& effect : summary.effects)
        fields.emplace_back(SimulateText::tr("Effect %1").arg(QString::fromStdString(effect.name)),
                            SimulateText::tr("%1 s").arg(forPeople(effect.time_s, 3)));
    double parts_s = 0.0;
    for (const scene_run::SceneSummary::EffectTime& part : summary.parts)
        parts_s += part.time_s;
    for (const scene_run::SceneSummary::EffectTime& part : summary.parts)
        fields.emplace_back(
            SimulateText::tr("Share of %1").arg(QString::fromStdString(part.name)),
            SimulateText::tr("%1 %").arg(forPeople(parts_s > 0.0 ? 100.0 * part.time_s / parts_s : 0.0, 3)));
    for (const auto& [name, value] : summary.measures.items())
        fields.emplace_back(QString::fromStdString(name), valueText(value));
    fields.emplace_back(SimulateText::tr("Events"), QString::number(summary.events.size()));
    return printFields(fields);
}

core::Expected<void> printScenes(bool json) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    std::vector<std::pair<QString, QString>> fields;
    for (const std::string& name : app::sceneNames()) {
        TELETA_TRY(const app::AnyScene any, app::readAnyScene(name));
        std::visit(
            [&](const auto& scene) {
                document.push_back({{"id", name},
                                    {"name", scene.name},
                                    {"description", scene.description},
                                    {"duration_s", scene.duration_s}});
                fields.emplace_back(QString::fromStdString(name), QString::fromStdString(scene.name));
            },
            any);
    }
    return json ? printDocument(document) : printFields(fields);
}

} // namespace

QString SimulateCommand::summary() const {
    return SimulateText::tr("Run a simulated scene as fast as possible and measure what was estimated");
}

const char* SimulateCommand::example() const {
    return "teleta simulate teleta-touch --out run";
}

void SimulateCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return SimulateText::tr(text).toStdString(); };
    app.add_option("scene", m_scenePath,
                   help(QT_TRANSLATE_NOOP("SimulateCommand",
                                          "Scene file, or the name of a scene that comes with the program")))
        ->type_name("SCENE");
    app.add_flag("--list", m_list,
                 help(QT_TRANSLATE_NOOP("SimulateCommand", "List the scenes that come with the program")));
    app.add_option("--seed", m_seed,
                   help(QT_TRANSLATE_NOOP("SimulateCommand", "Seed of all random numbers of the scene")))
        ->type_name("N")
        ->capture_default_str()
        ->check(seed());
    app.add_option("--duration", m_duration_s,
                   help(QT_TRANSLATE_NOOP("SimulateCommand",
                                          "Simulated time in seconds; default: as the scene says")))
        ->type_name("S")
        ->check(positive());
    app.add_option(
           "--out", m_outFolder,
           help(QT_TRANSLATE_NOOP(
               "SimulateCommand",
               "Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file")))
        ->type_name("DIR");
    CLI::Option* figures =
        app.add_option("--figures", m_figures,
                       help(QT_TRANSLATE_NOOP("SimulateCommand",
                                              "Formats of the chart of a servo run in --out, separated by "
                                              "commas")))
            ->type_name("svg|pdf|png")
            ->delimiter(',')
            ->allow_extra_args(false)
            ->check(CLI::IsMember({"svg", "pdf", "png"}).description(""))
            ->needs("--out");
    app.add_option("--compare", m_compare,
                   help(QT_TRANSLATE_NOOP("SimulateCommand",
                                          "Folders of earlier servo runs for the same chart, up to five")))
        ->type_name("DIR")
        ->expected(1, 5)
        ->needs(figures);
    CLI::Option* ablate = app.add_flag(
        "--ablate", m_ablate,
        help(QT_TRANSLATE_NOOP(
            "SimulateCommand",
            "Leave out one effect at a time and compare how far each measure moves with its spread")));
    ablate->excludes(figures);
    app.add_option(
           "--seeds", m_seeds,
           help(QT_TRANSLATE_NOOP("SimulateCommand", "Runs of each variant, with seeds from --seed upwards")))
        ->type_name("N")
        ->needs(ablate)
        ->capture_default_str()
        ->check(between(2, 1000));
    declareJson(app, m_json);
}

core::Expected<void> SimulateCommand::ablate(const app::AnyScene& scene) const {
    ProgressBar progress(ProgressBar::Unit::runs, false);
    scene_run::AblationOptions options;
    options.firstSeed = m_seed;
    options.seeds = m_seeds;
    options.duration_s = m_duration_s;
    options.goOn = [&progress](double runs, double allRuns) {
        progress.update(runs, allRuns);
        return !interrupted();
    };
    const core::Expected<scene_run::Ablation> ablation =
        std::visit([&](const auto& any) { return scene_run::ablateEffects(any, options); }, scene);
    progress.erase();
    TELETA_CHECK(ablation);
    return printAblation(*ablation, {.json = m_json, .outPath = m_outFolder});
}

core::Expected<std::vector<servo_figure::ServoCurves>> SimulateCommand::readEarlierRuns() const {
    std::vector<servo_figure::ServoCurves> runs;
    for (const std::string& folder : m_compare) {
        TELETA_TRY(servo_figure::ServoCurves run, servo_figure::readServoCurves(folder));
        runs.push_back(std::move(run));
    }
    return runs;
}

core::Expected<void> SimulateCommand::writeFigures(std::vector<servo_figure::ServoCurves> runs) const {
    TELETA_TRY(servo_figure::ServoCurves own, servo_figure::readServoCurves(m_outFolder));
    runs.insert(runs.begin(), std::move(own));
    const std::string svg = servo_figure::servoFigure(runs).standalone();
    for (const std::string& format : m_figures) {
        TELETA_TRY(const std::string bytes, format == "pdf"   ? figure::pdfOf(svg)
                                            : format == "png" ? figure::pngOf(svg)
                                                              : core::Expected<std::string>(svg));
        TELETA_CHECK(core::writeFile(m_outFolder + "/servo." + format, bytes));
    }
    return {};
}

core::Expected<void> SimulateCommand::run() {
    if (m_list)
        return printScenes(m_json);
    if (m_scenePath.empty())
        throw CLI::ValidationError("scene", SimulateText::tr("is required").toStdString());
    const core::Expected<app::AnyScene> scene = app::readAnyScene(m_scenePath);
    if (!scene) {
        core::Error error = scene.error();
        if (error.kind == core::ErrorKind::notFound)
            error.expected =
                SimulateText::tr("a scene file, or a name that teleta simulate --list prints").toStdString();
        return core::Unexpected(std::move(error));
    }
    if (m_ablate)
        return ablate(*scene);
    const auto* study = std::get_if<study::StudyScene>(&*scene);
    if (!m_figures.empty() && (study != nullptr || !std::get<scene::Scene>(*scene).isServo()))
        throw CLI::ValidationError("--figures", SimulateText::tr("is for scenes of a servo").toStdString());

    // Before the run, which may take long; and the run may be of the same folder.
    TELETA_TRY(std::vector<servo_figure::ServoCurves> earlier, readEarlierRuns());
    // Nothing is printed before the end, so the bar may share the terminal with the results.
    ProgressBar progress(ProgressBar::Unit::simulatedSeconds, false);
    scene_run::RunOptions options;
    options.name = QFileInfo(QString::fromStdString(m_scenePath)).completeBaseName().toStdString();
    options.seed = m_seed;
    options.duration_s = m_duration_s;
    options.outFolder = m_outFolder;
    options.sceneText = app::readSceneText(m_scenePath);
    options.goOn = [&progress](double simulated_s, double duration_s) {
        progress.update(simulated_s, duration_s);
        return !interrupted();
    };
    const core::Expected<scene_run::SceneSummary> summary =
        study != nullptr ? scene_run::runStudyScene(*study, options)
                         : scene_run::runScene(std::get<scene::Scene>(*scene), options);
    progress.erase();
    TELETA_CHECK(summary);
    if (!m_figures.empty())
        TELETA_CHECK(writeFigures(std::move(earlier)));
    TELETA_CHECK(m_json ? printDocument(summary->toJson()) : printTable(*summary));
    if (summary->interrupted)
        return core::Unexpected(interruption());
    return {};
}

} // namespace teleta::cli
