// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/standard_questionnaire.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/due_questionnaires.h"
#include "backend/study/session/rehearsal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <set>
#include <sstream>

namespace teleta::study {

namespace {

constexpr std::array kFactors{"mental", "physical", "temporal", "performance", "effort", "frustration"};

/// Ratings in the order of the factors, and pairs in which the factors win as often as their weights say.
std::vector<ItemAnswer> loadOf(const std::array<int, 6>& ratings, std::array<int, 6> weights) {
    std::vector<ItemAnswer> answers;
    for (std::size_t i = 0; i < kFactors.size(); ++i)
        answers.push_back({kFactors[i], std::to_string(ratings[i])});
    // Whoever needs more wins yet wins: a tournament with these scores exists.
    const std::array<int, 6> wanted = weights;
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
        for (std::size_t j = i + 1; j < kFactors.size(); ++j) {
            const bool first = wanted[i] > wanted[j];
            answers.push_back({std::string(kFactors[i]) + '_' + kFactors[j], kFactors[first ? i : j]});
        }
    }
    return answers;
}

std::vector<ItemAnswer> statements(const std::array<int, 10>& points) {
    std::vector<ItemAnswer> answers;
    for (std::size_t i = 0; i < points.size(); ++i)
        answers.push_back({"sus" + std::to_string(i + 1), std::to_string(points[i])});
    return answers;
}

Protocol with(const std::string& text) {
    return parseProtocol(smallProtocol().source + text, "mine.toml").value();
}

} // namespace

// Expected by hand: (70 + 15 + 60 + 35 + 65 + 40) / 6 = 47.5 and
// (4*70 + 0*15 + 3*60 + 2*35 + 5*65 + 1*40) / 15 = 895 / 15.
TEST(StandardQuestionnaire, computesTheTaskLoad) {
    const Questionnaire weighted = standardQuestionnaire(StandardQuestionnaire::nasaTlxWeighted);
    ASSERT_EQ(weighted.items.size(), 21U);
    const auto answers = loadOf({70, 15, 60, 35, 65, 40}, {4, 0, 3, 2, 5, 1});
    ASSERT_TRUE(checkAnswers(weighted, answers));
    const std::vector<QuestionnaireScore> scores = questionnaireScores(weighted, answers);
    ASSERT_EQ(scores.size(), 2U);
    EXPECT_EQ(scores[0].name, "tlx_raw");
    EXPECT_DOUBLE_EQ(scores[0].value.value(), 47.5);
    EXPECT_EQ(scores[1].name, "tlx_weighted");
    EXPECT_NEAR(scores[1].value.value(), 59.66667, 1e-5);
    const Questionnaire raw = standardQuestionnaire(StandardQuestionnaire::nasaTlx);
    EXPECT_EQ(raw.items.size(), 6U);
    EXPECT_DOUBLE_EQ(questionnaireScores(raw, answers).front().value.value(), 47.5);
}

// (3+2+4+3+3+3+4+3+3... : 2.5 * ((4-1)+(5-2)+(5-1)+(5-1)+(4-1)+(5-2)+(5-1)+(5-2)+(4-1)+(5-1)) = 85.
TEST(StandardQuestionnaire, computesTheUsability) {
    const Questionnaire sus = standardQuestionnaire(StandardQuestionnaire::sus);
    EXPECT_DOUBLE_EQ(
        questionnaireScores(sus, statements({4, 2, 5, 1, 4, 2, 5, 2, 4, 1})).front().value.value(), 85.0);
    EXPECT_DOUBLE_EQ(
        questionnaireScores(sus, statements({3, 3, 3, 3, 3, 3, 3, 3, 3, 3})).front().value.value(), 50.0);
}

TEST(StandardQuestionnaire, hasNoScoreWithoutAllItsItems) {
    const Questionnaire weighted = standardQuestionnaire(StandardQuestionnaire::nasaTlxWeighted, false);
    auto answers = loadOf({70, 15, 60, 35, 65, 40}, {4, 0, 3, 2, 5, 1});
    answers.back().value.reset();
    ASSERT_TRUE(checkAnswers(weighted, answers));
    auto scores = questionnaireScores(weighted, answers);
    EXPECT_DOUBLE_EQ(scores[0].value.value(), 47.5) << "the pair is not needed";
    EXPECT_FALSE(scores[1].value);
    EXPECT_EQ(scores[1].missing, 1U);
    answers.front().value.reset();
    scores = questionnaireScores(weighted, answers);
    EXPECT_FALSE(scores[0].value);
    EXPECT_EQ(scores[1].missing, 2U);
    const Questionnaire sus = standardQuestionnaire(StandardQuestionnaire::sus);
    const auto none = questionnaireScores(sus, {});
    EXPECT_FALSE(none.front().value);
    EXPECT_EQ(none.front().missing, 10U);
    EXPECT_TRUE(questionnaireScores({}, {}).empty());
}

TEST(StandardQuestionnaire, isNamedInAProtocolAndWrittenBack) {
    const Protocol protocol = with("[[questionnaire]]\nid = \"load\"\nwhen = \"after_session\"\n"
                                   "use = \"nasa-tlx-weighted\"\nrequired = false\n"
                                   "[[questionnaire]]\nid = \"u\"\nwhen = \"after_study\"\nuse = \"sus\"\n");
    ASSERT_EQ(protocol.questionnaires.size(), 2U);
    EXPECT_EQ(protocol.questionnaires[0].items.size(), 21U);
    EXPECT_FALSE(protocol.questionnaires[0].items[20].required);
    EXPECT_TRUE(protocol.questionnaires[1].items[9].required);
    EXPECT_EQ(protocol.questionnaires[1].title, "System Usability Scale");
    const std::string text = protocolText(protocol);
    EXPECT_NE(text.find("use = \"nasa-tlx-weighted\"\nrequired = false\n"), std::string::npos) << text;
    const Protocol again = parseProtocol(text, "again.toml").value();
    EXPECT_EQ(protocolText(again), text);
    EXPECT_EQ(again.questionnaires[0].items.size(), 21U);
}

TEST(StandardQuestionnaire, takesNoItemsOfItsOwn) {
    const auto both =
        parseProtocol(smallProtocol().source +
                          "[[questionnaire]]\nid = \"load\"\nwhen = \"after_session\"\n"
                          "use = \"sus\"\nitem = [{ id = \"a\", kind = \"text\", question = \"?\" }]\n",
                      "mine.toml");
    ASSERT_FALSE(both);
    EXPECT_GT(both.error().where.line, 15) << core::describe(both.error());
    EXPECT_FALSE(parseProtocol(smallProtocol().source +
                                   "[[questionnaire]]\nid = \"x\"\nwhen = \"after_session\"\nuse = \"ueq\"\n",
                               "mine.toml"));
}

TEST(Questionnaire, hasScalesAndPairsOfOnesOwn) {
    const std::string head = "[[questionnaire]]\nid = \"q\"\nwhen = \"after_study\"\n";
    const Protocol protocol = with(
        head +
        "item = [{ id = \"s\", kind = \"scale\", question = \"?\", low = \"a\", high = \"b\" }, "
        "{ id = \"p\", kind = \"pair\", question = \"?\", choice = [{ id = \"x\" }, { id = \"y\" }] }]\n");
    const Questionnaire& questionnaire = protocol.questionnaires[0];
    EXPECT_EQ(questionnaire.items[0].kind, ItemKind::scale);
    EXPECT_EQ(questionnaire.items[1].choices.size(), 2U);
    const std::string text = protocolText(protocol);
    EXPECT_EQ(protocolText(parseProtocol(text, "again.toml").value()), text);
    for (const char* value : {"0", "5", "100"})
        EXPECT_TRUE(checkAnswers(questionnaire, {{"s", value}, {"p", "x"}})) << value;
    for (const char* value : {"", "-5", "3", "105", "05", "5.0", "five"})
        EXPECT_FALSE(checkAnswers(questionnaire, {{"s", value}, {"p", "x"}})) << value;
    EXPECT_FALSE(checkAnswers(questionnaire, {{"s", "5"}, {"p", "z"}}));
    const auto three = parseProtocol(smallProtocol().source + head +
                                         "item = [{ id = \"p\", kind = \"pair\", question = \"?\", choice = "
                                         "[{ id = \"x\" }, { id = \"y\" }, "
                                         "{ id = \"z\" }] }]\n",
                                     "mine.toml");
    ASSERT_FALSE(three);
    EXPECT_GT(three.error().where.line, 15) << core::describe(three.error());
}

TEST(Questionnaire, showsPairsInAnOrderOfTheSeed) {
    const Questionnaire weighted = standardQuestionnaire(StandardQuestionnaire::nasaTlxWeighted);
    const auto ids = [](const Questionnaire& questionnaire) {
        std::vector<std::string> found;
        for (const QuestionnaireItem& item : questionnaire.items)
            found.push_back(item.id);
        return found;
    };
    const Questionnaire shown = shownQuestionnaire(weighted, 7);
    EXPECT_EQ(ids(shown), ids(shownQuestionnaire(weighted, 7)));
    EXPECT_NE(ids(shown), ids(shownQuestionnaire(weighted, 8)));
    EXPECT_NE(ids(shown), ids(weighted));
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(shown.items[i].id, weighted.items[i].id) << "ratings stay in their places";
    const auto all = ids(shown);
    EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), 21U);
    // Each place has each pair about equally often, and each side too: 3000 seeds, 5 standard deviations.
    constexpr int kSeeds = 3000;
    std::map<std::string, int> first;
    int swapped = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const Questionnaire one = shownQuestionnaire(weighted, static_cast<std::uint64_t>(seed));
        ++first[one.items[6].id];
        swapped += one.items[6].id.starts_with(one.items[6].choices[0].id) ? 0 : 1;
    }
    EXPECT_EQ(first.size(), 15U);
    for (const auto& [id, count] : first)
        EXPECT_NEAR(count, 200, 5 * 13.7) << id;
    EXPECT_NEAR(swapped, 1500, 5 * 27.4);

    std::vector<ItemAnswer> answers;
    for (const std::string& id : all)
        answers.push_back({id, std::nullopt});
    std::vector<std::string> sorted;
    for (const ItemAnswer& answer : inOrderOfItems(weighted, answers))
        sorted.push_back(answer.item);
    EXPECT_EQ(sorted, ids(weighted));
}

TEST(StandardQuestionnaire, hasItsScoresInTheExports) {
    const test::TemporaryFolder folder;
    StudyHead head;
    head.protocol = with("[[questionnaire]]\nid = \"load\"\nwhen = \"after_session\"\n"
                         "use = \"nasa-tlx-weighted\"\n"
                         "[[questionnaire]]\nid = \"u\"\nwhen = \"after_study\"\nuse = \"sus\"\n");
    head.mode = Mode::simulated;
    head.plannedParticipants = 2;
    head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);
    StudyStore store = std::move(StudyStore::create(folder.path("study"), head).value());
    ASSERT_TRUE(rehearse(store));
    ASSERT_TRUE(exportStudy(store, ExportFormat::psychds));
    std::istringstream scores(test::readAll(folder.path("study/questionnaire_scores.csv")));
    std::string line;
    std::getline(scores, line);
    EXPECT_EQ(line, "participant_id,session_id,task,condition,questionnaire,score,value,n_missing");
    std::map<std::string, int> counts;
    while (std::getline(scores, line)) {
        for (const char* score : {",load,tlx_raw,", ",load,tlx_weighted,", ",NA,NA,NA,u,sus,"})
            counts[score] += line.find(score) != std::string::npos ? 1 : 0;
        EXPECT_TRUE(line.ends_with(",0")) << line;
    }
    EXPECT_EQ(counts, (std::map<std::string, int>{
                          {",load,tlx_raw,", 4}, {",load,tlx_weighted,", 4}, {",NA,NA,NA,u,sus,", 2}}));

    ASSERT_TRUE(exportStudy(store, ExportFormat::bids));
    const std::string table = test::readAll(folder.path("study/bids/phenotype/load_shapestatic.tsv"));
    EXPECT_TRUE(table.starts_with("participant_id\tsession_id\tmental\tphysical\t")) << table;
    EXPECT_NE(table.find("\ttlx_raw\ttlx_weighted\nsub-P01\tses-shapestatic\t"), std::string::npos) << table;
    const auto sidecar =
        nlohmann::json::parse(test::readAll(folder.path("study/bids/phenotype/load_shapestatic.json")));
    EXPECT_EQ(sidecar["MeasurementToolMetadata"]["LanguageShown"], "en");
    EXPECT_EQ(sidecar["performance"]["Levels"]["100"], "Poor");
    EXPECT_TRUE(sidecar["mental_effort"]["Levels"].contains("effort"));
    EXPECT_TRUE(test::readAll(folder.path("study/bids/phenotype/u.tsv"))
                    .starts_with("participant_id\tsession_id\tsus1\t"));
}

} // namespace teleta::study
