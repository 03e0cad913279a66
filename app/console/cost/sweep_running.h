// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/sweep/sweep_folder.h"
#include "backend/sweep/sweep_runner.h"
#include "backend/sweep/sweep_subject.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace teleta::console {

/// A sweep with what it has shown, as the Cost page draws it.
struct ShownSweep {
    sweep::SweepPlan plan;
    std::optional<sweep::SweepResults> results; ///< empty: it has none yet
    QString folder;                             ///< of the results
};

/// Reads sweeps and results, and runs a sweep on this machine, all on pool threads. Thread: GUI.
class SweepRunning : public QObject {
    Q_OBJECT

public:
    using MakeSources = std::function<sweep::SubjectSources()>;
    /// makeSources: called on a pool thread.
    explicit SweepRunning(MakeSources makeSources, QObject* parent = nullptr);
    /// Lets the runs that are under way end, without waiting for them.
    ~SweepRunning() override;

    [[nodiscard]] bool isRunning() const { return m_run != nullptr; }
    /// It was told to end, and will after the runs that are under way.
    [[nodiscard]] bool isCancelled() const;
    [[nodiscard]] const ShownSweep* shown() const { return m_shown ? &*m_shown : nullptr; }
    /// Of the run, once it has come so far.
    [[nodiscard]] std::optional<sweep::SweepProgress> progress();

    /// A sweep file, the name of a sweep that comes with the program, or a folder with results.
    void open(const QString& path);
    /// Runs the sweep that is shown, with its results in this folder; goes on with what is there.
    void start(const QString& folder);
    void cancel();

signals:
    void shownChanged();
    void runningChanged();
    void failed(const QString& what, const QString& details);

private:
    struct Run {
        std::atomic<bool> cancelled{false};
        core::LatestExchange<sweep::SweepProgress> progress;
        bool any = false; ///< some progress came
    };

    void show(core::Expected<ShownSweep> shown);

    MakeSources m_makeSources;
    std::optional<ShownSweep> m_shown;
    std::shared_ptr<Run> m_run;
    std::uint64_t m_opened = 0; ///< an older answer is dropped
};

} // namespace teleta::console
