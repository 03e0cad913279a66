// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/questionnaire.h"

#include "backend/core/failure.h"
#include "backend/core/random_stream.h"
#include "backend/core/words.h"
#include "backend/study/protocol/identifier.h"
#include "backend/study/protocol/standard_questionnaire.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

using core::Keys;
using core::Need;

struct ItemText {
    Q_DECLARE_TR_FUNCTIONS(StudyQuestionnaire)
};

constexpr core::Words<QuestionnaireTime, 4> kTimes{
    {"before_study", "before_session", "after_session", "after_study"}};
constexpr core::Words<ItemKind, 5> kKinds{{"text", "likert", "choice", "scale", "pair"}};
constexpr core::Words<StandardQuestionnaire, 4> kStandards{{"own", "nasa-tlx", "nasa-tlx-weighted", "sus"}};
constexpr int kLongestAnswer = 10'000;
constexpr long long kMostPoints = 11;

core::Unexpected misfit(const std::string& item, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::refused, message, expected, {item});
}

void describeItem(Keys& keys, QuestionnaireItem& item, std::set<std::string>& used) {
    describeIdentifier(keys, "id", item.id, used, "The question's name in results");
    keys.choose(
        "kind", static_cast<std::size_t>(item.kind),
        {{"text", "Answered in the participant's own words"},
         {"likert", "Answered by a point on a scale"},
         {"choice", "Answered by one of some choices"},
         {"scale", "Answered by a value from 0 to 100 in steps of 5"},
         {"pair", "Answered by one of two choices"}},
        "Kind of question", Need::required, [&item](Keys& same, std::size_t chosen) {
            item.kind = static_cast<ItemKind>(chosen);
            if (item.kind == ItemKind::likert) {
                same.whole("points", item.points, {2, kMostPoints}, "Points of the scale", Need::optional);
                same.text("low", item.low, "What the first point means", Need::optional);
                same.text("high", item.high, "What the last point means", Need::optional);
            } else if (item.kind == ItemKind::scale) {
                same.text("low", item.low, "What 0 means", Need::optional);
                same.text("high", item.high, "What 100 means", Need::optional);
            } else if (item.kind == ItemKind::choice || item.kind == ItemKind::pair) {
                std::set<std::string> ids;
                same.tables("choice", item.choices, 2, "The choices",
                            [&ids, &item](Keys& entry, std::vector<ItemChoice>& choices, std::size_t i) {
                                describeIdentifier(entry, "id", choices[i].id, ids,
                                                   "The choice's name in results");
                                choices[i].text = choices[i].id;
                                entry.text("text", choices[i].text,
                                           "What the participant reads; otherwise the id", Need::optional);
                                if (item.kind == ItemKind::pair && i == 2)
                                    entry.refuse("id", ItemText::tr("a pair has two choices").toStdString(),
                                                 ItemText::tr("two of them").toStdString());
                            });
            }
        });
    keys.text("question", item.question, "The question");
    keys.flag("required", item.required, "It has to be answered");
}

bool isPoint(const std::string& value, std::size_t points) {
    std::size_t point = 0;
    const auto [stop, code] = std::from_chars(value.data(), value.data() + value.size(), point);
    return code == std::errc{} && stop == value.data() + value.size() && value.front() != '0' && point >= 1 &&
           point <= points;
}

bool isOnScale(const std::string& value) {
    for (std::size_t point = 0; point < kScalePoints; ++point) {
        if (value == std::to_string(point * kScaleStep))
            return true;
    }
    return false;
}

core::Expected<void> checkAnswer(const QuestionnaireItem& item, const std::optional<std::string>& value) {
    const QString question = QString::fromStdString(item.question);
    const bool isEmpty = !value || QString::fromStdString(*value).trimmed().isEmpty();
    if (isEmpty && item.required)
        return misfit(item.id, ItemText::tr("\"%1\" is not answered").arg(question),
                      ItemText::tr("an answer"));
    if (isEmpty)
        return {};
    switch (item.kind) {
    case ItemKind::text:
        if (QString::fromStdString(*value).size() > kLongestAnswer)
            return misfit(item.id, ItemText::tr("the answer to \"%1\" is too long").arg(question),
                          ItemText::tr("%1 characters at most").arg(kLongestAnswer));
        break;
    case ItemKind::likert:
        if (!isPoint(*value, item.points))
            return misfit(item.id,
                          ItemText::tr("\"%1\" cannot be answered with \"%2\"")
                              .arg(question, QString::fromStdString(*value)),
                          ItemText::tr("a number from 1 to %1").arg(item.points));
        break;
    case ItemKind::scale:
        if (!isOnScale(*value))
            return misfit(item.id,
                          ItemText::tr("\"%1\" cannot be answered with \"%2\"")
                              .arg(question, QString::fromStdString(*value)),
                          ItemText::tr("a number from 0 to 100 in steps of 5"));
        break;
    case ItemKind::choice:
    case ItemKind::pair:
        if (std::ranges::find(item.choices, *value, &ItemChoice::id) == item.choices.end())
            return misfit(item.id,
                          ItemText::tr("\"%1\" cannot be answered with \"%2\"")
                              .arg(question, QString::fromStdString(*value)),
                          ItemText::tr("one of the choices"));
        break;
    }
    return {};
}

void describeItems(Keys& keys, std::vector<QuestionnaireItem>& items) {
    std::set<std::string> used;
    keys.tables("item", items, 1, "Its questions",
                [&used](Keys& item, std::vector<QuestionnaireItem>& all, std::size_t i) {
                    describeItem(item, all[i], used);
                });
}

/// Everything but the id.
void describeQuestionnaire(Keys& keys, Questionnaire& questionnaire) {
    keys.choice("when", questionnaire.when,
                {"before_study", "before_session", "after_session", "after_study"}, "When it is filled in");
    keys.choose("use", static_cast<std::size_t>(questionnaire.use),
                {{"own", "The questions of `item`"},
                 {"nasa-tlx", "Task Load Index, six ratings"},
                 {"nasa-tlx-weighted", "Task Load Index, six ratings and 15 comparisons that weight them"},
                 {"sus", "System Usability Scale, ten questions"}},
                "Which questions it has", Need::optional, [&questionnaire](Keys& same, std::size_t chosen) {
                    questionnaire.use = static_cast<StandardQuestionnaire>(chosen);
                    if (questionnaire.use == StandardQuestionnaire::none) {
                        questionnaire.title = questionnaire.id;
                        same.text("title", questionnaire.title, "Its heading; otherwise the id",
                                  Need::optional);
                        describeItems(same, questionnaire.items);
                        return;
                    }
                    bool required = questionnaire.items.empty() || questionnaire.items.front().required;
                    same.flag("required", required, "All its questions have to be answered");
                    const Questionnaire standard = standardQuestionnaire(questionnaire.use, required);
                    questionnaire.title = standard.title;
                    questionnaire.items = standard.items;
                });
}

} // namespace

const char* toString(QuestionnaireTime time) {
    return kTimes.of(time);
}

const char* toString(ItemKind kind) {
    return kKinds.of(kind);
}

const char* toString(StandardQuestionnaire standard) {
    return kStandards.of(standard);
}

void describeQuestionnaires(Keys& keys, std::vector<Questionnaire>& questionnaires) {
    std::set<std::string> ids;
    keys.tables("questionnaire", questionnaires, 0, "Questions to the participants",
                [&ids](Keys& table, std::vector<Questionnaire>& all, std::size_t q) {
                    Questionnaire& questionnaire = all[q];
                    describeIdentifier(table, "id", questionnaire.id, ids,
                                       "The questionnaire's name in results");
                    describeQuestionnaire(table, questionnaire);
                });
}

core::Expected<void> checkAnswers(const Questionnaire& questionnaire,
                                  const std::vector<ItemAnswer>& answers) {
    const std::vector<QuestionnaireItem>& items = questionnaire.items;
    for (std::size_t i = 0; i < std::max(items.size(), answers.size()); ++i) {
        if (i >= items.size() || i >= answers.size() || answers[i].item != items[i].id)
            return misfit(i < items.size() ? items[i].id : answers.back().item,
                          ItemText::tr("the answers do not match this questionnaire"),
                          ItemText::tr("one answer per item, in order"));
        TELETA_CHECK(checkAnswer(items[i], answers[i].value));
    }
    return {};
}

std::string shownAnswer(const QuestionnaireItem& item, const std::optional<std::string>& value) {
    const auto choice =
        std::ranges::find_if(item.choices, [&](const ItemChoice& c) { return value && c.id == *value; });
    return choice != item.choices.end() ? choice->text : value.value_or(std::string());
}

Questionnaire shownQuestionnaire(const Questionnaire& questionnaire, std::uint64_t seed) {
    Questionnaire shown = questionnaire;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < shown.items.size(); ++i) {
        if (shown.items[i].kind == ItemKind::pair)
            places.push_back(i);
    }
    if (places.empty())
        return shown;
    core::RandomStream random(seed);
    for (std::size_t i = places.size() - 1; i > 0; --i)
        std::swap(shown.items[places[i]], shown.items[places[static_cast<std::size_t>(random.below(i + 1))]]);
    for (const std::size_t place : places) {
        if (random.below(2) == 1)
            std::ranges::reverse(shown.items[place].choices);
    }
    return shown;
}

std::vector<ItemAnswer> inOrderOfItems(const Questionnaire& questionnaire, std::vector<ItemAnswer> answers) {
    const auto placeOf = [&](const ItemAnswer& answer) {
        return std::ranges::find(questionnaire.items, answer.item, &QuestionnaireItem::id) -
               questionnaire.items.begin();
    };
    std::ranges::stable_sort(answers, {}, placeOf);
    return answers;
}

} // namespace teleta::study
