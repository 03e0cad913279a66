// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/files/recovery_file.h"
#include "backend/study/store/file_claim.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>
#include <optional>
#include <vector>

namespace teleta::console {

/// Unsaved edits of a program that has ended.
struct LostEdits {
    pattern::RecoveredPattern recovered;
    QString file;
    std::shared_ptr<study::FileClaim> claim; ///< keeps other consoles from offering them
};

/// Backs up unsaved edits in a file of its own, next to those of other consoles, and finds the files of
/// consoles that were killed. Never writes to the user's files. The file of a running console is not offered:
/// it is locked, and the kernel releases the lock when the console ends. Thread: GUI; files are read and
/// written on its own thread, for which only the destructor waits.
class RecoveryKeeper : public QObject {
    Q_OBJECT

public:
    /// folder: empty: nothing is backed up.
    explicit RecoveryKeeper(QString folder, QObject* parent = nullptr);
    ~RecoveryKeeper() override;

    /// Searches for unsaved edits; emits found() if there are any.
    void look();
    [[nodiscard]] const std::vector<LostEdits>& lost() const { return m_lost; }
    /// Hands over the first of lost() to the caller.
    [[nodiscard]] LostEdits take();

    /// Backs up these edits, replacing the previous ones.
    void keep(const pattern::RecoveredPattern& edits);
    /// Removes the backup, because the edits were saved or discarded.
    void forget();
    /// Removes the file of edits that were taken, because they are backed up again or were discarded.
    void discard(const LostEdits& lost);

signals:
    void found();
    /// Emitted once until backing up works again.
    void failed(const teleta::core::Error& error);

private:
    void write();

    QString m_folder;
    QString m_file;
    std::unique_ptr<study::FileClaim> m_claim; ///< used on the pool's thread only
    QThreadPool m_pool;                        ///< one thread, so that files are written in order
    std::vector<LostEdits> m_lost;
    std::optional<pattern::RecoveredPattern> m_next;
    bool m_writing = false;
    bool m_failing = false;
};

} // namespace teleta::console
