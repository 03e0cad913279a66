// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/bracelet_content.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

QString plainText(const std::string& text) {
    return QString::fromStdString(text);
}

ResultCell valueCell(const std::optional<double>& value, int digits = 3) {
    if (!value || !std::isfinite(*value))
        return {QStringLiteral("\u2013"), QStringLiteral("NA")};
    return {QLocale().toString(*value, 'g', digits),
            QLocale::c().toString(*value, 'g', QLocale::FloatingPointShortest)};
}

ResultCell betweenCell(double low, double high) {
    return {
        QStringLiteral("%1 \u2013 %2").arg(QLocale().toString(low, 'g', 3), QLocale().toString(high, 'g', 3)),
        valueCell(low).data + QLatin1Char(';') + valueCell(high).data};
}

ResultCell whoCell(const std::string& participant, const QString& all) {
    return participant.empty() ? ResultCell{all, QStringLiteral("GROUP")}
                               : ResultCell{plainText(participant)};
}

QString tactorList(const std::vector<std::size_t>& tactors) {
    QStringList names;
    for (const std::size_t tactor : tactors)
        names << QString::number(tactor + 1);
    return names.join(QStringLiteral(", "));
}

} // namespace

bool BraceletContent::has(const LevelResults& results, const QString& task) {
    const FeltTask* felt = results.feltTask(task);
    return felt != nullptr && (!feltOnsets(results.thresholds, *felt).empty() ||
                               !feltSteps(results.thresholds, *felt).empty() || equal(results, task, {}));
}

TableContent BraceletContent::onsets(const LevelResults& results, const QString& task,
                                     const ConditionNames& names) {
    TableContent table;
    table.header = {tr("Participant"), tr("Condition"),      tr("Track"),       tr("Best onset, ms"),
                    tr("95 %"),        tr("By the law, ms"), tr("What it says")};
    table.tips = {{},
                  {},
                  {},
                  tr("Time from burst to burst at which most answers are yes: the top of a parabola on the "
                     "probit scale"),
                  tr("By the delta method; of all participants Student's t of their best onsets"),
                  tr("0.32 times the length of a burst + 47.3 ms, the law of apparent motion")};
    const FeltTask* felt = results.feltTask(task);
    if (felt == nullptr)
        return table;
    const auto words = [](const FeltOnset& line) {
        switch (line.best.doubt) {
        case OnsetDoubt::tooFewTimes:
            return line.participant.empty() ? tr("nobody has a best onset")
                                            : tr("fewer than three times were shown");
        case OnsetDoubt::noTop:
            return tr("no onset is best: the answers have no top");
        case OnsetDoubt::outside:
            return tr("best beyond the times that were shown");
        case OnsetDoubt::none:
            break;
        }
        if (line.participant.empty())
            return tr("mean of %1").arg(line.participants);
        if (!line.law_s)
            return QString();
        return *line.law_s < line.best.low_s    ? tr("later than the law says")
               : *line.law_s > line.best.high_s ? tr("earlier than the law says")
                                                : tr("agrees with the law");
    };
    for (const FeltOnset& line : feltOnsets(results.thresholds, *felt)) {
        const bool isKnown = line.best.doubt == OnsetDoubt::none;
        const bool hasInterval = isKnown && line.best.high_s > line.best.low_s;
        const QString id = plainText(line.condition);
        table.rows.push_back({whoCell(line.participant, tr("All")),
                              {names.value(id, id), id},
                              {plainText(line.track)},
                              valueCell(isKnown ? std::optional(1e3 * line.best.onset_s) : std::nullopt),
                              hasInterval ? betweenCell(1e3 * line.best.low_s, 1e3 * line.best.high_s)
                                          : ResultCell{QStringLiteral("\u2013"), QStringLiteral("NA;NA")},
                              valueCell(line.law_s ? std::optional(1e3 * *line.law_s) : std::nullopt),
                              {words(line)}});
    }
    return table;
}

TableContent BraceletContent::steps(const LevelResults& results, const QString& task) {
    TableContent table;
    table.header = {tr("Participant"), tr("Track"), tr("Steps"), tr("What it says")};
    table.tips = {{},
                  {},
                  tr("Steps of one JND each from the start of the motors to their full drive. The JND is "
                     "linear between "
                     "the references, and stays as it is beyond them")};
    const FeltTask* felt = results.feltTask(task);
    if (felt == nullptr)
        return table;
    for (const StepsLine& line : feltSteps(results.thresholds, *felt)) {
        const QString words =
            line.steps
                ? (line.participant.empty()
                       ? tr("by the mean JND of all")
                       : tr("by the JND at %n reference(s)", nullptr, static_cast<int>(line.references)))
                : tr("%1 of %2 references have a JND").arg(line.references).arg(line.wanted);
        table.rows.push_back({whoCell(line.participant, tr("All")),
                              {plainText(line.track)},
                              line.steps ? ResultCell{QString::number(*line.steps)} : valueCell({}),
                              {words}});
    }
    return table;
}

TableContent BraceletContent::strength(const EqualStrength& equal, double strongest,
                                       const pattern::MotorProfiles* motors,
                                       const std::optional<pattern::MotorProfiles>& balanced) {
    TableContent table;
    table.header = {tr("Tactor"),         tr("Feels equal at"), tr("95 %"),
                    tr("That is, drive"), tr("Full drive now"), tr("Full drive, balanced")};
    table.tips = {{},
                  tr("Level at which it feels as strong as the reference"),
                  tr("? stands for an open end"),
                  tr("Share of the full voltage, by the motor's start and full drive"),
                  tr("Share of the full voltage at intensity 1"),
                  tr("With it the tactors feel equally strong: the strongest ones are turned down")};
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        const std::optional<double>& level = equal.levels[tactor];
        const OpenInterval& ends = equal.intervals[tactor];
        const auto end = [](const std::optional<double>& one) {
            return one ? QLocale().toString(*one, 'g', 3) : QStringLiteral("?");
        };
        const bool isReference = tactor == equal.reference;
        const bool hasEnds = !isReference && (ends.low || ends.high);
        std::optional<double> drive;
        if (level && motors != nullptr)
            drive = pattern::driveOf((*motors)[tactor], *level * strongest);
        table.rows.push_back(
            {{isReference ? tr("%1, the reference").arg(tactor + 1) : QString::number(tactor + 1),
              QString::number(tactor + 1)},
             valueCell(level),
             hasEnds ? ResultCell{QStringLiteral("%1 \u2013 %2").arg(end(ends.low), end(ends.high)),
                                  valueCell(ends.low).data + QLatin1Char(';') + valueCell(ends.high).data}
                     : ResultCell{QStringLiteral("\u2013"), QStringLiteral("NA;NA")},
             valueCell(drive),
             valueCell(motors != nullptr ? std::optional((*motors)[tactor].fullDrive) : std::nullopt),
             valueCell(balanced ? std::optional((*balanced)[tactor].fullDrive) : std::nullopt)});
    }
    return table;
}

std::optional<EqualStrength> BraceletContent::equal(const LevelResults& results, const QString& task,
                                                    const QString& participant) {
    const FeltTask* felt = results.feltTask(task);
    if (felt == nullptr)
        return std::nullopt;
    std::vector<EqualStrength> all = equalStrengths(results.thresholds, *felt, participant.toStdString());
    return all.empty() ? std::nullopt : std::optional(std::move(all.front()));
}

std::vector<StrengthConflict> BraceletContent::conflicts(const LevelResults& results, const QString& task,
                                                         const QString& participant,
                                                         const pattern::MotorProfiles& motors) {
    std::vector<StrengthConflict> conflicts;
    const std::optional<EqualStrength> first = equal(results, task, participant);
    const FeltTask* own = results.feltTask(task);
    if (!first || own == nullptr)
        return conflicts;
    for (const FeltTask& felt : results.felt) {
        for (const EqualStrength& other :
             equalStrengths(results.thresholds, felt, participant.toStdString())) {
            // Levels of stimuli that differ in strength cannot be compared.
            if (other.reference == first->reference || felt.strongest != own->strongest)
                continue;
            std::vector<std::size_t> tactors = disagreements(*first, other, own->strongest, motors);
            if (!tactors.empty())
                conflicts.push_back({other.reference, std::move(tactors)});
        }
    }
    return conflicts;
}

QString BraceletContent::conflictText(const std::vector<StrengthConflict>& conflicts) {
    QStringList lines;
    for (const StrengthConflict& conflict : conflicts)
        lines << tr("Measured against tactor %1, tactor %2 differs by more than both intervals allow.",
                    "a tactor; a list of tactors")
                     .arg(conflict.reference + 1)
                     .arg(tactorList(conflict.tactors));
    return lines.join(QLatin1Char('\n'));
}

} // namespace teleta::study
