// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// When a questionnaire is filled in.
enum class QuestionnaireTime { beforeStudy, beforeSession, afterSession, afterStudy };

enum class ItemKind {
    text,   ///< free text
    likert, ///< one of 1 .. points
    choice, ///< one of the choices
    scale,  ///< 0 .. 100 in steps of 5
    pair,   ///< one of two choices
};

/// A published questionnaire, which brings its items and scores.
enum class StandardQuestionnaire { none, nasaTlx, nasaTlxWeighted, sus };

/// Words in files: before_study, ..; text, likert, choice, scale, pair; own, nasa-tlx, nasa-tlx-weighted,
/// sus.
[[nodiscard]] const char* toString(QuestionnaireTime time);
[[nodiscard]] const char* toString(ItemKind kind);
[[nodiscard]] const char* toString(StandardQuestionnaire standard);

/// Of every session, as opposed to once per participant.
[[nodiscard]] constexpr bool isOfSession(QuestionnaireTime time) {
    return time == QuestionnaireTime::beforeSession || time == QuestionnaireTime::afterSession;
}

/// Points of ItemKind::scale: 0, 5, .., 100.
inline constexpr std::size_t kScalePoints = 21;
inline constexpr std::size_t kScaleStep = 5;

struct ItemChoice {
    std::string id; ///< what files have
    std::string text;
};

struct QuestionnaireItem {
    std::string id;
    ItemKind kind = ItemKind::text;
    std::string question;
    bool required = true;
    std::size_t points = 7; ///< of a Likert scale, 2 .. 11
    std::string low;        ///< what 1, or 0 of a scale, means; may be empty
    std::string high;       ///< what the last point means; may be empty
    std::vector<ItemChoice> choices;
};

struct Questionnaire {
    std::string id;
    std::string title;
    QuestionnaireTime when = QuestionnaireTime::afterStudy;
    std::vector<QuestionnaireItem> items;
    StandardQuestionnaire use = StandardQuestionnaire::none;
};

/// The answer to an item: the text, the number of the point, the value on the scale, or the id of the choice.
/// Empty: left out.
struct ItemAnswer {
    std::string item;
    std::optional<std::string> value;
};

/// Describes [[questionnaire]]. Ids: as in the protocol.
void describeQuestionnaires(core::Keys& keys, std::vector<Questionnaire>& questionnaires);

/// Checks answers: one per item in the items' order, required items answered, valid values, texts of at most
/// 10000 characters. Error: refused, naming the item in Error::where.file.
[[nodiscard]] core::Expected<void> checkAnswers(const Questionnaire& questionnaire,
                                                const std::vector<ItemAnswer>& answers);

/// The value for people: the text of a choice, otherwise the value itself; empty when left out.
[[nodiscard]] std::string shownAnswer(const QuestionnaireItem& item, const std::optional<std::string>& value);

/// The questionnaire as it is shown: pairs in random order among their places, and the two sides of each in
/// random order. The same seed gives the same order. Thread: any (pure).
[[nodiscard]] Questionnaire shownQuestionnaire(const Questionnaire& questionnaire, std::uint64_t seed);

/// Answers in the order of the questionnaire's items, as checkAnswers() wants them; answers to other items
/// come last.
[[nodiscard]] std::vector<ItemAnswer> inOrderOfItems(const Questionnaire& questionnaire,
                                                     std::vector<ItemAnswer> answers);

} // namespace teleta::study
