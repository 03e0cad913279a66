// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/sweep/slurm.h"
#include "app/cli/commands/sweep/sweep_commands.h"
#include "app/cli/commands/sweep/sweep_report.h"
#include "app/common/scene_file.h"
#include "backend/core/failure.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/sweep/sweep_folder.h"
#include "backend/sweep/sweep_parts.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QString>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

constexpr std::chrono::seconds kBetweenLooks{2};
/// A scheduler that is busy or restarts does not answer for a while.
constexpr int kMostUnanswered = 10;
constexpr std::uint64_t kTasksByDefault = 100;
constexpr double kMostTasks = 1e6;

struct SweepText {
    Q_DECLARE_TR_FUNCTIONS(SweepCommand)
};

/// checked: every cell was tried when the array was submitted.
sweep::SubjectSources sources(bool checked) {
    return {[](const std::string& name) -> core::Expected<std::string> { return app::sceneText(name); },
            cost::allLadders(), checked};
}

std::string absolute(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).absoluteFilePath().toStdString();
}

class SweepCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "sweep", m_file, SweepText::tr("Sweep file: what runs, with which settings and seeds"),
                  "SWEEP.toml");
        addOption(app, "-o,--out", m_folder,
                  SweepText::tr("Folder for runs.csv, cells.csv, figures and sweep.json; a sweep that was "
                                "interrupted goes on in it"),
                  "DIR");
        addOption(
            app, "--workers", m_workers,
            SweepText::tr("Runs at the same time; otherwise as many as the machine has cores, and one of a "
                          "ladder, which is timed"),
            between(1, 1024), "N");
        addFlag(app, "--restart", m_restart,
                SweepText::tr("Throw away what the folder has of an earlier sweep"));
        addOption(app, "--allow-failed", m_allowFailed,
                  SweepText::tr("Share of the runs that may fail before this counts as an error"),
                  between(0, 1), "SHARE");
        addChoice(app, "--frames", m_frames,
                  SweepText::tr("Write the tactile frames with contacts, forces and objects to DIR/frames"),
                  {"npz"});
        CLI::Option* status = addOption(
            app, "--status", m_status, SweepText::tr("Say how far the sweep in this folder has come"), "DIR");
        addFlag(app, "--merge", m_merge,
                SweepText::tr(
                    "Only merge the results that are there, as each run of this command does at its end"));
        CLI::Option* slurm = addFlag(app, "--slurm", m_slurm,
                                     SweepText::tr("Run it as an array of jobs of Slurm on a cluster"));
        slurm->excludes(status);
        CLI::Option* tasks =
            addOption(app, "--tasks", m_tasks, SweepText::tr("Of Slurm: tasks of the array"), "N")
                ->check(between(1, kMostTasks));
        addOption(app, "--runs-per-task", m_runsPerTask, SweepText::tr("Of Slurm: runs of one task"), "K")
            ->check(between(1, kMostTasks))
            ->needs(slurm)
            ->excludes(tasks);
        addOption(app, "--sbatch-option", m_sbatchOptions,
                  SweepText::tr("Of Slurm: an option of sbatch, such as --partition=short; may come again"),
                  "OPTION")
            ->allow_extra_args(false)
            ->needs(slurm);
        addFlag(app, "--wait", m_wait, SweepText::tr("Of Slurm: wait until all is done and merged"))
            ->needs(slurm);
        addOption(app, "--task", m_task,
                  SweepText::tr("Do the share of this task of --tasks, from 0, as the jobs of Slurm do"), "T")
            ->check(between(0, kMostTasks))
            ->needs(tasks);
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        if (!m_status.empty())
            return printStatus();
        if (m_file.empty())
            refuse("sweep", SweepText::tr("is required"));
        if (m_folder.empty())
            refuse("--out", SweepText::tr("is required"));
        if (m_tasks && !m_slurm && !m_task)
            refuse("--tasks", SweepText::tr("needs --slurm or --task"));
        if (m_task && *m_task >= *m_tasks)
            refuse("--task", SweepText::tr("is not below the number of tasks, %1").arg(*m_tasks));
        TELETA_TRY(sweep::SweepPlan plan, readPlan());
        TELETA_TRY(const std::unique_ptr<sweep::SweepSubject> subject,
                   sweep::makeSubject(plan, sources(m_task.has_value())));
        const sweep::SweepFolder folder{m_folder, subject->source(),
                                        QCoreApplication::applicationVersion().toStdString(),
                                        !m_frames.empty()};
        if (folder.frames && !subject->hasFrames())
            refuse("--frames", SweepText::tr("is for scenes of an array or a servo"));
        TELETA_CHECK(folder.open(plan, m_restart));
        if (m_slurm)
            return runOnSlurm(plan, folder);
        sweep::SweepOutcome outcome;
        if (!m_merge) {
            TELETA_TRY(outcome, runHere(plan, *subject));
        }
        // Of an array each task leaves the merging to the job that comes after all of them.
        if (m_task)
            return outcome.interrupted ? core::Unexpected(interruption()) : core::Expected<void>();
        TELETA_TRY(const sweep::SweepResults results, folder.merge(plan));
        TELETA_CHECK(printSweep(plan, results, m_folder, m_json));
        if (outcome.interrupted)
            return core::Unexpected(interruption());
        return judged(results);
    }

private:
    /// A file, or a sweep that comes with the program.
    [[nodiscard]] core::Expected<sweep::SweepPlan> readPlan() const {
        auto plan = sweep::readSweepPlan(app::sweepPlace(m_file));
        if (!plan && plan.error().kind == core::ErrorKind::notFound)
            plan.error().expected = SweepText::tr("a sweep file, or one of: %1")
                                        .arg(app::sweepNames().join(QStringLiteral(", ")))
                                        .toStdString();
        return plan;
    }

    [[nodiscard]] core::Expected<sweep::SweepOutcome> runHere(const sweep::SweepPlan& plan,
                                                              const sweep::SweepSubject& subject) const {
        SweepScreen screen(plan);
        sweep::SweepOptions options;
        options.folder = m_folder;
        options.workers = m_workers;
        options.frames = !m_frames.empty();
        if (m_task) {
            const auto share = [&](std::uint64_t task) {
                return static_cast<std::uint64_t>(static_cast<long double>(plan.runs()) *
                                                  static_cast<long double>(task) /
                                                  static_cast<long double>(*m_tasks));
            };
            options.first = share(*m_task);
            options.end = share(*m_task + 1);
        }
        options.goOn = [&](const sweep::SweepProgress& progress) {
            screen.update(progress);
            return !interrupted();
        };
        return sweep::runSweep(plan, subject, options);
    }

    /// An error when more runs failed than may, or some are missing.
    [[nodiscard]] core::Expected<void> judged(const sweep::SweepResults& results) const {
        if (results.done < results.all)
            return core::failed(
                core::ErrorKind::refused,
                SweepText::tr("%1 of %2 runs are missing").arg(results.all - results.done).arg(results.all),
                SweepText::tr("the same command without --merge, which goes on with them"));
        if (static_cast<double>(results.failed) > m_allowFailed * static_cast<double>(results.all))
            return core::failed(core::ErrorKind::refused,
                                SweepText::tr("%1 of %2 runs failed; runs.csv has the reasons")
                                    .arg(results.failed)
                                    .arg(results.all),
                                SweepText::tr("at most %1 (see --allow-failed)")
                                    .arg(forPeople(m_allowFailed * static_cast<double>(results.all))));
        return {};
    }

    [[nodiscard]] core::Expected<void> printStatus() const {
        sweep::SweepPlan plan;
        TELETA_CHECK(sweep::SweepFolder::read(m_status, plan));
        TELETA_TRY(const sweep::SweepResults results, sweep::readResults(plan, m_status));
        return printSweep(plan, results, m_status, m_json);
    }

    [[nodiscard]] core::Expected<void> runOnSlurm(const sweep::SweepPlan& plan,
                                                  const sweep::SweepFolder& folder) const {
        SlurmJob job;
        job.program = QCoreApplication::applicationFilePath().toStdString();
        job.sweepFile = QFileInfo::exists(QString::fromStdString(m_file)) ? absolute(m_file) : m_file;
        job.folder = absolute(m_folder);
        job.frames = folder.frames;
        job.allowFailed = m_allowFailed;
        job.tasks = m_tasks.value_or(kTasksByDefault);
        if (m_runsPerTask)
            job.tasks = (plan.runs() + *m_runsPerTask - 1) / *m_runsPerTask;
        job.tasks = std::clamp<std::uint64_t>(job.tasks, 1, plan.runs());
        job.options = m_sbatchOptions;
        TELETA_TRY(const SubmittedJob submitted, submitToSlurm(job));
        if (m_wait)
            return waitFor(plan, folder, submitted);
        return m_json
                   ? printDocument({{"array", submitted.array},
                                    {"merge", submitted.merge},
                                    {"tasks", job.tasks},
                                    {"folder", m_folder}})
                   : printFields({{SweepText::tr("Job"), QString::fromStdString(submitted.array)},
                                  {SweepText::tr("Tasks"), QString::number(job.tasks)},
                                  {SweepText::tr("Merging job"), QString::fromStdString(submitted.merge)},
                                  {SweepText::tr("How far it is"), QStringLiteral("teleta sweep --status ") +
                                                                       QString::fromStdString(m_folder)}});
    }

    [[nodiscard]] core::Expected<void> waitFor(const sweep::SweepPlan& plan, const sweep::SweepFolder& folder,
                                               const SubmittedJob& submitted) const {
        SweepScreen screen(plan);
        const auto start = std::chrono::steady_clock::now();
        std::optional<std::uint64_t> before;
        int unanswered = 0;
        for (;;) {
            if (interrupted())
                return core::Unexpected(interruption()); // the jobs go on
            const core::Expected<std::uint64_t> tasks = tasksInSlurm({submitted.array, submitted.merge});
            if (!tasks) {
                if (++unanswered >= kMostUnanswered)
                    return core::Unexpected(tasks.error());
                screen.erase();
                warn(SweepText::tr("%1; asking again (%2 of %3)")
                         .arg(QString::fromStdString(describe(tasks.error())))
                         .arg(unanswered)
                         .arg(kMostUnanswered - 1));
                std::this_thread::sleep_for(kBetweenLooks);
                continue;
            }
            unanswered = 0;
            TELETA_TRY(const std::vector<bool> finished, sweep::finishedRuns(m_folder, plan.runs()));
            const auto done = static_cast<std::uint64_t>(std::ranges::count(finished, true));
            if (!before)
                before = done;
            sweep::SweepProgress progress;
            progress.done = done;
            progress.all = plan.runs();
            progress.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            progress.left_s = done > *before ? progress.wall_s * static_cast<double>(plan.runs() - done) /
                                                   static_cast<double>(done - *before)
                                             : std::numeric_limits<double>::quiet_NaN();
            screen.update(progress);
            if (*tasks == 0)
                break;
            std::this_thread::sleep_for(kBetweenLooks);
        }
        screen.erase();
        // The merging job may have been cancelled; merging again changes nothing.
        TELETA_TRY(const sweep::SweepResults results, folder.merge(plan));
        TELETA_CHECK(printSweep(plan, results, m_folder, m_json));
        return judged(results);
    }

    std::string m_file;
    std::string m_folder;
    std::size_t m_workers = 0;
    bool m_restart = false;
    double m_allowFailed = 0.0;
    std::string m_frames;
    std::string m_status;
    bool m_merge = false;
    bool m_slurm = false;
    bool m_wait = false;
    std::optional<std::uint64_t> m_tasks;
    std::optional<std::uint64_t> m_runsPerTask;
    std::optional<std::uint64_t> m_task;
    std::vector<std::string> m_sbatchOptions;
    bool m_json = false;
};

} // namespace

Command sweepCommand() {
    return makeCommand<SweepCommand>(
        "sweep", SweepText::tr("Run a scene over a grid of settings and seeds, here or on a cluster"),
        "teleta sweep contour-ladder --out sweep");
}

} // namespace teleta::cli
