// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/trial_lines.h"

#include "widgets/study/study_names.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <tuple>
#include <utility>

namespace teleta::console {

using study::Tone;

namespace {

constexpr std::size_t kShownOutcomes = 60;

struct LineText {
    Q_DECLARE_TR_FUNCTIONS(TrialLines)
};

std::pair<QString, Tone> outcomeText(study::Outcome outcome) {
    switch (outcome) {
    case study::Outcome::correct:
        return {LineText::tr("\u2713 right"), Tone::good};
    case study::Outcome::incorrect:
        return {LineText::tr("\u2717 wrong"), Tone::attention};
    case study::Outcome::timeout:
        return {LineText::tr("no answer"), Tone::attention};
    case study::Outcome::aborted:
        return {LineText::tr("aborted"), Tone::calm};
    case study::Outcome::deviceError:
        break;
    }
    return {LineText::tr("interrupted, repeated later"), Tone::alarm};
}

} // namespace

std::vector<study::OutcomeLine> outcomeLines(const std::vector<study::TrialResult>& results,
                                             const study::StudyTask& task) {
    std::vector<study::OutcomeLine> lines;
    const auto letter = [&](std::size_t pattern) {
        return QString::fromStdString(task.patterns[pattern].letter);
    };
    for (auto result = results.rbegin(); result != results.rend() && lines.size() < kShownOutcomes;
         ++result) {
        study::OutcomeLine line;
        const bool isPractice = result->planned.phase == study::Phase::practice;
        line.trial =
            (isPractice ? LineText::tr("practice %1") : LineText::tr("test %1")).arg(result->planned.trial);
        if (result->planned.level)
            line.level = LineText::tr("%1: %2 %3", "track, level, unit")
                             .arg(QString::fromStdString(result->planned.track),
                                  QLocale().toString(*result->planned.level, 'g', 3),
                                  study::displayUnit(task.levels.vary));
        line.presented = letter(result->planned.stimulus);
        line.answered = result->response ? letter(*result->response) : QStringLiteral("\u2013");
        line.responseTime_s = result->responseTime_s;
        std::tie(line.outcome, line.tone) = outcomeText(result->outcome);
        lines.push_back(std::move(line));
    }
    return lines;
}

study::ConfusionMatrix confusionOf(const std::vector<study::TrialResult>& results, study::Phase phase,
                                   std::size_t patterns) {
    study::ConfusionMatrix matrix(std::max<std::size_t>(patterns, 1));
    for (const study::TrialResult& result : results) {
        if (result.planned.phase == phase && result.isComplete())
            matrix.add(result.planned.stimulus, result.response);
    }
    return matrix;
}

} // namespace teleta::console
