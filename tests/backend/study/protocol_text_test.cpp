// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

using namespace teleta::study;

namespace {

void expectTheSame(const Protocol& read, const Protocol& written) {
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.description, written.description);
    EXPECT_EQ(read.stimulus_s, written.stimulus_s);
    EXPECT_EQ(read.responseLimit_s, written.responseLimit_s);
    EXPECT_EQ(read.window, written.window);
    EXPECT_EQ(read.replays, written.replays);
    EXPECT_EQ(read.order, written.order);
    for (const auto phase : {&Protocol::practice, &Protocol::test}) {
        EXPECT_EQ((read.*phase).repetitions, (written.*phase).repetitions);
        EXPECT_EQ((read.*phase).feedback, (written.*phase).feedback);
        EXPECT_EQ((read.*phase).diagram, (written.*phase).diagram);
    }
    EXPECT_EQ(read.rest.everyTrials, written.rest.everyTrials);
    EXPECT_EQ(read.rest.atLeast_s, written.rest.atLeast_s);
    EXPECT_EQ(read.noiseColour, written.noiseColour);
    EXPECT_EQ(read.noise_dBA, written.noise_dBA);
    ASSERT_EQ(read.tasks.size(), written.tasks.size());
    for (std::size_t t = 0; t < read.tasks.size(); ++t) {
        EXPECT_EQ(read.tasks[t].id, written.tasks[t].id);
        EXPECT_EQ(read.tasks[t].name, written.tasks[t].name);
        EXPECT_EQ(read.tasks[t].conditions, written.tasks[t].conditions);
        ASSERT_EQ(read.tasks[t].patterns.size(), written.tasks[t].patterns.size());
        for (std::size_t p = 0; p < read.tasks[t].patterns.size(); ++p) {
            EXPECT_EQ(read.tasks[t].patterns[p].letter, written.tasks[t].patterns[p].letter);
            EXPECT_EQ(read.tasks[t].patterns[p].name, written.tasks[t].patterns[p].name);
        }
    }
    ASSERT_EQ(read.questionnaires.size(), written.questionnaires.size());
    for (std::size_t q = 0; q < read.questionnaires.size(); ++q) {
        EXPECT_EQ(read.questionnaires[q].id, written.questionnaires[q].id);
        EXPECT_EQ(read.questionnaires[q].title, written.questionnaires[q].title);
        EXPECT_EQ(read.questionnaires[q].when, written.questionnaires[q].when);
        ASSERT_EQ(read.questionnaires[q].items.size(), written.questionnaires[q].items.size());
        for (std::size_t i = 0; i < read.questionnaires[q].items.size(); ++i) {
            const QuestionnaireItem& a = read.questionnaires[q].items[i];
            const QuestionnaireItem& b = written.questionnaires[q].items[i];
            EXPECT_EQ(a.id, b.id);
            EXPECT_EQ(a.kind, b.kind);
            EXPECT_EQ(a.question, b.question);
            EXPECT_EQ(a.required, b.required);
            EXPECT_EQ(a.points, b.points);
            EXPECT_EQ(a.low, b.low);
            EXPECT_EQ(a.high, b.high);
            ASSERT_EQ(a.choices.size(), b.choices.size());
            for (std::size_t c = 0; c < a.choices.size(); ++c) {
                EXPECT_EQ(a.choices[c].id, b.choices[c].id);
                EXPECT_EQ(a.choices[c].text, b.choices[c].text);
            }
        }
    }
}

} // namespace

TEST(ProtocolText, isReadBackAsTheSameProtocol) {
    for (const Protocol& protocol : {paperProtocol().value(), smallProtocol(), smallProtocol("from_end")}) {
        const auto read = parseProtocol(protocolText(protocol), "written.toml");
        ASSERT_TRUE(read) << teleta::core::describe(read.error());
        expectTheSame(*read, protocol);
    }
}

TEST(ProtocolText, writesRests) {
    Protocol protocol = smallProtocol();
    protocol.rest = {15, 20.0};
    const auto read = parseProtocol(protocolText(protocol), "text");
    ASSERT_TRUE(read) << teleta::core::describe(read.error());
    expectTheSame(*read, protocol);
}

TEST(ProtocolText, keepsWhatIsHardToWrite) {
    Protocol protocol = smallProtocol();
    protocol.name = "\"quoted\" \\ back\nline\ttab \x01 \u96d1\u97f3";
    protocol.stimulus_s = 0.1 + 0.2;
    protocol.responseLimit_s = 7;
    protocol.replays = 2;
    protocol.order = OrderMethod::blockedRandom;
    protocol.noiseColour = "pink";
    protocol.noise_dBA = 62.5;
    protocol.tasks[0].patterns[1].name = "a, \"b\"";
    QuestionnaireItem text;
    text.id = "age";
    text.question = "How old are you?";
    QuestionnaireItem likert;
    likert.id = "hard";
    likert.kind = ItemKind::likert;
    likert.question = "How hard was it?";
    likert.required = false;
    likert.points = 5;
    likert.low = "easy";
    QuestionnaireItem choice;
    choice.id = "hand";
    choice.kind = ItemKind::choice;
    choice.question = "Which hand?";
    choice.choices = {{"l", "left"}, {"r", "right"}};
    protocol.questionnaires = {
        {"after", "Afterwards", QuestionnaireTime::afterSession, {text, likert, choice}}};
    const auto read = parseProtocol(protocolText(protocol), "written.toml");
    ASSERT_TRUE(read) << teleta::core::describe(read.error());
    expectTheSame(*read, protocol);
}
