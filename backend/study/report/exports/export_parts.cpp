// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/export_parts.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/failure.h"
#include "backend/study/protocol/standard_questionnaire.h"
#include "backend/study/protocol/stimulus_set.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct ExportPartText {
    Q_DECLARE_TR_FUNCTIONS(StudyExport)
};

constexpr std::array<std::string_view, 8> kScoreColumns{"participant_id", "session_id", "task",  "condition",
                                                        "questionnaire",  "score",      "value", "n_missing"};

} // namespace

core::Expected<void> writeChecked(const std::string& path, const std::string& content) {
    const core::PrivateFiles forOwner;
    const QString name = QString::fromStdString(path);
    TELETA_CHECK(core::makeFolder(QFileInfo(name).path().toStdString()));
    TELETA_CHECK(core::writeFile(path, content));
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly) || file.readAll().toStdString() != content)
        return core::failed(core::ErrorKind::ioFailed,
                            ExportPartText::tr("the file differs from what was written"), {}, {path});
    return {};
}

std::string alphanumeric(const std::string& text) {
    std::string kept;
    std::ranges::copy_if(text, std::back_inserter(kept), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    });
    return kept;
}

std::vector<std::string> alphanumericLabels(const std::vector<std::string>& texts,
                                            const std::vector<std::size_t>& numbers) {
    std::set<std::string> used;
    std::vector<std::string> labels;
    for (const std::string& text : texts) {
        const std::string number =
            'x' + std::to_string(numbers.empty() ? labels.size() + 1 : numbers.at(labels.size()));
        std::string label = alphanumeric(text);
        if (label != text)
            label += number;
        // Some file systems ignore case.
        while (!used.insert(QString::fromStdString(label).toLower().toStdString()).second)
            label += number;
        labels.push_back(std::move(label));
    }
    return labels;
}

ordered_json sessionSidecar(const StudyHead& head, const PlannedSession& plan) {
    const StudyTask& task = head.protocol.tasks[plan.task];
    const std::string& condition = task.conditions[plan.condition];
    ordered_json stimuli = ordered_json::object();
    const auto describe = [&](ordered_json& stimulus, const std::string& id) {
        stimulus["pattern"] = id;
        if (const OwnStimulus* own = head.stimuli.findOwn(id)) {
            stimulus["file"] = own->file;
            // It was parsed when the study was opened.
            stimulus["definition"] = ordered_json::parse(own->json, nullptr, false);
        }
    };
    const bool hasLevels = task.design != Design::identification;
    for (const StudyPattern& pattern : task.patterns) {
        stimuli[pattern.letter] = {{"name", pattern.name}};
        if (!hasLevels)
            describe(stimuli[pattern.letter], stimulusId(task, pattern, condition));
    }
    ordered_json levels = nullptr;
    if (hasLevels)
        describe(levels, levelStimulusId(task));
    return {
        {"task", task.name},
        {"condition", condition},
        {"stimuli", std::move(stimuli)},
        {"levels", std::move(levels)},
        {"stimulus_s", head.protocol.stimulus_s},
        {"response_limit_s", head.protocol.responseLimit_s},
        {"response_window", head.protocol.window == ResponseWindow::fromOnset ? "from_onset" : "from_end"},
        {"seed", std::to_string(plan.seed)}};
}

ordered_json questionnaireSources(const Protocol& protocol) {
    ordered_json sources = ordered_json::object();
    for (const Questionnaire& questionnaire : protocol.questionnaires) {
        if (questionnaire.use != StandardQuestionnaire::none)
            sources[questionnaire.id] = {{"use", toString(questionnaire.use)},
                                         {"title", questionnaire.title},
                                         {"language_shown", languageOf(questionnaire.use)},
                                         {"source", sourceOf(questionnaire.use)}};
    }
    return sources;
}

std::vector<ItemAnswer> answersTo(const Questionnaire& questionnaire, const SessionRecord* session,
                                  const std::vector<StoredAnswer>& answers) {
    const auto isOfThis = [&](const StoredAnswer& answer) {
        return session != nullptr ? answer.session && *answer.session == session->key : !answer.session;
    };
    std::vector<ItemAnswer> given;
    for (const StoredAnswer& answer : answers) {
        if (answer.questionnaire == questionnaire.id && isOfThis(answer))
            given.push_back({answer.item, answer.value});
    }
    return given;
}

core::Expected<std::string> scoreText(const StudyStore& store) {
    const StudyHead& head = store.head();
    const auto isStandard = [](const Questionnaire& questionnaire) {
        return questionnaire.use != StandardQuestionnaire::none;
    };
    if (std::ranges::none_of(head.protocol.questionnaires, isStandard))
        return std::string();
    std::vector<TrialRow> rows;
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    for (const Participant& participant : participants) {
        TELETA_TRY(const std::vector<StoredAnswer> answers, store.answers(participant));
        TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
        const std::vector<PlannedSession> plans =
            planSessions(head.protocol, head.seed, participant.enrolment);
        const auto add = [&](const Questionnaire& questionnaire, const SessionRecord* session) {
            const std::vector<ItemAnswer> given = answersTo(questionnaire, session, answers);
            if (given.empty())
                return;
            std::array<TrialCell, 3> place{};
            if (session != nullptr) {
                const PlannedSession& plan = plans.at(session->planIndex);
                const StudyTask& task = head.protocol.tasks[plan.task];
                place = {wordCell(session->id), wordCell(task.id), wordCell(task.conditions[plan.condition])};
            }
            for (const QuestionnaireScore& score : questionnaireScores(questionnaire, given))
                rows.push_back({wordCell(participant.id), place[0], place[1], place[2],
                                wordCell(questionnaire.id), wordCell(score.name),
                                score.value ? numberCell(*score.value) : TrialCell{},
                                numberCell(score.missing)});
        };
        for (const Questionnaire& questionnaire : head.protocol.questionnaires) {
            if (!isOfSession(questionnaire.when)) {
                add(questionnaire, nullptr);
                continue;
            }
            for (const SessionRecord& session : sessions)
                add(questionnaire, &session);
        }
    }
    return tableText(rows, {}, kScoreColumns);
}

} // namespace teleta::study
