// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/simulated_observer.h"

#include "backend/core/failure.h"
#include "backend/core/random_stream.h"
#include "backend/study/protocol/level_sequence.h"
#include "backend/study/protocol/trial_order.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <cmath>

namespace teleta::study {

namespace {

struct ObserverText {
    Q_DECLARE_TR_FUNCTIONS(SimulatedObserver)
};

/// Apart from the parts that a session's seed has.
constexpr std::uint64_t kSeedOfObservers = 2'000'000;
constexpr double kUsualSlope = 3.5;
constexpr double kUsualSpread = 1.0 / 6.0; ///< of the range
constexpr double kMostLapses = 0.5;

RiseShape shapeOf(const StudyTask& task) {
    if (const auto* bayes = std::get_if<BayesSettings>(&task.levels.procedure))
        return bayes->function;
    return task.design == Design::compare || task.levels.range.lowest <= 0.0 ? RiseShape::gauss
                                                                             : RiseShape::weibull;
}

} // namespace

core::Expected<SimulatedObserver> SimulatedObserver::parse(const std::string& text) {
    SimulatedObserver observer;
    const QStringList parts = QString::fromStdString(text).split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (const QString& part : parts) {
        const QString key = part.section(QLatin1Char('='), 0, 0).trimmed();
        bool isNumber = false;
        const double value = part.section(QLatin1Char('='), 1).trimmed().toDouble(&isNumber);
        isNumber = isNumber && std::isfinite(value);
        if (key == QStringLiteral("t") && isNumber && value > 0.0)
            observer.threshold = value;
        else if (key == QStringLiteral("slope") && isNumber && value > 0.0)
            observer.slope = value;
        else if (key == QStringLiteral("lapse") && isNumber && value >= 0.0 && value <= kMostLapses)
            observer.lapse = value;
        else if (key == QStringLiteral("sd") && isNumber && value >= 0.0)
            observer.sd = value;
        else
            return core::failed(
                core::ErrorKind::badInput, ObserverText::tr("an observer cannot have \"%1\"").arg(part),
                ObserverText::tr("t and slope above 0, lapse from 0 to %1, sd of at least 0, as in "
                                 "t=0.2,slope=3.5,lapse=0.02,sd=0.1")
                    .arg(kMostLapses));
    }
    return observer;
}

PsychometricFunction SimulatedObserver::functionOf(const StudyTask& task, const std::string& condition,
                                                   std::uint64_t person) const {
    const LevelRange& range = task.levels.range;
    const LevelScale scale = range.scale;
    PsychometricFunction function;
    function.shape = shapeOf(task);
    const bool compares = task.design == Design::compare;
    const double middle =
        fromScale(scale, 0.5 * (onScale(scale, range.lowest) + onScale(scale, range.highest)));
    const double centre = threshold.value_or(compares ? task.referenceOf(condition) : middle);
    function.threshold =
        sd == 0.0 ? centre
                  : fromScale(scale, onScale(scale, centre) + sd * core::RandomStream(person).normal());
    function.spread = slope.value_or(
        function.shape == RiseShape::weibull ? kUsualSlope : kUsualSpread * (range.highest - range.lowest));
    function.lapse = lapse;
    function.guess =
        task.design == Design::interval ? 1.0 / static_cast<double>(task.levels.intervals) : lapse;
    return function;
}

std::size_t SimulatedObserver::answer(const PsychometricFunction& function, const StudyTask& task,
                                      const PlannedTrial& trial, std::uint64_t seed) {
    core::RandomStream random(seed);
    const double draw = random.uniform();
    const Target target = trial.target.value_or(0);
    const double share = function.shareAt(trial.level.value_or(0.0));
    switch (task.design) {
    case Design::yesNo:
        return draw < share ? 0 : 1;
    case Design::sameDifferent:
        return draw < (target < 2 ? function.guess : share) ? 1 : 0;
    case Design::interval: {
        if (draw < share)
            return target;
        const auto others = static_cast<std::size_t>(random.below(task.levels.intervals - 1));
        return others < target ? others : others + 1;
    }
    case Design::compare:
        return draw < share ? target : 1 - target;
    case Design::identification:
        break;
    }
    return 0;
}

std::uint64_t observerSeed(std::uint64_t studySeed, std::size_t enrolment) {
    return derivedSeed(derivedSeed(studySeed, enrolment), kSeedOfObservers);
}

} // namespace teleta::study
