// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_texts.h"

#include "widgets/base/numbers/quantity_text.h"

#include <QStringList>

#include <array>

namespace teleta::servo {

QString ServoTexts::task(TaskKind kind) {
    static constexpr std::array kNames{QT_TR_NOOP("Free motion"),    QT_TR_NOOP("Align"),
                                       QT_TR_NOOP("Edge control"),   QT_TR_NOOP("Explore"),
                                       QT_TR_NOOP("Roll"),           QT_TR_NOOP("Follow a point"),
                                       QT_TR_NOOP("Co-manipulation")};
    return tr(kNames[static_cast<std::size_t>(kind)]);
}

QString ServoTexts::contact(ContactState state) {
    static constexpr std::array kNames{QT_TR_NOOP("no contact"), QT_TR_NOOP("in contact"),
                                       QT_TR_NOOP("searching for the contact"), QT_TR_NOOP("contact lost")};
    return tr(kNames[static_cast<std::size_t>(state)]);
}

QString ServoTexts::limit(Limit limit) {
    static constexpr std::array<const char*, kLimits> kNames{QT_TR_NOOP("tool speed"),
                                                             QT_TR_NOOP("turn rate"),
                                                             QT_TR_NOOP("force"),
                                                             QT_TR_NOOP("saturated taxel"),
                                                             QT_TR_NOOP("distance from the measured pose"),
                                                             QT_TR_NOOP("joint speed"),
                                                             QT_TR_NOOP("end of a joint"),
                                                             QT_TR_NOOP("singular arm"),
                                                             QT_TR_NOOP("gap between frames"),
                                                             QT_TR_NOOP("unusable numbers")};
    return tr(kNames[static_cast<std::size_t>(limit)]);
}

QString ServoTexts::limits(const ActiveLimits& limits) {
    QStringList names;
    for (std::size_t i = 0; i < kLimits; ++i)
        if (limits.has(static_cast<Limit>(i)))
            names << limit(static_cast<Limit>(i));
    return names.join(tr(", ", "between the limits that act"));
}

QString ServoTexts::verdict(const TaskVerdict& verdict) {
    if (verdict.completed)
        return tr("task completed");
    if (verdict.reason == NotCompleted::stalled && verdict.limit)
        return tr("task not completed: stalled by the limit \u201c%1\u201d").arg(limit(*verdict.limit));
    static constexpr std::array kReasons{QT_TR_NOOP("task not completed: never in contact"),
                                         QT_TR_NOOP("task not completed: the contact was lost"),
                                         QT_TR_NOOP("task not completed: stalled"),
                                         QT_TR_NOOP("task not completed: not aligned")};
    return tr(kReasons[static_cast<std::size_t>(verdict.reason)]);
}

QString ServoTexts::cost(const CycleTimes& times, double rate_Hz) {
    const double sum_s = times.sum_s();
    if (times.cycles == 0 || !(sum_s > 0.0))
        return {};
    const auto share = [&](CyclePart part) {
        return base::fixedDigits(100.0 * times.part_s[static_cast<std::size_t>(part)] / sum_s, 0);
    };
    const double cycle_s = sum_s / static_cast<double>(times.cycles);
    return tr("Simulated cycle: %1 \u00b5s, %2 times real time. Contact %3 %, kinematics %4 %, features %5 "
              "%, "
              "control %6 %, dynamics %7 %.")
        .arg(base::fixedDigits(1e6 * cycle_s, 1), base::fixedDigits(1.0 / (cycle_s * rate_Hz), 0),
             share(CyclePart::contact), share(CyclePart::kinematics), share(CyclePart::features),
             share(CyclePart::control), share(CyclePart::dynamics))
        .replace(QStringLiteral(" %"), QStringLiteral("\u00a0%")) // no line break between the two
        .replace(QStringLiteral(" \u00b5s"), QStringLiteral("\u00a0\u00b5s"));
}

QString ServoTexts::run(const QString& source, int number, bool unbalanced, bool balanced) {
    const QString name =
        number > 1 ? tr("%1, run %2", "a source, and which of its runs").arg(source).arg(number) : source;
    if (!unbalanced)
        return name;
    return balanced ? tr("%1, partly without DZMP", "a run").arg(name)
                    : tr("%1, without DZMP", "a run").arg(name);
}

QString ServoTexts::feature(int row, bool edge) {
    // The minus sign is a literal of its own: lupdate would take the D as a digit of its code.
    static constexpr std::array kOfEdge{QT_TR_NOOP("CoP x"),
                                        QT_TR_NOOP("CoP y"),
                                        QT_TR_NOOP("Force"),
                                        QT_TR_NOOP("\u2212"
                                                   "DZMP x"),
                                        QT_TR_NOOP("\u2212"
                                                   "DZMP y"),
                                        QT_TR_NOOP("\u03b1 z")};
    static constexpr std::array kOfPoint{QT_TR_NOOP("CoP x"), QT_TR_NOOP("CoP y"), QT_TR_NOOP("Force"),
                                         QT_TR_NOOP("CoC y"), QT_TR_NOOP("CoC x"), QT_TR_NOOP("\u03b1 z")};
    return tr((edge ? kOfEdge : kOfPoint)[static_cast<std::size_t>(row)]);
}

} // namespace teleta::servo
