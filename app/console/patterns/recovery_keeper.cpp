// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/recovery_keeper.h"

#include "widgets/base/background.h"

#include <QDir>
#include <QFile>
#include <QUuid>

#include <utility>

namespace teleta::console {

namespace {

/// Null when a running console (including this one) holds the lock, or it cannot be taken.
std::unique_ptr<study::FileClaim> claimOf(const QString& file) {
    auto claim = study::FileClaim::take((file + QStringLiteral(".lock")).toStdString(), {});
    return claim ? std::move(*claim) : nullptr;
}

std::vector<LostEdits> leftIn(const QString& folder, const QString& own) {
    std::vector<LostEdits> all;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Time)) {
        const QString file = dir.filePath(name);
        if (file == own)
            continue;
        std::shared_ptr<study::FileClaim> claim = claimOf(file);
        if (!claim)
            continue;
        // Files that cannot be read are kept for inspection.
        if (core::Expected<pattern::RecoveredPattern> recovered = pattern::readRecovery(file.toStdString()))
            all.push_back({std::move(*recovered), file, std::move(claim)});
    }
    return all;
}

} // namespace

RecoveryKeeper::RecoveryKeeper(QString folder, QObject* parent)
    : QObject(parent)
    , m_folder(std::move(folder))
    , m_file(m_folder.isEmpty() ? QString()
                                : QDir(m_folder).filePath(QUuid::createUuid().toString(QUuid::Id128) +
                                                          QStringLiteral(".json"))) {
    m_pool.setMaxThreadCount(1);
}

RecoveryKeeper::~RecoveryKeeper() {
    m_pool.waitForDone();
    // The newest edits may have waited for those before them.
    if (m_next)
        (void)pattern::writeRecovery(m_file.toStdString(), *m_next);
}

void RecoveryKeeper::look() {
    if (m_folder.isEmpty())
        return;
    base::runInBackground(
        m_pool, this, [folder = m_folder, own = m_file] { return leftIn(folder, own); },
        [this](std::vector<LostEdits> all) {
            m_lost = std::move(all);
            if (!m_lost.empty())
                emit found();
        });
}

LostEdits RecoveryKeeper::take() {
    LostEdits first = std::move(m_lost.front());
    m_lost.erase(m_lost.begin());
    return first;
}

void RecoveryKeeper::keep(const pattern::RecoveredPattern& edits) {
    if (m_folder.isEmpty())
        return;
    m_next = edits;
    write();
}

void RecoveryKeeper::write() {
    if (m_writing || !m_next)
        return;
    m_writing = true;
    base::runInBackground(
        m_pool, this,
        [this, edits = *std::exchange(m_next, std::nullopt)]() -> core::Expected<void> {
            // Without a lock the edits are still backed up, but may be offered too early.
            if (!m_claim) {
                QDir().mkpath(m_folder);
                m_claim = claimOf(m_file);
            }
            return pattern::writeRecovery(m_file.toStdString(), edits);
        },
        [this](core::Expected<void> written) {
            m_writing = false;
            if (!written && !m_failing)
                emit failed(written.error());
            m_failing = !written;
            write();
        });
}

void RecoveryKeeper::forget() {
    m_next.reset();
    if (m_file.isEmpty())
        return;
    m_pool.start([file = m_file] { QFile::remove(file); });
}

void RecoveryKeeper::discard(const LostEdits& lost) {
    m_pool.start([file = lost.file, claim = lost.claim] { QFile::remove(file); });
}

} // namespace teleta::console
