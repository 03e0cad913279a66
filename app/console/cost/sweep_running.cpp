// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/sweep_running.h"

#include "app/common/scene_file.h"
#include "widgets/base/background.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <utility>

namespace teleta::console {

namespace {

core::Expected<ShownSweep> readShown(const std::string& path) {
    ShownSweep shown;
    const QFileInfo info(QString::fromStdString(path));
    if (info.isDir() || info.fileName() == QStringLiteral("sweep.json")) {
        const QString folder = info.isDir() ? info.filePath() : info.path();
        shown.folder = folder;
        TELETA_CHECK(sweep::SweepFolder::read(folder.toStdString(), shown.plan));
        TELETA_TRY(shown.results, sweep::readResults(shown.plan, folder.toStdString()));
        return shown;
    }
    TELETA_TRY(shown.plan, sweep::readSweepPlan(app::sweepPlace(path)));
    return shown;
}

} // namespace

SweepRunning::SweepRunning(MakeSources makeSources, QObject* parent)
    : QObject(parent)
    , m_makeSources(std::move(makeSources)) {
}

SweepRunning::~SweepRunning() {
    cancel();
}

bool SweepRunning::isCancelled() const {
    return m_run && m_run->cancelled.load(std::memory_order_relaxed);
}

std::optional<sweep::SweepProgress> SweepRunning::progress() {
    if (!m_run)
        return std::nullopt;
    m_run->any = m_run->progress.update() || m_run->any;
    return m_run->any ? std::optional(m_run->progress.front()) : std::nullopt;
}

void SweepRunning::open(const QString& path) {
    base::runInBackground(
        this, [path = path.toStdString()] { return readShown(path); },
        [this, opened = ++m_opened](core::Expected<ShownSweep> shown) {
            if (opened == m_opened)
                show(std::move(shown));
        });
}

void SweepRunning::show(core::Expected<ShownSweep> shown) {
    if (!shown) {
        emit failed(tr("The sweep cannot be opened."), QString::fromStdString(core::describe(shown.error())));
        return;
    }
    m_shown = std::move(*shown);
    emit shownChanged();
}

void SweepRunning::start(const QString& folder) {
    if (m_run || !m_shown)
        return;
    m_run = std::make_shared<Run>();
    emit runningChanged();
    base::runInBackground(
        this,
        [run = m_run, makeSources = m_makeSources, plan = m_shown->plan,
         folder = folder.toStdString()]() mutable -> core::Expected<ShownSweep> {
            TELETA_TRY(const std::unique_ptr<sweep::SweepSubject> subject,
                       sweep::makeSubject(plan, makeSources()));
            const sweep::SweepFolder results{folder, subject->source(),
                                             QCoreApplication::applicationVersion().toStdString(), false};
            TELETA_CHECK(results.open(plan, false));
            sweep::SweepOptions options;
            options.folder = folder;
            options.goOn = [&run](const sweep::SweepProgress& now) {
                run->progress.back() = now;
                run->progress.publish();
                return !run->cancelled.load(std::memory_order_relaxed);
            };
            TELETA_CHECK(sweep::runSweep(plan, *subject, options));
            TELETA_TRY(sweep::SweepResults merged, results.merge(plan));
            return ShownSweep{std::move(plan), std::move(merged), QString::fromStdString(folder)};
        },
        [this, opened = m_opened](core::Expected<ShownSweep> shown) {
            m_run.reset();
            // Another one may have been opened meanwhile.
            if (!shown)
                emit failed(tr("The sweep has failed."),
                            QString::fromStdString(core::describe(shown.error())));
            else if (opened == m_opened)
                show(std::move(shown));
            emit runningChanged();
        });
}

void SweepRunning::cancel() {
    if (!m_run)
        return;
    m_run->cancelled.store(true, std::memory_order_relaxed);
    emit runningChanged();
}

} // namespace teleta::console
