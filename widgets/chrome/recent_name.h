// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QString>
#include <QStringList>

namespace teleta::chrome {

/// What people read of a file that was opened before.
struct RecentName {
    QString title; ///< what is in it
    QString about; ///< when it was recorded, and how long it is; may be empty
    QString exact; ///< the same with seconds, for files that are alike otherwise

    [[nodiscard]] QString oneLine() const;
};

/// By the path of the file.
using RecentNames = QHash<QString, RecentName>;

/// The names of some files in their order. A file of an unknown name has that of the file. Files with the
/// same name have the exact one; where this is the same too, those of their files, and of their folders.
/// Thread: any.
[[nodiscard]] QList<RecentName> recentNamesOf(const QStringList& paths, const RecentNames& known);

} // namespace teleta::chrome
