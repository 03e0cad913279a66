// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/codebook.h"

#include <array>

namespace teleta::study {

namespace {

constexpr char kPerson[] = "Participant; GROUP: all of them";
constexpr char kFewTrials[] = "1: fewer than 5 trials a cell of the matrix; 0: enough";
constexpr char kNoTrials[] = "no trials";
constexpr char kRefused[] = "not computed; see note";
constexpr char kSphericity[] = "not computed, or nothing to correct";

constexpr std::array kConfusion{
    CodebookRow{"participant_id", kPerson},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"phase", "Part of the session", "", "practice; test"},
    CodebookRow{"stimulus", "What was presented"},
    CodebookRow{"response", "What was answered", "", "NONE: no answer in time"},
    CodebookRow{"count", "Trials with this stimulus and this answer"},
    CodebookRow{"row_total", "Trials with this stimulus"},
};

constexpr std::array kSummary{
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"n", "Completed test trials"},
    CodebookRow{"n_correct", "Of them answered correctly"},
    CodebookRow{"n_timeout", "Of them not answered in time"},
    CodebookRow{"accuracy", "Share of correct answers", "", "", kNoTrials},
    CodebookRow{"wilson_lo", "Lower end of Wilson's 95 % interval of the share", "", "", kNoTrials},
    CodebookRow{"wilson_hi", "Its upper end", "", "", kNoTrials},
    CodebookRow{"cp_lo", "Lower end of the exact 95 % interval (Clopper and Pearson)", "", "", kNoTrials},
    CodebookRow{"cp_hi", "Its upper end", "", "", kNoTrials},
    CodebookRow{"p_chance", "Probability of as many correct answers by guessing, exact, one-sided"},
    CodebookRow{"it_bits", "Information transfer as measured", "bit", "", kNoTrials},
    CodebookRow{"it_bias_bits", "Its expected excess, after Miller", "bit", "", kNoTrials},
    CodebookRow{"it_corrected_bits", "Information transfer less that excess", "bit", "", kNoTrials},
    CodebookRow{"rt_median_s", "Median response time of correct answers", "s", "", "no correct answer"},
    CodebookRow{"rt_n", "Number of these answers"},
};

constexpr std::array kGroup{
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"participants", "Number of participants"},
    CodebookRow{"accuracy_mean", "Mean of the participants' shares of correct answers", "", "", kNoTrials},
    CodebookRow{"accuracy_sd", "Standard deviation of these shares", "", "", "fewer than two participants"},
    CodebookRow{"t_lo", "Lower end of the 95 % t interval of the mean", "", "",
                "fewer than two participants"},
    CodebookRow{"t_hi", "Its upper end", "", "", "fewer than two participants"},
    CodebookRow{"n", "Completed test trials"},
    CodebookRow{"it_bits", "Information transfer as measured", "bit", "", kNoTrials},
    CodebookRow{"it_bias_bits", "Its bias, by the jackknife over participants", "bit", "", kNoTrials},
    CodebookRow{"it_corrected_bits", "Information transfer less its bias", "bit", "", kNoTrials},
    CodebookRow{"it_few_trials", "Whether the trials are few for this estimate", "", kFewTrials},
    CodebookRow{"it_lo", "Lower end of the 95 % interval of the true transfer", "bit", "",
                "too few data; see it_note"},
    CodebookRow{"it_hi", "Its upper end", "bit", "", "too few data; see it_note"},
    CodebookRow{"it_at_least", "Bound in place of an interval", "bit", "",
                "there is an interval or no bound"},
    CodebookRow{"it_at_most", "Bound in place of an interval", "bit", "", "there is an interval or no bound"},
    CodebookRow{"it_note", "Why there is no interval", "", "", "there is one"},
};

constexpr std::array kAnova{
    CodebookRow{"task", "Task"},
    CodebookRow{"effect", "Effect within participants", "", "condition; pattern; condition:pattern"},
    CodebookRow{"stimulus", "Pattern whose conditions are compared", "", "", "all patterns"},
    CodebookRow{"df1", "Degrees of freedom of the effect", "", "", kRefused},
    CodebookRow{"df2", "Degrees of freedom of its error", "", "", kRefused},
    CodebookRow{"ss", "Sum of squares of the effect", "", "", kRefused},
    CodebookRow{"ss_error", "Sum of squares of its error", "", "", kRefused},
    CodebookRow{"f", "F", "", "", kRefused},
    CodebookRow{"p", "p without a correction", "", "", kRefused},
    CodebookRow{"eps_gg", "Epsilon of Greenhouse and Geisser", "", "", kRefused},
    CodebookRow{"p_gg", "p with that correction", "", "", kRefused},
    CodebookRow{"eps_hf", "Epsilon of Huynh and Feldt, at most 1", "", "", kSphericity},
    CodebookRow{"p_hf", "p with that correction", "", "", kSphericity},
    CodebookRow{"partial_eta2", "Partial eta squared", "", "", kRefused},
    CodebookRow{"generalized_eta2", "Generalised eta squared", "", "", kRefused},
    CodebookRow{"n", "Participants that were compared"},
    CodebookRow{"dropped", "Participants without data in every cell, separated by ;", "", "", "nobody"},
    CodebookRow{"note", "Why there are no numbers", "", "", "there are"},
};

constexpr std::array kResultTables{
    CodebookFile{"confusion_long.csv", kConfusion},
    CodebookFile{"summary.csv", kSummary},
    CodebookFile{"group.csv", kGroup},
    CodebookFile{"anova.csv", kAnova},
};

} // namespace

std::span<const CodebookFile> codebookOfResults() {
    return kResultTables;
}

} // namespace teleta::study
