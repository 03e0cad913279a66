// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/cost_words.h"

#include "widgets/base/numbers/number_format.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace teleta::console {

namespace {

bool isKnown(const cost::RungCost& rung) {
    return rung.isTimed() && rung.timeMedian_s > 0.0 && !std::isnan(rung.errorMean) && !rung.isLimit();
}

/// "2.5", "12".
QString factorText(double factor) {
    return QLocale().toString(factor, 'g', 2);
}

} // namespace

QString CostWords::topic(cost::Topic topic) {
    switch (topic) {
    case cost::Topic::camera:
        return tr("Camera");
    case cost::Topic::tactileArray:
        return tr("Tactile array");
    case cost::Topic::touchedObject:
        return tr("Touched object");
    case cost::Topic::simulation:
        return tr("Simulation");
    case cost::Topic::study:
        return tr("Study");
    }
    return {};
}

QString CostWords::quantity(double value, const QString& unit) {
    if (std::isnan(value))
        return QStringLiteral("\u2014");
    const bool isShare = unit == QStringLiteral("1");
    const double number = isShare ? 100.0 * value : value;
    const double least = isShare ? 0.01 : 1e-12;
    // Rounding errors have no prefix that anybody would know.
    if (number != 0.0 && std::abs(number) < least)
        return base::withUnit(QLocale().toString(number, 'e', 1), isShare ? QStringLiteral("%") : unit);
    return isShare ? base::withUnit(base::threeDigits(number).trimmed(), QStringLiteral("%"))
                   : base::siQuantity(number, unit).simplified();
}

/// Shares differ by points, not by percent of each other.
QString CostWords::difference(double from, double to, const QString& unit) {
    const double difference = std::abs(to - from);
    return unit == QStringLiteral("1")
               ? tr("%1 percentage points").arg(base::threeDigits(100.0 * difference).trimmed())
               : quantity(difference, unit);
}

QString CostWords::comparedWith(const cost::RungCost& other, const cost::RungCost& here,
                                const QString& unit) {
    constexpr double kNear = 0.05; ///< so near to 1 is the same, and to 2 twice
    const double ratio = here.timeMedian_s / other.timeMedian_s;
    QString time;
    if (std::abs(ratio - 1.0) < kNear)
        time = tr("as fast");
    else if (ratio > 1.0)
        time = std::abs(ratio - 2.0) < kNear ? tr("twice as fast")
                                             : tr("%1 times as fast").arg(factorText(ratio));
    else
        time = std::abs(1.0 / ratio - 2.0) < kNear
                   ? tr("takes twice as long")
                   : tr("takes %1 times as long").arg(factorText(1.0 / ratio));
    if (other.errorMean == here.errorMean)
        return tr("%1, equally accurate").arg(time);
    //: How fast another setting is, and by how much its results are better or worse
    return (other.errorMean > here.errorMean ? tr("%1, %2 less accurate") : tr("%1, %2 more accurate"))
        .arg(time, difference(here.errorMean, other.errorMean, unit));
}

QString CostWords::whyNotCompared(const cost::RungCost& rung) {
    const QString name = QString::fromStdString(rung.name);
    if (!rung.isTimed())
        return tr("%1 has no time: the machine was too busy. Close other programs and measure again.")
            .arg(name);
    const QString time = quantity(rung.timeMedian_s, QStringLiteral("s"));
    return rung.isLimit() ? tr("Nothing can do this job in less than %1: this is its limit.").arg(time)
                          : tr("%1 takes %2. It has no error to compare.").arg(name, time);
}

QString CostWords::about(const cost::LadderCost& job, const std::string& setting, bool inUse) {
    const auto found = std::ranges::find(job.rungs, setting, &cost::RungCost::name);
    if (found == job.rungs.end())
        return {};
    if (!isKnown(*found))
        return whyNotCompared(*found);
    const cost::RungCost& here = *found;
    const QString unit = QString::fromStdString(job.errorUnit);
    const QString name = QString::fromStdString(here.name);
    const QString time = quantity(here.timeMedian_s, QStringLiteral("s"));
    const QString error = quantity(here.errorMean, unit);
    QStringList sentences;
    //: A setting, its time, its error
    sentences << (inUse ? tr("In use: %1. It takes %2 and is off by %3 on average.")
                        : tr("%1 takes %2 and is off by %3 on average."))
                     .arg(name, time, error);
    const cost::RungCost* faster = nullptr;
    const cost::RungCost* better = nullptr;
    const cost::RungCost* beats = nullptr;
    for (const cost::RungCost& other : job.rungs) {
        if (!isKnown(other) || !other.pareto || &other == &here)
            continue;
        const bool isFaster = other.timeMedian_s < here.timeMedian_s;
        const bool isSlower = other.timeMedian_s > here.timeMedian_s;
        const bool isBetter = other.errorMean < here.errorMean;
        const bool isWorse = other.errorMean > here.errorMean;
        if ((isFaster && !isWorse) || (isBetter && !isSlower)) {
            if (beats == nullptr || other.errorMean < beats->errorMean)
                beats = &other;
        } else if (isFaster && (faster == nullptr || other.timeMedian_s > faster->timeMedian_s)) {
            faster = &other;
        } else if (isBetter && (better == nullptr || other.timeMedian_s < better->timeMedian_s)) {
            better = &other;
        }
    }
    if (beats != nullptr)
        sentences << tr("%1 beats it: %2.")
                         .arg(QString::fromStdString(beats->name), comparedWith(*beats, here, unit));
    if (faster != nullptr)
        sentences << tr("Faster: %1, %2.")
                         .arg(QString::fromStdString(faster->name), comparedWith(*faster, here, unit));
    if (better != nullptr)
        sentences << tr("More accurate: %1, %2.")
                         .arg(QString::fromStdString(better->name), comparedWith(*better, here, unit));
    if (beats == nullptr && faster == nullptr)
        sentences << tr("No setting is faster.");
    if (beats == nullptr && better == nullptr)
        sentences << tr("No setting is more accurate.");
    return sentences.join(QLatin1Char(' '));
}

} // namespace teleta::console
