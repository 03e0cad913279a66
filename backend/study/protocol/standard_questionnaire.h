// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/questionnaire.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// Title and items of a published questionnaire, in its published English words; id and time are left as they
/// are by default. required: of all items. Thread: any (pure).
/// Sources: NASA Task Load Index v. 1.0, manual (Hart and Staveland 1988, doi:10.1016/S0166-4115(08)62386-9);
/// Brooke 1996, SUS: a quick and dirty usability scale.
[[nodiscard]] Questionnaire standardQuestionnaire(StandardQuestionnaire standard, bool required = true);

/// Where its words are from; empty for a study's own.
[[nodiscard]] const char* sourceOf(StandardQuestionnaire standard);
/// Language in which its items are shown, ISO 639-1: "en", since no validated translation comes with the
/// program. Empty for a study's own questionnaires, whose language the program does not know.
[[nodiscard]] const char* languageOf(StandardQuestionnaire standard);

struct QuestionnaireScore {
    std::string name;            ///< tlx_raw, tlx_weighted, sus
    std::optional<double> value; ///< 0 .. 100; empty when an item that it needs was left out
    std::size_t missing = 0;     ///< items of the score that were left out
};

/// The scores of a published questionnaire; none for others. answers: those to items that are not there count
/// as left out. Thread: any (pure).
/// tlx_raw: mean of the six ratings (Hart 2006, doi:10.1177/154193120605000909).
/// tlx_weighted: sum(weight x rating) / 15; weight: how often the factor was chosen in the 15 pairs.
/// sus: 2.5 x (sum over odd items of (x - 1) + sum over even items of (5 - x)), items from 1.
[[nodiscard]] std::vector<QuestionnaireScore> questionnaireScores(const Questionnaire& questionnaire,
                                                                  const std::vector<ItemAnswer>& answers);

/// "mean of six ratings" and the like, in English for files.
[[nodiscard]] std::string scoreMeaning(std::string_view name);

} // namespace teleta::study
