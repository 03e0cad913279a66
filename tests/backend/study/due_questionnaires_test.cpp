// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/due_questionnaires.h"

#include <gtest/gtest.h>

namespace teleta::study {

namespace {

Questionnaire asked(const char* id, QuestionnaireTime when) {
    QuestionnaireItem likert;
    likert.id = "hard";
    likert.kind = ItemKind::likert;
    likert.points = 5;
    QuestionnaireItem choice;
    choice.id = "hand";
    choice.kind = ItemKind::choice;
    choice.choices = {{"left", "Left"}, {"right", "Right"}};
    QuestionnaireItem text;
    text.id = "more";
    return {id, id, when, {likert, choice, text}};
}

Protocol protocol() {
    Protocol protocol;
    protocol.questionnaires = {
        asked("person", QuestionnaireTime::beforeStudy), asked("effort", QuestionnaireTime::afterSession),
        asked("rest", QuestionnaireTime::afterSession), asked("end", QuestionnaireTime::afterStudy)};
    return protocol;
}

SessionRecord sessionOf(long long key) {
    SessionRecord session;
    session.key = key;
    return session;
}

StoredAnswer answered(const char* questionnaire, std::optional<long long> session) {
    StoredAnswer answer;
    answer.session = session;
    answer.questionnaire = questionnaire;
    answer.item = "hard";
    answer.value = "3";
    return answer;
}

} // namespace

TEST(DueQuestionnaires, areThoseOfTheirTimeInTheProtocolsOrder) {
    const auto due = dueQuestionnaires(protocol(), QuestionnaireTime::afterSession, sessionOf(7), {});
    ASSERT_EQ(due.size(), 2U);
    EXPECT_EQ(due[0].index, 1U);
    EXPECT_EQ(due[1].index, 2U);
    ASSERT_TRUE(due[0].session);
    EXPECT_EQ(due[0].session->key, 7);
    const auto person = dueQuestionnaires(protocol(), QuestionnaireTime::beforeStudy, sessionOf(7), {});
    ASSERT_EQ(person.size(), 1U);
    EXPECT_FALSE(person[0].session) << "it belongs to the participant";
    EXPECT_TRUE(dueQuestionnaires(protocol(), QuestionnaireTime::beforeSession, sessionOf(7), {}).empty());
}

TEST(DueQuestionnaires, areDueOnceASessionAndOnceAParticipant) {
    const std::vector<StoredAnswer> kept{answered("person", {}), answered("effort", 7)};
    EXPECT_TRUE(dueQuestionnaires(protocol(), QuestionnaireTime::beforeStudy, sessionOf(8), kept).empty());
    const auto same = dueQuestionnaires(protocol(), QuestionnaireTime::afterSession, sessionOf(7), kept);
    ASSERT_EQ(same.size(), 1U);
    EXPECT_EQ(same[0].index, 2U);
    EXPECT_EQ(dueQuestionnaires(protocol(), QuestionnaireTime::afterSession, sessionOf(8), kept).size(), 2U)
        << "another session asks again";
}

TEST(DueQuestionnaires, simulatedAnswersFitAndFollowTheSeedTheParticipantAndTheSession) {
    StudyHead head;
    head.protocol = protocol();
    head.seed = 3;
    const Participant first{1, "P01", 0};
    const Participant second{2, "P02", 1};
    PlannedSession plan;
    plan.seed = 11;
    PlannedSession other;
    other.seed = 12;
    const auto values = [&](const Participant& who, const PlannedSession& session, std::size_t index) {
        const std::vector<ItemAnswer> answers = simulatedAnswers(head, who, session, index);
        EXPECT_TRUE(checkAnswers(head.protocol.questionnaires[index], answers));
        std::string all;
        for (const ItemAnswer& answer : answers)
            all += answer.value.value_or("-") + ' ';
        return all;
    };
    EXPECT_EQ(values(first, plan, 0), values(first, other, 0)) << "that of a participant has no session";
    EXPECT_EQ(values(first, plan, 1), values(first, plan, 1));
    // Ten choices for each of many seeds: they cannot all be equal by chance.
    int differ = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        plan.seed = seed;
        other.seed = seed + 1;
        differ += values(first, plan, 1) != values(first, other, 1) ? 1 : 0;
        head.seed = seed;
        differ += values(first, plan, 0) != values(second, plan, 0) ? 1 : 0;
    }
    EXPECT_GT(differ, 40);
}

} // namespace teleta::study
