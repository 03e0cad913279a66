// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/planning/plan_content.h"

#include "widgets/study/study_names.h"

#include <QLocale>

#include <algorithm>

namespace teleta::study {

namespace {

constexpr double kPowerToPercent = 100.0;

} // namespace

std::vector<PlanTest> PlanContent::tests(const Protocol& protocol) {
    std::vector<PlanTest> tests;
    for (std::size_t i = 0; i < protocol.tasks.size(); ++i) {
        const StudyTask& task = protocol.tasks[i];
        const QString name = displayName(task);
        const auto add = [&](const char* effect, const QString& shown) {
            tests.push_back({i, QString::fromStdString(task.id) + QLatin1Char(':') + QLatin1String(effect),
                             tr("%1: %2", "task, test").arg(name, shown)});
        };
        if (task.design != Design::identification) {
            add("threshold", tr("threshold"));
            continue;
        }
        if (task.conditions.size() > 1)
            add("condition", tr("conditions"));
        add("pattern", tr("patterns"));
        if (task.conditions.size() > 1)
            add("condition:pattern", tr("conditions by patterns"));
    }
    return tests;
}

CurveContent PlanContent::curve(const PowerPlan& plan, const PlanRequest& request, const QString& test) {
    const PlanSettings& settings = request.settings;
    CurveContent chart;
    chart.name = QStringLiteral("plan");
    chart.title = request.wish ? tr("Precision: %1", "test").arg(test) : tr("Power: %1", "test").arg(test);
    chart.xAxis = tr("participants");
    chart.yAxis =
        request.wish ? tr("studies with an interval narrow enough, %") : tr("significant studies, %");
    chart.highest = kPowerToPercent;
    chart.reference = kPowerToPercent * settings.target;
    chart.referenceName = tr("target");
    CurveSeries series{{}, {}, true};
    for (const PowerPoint& point : plan.points) {
        if (point.studies == 0)
            continue;
        const Interval ends = point.interval();
        series.points.push_back({static_cast<double>(point.participants), kPowerToPercent * point.power(),
                                 Interval{kPowerToPercent * ends.low, kPowerToPercent * ends.high}});
    }
    if (!settings.participants.empty()) {
        const auto first = static_cast<double>(settings.participants.front());
        const auto last = static_cast<double>(settings.participants.back());
        chart.lowestX = first - 1.0;
        chart.highestX = std::max(last, first) + 1.0;
    }
    chart.series.push_back(std::move(series));
    return chart;
}

QString PlanContent::answer(const PowerPlan& plan, const PlanSettings& settings) {
    const QString target = QLocale().toString(kPowerToPercent * settings.target, 'g', 3);
    if (plan.cancelled)
        return tr("Cancelled. The curve has the studies drawn so far.");
    if (!plan.participants)
        return tr("No number up to %1 reaches %2 %.").arg(settings.participants.back()).arg(target);
    if (plan.orParticipants)
        return tr("%1 or %2 participants reach %3 %; chance cannot tell which.")
            .arg(*plan.participants)
            .arg(*plan.orParticipants)
            .arg(target);
    return tr("%1 participants reach %2 %.").arg(*plan.participants).arg(target);
}

} // namespace teleta::study
