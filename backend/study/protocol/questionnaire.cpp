// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/questionnaire.h"

#include "backend/study/protocol/identifier.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

namespace teleta::study {

namespace {

using core::TomlTable;

struct ItemText {
    Q_DECLARE_TR_FUNCTIONS(StudyQuestionnaire)
};

constexpr int kLongestAnswer = 10'000;
constexpr long long kMostPoints = 11;

core::Unexpected misfit(const std::string& item, const QString& message, const QString& expected) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {item}});
}

QuestionnaireItem readItem(TomlTable& table, std::set<std::string>& used) {
    QuestionnaireItem item;
    item.id = readIdentifier(table, "id", used);
    item.kind = static_cast<ItemKind>(table.choice("kind", {"text", "likert", "choice"}));
    item.question = table.text("question");
    item.required = table.boolean("required", true);
    if (item.kind == ItemKind::likert) {
        item.points = static_cast<std::size_t>(table.integer("points", 2, kMostPoints, 7));
        item.low = table.has("low") ? table.text("low") : std::string();
        item.high = table.has("high") ? table.text("high") : std::string();
    }
    if (item.kind == ItemKind::choice) {
        std::set<std::string> ids;
        for (TomlTable& entry : table.tables("choice", 2)) {
            ItemChoice choice;
            choice.id = readIdentifier(entry, "id", ids);
            choice.text = entry.text("text", choice.id);
            entry.finish();
            item.choices.push_back(std::move(choice));
        }
    }
    table.finish();
    return item;
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
        if (std::none_of(item.choices.begin(), item.choices.end(),
                         [&](const ItemChoice& choice) { return choice.id == *value; }))
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
    switch (time) {
    case QuestionnaireTime::beforeStudy:
        return "before_study";
    case QuestionnaireTime::beforeSession:
        return "before_session";
    case QuestionnaireTime::afterSession:
        return "after_session";
    case QuestionnaireTime::afterStudy:
        break;
    }
    return "after_study";
}

const char* toString(ItemKind kind) {
    switch (kind) {
    case ItemKind::text:
        return "text";
    case ItemKind::likert:
        return "likert";
    case ItemKind::choice:
        break;
    }
    return "choice";
}

std::vector<Questionnaire> readQuestionnaires(TomlTable& root) {
    std::vector<Questionnaire> questionnaires;
    if (!root.has("questionnaire"))
        return questionnaires;
    std::set<std::string> ids;
    for (TomlTable& table : root.tables("questionnaire", 1)) {
        Questionnaire questionnaire;
        questionnaire.id = readIdentifier(table, "id", ids);
        questionnaire.title = table.text("title", questionnaire.id);
        questionnaire.when = static_cast<QuestionnaireTime>(
            table.choice("when", {"before_study", "before_session", "after_session", "after_study"}));
        std::set<std::string> items;
        for (TomlTable& item : table.tables("item", 1))
            questionnaire.items.push_back(readItem(item, items));
        table.finish();
        questionnaires.push_back(std::move(questionnaire));
    }
    return questionnaires;
}

core::Expected<void> checkAnswers(const Questionnaire& questionnaire,
                                  const std::vector<ItemAnswer>& answers) {
    for (std::size_t i = 0; i < questionnaire.items.size(); ++i) {
        const QuestionnaireItem& item = questionnaire.items[i];
        if (i >= answers.size() || answers[i].item != item.id)
            return misfit(item.id, ItemText::tr("the answers do not match this questionnaire"),
                          ItemText::tr("one answer per item, in order"));
        if (const core::Expected<void> fits = checkAnswer(item, answers[i].value); !fits)
            return fits;
    }
    if (answers.size() > questionnaire.items.size())
        return misfit(answers.back().item, ItemText::tr("the answers do not match this questionnaire"),
                      ItemText::tr("one answer per item, in order"));
    return {};
}

std::string shownAnswer(const QuestionnaireItem& item, const std::optional<std::string>& value) {
    const auto choice = std::find_if(item.choices.begin(), item.choices.end(),
                                     [&](const ItemChoice& c) { return value && c.id == *value; });
    return choice != item.choices.end() ? choice->text : value.value_or(std::string());
}

} // namespace teleta::study
