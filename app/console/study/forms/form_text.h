// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

namespace teleta::console {

/// Trimmed, non-empty parts of a text between separators.
inline QStringList parts(const QString& text, QChar separator) {
    QStringList found;
    for (const QString& part : text.split(separator, Qt::SkipEmptyParts)) {
        if (const QString trimmed = part.trimmed(); !trimmed.isEmpty())
            found << trimmed;
    }
    return found;
}

/// Each line as its first word and the rest; the word itself if there is no rest.
inline std::vector<std::pair<QString, QString>> firstWords(const QString& text) {
    std::vector<std::pair<QString, QString>> lines;
    for (const QString& line : parts(text, QLatin1Char('\n'))) {
        const QString word = line.section(QLatin1Char(' '), 0, 0);
        const QString rest = line.section(QLatin1Char(' '), 1).trimmed();
        lines.emplace_back(word, rest.isEmpty() ? word : rest);
    }
    return lines;
}

} // namespace teleta::console
