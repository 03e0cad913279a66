// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>

#include <cstddef>
#include <string>

/// What file_work.cpp writes.
namespace teleta::test {

inline constexpr int kSteps = 4;
inline constexpr int kFramesAStep = 40;
inline constexpr int kOutputs = 3;

[[nodiscard]] inline QDateTime workTime() {
    return QDateTime::fromString(QStringLiteral("2026-01-02T03:04:05Z"), Qt::ISODate);
}

/// Each is longer than a buffer and unlike the others.
[[nodiscard]] inline std::string outputOf(int step) {
    constexpr std::size_t kLines = 12'000;
    std::string text;
    for (std::size_t line = 0; line < kLines; ++line)
        text += std::to_string(step) + "," + std::to_string(line) + "\n";
    return text;
}

} // namespace teleta::test
