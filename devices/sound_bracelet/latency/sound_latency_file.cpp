// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/latency/sound_latency_file.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QString>

#include <array>
#include <utility>

namespace teleta::sound {

namespace {

struct LatencyFileText {
    Q_DECLARE_TR_FUNCTIONS(SoundLatencyFile)
};

using Entry = std::pair<QString, QString>; ///< key and value

std::array<Entry, 2> entriesOf(const SoundLatency& latency) {
    const auto number = [](double value_s) { return QString::number(1e3 * value_s, 'f', 2); };
    return {Entry{QStringLiteral("latency_ms"), number(latency.median_s())},
            Entry{QStringLiteral("latency_spread_ms"), number(latency.spread_s())}};
}

QString lineOf(const Entry& entry) {
    return entry.first + QStringLiteral(" = ") + entry.second + QLatin1Char('\n');
}

/// The text with the value of that key, in its line or in one at the end. A sound bracelet's file has no
/// tables.
QString withEntry(const QString& text, const Entry& entry) {
    const QRegularExpression line(QStringLiteral("^([ \\t]*%1[ \\t]*=[ \\t]*)[^\\s#]+").arg(entry.first),
                                  QRegularExpression::MultilineOption);
    const QRegularExpressionMatch match = line.match(text);
    if (match.hasMatch())
        return text.left(match.capturedEnd(1)) + entry.second + text.mid(match.capturedEnd(0));
    const bool ends = text.isEmpty() || text.endsWith(QLatin1Char('\n'));
    return text + (ends ? QString() : QStringLiteral("\n")) + lineOf(entry);
}

} // namespace

std::string latencyLines(const SoundLatency& latency) {
    QString lines;
    for (const Entry& entry : entriesOf(latency))
        lines += lineOf(entry);
    return lines.toStdString();
}

core::Expected<void> keepLatency(const std::string& path, const SoundLatency& latency) {
    TELETA_TRY(const std::string before, core::readFile(path));
    TELETA_TRY(SoundBraceletFile wanted, parseSoundBracelet(before, path));
    const auto entries = entriesOf(latency);
    QString text = QString::fromStdString(before);
    for (const Entry& entry : entries)
        text = withEntry(text, entry);
    wanted.latency_ms = entries[0].second.toDouble();
    wanted.latencySpread_ms = entries[1].second.toDouble();
    const auto after = parseSoundBracelet(text.toStdString(), path);
    if (!after || *after != wanted)
        return core::refused(
            LatencyFileText::tr("The latency cannot be written into %1.").arg(QString::fromStdString(path)),
            LatencyFileText::tr("these lines in the file, written by hand:\n%1")
                .arg(QString::fromStdString(latencyLines(latency))));
    return core::writeFile(path, text.toStdString());
}

} // namespace teleta::sound
