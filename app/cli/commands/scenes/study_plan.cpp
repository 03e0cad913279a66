// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_plan.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "backend/core/failure.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/results/level_trial_store.h"
#include "backend/study/planning/identification_plan.h"
#include "backend/study/planning/plan_file.h"
#include "backend/study/planning/power.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/planning/threshold_plan.h"
#include "backend/study/protocol/protocol.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct PlanningText {
    Q_DECLARE_TR_FUNCTIONS(StudyPlanCommand)
};

constexpr std::size_t kMostPeople = 1000;
/// Threshold plans run a procedure for every participant.
constexpr std::size_t kThresholdStudies = 1000;
constexpr std::size_t kMostThresholdStudies = 4000;

/// Numbers of FROM:TO:STEP, FROM:TO or one number.
std::optional<std::vector<std::size_t>> numbersOf(const std::string& text) {
    std::vector<std::size_t> parts;
    for (const QString& part : QString::fromStdString(text).split(QLatin1Char(':'))) {
        bool isNumber = false;
        const qulonglong value = part.toULongLong(&isNumber);
        if (!isNumber || value < 1 || value > kMostPeople)
            return std::nullopt;
        parts.push_back(static_cast<std::size_t>(value));
    }
    if (parts.empty() || parts.size() > 3)
        return std::nullopt;
    const std::size_t to = parts.size() > 1 ? parts[1] : parts[0];
    const std::size_t step = parts.size() > 2 ? parts[2] : 1;
    std::vector<std::size_t> numbers;
    for (std::size_t n = parts[0]; n <= to; n += step)
        numbers.push_back(n);
    return numbers.empty() ? std::nullopt : std::optional(numbers);
}

core::Expected<study::StudyTruth> truthAt(const std::string& path) {
    if (!QFileInfo(QString::fromStdString(path)).isDir())
        return study::readTruth(path);
    TELETA_TRY(const study::StudyStore store, study::StudyStore::openForReading(path));
    study::TrialTally tally;
    study::ModeFilter modes;
    TELETA_CHECK(study::tallyStore(store, modes, tally));
    study::LevelTrials levels;
    TELETA_CHECK(study::addLevelTrials(store, modes, levels));
    study::FitChoices choices;
    choices.interval = study::FitInterval::none;
    return study::truthOf(study::studyResults(tally), study::thresholdResults(levels, choices), path);
}

QString answerText(const study::PowerPlan& plan, const study::PlanSettings& settings) {
    const QString target = forPeople(100.0 * settings.target, 3);
    if (!plan.participants)
        return PlanningText::tr("no number up to %1 reaches %2 %")
            .arg(settings.participants.back())
            .arg(target);
    if (plan.orParticipants)
        return PlanningText::tr("%1 or %2 participants; %3 studies cannot tell which")
            .arg(*plan.participants)
            .arg(*plan.orParticipants)
            .arg(settings.mostStudies);
    return PlanningText::tr("%1 participants reach %2 %").arg(*plan.participants).arg(target);
}

} // namespace

void StudyPlan::declare(CLI::App& app) {
    addOption(app, "protocol", m_protocolPath, PlanningText::tr("Protocol of the study"), "PROTOCOL.toml")
        ->required();
    addOption(app, "--participants", m_participants,
              PlanningText::tr("Numbers of participants to try: from, to, step"), "FROM:TO:STEP")
        ->capture_default_str();
    addOption(app, "--truth", m_truth,
              PlanningText::tr("What is assumed: a file with shares of right answers and spreads, or the "
                               "folder of a pilot study"),
              "TRUTH.toml|STUDY")
        ->required();
    addOption(app, "--test", m_test,
              PlanningText::tr("Line of the analysis: shape:condition, shape:pattern, "
                               "shape:condition:pattern, or shape:condition@A within pattern A; or "
                               "detect:threshold for the interval of a threshold"),
              "TASK:EFFECT")
        ->required();
    addOption(
        app, "--width", m_width,
        PlanningText::tr("Of a threshold: how far its 95 % interval may reach to each side, on the scale "
                         "of the levels (0.1 log10 units are a factor of 1.26)"),
        positive(), "W");
    addOption(app, "--trials", m_trials,
              PlanningText::tr("Of a threshold: trials of a track, of constant stimuli at each level; "
                               "otherwise the protocol's"),
              between(1, 10'000), "N");
    addOption(app, "--studies", m_studies,
              PlanningText::tr("Studies drawn for each number; otherwise 10000, for thresholds 1000"),
              between(100, static_cast<double>(study::kMostStudies)), "R");
    addOption(app, "--seed", m_seed, PlanningText::tr("Seed of all studies"), seed(), "S");
    addOption(app, "--target", m_target, PlanningText::tr("Wanted share of significant studies"),
              between(0.01, 0.999), "P");
    addOption(app, "--out", m_outPath, PlanningText::tr("Table of the power, CSV"), "FILE.csv");
    declareJson(app, m_json);
}

core::Expected<void> StudyPlan::run() const {
    const auto numbers = numbersOf(m_participants);
    if (!numbers)
        refuse("--participants", PlanningText::tr("%1 is not FROM:TO:STEP with numbers from 1 to %2")
                                     .arg(QString::fromStdString(m_participants))
                                     .arg(kMostPeople));
    TELETA_TRY(const study::Protocol protocol, study::readNamedProtocol(m_protocolPath));
    TELETA_TRY(const study::StudyTruth truth, truthAt(m_truth));
    study::PlanSettings settings;
    settings.participants = *numbers;
    std::unique_ptr<const study::PossibleStudy> possible;
    if (study::ThresholdPlan::isTest(m_test)) {
        study::ThresholdWish wish{m_width, {}};
        if (m_trials > 0)
            wish.trials = m_trials;
        TELETA_TRY(study::ThresholdPlan plan, study::ThresholdPlan::make(protocol, truth, m_test, wish));
        possible = std::make_unique<study::ThresholdPlan>(std::move(plan));
        settings.studies = kThresholdStudies;
        settings.mostStudies = kMostThresholdStudies;
    } else {
        TELETA_TRY(study::IdentificationPlan plan, study::IdentificationPlan::make(protocol, truth, m_test));
        possible = std::make_unique<study::IdentificationPlan>(std::move(plan));
    }
    if (m_studies > 0) {
        settings.studies = m_studies;
        settings.mostStudies = std::max(settings.mostStudies, m_studies);
    }
    settings.seed = m_seed;
    settings.target = m_target;
    ProgressBar bar(ProgressBar::Unit::share, false);
    const study::PowerPlan plan = study::planPower(*possible, settings, [&](double done) {
        bar.update(done, 1.0);
        return !interrupted();
    });
    bar.erase();
    if (plan.cancelled)
        return core::Unexpected(interruption());
    if (!m_outPath.empty())
        TELETA_CHECK(study::writePlan(plan, settings, m_test, m_outPath));
    if (m_json) {
        nlohmann::ordered_json points = nlohmann::ordered_json::array();
        for (const study::PowerPoint& point : plan.points) {
            const study::Interval ends = point.interval();
            points.push_back({{"participants", point.participants},
                              {"studies", point.studies},
                              {"refused", point.refused},
                              {"power", point.power()},
                              {"se", point.standardError()},
                              {"interval_95", {ends.low, ends.high}}});
        }
        const auto number = [](const std::optional<std::size_t>& value) {
            return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
        };
        return printDocument({{"test", m_test},
                              {"target", m_target},
                              {"seed", std::to_string(m_seed)},
                              {"participants", number(plan.participants)},
                              {"or_participants", number(plan.orParticipants)},
                              {"points", std::move(points)}});
    }
    Fields fields{{PlanningText::tr("Test"), QString::fromStdString(m_test)}};
    for (const study::PowerPoint& point : plan.points) {
        const study::Interval ends = point.interval();
        QString text = PlanningText::tr("%1 % (95 %: %2 to %3, %4 studies)")
                           .arg(forPeople(100.0 * point.power(), 3), forPeople(100.0 * ends.low, 3),
                                forPeople(100.0 * ends.high, 3))
                           .arg(point.studies);
        if (point.refused > 0)
            text = PlanningText::tr("%1; no analysis in %2 of them").arg(text).arg(point.refused);
        fields.emplace_back(PlanningText::tr("%1 participants").arg(point.participants), text);
    }
    fields.emplace_back(PlanningText::tr("Answer"), answerText(plan, settings));
    if (!m_outPath.empty())
        fields.emplace_back(PlanningText::tr("Table"), QString::fromStdString(m_outPath));
    return printFields(fields);
}

} // namespace teleta::cli
