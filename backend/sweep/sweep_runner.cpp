// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_runner.h"

#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/cost/trial.h"
#include "backend/sweep/frame_parts.h"
#include "backend/sweep/sweep_parts.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

namespace teleta::sweep {

namespace {

constexpr std::chrono::milliseconds kBetweenReports{100};
/// Runs that are lost in a power cut took no longer than this, or one run if that takes longer.
constexpr double kBetweenWrites_s = 5.0;
/// The same with frames, which make a file each time.
constexpr double kBetweenFrameWrites_s = 30.0;
constexpr std::size_t kWorstCells = 5;

struct SweepRunnerText {
    Q_DECLARE_TR_FUNCTIONS(SweepRunner)
};

class Runner {
public:
    Runner(const SweepPlan& plan, const SweepSubject& subject, const SweepOptions& options,
           std::vector<std::uint64_t> missing)
        : m_plan(plan)
        , m_subject(subject)
        , m_options(options)
        , m_missing(std::move(missing))
        , m_tallies(plan.cells()) {}

    core::Expected<void> run(std::uint64_t before, std::uint64_t all) {
        const std::int64_t start_ns = core::steadyNow_ns();
        // Runs of a ladder are timed: they would take each other's time.
        const std::size_t usual =
            m_plan.kind == SubjectKind::ladder ? 1 : std::max(1U, std::thread::hardware_concurrency());
        const std::size_t wanted = m_options.workers > 0 ? m_options.workers : usual;
        const std::size_t threads = std::min<std::size_t>(wanted, m_missing.size());
        m_working = threads;
        std::vector<std::thread> workers;
        for (std::size_t i = 0; i < threads; ++i)
            workers.emplace_back([this] { work(); });
        {
            std::unique_lock lock(m_mutex);
            while (!m_ended.wait_for(lock, kBetweenReports, [this] { return m_working == 0; })) {
                lock.unlock();
                if (m_options.goOn && !m_stop && !m_options.goOn(progress(before, all, start_ns))) {
                    m_interrupted = true;
                    m_stop = true;
                }
                lock.lock();
            }
        }
        for (std::thread& worker : workers)
            worker.join();
        if (m_error)
            return core::Unexpected(*m_error);
        if (m_options.goOn)
            (void)m_options.goOn(progress(before, all, start_ns));
        return {};
    }

    [[nodiscard]] std::uint64_t done() const { return m_done; }
    [[nodiscard]] std::uint64_t failed() const { return m_failed; }
    [[nodiscard]] bool interrupted() const { return m_interrupted && m_done < m_missing.size(); }

private:
    [[nodiscard]] SweepProgress progress(std::uint64_t before, std::uint64_t all, std::int64_t start_ns) {
        SweepProgress now;
        now.done = before + m_done;
        now.all = all;
        now.failed = m_failed;
        now.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
        now.left_s = std::numeric_limits<double>::quiet_NaN();
        {
            const std::scoped_lock lock(m_tallyMutex);
            now.measure = m_measure;
            now.worst = worstCells();
        }
        if (m_done > 0)
            now.left_s =
                now.wall_s * static_cast<double>(m_missing.size() - m_done) / static_cast<double>(m_done);
        return now;
    }

    /// The mutex of the tallies is held.
    [[nodiscard]] std::vector<WorstCell> worstCells() const {
        const bool smallIsBad =
            m_measure == "completed" || m_measure == "significant" || m_measure.ends_with("_covered");
        std::vector<WorstCell> cells;
        for (std::uint64_t cell = 0; cell < m_tallies.size(); ++cell) {
            const Tally& tally = m_tallies[cell];
            if (tally.runs == 0)
                continue;
            WorstCell& worst = cells.emplace_back();
            worst.cell = cell;
            worst.runs = tally.runs;
            worst.failed = tally.failed;
            if (tally.n > 0)
                worst.mean = tally.sum / static_cast<double>(tally.n);
        }
        const auto badness = [smallIsBad](const WorstCell& cell) {
            const double mean = cell.mean.value_or(0.0);
            return std::pair(static_cast<double>(cell.failed) / static_cast<double>(cell.runs),
                             smallIsBad ? -mean : mean);
        };
        const std::size_t shown = std::min(cells.size(), kWorstCells);
        std::ranges::partial_sort(cells, cells.begin() + static_cast<std::ptrdiff_t>(shown),
                                  std::ranges::greater(), badness);
        cells.resize(shown);
        return cells;
    }

    void tally(const RunRow& row) {
        m_failed += row.failed() ? 1 : 0;
        const std::scoped_lock lock(m_tallyMutex);
        Tally& tally = m_tallies[m_plan.cellOf(row.run)];
        ++tally.runs;
        tally.failed += row.failed() ? 1 : 0;
        if (m_measure.empty())
            m_measure = !m_plan.measures.empty() ? m_plan.measures.front()
                        : !row.measures.empty()  ? row.measures.front().first
                                                 : std::string();
        for (const auto& [name, value] : row.measures)
            if (baseName(name) == baseName(m_measure) && std::isfinite(value)) {
                tally.sum += value;
                ++tally.n;
            }
    }

    void work() {
        const auto worked = workThrough();
        const std::scoped_lock lock(m_mutex);
        if (!worked && !m_error)
            m_error = worked.error();
        if (!worked)
            m_stop = true;
        if (--m_working == 0)
            m_ended.notify_one();
    }

    core::Expected<void> workThrough() {
        const std::unique_ptr<SweepWorker> worker = m_subject.makeWorker();
        PartWriter part(m_options.folder);
        FrameParts frames;
        std::int64_t written_ns = core::steadyNow_ns();
        core::Expected<void> state;
        while (state && !m_stop) {
            const std::size_t next = m_next.fetch_add(1);
            if (next >= m_missing.size())
                break;
            const std::uint64_t run = m_missing[next];
            std::optional<core::ArrayLayout> layout;
            if (m_options.frames)
                layout = worker->layoutOf(m_plan, m_plan.cellOf(run));
            if (layout && !frames.takes(*layout)) {
                state = write(part, frames);
                written_ns = core::steadyNow_ns();
            }
            if (!state)
                break;
            RunRow row = runOne(*worker, run, layout ? &*layout : nullptr, frames);
            if (auto known = checkMeasures(row); !known) {
                state = std::move(known);
                break;
            }
            keepWanted(row.measures);
            tally(row);
            part.add(std::move(row));
            ++m_done;
            const double longest_s = m_options.frames ? kBetweenFrameWrites_s : kBetweenWrites_s;
            const bool due = core::elapsed_s(written_ns, core::steadyNow_ns()) > longest_s ||
                             (m_options.frames && frames.frames() >= kFramesOfPart);
            if (due || part.rows() >= kRowsOfPart) {
                state = write(part, frames);
                written_ns = core::steadyNow_ns();
            }
        }
        // What was done is kept, whatever ended the loop.
        auto last = write(part, frames);
        return state ? last : state;
    }

    /// layout: of the frames; null: none are kept.
    RunRow runOne(SweepWorker& worker, std::uint64_t run, const core::ArrayLayout* layout,
                  FrameParts& frames) {
        RunRow row;
        row.run = run;
        std::function<void(const scene_run::LabelledFrame&)> onFrame;
        if (layout != nullptr) {
            frames.beginRun(run, m_plan.cellOf(run), m_plan.seedOf(run), *layout);
            onFrame = [&frames](const scene_run::LabelledFrame& frame) { frames.add(frame); };
        }
        const std::int64_t start_ns = core::steadyNow_ns();
        const std::int64_t ownStart_ns = cost::threadTime_ns();
        auto measures = worker.run(m_plan, m_plan.cellOf(run), m_plan.seedOf(run), onFrame);
        row.processor_s = core::elapsed_s(ownStart_ns, cost::threadTime_ns());
        row.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
        if (measures) {
            row.measures = std::move(*measures);
        } else {
            const QString reason = QString::fromStdString(describe(measures.error())).simplified();
            row.reason = reason.toStdString();
        }
        if (layout != nullptr)
            frames.endRun(!row.failed());
        return row;
    }

    /// Frames go first: a run that has a row has its frames. A file whose rows never came is of no run;
    /// merging leaves it out.
    core::Expected<void> write(PartWriter& part, FrameParts& frames) {
        if (m_options.frames && frames.frames() > 0) {
            TELETA_TRY(const std::string number, part.number());
            TELETA_CHECK(frames.write(m_options.folder + "/frames/" + number + ".npz"));
        }
        return m_options.frames ? part.close() : part.flush();
    }

    /// A measure that no run has is most likely misspelt.
    core::Expected<void> checkMeasures(const RunRow& row) {
        if (row.failed() || m_plan.measures.empty() || m_checked.exchange(true))
            return {};
        QStringList known;
        for (const auto& [name, value] : row.measures)
            known << QString::fromStdString(baseName(name));
        known.removeDuplicates();
        for (const std::string& wanted : m_plan.measures)
            if (!known.contains(QString::fromStdString(baseName(wanted))))
                return core::failed(
                    core::ErrorKind::badInput,
                    SweepRunnerText::tr("a run has no measure \"%1\"").arg(QString::fromStdString(wanted)),
                    SweepRunnerText::tr("of: %1").arg(known.join(QStringLiteral(", "))),
                    m_plan.measuresPlace);
        return {};
    }

    void keepWanted(RunMeasures& measures) const {
        if (m_plan.measures.empty())
            return;
        RunMeasures wanted;
        for (const std::string& name : m_plan.measures)
            for (const auto& measure : measures)
                if (measure.first == name || (baseName(measure.first) == name && measure.first != name))
                    wanted.push_back(measure);
        measures = std::move(wanted);
    }

    /// What the runs of a cell have given in this call.
    struct Tally {
        std::uint64_t runs = 0, failed = 0, n = 0;
        double sum = 0.0; ///< of the measure
    };

    const SweepPlan& m_plan;
    const SweepSubject& m_subject;
    const SweepOptions& m_options;
    const std::vector<std::uint64_t> m_missing;
    std::atomic<std::size_t> m_next{0};
    std::atomic<std::uint64_t> m_done{0};
    std::atomic<std::uint64_t> m_failed{0};
    std::atomic<bool> m_checked{false};
    std::atomic<bool> m_stop{false};
    bool m_interrupted = false;
    std::mutex m_tallyMutex;
    std::vector<Tally> m_tallies; ///< of each cell
    std::string m_measure;
    std::mutex m_mutex;
    std::condition_variable m_ended;
    std::size_t m_working = 0;          ///< threads; under the mutex
    std::optional<core::Error> m_error; ///< likewise
};

} // namespace

core::Expected<SweepOutcome> runSweep(const SweepPlan& plan, const SweepSubject& subject,
                                      const SweepOptions& options) {
    TELETA_CHECK(core::makeFolder(options.folder + "/parts"));
    if (options.frames) {
        if (!subject.hasFrames())
            return core::failed(core::ErrorKind::badInput,
                                SweepRunnerText::tr("this has no frames of a tactile array"),
                                SweepRunnerText::tr("a scene of an array or a servo"), {plan.file});
        TELETA_CHECK(core::makeFolder(options.folder + "/frames"));
    }
    TELETA_TRY(const std::vector<bool> finished, finishedRuns(options.folder, plan.runs()));
    std::vector<std::uint64_t> missing;
    std::uint64_t all = 0;
    for (std::uint64_t run = options.first; run < std::min(options.end, plan.runs()); ++run) {
        ++all;
        if (!finished[run])
            missing.push_back(run);
    }
    const std::uint64_t before = all - missing.size();
    Runner runner(plan, subject, options, std::move(missing));
    if (before < all)
        TELETA_CHECK(runner.run(before, all));
    return SweepOutcome{before + runner.done(), all, runner.failed(), runner.interrupted()};
}

} // namespace teleta::sweep
