// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QString>

namespace teleta::base {

/// A path as one types it into a shell: ~ for the home of the user. Thread: any.
[[nodiscard]] inline QString fromHome(const QString& path) {
    const QString home = QDir::homePath();
    return path.startsWith(home + QLatin1Char('/')) ? QLatin1Char('~') + path.sliced(home.size()) : path;
}

} // namespace teleta::base
