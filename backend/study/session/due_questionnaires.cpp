// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/due_questionnaires.h"

#include "backend/core/random_stream.h"
#include "backend/study/protocol/trial_order.h"

#include <algorithm>
#include <utility>

namespace teleta::study {

std::vector<DueQuestionnaire> dueQuestionnaires(const Protocol& protocol, QuestionnaireTime when,
                                                const SessionRecord& session,
                                                const std::vector<StoredAnswer>& answers) {
    const bool ofSession = isOfSession(when);
    const auto isOfThis = [&](const StoredAnswer& answer) {
        return ofSession ? answer.session && *answer.session == session.key : !answer.session;
    };
    std::vector<DueQuestionnaire> due;
    for (std::size_t i = 0; i < protocol.questionnaires.size(); ++i) {
        const Questionnaire& questionnaire = protocol.questionnaires[i];
        const bool isKept = std::ranges::any_of(answers, [&](const StoredAnswer& answer) {
            return answer.questionnaire == questionnaire.id && isOfThis(answer);
        });
        if (questionnaire.when == when && !isKept)
            due.push_back({i, ofSession ? std::optional(session) : std::nullopt});
    }
    return due;
}

namespace {

/// The seed of a participant's questionnaire; part: of kSeedOf...
std::uint64_t seedOf(std::uint64_t part, const StudyHead& head, const Participant& participant,
                     const PlannedSession& plan, std::size_t index) {
    const std::uint64_t seed = isOfSession(head.protocol.questionnaires.at(index).when)
                                   ? plan.seed
                                   : derivedSeed(head.seed, participant.enrolment);
    return derivedSeed(derivedSeed(seed, part), index);
}

} // namespace

Questionnaire shownQuestionnaire(const StudyHead& head, const Participant& participant,
                                 const PlannedSession& plan, std::size_t index) {
    return shownQuestionnaire(head.protocol.questionnaires.at(index),
                              seedOf(kSeedOfPairs, head, participant, plan, index));
}

std::vector<ItemAnswer> simulatedAnswers(const StudyHead& head, const Participant& participant,
                                         const PlannedSession& plan, std::size_t index) {
    const Questionnaire& questionnaire = head.protocol.questionnaires.at(index);
    core::RandomStream random(seedOf(kSeedOfQuestionnaires, head, participant, plan, index));
    std::vector<ItemAnswer> answers;
    for (const QuestionnaireItem& item : questionnaire.items) {
        std::string value = "simulated";
        if (item.kind == ItemKind::likert)
            value = std::to_string(random.below(item.points) + 1);
        else if (item.kind == ItemKind::scale)
            value = std::to_string(random.below(kScalePoints) * kScaleStep);
        else if (item.kind == ItemKind::choice || item.kind == ItemKind::pair)
            value = item.choices[static_cast<std::size_t>(random.below(item.choices.size()))].id;
        answers.push_back({item.id, std::move(value)});
    }
    return answers;
}

} // namespace teleta::study
