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

/// Edits that a program which ended without saving has left.
struct LostEdits {
    pattern::RecoveredPattern recovered;
    QString file;
    std::shared_ptr<study::FileClaim> claim; ///< no other console offers them meanwhile
};

/// Keeps what is edited and not saved in a file of its own, beside those of other consoles, and finds what
/// consoles have left that were killed. It writes nowhere else, never to the user's files. A file of a
/// console that still runs is not offered: the kernel holds its lock, and lets it go with the console.
/// Thread: GUI; files are read and written on a thread of its own. Only the destructor waits for it.
class RecoveryKeeper : public QObject {
    Q_OBJECT

public:
    /// folder: empty: nothing is kept.
    explicit RecoveryKeeper(QString folder, QObject* parent = nullptr);
    ~RecoveryKeeper() override;

    /// Looks for what was left; found() follows when there is something.
    void look();
    [[nodiscard]] const std::vector<LostEdits>& lost() const { return m_lost; }
    /// The first of lost(), which is then kept no more: it is with the caller.
    [[nodiscard]] LostEdits take();

    /// Keeps these edits in place of those before.
    void keep(const pattern::RecoveredPattern& edits);
    /// They are saved, or not wanted.
    void forget();
    /// Removes the file of what was taken: it is open, and kept anew, or not wanted.
    void discard(const LostEdits& lost);

signals:
    void found();
    /// Emits once until it works again.
    void failed(const teleta::core::Error& error);

private:
    void write();

    QString m_folder;
    QString m_file;
    std::unique_ptr<study::FileClaim> m_claim; ///< used on the pool's thread only
    QThreadPool m_pool;                        ///< of one thread, so that files are written in order
    std::vector<LostEdits> m_lost;
    std::optional<pattern::RecoveredPattern> m_next;
    bool m_writing = false;
    bool m_failing = false;
};

} // namespace teleta::console
