// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/standard_questionnaire.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace teleta::study {

namespace {

struct Factor {
    const char* id;
    const char* title;
    const char* question;
    const char* low;
    const char* high;
};

constexpr std::array<Factor, 6> kFactors{
    {{"mental", "Mental Demand",
      "Mental Demand: How much mental and perceptual activity was required (e.g., thinking, deciding, "
      "calculating, remembering, looking, searching, etc.)? Was the task easy or demanding, simple or "
      "complex, "
      "exacting or forgiving?",
      "Low", "High"},
     {"physical", "Physical Demand",
      "Physical Demand: How much physical activity was required (e.g., pushing, pulling, turning, "
      "controlling, "
      "activating, etc.)? Was the task easy or demanding, slow or brisk, slack or strenuous, restful or "
      "laborious?",
      "Low", "High"},
     {"temporal", "Temporal Demand",
      "Temporal Demand: How much time pressure did you feel due to the rate or pace at which the tasks or "
      "task "
      "elements occurred? Was the pace slow and leisurely or rapid and frantic?",
      "Low", "High"},
     {"performance", "Performance",
      "Performance: How successful do you think you were in accomplishing the goals of the task set by the "
      "experimenter (or yourself)? How satisfied were you with your performance in accomplishing these "
      "goals?",
      "Good", "Poor"},
     {"effort", "Effort",
      "Effort: How hard did you have to work (mentally and physically) to accomplish your level of "
      "performance?",
      "Low", "High"},
     {"frustration", "Frustration Level",
      "Frustration Level: How insecure, discouraged, irritated, stressed and annoyed versus secure, "
      "gratified, "
      "content, relaxed and complacent did you feel during the task?",
      "Low", "High"}}};
constexpr char kPairQuestion[] = "Which of the items was more important to your experience of workload in "
                                 "the task that you just performed?";
constexpr double kPairs = 15.0;

constexpr std::array kStatements{
    "I think that I would like to use this system frequently",
    "I found the system unnecessarily complex",
    "I thought the system was easy to use",
    "I think that I would need the support of a technical person to be able to use this system",
    "I found the various functions in this system were well integrated",
    "I thought there was too much inconsistency in this system",
    "I would imagine that most people would learn to use this system very quickly",
    "I found the system very cumbersome to use",
    "I felt very confident using the system",
    "I needed to learn a lot of things before I could get going with this system"};
constexpr std::size_t kStatementPoints = 5;

QuestionnaireItem ratingOf(const Factor& factor) {
    QuestionnaireItem item;
    item.id = factor.id;
    item.kind = ItemKind::scale;
    item.question = factor.question;
    item.low = factor.low;
    item.high = factor.high;
    return item;
}

QuestionnaireItem pairOf(const Factor& one, const Factor& other) {
    QuestionnaireItem item;
    item.id = std::string(one.id) + '_' + other.id;
    item.kind = ItemKind::pair;
    item.question = kPairQuestion;
    item.choices = {{one.id, one.title}, {other.id, other.title}};
    return item;
}

QuestionnaireItem statement(std::size_t number) {
    QuestionnaireItem item;
    item.id = "sus" + std::to_string(number + 1);
    item.kind = ItemKind::likert;
    item.question = kStatements[number];
    item.points = kStatementPoints;
    item.low = "Strongly disagree";
    item.high = "Strongly agree";
    return item;
}

/// Looks up answers and counts what is missing.
class Answers {
public:
    explicit Answers(const std::vector<ItemAnswer>& answers)
        : m_answers(answers) {}

    std::optional<std::string> text(const std::string& item) {
        const auto found = std::ranges::find(m_answers, item, &ItemAnswer::item);
        if (found != m_answers.end() && found->value)
            return found->value;
        ++m_missing;
        return std::nullopt;
    }
    double number(const std::string& item) {
        double value = 0.0;
        if (const std::optional<std::string> given = text(item))
            std::from_chars(given->data(), given->data() + given->size(), value);
        return value;
    }
    [[nodiscard]] QuestionnaireScore score(const char* name, double value) const {
        return {name, m_missing == 0 ? std::optional(value) : std::nullopt, m_missing};
    }

private:
    const std::vector<ItemAnswer>& m_answers;
    std::size_t m_missing = 0;
};

QuestionnaireScore rawLoad(Answers answers) {
    double sum = 0.0;
    for (const Factor& factor : kFactors)
        sum += answers.number(factor.id);
    return answers.score("tlx_raw", sum / static_cast<double>(kFactors.size()));
}

/// Each pair gives its winner's rating once.
QuestionnaireScore weightedLoad(Answers answers) {
    double sum = 0.0;
    std::array<double, kFactors.size()> ratings{};
    for (std::size_t i = 0; i < kFactors.size(); ++i)
        ratings[i] = answers.number(kFactors[i].id);
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
        for (std::size_t j = i + 1; j < kFactors.size(); ++j) {
            const std::optional<std::string> chosen = answers.text(pairOf(kFactors[i], kFactors[j]).id);
            sum += chosen == kFactors[i].id ? ratings[i] : ratings[j];
        }
    }
    return answers.score("tlx_weighted", sum / kPairs);
}

QuestionnaireScore usability(Answers answers) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kStatements.size(); ++i) {
        const double point = answers.number(statement(i).id);
        sum += i % 2 == 0 ? point - 1.0 : static_cast<double>(kStatementPoints) - point;
    }
    return answers.score("sus", 2.5 * sum);
}

} // namespace

Questionnaire standardQuestionnaire(StandardQuestionnaire standard, bool required) {
    Questionnaire made;
    made.use = standard;
    switch (standard) {
    case StandardQuestionnaire::none:
        break;
    case StandardQuestionnaire::nasaTlx:
    case StandardQuestionnaire::nasaTlxWeighted:
        made.title = "NASA Task Load Index";
        for (const Factor& factor : kFactors)
            made.items.push_back(ratingOf(factor));
        if (standard == StandardQuestionnaire::nasaTlx)
            break;
        for (std::size_t i = 0; i < kFactors.size(); ++i) {
            for (std::size_t j = i + 1; j < kFactors.size(); ++j)
                made.items.push_back(pairOf(kFactors[i], kFactors[j]));
        }
        break;
    case StandardQuestionnaire::sus:
        made.title = "System Usability Scale";
        for (std::size_t i = 0; i < kStatements.size(); ++i)
            made.items.push_back(statement(i));
        break;
    }
    for (QuestionnaireItem& item : made.items)
        item.required = required;
    return made;
}

const char* sourceOf(StandardQuestionnaire standard) {
    switch (standard) {
    case StandardQuestionnaire::none:
        break;
    case StandardQuestionnaire::nasaTlx:
    case StandardQuestionnaire::nasaTlxWeighted:
        return "Hart and Staveland 1988, doi:10.1016/S0166-4115(08)62386-9";
    case StandardQuestionnaire::sus:
        return "Brooke 1996, SUS: a quick and dirty usability scale";
    }
    return "";
}

const char* languageOf(StandardQuestionnaire standard) {
    return standard == StandardQuestionnaire::none ? "" : "en";
}

std::vector<QuestionnaireScore> questionnaireScores(const Questionnaire& questionnaire,
                                                    const std::vector<ItemAnswer>& answers) {
    switch (questionnaire.use) {
    case StandardQuestionnaire::none:
        break;
    case StandardQuestionnaire::nasaTlx:
        return {rawLoad(Answers(answers))};
    case StandardQuestionnaire::nasaTlxWeighted:
        return {rawLoad(Answers(answers)), weightedLoad(Answers(answers))};
    case StandardQuestionnaire::sus:
        return {usability(Answers(answers))};
    }
    return {};
}

std::string scoreMeaning(std::string_view name) {
    if (name == "tlx_raw")
        return "mean of the six ratings, 0 to 100";
    if (name == "tlx_weighted")
        return "mean of the ratings weighted by the 15 comparisons, 0 to 100";
    return "score of the System Usability Scale, 0 to 100";
}

} // namespace teleta::study
