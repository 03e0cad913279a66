// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/scenes/scene_commands.h"
#include "app/common/scene_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/figure/figure_file.h"
#include "backend/scene_run/effect_ablation.h"
#include "backend/scene_run/scene_run.h"
#include "backend/scene_run/study/study_run.h"
#include "backend/servo/task_verdict.h"
#include "backend/servo_figure/servo_curves.h"
#include "backend/servo_figure/servo_figure.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
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

QString reasonText(const scene_run::RunVerdict& verdict) {
    switch (verdict.reason) {
    case servo::NotCompleted::neverInContact:
        return SimulateText::tr("never in contact");
    case servo::NotCompleted::lost:
        return SimulateText::tr("the contact was lost");
    case servo::NotCompleted::stalled:
        return !verdict.limit ? SimulateText::tr("stalled")
                              : SimulateText::tr("stalled by the limit %1")
                                    .arg(QLatin1String(servo::toString(*verdict.limit)));
    case servo::NotCompleted::notAligned:
        break;
    }
    return SimulateText::tr("not aligned");
}

QString verdictText(const scene_run::RunVerdict& verdict) {
    return verdict.completed ? SimulateText::tr("completed")
                             : SimulateText::tr("not completed: %1, in the phase %2")
                                   .arg(reasonText(verdict), QLatin1String(servo::toString(verdict.phase)));
}

core::Expected<void> printTable(const scene_run::SceneSummary& summary) {
    Fields fields{
        {SimulateText::tr("Scene"), QString::fromStdString(summary.scene)},
        {SimulateText::tr("Seed"), QString::number(summary.seed)},
        {SimulateText::tr("Simulated"), SimulateText::tr("%1 s").arg(forPeople(summary.simulated_s))},
        {SimulateText::tr("Computed in"),
         SimulateText::tr("%1 s (%2 x real time)")
             .arg(forPeople(summary.wall_s), forPeople(summary.simulated_s / summary.wall_s, 3))}};
    if (summary.verdict)
        fields.emplace_back(SimulateText::tr("Task"), verdictText(*summary.verdict));
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
    Fields fields;
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

constexpr std::array<std::string_view, 15> kColumns{"effect",
                                                    "measure",
                                                    "mean",
                                                    "spread_with",
                                                    "mean_without",
                                                    "spread_without",
                                                    "change",
                                                    "change_per_spread",
                                                    "p_mean",
                                                    "p_spread",
                                                    "seeds_that_differ",
                                                    "moves",
                                                    "own_time_s",
                                                    "run_s",
                                                    "run_with_all_s"};

std::set<std::string> measuresThatChange(const scene_run::Ablation& ablation) {
    std::set<std::string> names;
    for (const scene_run::EffectAblation& effect : ablation.effects)
        for (const scene_run::MeasureChange& change : effect.changes)
            if (change.differing > 0 || change.pMean < 1.0 || change.pSpread < 1.0 ||
                (change.change == change.change && change.change != 0.0))
                names.insert(change.measure);
    return names;
}

/// Prints what each effect of a scene does to its measures: one row an effect and measure.
///   effect, measure, mean, spread_with, mean_without, spread_without, change, change_per_spread, p_mean,
///   p_spread, seeds_that_differ, moves, own_time_s, run_s, run_with_all_s
/// Measures that no effect changes are left out. Spread: standard deviation over the seeds. p_mean, p_spread:
/// paired_tests.h. moves: yes, spread or no.
core::Expected<void> printAblation(const scene_run::Ablation& ablation, const RowOptions& options) {
    TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, options));
    const std::set<std::string> shown = measuresThatChange(ablation);
    for (const scene_run::EffectAblation& effect : ablation.effects)
        for (const scene_run::MeasureChange& change : effect.changes) {
            if (!shown.contains(change.measure))
                continue;
            rows.text(effect.effect);
            rows.text(change.measure);
            for (const double value :
                 {change.mean, change.spreadWith, change.meanWithout, change.spreadWithout, change.change})
                rows.number(value);
            // A measure without a spread has no such ratio, unless it stays as it is.
            rows.number(change.spreadWith > 0.0 ? std::optional(change.change / change.spreadWith)
                        : change.change == 0.0  ? std::optional(0.0)
                                                : std::nullopt);
            rows.number(change.pMean);
            rows.number(change.pSpread);
            rows.integer(static_cast<long long>(change.differing));
            rows.text(scene_run::toString(change.moves));
            for (const double time_s : {effect.own_s, effect.run_s, ablation.run_s})
                rows.number(time_s);
            rows.endRow();
        }
    return rows.finish();
}

class SimulateCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "scene", m_scenePath,
                  SimulateText::tr("Scene file, or the name of a scene that comes with the program"),
                  "SCENE");
        addFlag(app, "--list", m_list, SimulateText::tr("List the scenes that come with the program"));
        addOption(app, "-s,--seed", m_seed, SimulateText::tr("Seed of all random numbers of the scene"),
                  seed(), "N");
        addOption(app, "-d,--duration", m_duration_s,
                  SimulateText::tr("Simulated time in seconds; default: as the scene says"), "S")
            ->check(positive());
        addOption(
            app, "-o,--out", m_outFolder,
            SimulateText::tr(
                "Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file"),
            "DIR");
        CLI::Option* figures =
            addChoice(app, "--figures", m_figures,
                      SimulateText::tr("Formats of the chart of a servo run in --out, separated by commas"),
                      {"svg", "pdf", "png"})
                ->delimiter(',')
                ->allow_extra_args(false)
                ->needs("--out");
        addOption(app, "--compare", m_compare,
                  SimulateText::tr("Folders of earlier servo runs for the same chart, up to five"), "DIR")
            ->expected(1, 5)
            ->needs(figures);
        CLI::Option* ablate = addFlag(
            app, "--ablate", m_ablate,
            SimulateText::tr(
                "Leave out one effect at a time and compare how far each measure moves with its spread"));
        ablate->excludes(figures);
        addOption(app, "--seeds", m_seeds,
                  SimulateText::tr("Runs of each variant, with seeds from --seed upwards"), between(2, 1000),
                  "N")
            ->needs(ablate);
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        if (m_list)
            return printScenes(m_json);
        if (m_scenePath.empty())
            refuse("scene", SimulateText::tr("is required"));
        const core::Expected<app::AnyScene> scene = app::readAnyScene(m_scenePath);
        if (!scene) {
            core::Error error = scene.error();
            if (error.kind == core::ErrorKind::notFound)
                error.expected =
                    SimulateText::tr("a scene file, or a name that teleta simulate --list prints")
                        .toStdString();
            return core::Unexpected(std::move(error));
        }
        if (m_ablate)
            return ablate(*scene);
        const auto* study = std::get_if<study::StudyScene>(&*scene);
        if (!m_figures.empty() && (study != nullptr || !std::get<scene::Scene>(*scene).isServo()))
            refuse("--figures", SimulateText::tr("is for scenes of a servo"));

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
        if (summary->verdict && !summary->verdict->completed && !summary->verdict->expected)
            return core::failed(
                core::ErrorKind::refused,
                SimulateText::tr("the task was %1").arg(verdictText(*summary->verdict)),
                SimulateText::tr("a completed task, or expect = \"not_completed\" in the scene"));
        return {};
    }

private:
    [[nodiscard]] core::Expected<void> ablate(const app::AnyScene& scene) const {
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

    [[nodiscard]] core::Expected<std::vector<servo_figure::ServoCurves>> readEarlierRuns() const {
        std::vector<servo_figure::ServoCurves> runs;
        for (const std::string& folder : m_compare) {
            TELETA_TRY(servo_figure::ServoCurves run, servo_figure::readServoCurves(folder));
            runs.push_back(std::move(run));
        }
        return runs;
    }

    [[nodiscard]] core::Expected<void> writeFigures(std::vector<servo_figure::ServoCurves> runs) const {
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

    std::string m_scenePath;
    bool m_list = false;
    std::uint64_t m_seed = 1;
    std::optional<double> m_duration_s;
    std::string m_outFolder;
    bool m_json = false;
    bool m_ablate = false;
    std::uint64_t m_seeds = 8;
    std::vector<std::string> m_figures;
    std::vector<std::string> m_compare; ///< folders of earlier runs
};

} // namespace

Command simulateCommand() {
    return makeCommand<SimulateCommand>(
        "simulate",
        SimulateText::tr("Run a simulated scene as fast as possible and measure what was estimated"),
        "teleta simulate teleta-touch --out run");
}

} // namespace teleta::cli
