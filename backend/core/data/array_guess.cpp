// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/array_guess.h"

#include <QDir>
#include <QFileInfo>
#include <QString>

#include <array>

namespace teleta::core {

namespace {

/// Weiss WTS0614; Sensomatt and Tactilus bed arrays of the PoPu recordings (their pitch is not published: 50
/// and 25 mm are round numbers that give a bed's size).
struct KnownArray {
    ArrayLayout layout;
    const char* unit;
};
constexpr std::array kKnownArrays{KnownArray{{6, 14, 0.0034}, "N"}, KnownArray{{12, 6, 0.05}, "counts"},
                                  KnownArray{{64, 27, 0.025}, "counts"}};

} // namespace

ArrayGuess guessArray(std::size_t taxels) {
    for (const KnownArray& known : kKnownArrays)
        if (known.layout.taxels() == taxels)
            return {known.layout, known.unit};
    std::size_t rows = 1;
    for (std::size_t side = 1; side * side <= taxels; ++side)
        if (taxels % side == 0)
            rows = side;
    ArrayGuess guess{.layout = {}, .unit = "counts"};
    guess.layout.rows = static_cast<int>(rows);
    guess.layout.columns = static_cast<int>(taxels / rows);
    return guess;
}

std::string unloadedBeside(const std::string& path) {
    const QFileInfo file(QString::fromStdString(path));
    const qsizetype separator = file.completeBaseName().lastIndexOf(QLatin1Char('_'));
    if (separator <= 0)
        return {};
    const QString prefix = file.completeBaseName().left(separator + 1);
    const QStringList found =
        file.dir().entryList({prefix + QStringLiteral("empty*.csv")}, QDir::Files, QDir::Name);
    if (found.isEmpty() || found.front() == file.fileName())
        return {};
    return file.dir().filePath(found.front()).toStdString();
}

} // namespace teleta::core
