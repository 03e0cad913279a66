// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/questionnaire.h"

#include "backend/core/failure.h"
#include "backend/core/words.h"
#include "backend/study/protocol/identifier.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

namespace teleta::study {

namespace {

using core::Keys;
using core::Need;

struct ItemText {
    Q_DECLARE_TR_FUNCTIONS(StudyQuestionnaire)
};

constexpr core::Words<QuestionnaireTime, 4> kTimes{
    {"before_study", "before_session", "after_session", "after_study"}};
constexpr core::Words<ItemKind, 3> kKinds{{"text", "likert", "choice"}};
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
         {"choice", "Answered by one of some choices"}},
        "Kind of question", Need::required, [&item](Keys& same, std::size_t chosen) {
            item.kind = static_cast<ItemKind>(chosen);
            if (item.kind == ItemKind::likert) {
                same.whole("points", item.points, {2, kMostPoints}, "Points of the scale", Need::optional);
                same.text("low", item.low, "What the first point means", Need::optional);
                same.text("high", item.high, "What the last point means", Need::optional);
            } else if (item.kind == ItemKind::choice) {
                std::set<std::string> ids;
                same.tables("choice", item.choices, 2, "The choices",
                            [&ids](Keys& entry, std::vector<ItemChoice>& choices, std::size_t i) {
                                describeIdentifier(entry, "id", choices[i].id, ids,
                                                   "The choice's name in results");
                                choices[i].text = choices[i].id;
                                entry.text("text", choices[i].text,
                                           "What the participant reads; otherwise the id", Need::optional);
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
    case ItemKind::choice:
        if (std::ranges::find(item.choices, *value, &ItemChoice::id) == item.choices.end())
            return misfit(item.id,
                          ItemText::tr("\"%1\" cannot be answered with \"%2\"")
                              .arg(question, QString::fromStdString(*value)),
                          ItemText::tr("one of the choices"));
        break;
    }
    return {};
}

} // namespace

const char* toString(QuestionnaireTime time) {
    return kTimes.of(time);
}

const char* toString(ItemKind kind) {
    return kKinds.of(kind);
}

void describeQuestionnaires(Keys& keys, std::vector<Questionnaire>& questionnaires) {
    std::set<std::string> ids;
    keys.tables("questionnaire", questionnaires, 0, "Questions to the participants",
                [&ids](Keys& table, std::vector<Questionnaire>& all, std::size_t q) {
                    Questionnaire& questionnaire = all[q];
                    describeIdentifier(table, "id", questionnaire.id, ids,
                                       "The questionnaire's name in results");
                    questionnaire.title = questionnaire.id;
                    table.text("title", questionnaire.title, "Its heading; otherwise the id", Need::optional);
                    table.choice("when", questionnaire.when,
                                 {"before_study", "before_session", "after_session", "after_study"},
                                 "When it is filled in");
                    std::set<std::string> used;
                    table.tables("item", questionnaire.items, 1, "Its questions",
                                 [&used](Keys& item, std::vector<QuestionnaireItem>& items, std::size_t i) {
                                     describeItem(item, items[i], used);
                                 });
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

} // namespace teleta::study
