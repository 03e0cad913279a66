// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

namespace teleta::study {

namespace {

constexpr const char* kQuestionnaires = R"(
[[questionnaire]]
id = "person"
title = "About you"
when = "before_study"
[[questionnaire.item]]
id = "hand"
kind = "choice"
question = "Which hand do you write with?"
choice = [{ id = "left", text = "With the left" }, { id = "right", text = "With the right" }]
[[questionnaire.item]]
id = "remarks"
kind = "text"
question = "Anything else?"
required = false
[[questionnaire]]
id = "effort"
when = "after_session"
item = [{ id = "hard", kind = "likert", question = "How hard was it?", points = 5, low = "easy", high = "hard" }]
)";

core::Expected<Protocol> withQuestionnaires(const std::string& text) {
    return parseProtocol(smallProtocol().source + text, "mine.toml");
}

} // namespace

TEST(Questionnaire, isReadWithTheProtocol) {
    const auto protocol = withQuestionnaires(kQuestionnaires);
    ASSERT_TRUE(protocol) << core::describe(protocol.error());
    ASSERT_EQ(protocol->questionnaires.size(), 2U);
    const Questionnaire& person = protocol->questionnaires[0];
    EXPECT_EQ(person.id, "person");
    EXPECT_EQ(person.title, "About you");
    EXPECT_EQ(person.when, QuestionnaireTime::beforeStudy);
    ASSERT_EQ(person.items.size(), 2U);
    EXPECT_EQ(person.items[0].kind, ItemKind::choice);
    EXPECT_TRUE(person.items[0].required);
    EXPECT_EQ(person.items[0].choices.at(1).text, "With the right");
    EXPECT_FALSE(person.items[1].required);
    const Questionnaire& effort = protocol->questionnaires[1];
    EXPECT_EQ(effort.title, "effort");
    EXPECT_TRUE(isOfSession(effort.when));
    EXPECT_EQ(effort.items[0].points, 5U);
    EXPECT_EQ(effort.items[0].high, "hard");
    EXPECT_TRUE(smallProtocol().questionnaires.empty());
}

TEST(Questionnaire, saysWhereItIsWrong) {
    const char* wrong[] = {
        "[[questionnaire]]\nid = \"a\"\nwhen = \"at noon\"\nitem = [{ id = \"b\", kind = \"text\", question "
        "= \"?\" }]\n",
        "[[questionnaire]]\nid = \"a b\"\nwhen = \"after_study\"\nitem = [{ id = \"b\", kind = \"text\", "
        "question = \"?\" }]\n",
        "[[questionnaire]]\nid = \"a\"\nwhen = \"after_study\"\nitem = [{ id = \"b\", kind = \"likert\", "
        "question = \"?\", points = 1 }]\n",
        "[[questionnaire]]\nid = \"a\"\nwhen = \"after_study\"\nitem = [{ id = \"b\", kind = \"choice\", "
        "question = \"?\" }]\n",
        "[[questionnaire]]\nid = \"a\"\nwhen = \"after_study\"\n",
        "[[questionnaire]]\nid = \"a\"\nwhen = \"after_study\"\nitem = [{ id = \"b\", kind = \"text\", "
        "question = \"?\" }, { id = \"b\", kind = \"text\", question = \"?\" }]\n"};
    for (const char* text : wrong) {
        const auto protocol = withQuestionnaires(text);
        ASSERT_FALSE(protocol) << text;
        EXPECT_EQ(protocol.error().kind, core::ErrorKind::badInput);
        EXPECT_GT(protocol.error().where.line, 15) << core::describe(protocol.error());
    }
}

TEST(Questionnaire, takesAnswersThatFit) {
    const Protocol protocol = withQuestionnaires(kQuestionnaires).value();
    const Questionnaire& person = protocol.questionnaires[0];
    EXPECT_TRUE(checkAnswers(person, {{"hand", "left"}, {"remarks", std::nullopt}}));
    EXPECT_TRUE(checkAnswers(person, {{"hand", "right"}, {"remarks", "two\nlines, \"quoted\""}}));
    EXPECT_TRUE(checkAnswers(protocol.questionnaires[1], {{"hard", "1"}}));
    EXPECT_TRUE(checkAnswers(protocol.questionnaires[1], {{"hard", "5"}}));
    EXPECT_EQ(shownAnswer(person.items[0], "left"), "With the left");
    EXPECT_EQ(shownAnswer(person.items[1], "yes"), "yes");
    EXPECT_EQ(shownAnswer(person.items[1], std::nullopt), "");
}

TEST(Questionnaire, namesTheItemWhoseAnswerDoesNotFit) {
    const Protocol protocol = withQuestionnaires(kQuestionnaires).value();
    const Questionnaire& person = protocol.questionnaires[0];
    const std::vector<std::vector<ItemAnswer>> wrong = {{{"hand", "both"}, {"remarks", std::nullopt}},
                                                        {{"hand", std::nullopt}, {"remarks", std::nullopt}},
                                                        {{"hand", "  "}, {"remarks", std::nullopt}},
                                                        {{"remarks", "x"}, {"hand", "left"}},
                                                        {}};
    for (const auto& answers : wrong) {
        const auto fit = checkAnswers(person, answers);
        ASSERT_FALSE(fit);
        EXPECT_EQ(fit.error().where.file, "hand");
    }
    EXPECT_FALSE(checkAnswers(person, {{"hand", "left"}, {"remarks", std::string(10'001, 'x')}}));
    EXPECT_FALSE(checkAnswers(person, {{"hand", "left"}, {"remarks", "x"}, {"more", "x"}}));
    for (const char* point : {"0", "6", "-1", "1.5", "one", "01", " 1"})
        EXPECT_FALSE(checkAnswers(protocol.questionnaires[1], {{"hard", point}})) << point;
}

} // namespace teleta::study
