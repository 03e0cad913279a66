// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/codebook.h"

#include <array>

namespace teleta::study {

namespace {

constexpr char kGroupOrPerson[] = "Participant; GROUP: all of them";
constexpr char kMethodRefused[] = "not computed; see note";

constexpr std::array kComparisonsRows{
    CodebookRow{"task", "Task"},
    CodebookRow{"effect", "Effect that is compared: condition, pattern, or condition within a pattern"},
    CodebookRow{"stimulus", "Pattern within which conditions are compared", "", "",
                "the effect is over all patterns"},
    CodebookRow{"first", "First level of the pair", "", "", "the row is the effect as a whole"},
    CodebookRow{"second", "Second level; the difference is first less second", "", "",
                "the row is the effect as a whole"},
    CodebookRow{"n", "Participants that were compared", "", "", kMethodRefused},
    CodebookRow{"difference", "Mean of the differences of the participants' shares", "", "", kMethodRefused},
    CodebookRow{"lo", "Lower end of its 95 % t interval, not adjusted", "", "", kMethodRefused},
    CodebookRow{"hi", "Its upper end", "", "", kMethodRefused},
    CodebookRow{"t", "t of the paired comparison", "", "", kMethodRefused},
    CodebookRow{"df", "Degrees of freedom of t", "", "", kMethodRefused},
    CodebookRow{"p", "Two-sided p", "", "", kMethodRefused},
    CodebookRow{"p_holm", "p by Holm over the family", "", "", kMethodRefused},
    CodebookRow{"family", "Pairs in the family over which Holm corrects", "", "", kMethodRefused},
    CodebookRow{"dz", "Mean of the differences over their standard deviation", "", "", kMethodRefused},
    CodebookRow{"dz_lo", "Lower end of its 95 % interval from the noncentral t", "", "", kMethodRefused},
    CodebookRow{"dz_hi", "Its upper end", "", "", kMethodRefused},
    CodebookRow{"dav", "Difference over the root mean square of both standard deviations", "", "",
                kMethodRefused},
    CodebookRow{"hedges_j", "Hedges' correction for few participants", "", "", kMethodRefused},
    CodebookRow{"gz", "dz times that correction", "", "", kMethodRefused},
    CodebookRow{"partial_eta2", "Partial eta squared of the effect", "", "", "a pair, or not computed"},
    CodebookRow{"partial_eta2_lo", "Lower end of its 95 % interval; only where epsilon GG is at least .75",
                "", "", "a pair, or sphericity is in doubt"},
    CodebookRow{"partial_eta2_hi", "Its upper end", "", "", "a pair, or sphericity is in doubt"},
    CodebookRow{"note", "Why there are no numbers", "", "", "there are"},
};

constexpr std::array kRanksRows{
    CodebookRow{"task", "Task"},
    CodebookRow{"effect", "Effect that is compared: condition, pattern, or condition within a pattern"},
    CodebookRow{"stimulus", "Pattern within which conditions are compared", "", "",
                "the effect is over all patterns"},
    CodebookRow{"test", "Test of ranks", "", "wilcoxon: signed ranks of a pair; friedman: all levels"},
    CodebookRow{"first", "First level of the pair", "", "", "Friedman's test"},
    CodebookRow{"second", "Second level", "", "", "Friedman's test"},
    CodebookRow{"n", "Participants that were compared", "", "", kMethodRefused},
    CodebookRow{"zeros", "Differences of zero, which are ranked and then left out (Pratt)", "", "",
                "Friedman's test, or not computed"},
    CodebookRow{"w_plus", "Sum of the ranks of positive differences", "", "",
                "Friedman's test, or not computed"},
    CodebookRow{"w_minus", "Sum of the ranks of negative differences", "", "",
                "Friedman's test, or not computed"},
    CodebookRow{"chi2", "Friedman's statistic, with ties", "", "", "Wilcoxon's test, or not computed"},
    CodebookRow{"df", "Its degrees of freedom", "", "", "Wilcoxon's test, or not computed"},
    CodebookRow{"p", "Two-sided p", "", "", kMethodRefused},
    CodebookRow{"p_holm", "p by Holm over the family", "", "", "Friedman's test, or not computed"},
    CodebookRow{"family", "Pairs in that family", "", "", "Friedman's test"},
    CodebookRow{"exact", "How p was computed", "", "1: by enumeration; 0: by the normal distribution",
                "Friedman's test, or not computed"},
    CodebookRow{"rank_biserial", "Rank-biserial correlation", "", "", "Friedman's test, or not computed"},
    CodebookRow{"kendall_w", "Kendall's W", "", "", "Wilcoxon's test, or not computed"},
    CodebookRow{"note", "Why there are no numbers", "", "", "there are"},
};

constexpr std::array kModelRows{
    CodebookRow{"task", "Task"},
    CodebookRow{"term", "Term of the model", "",
                "intercept: the reference condition; condition: another one, or all of them together; model: "
                "refused"},
    CodebookRow{"level", "Condition of the term", "", "", "the intercept, or all conditions"},
    CodebookRow{"reference", "Condition that the intercept stands for", "", "", "all conditions together"},
    CodebookRow{"estimate", "Coefficient on the logit scale", "", "",
                "all conditions together, or not computed"},
    CodebookRow{"se", "Its standard error", "", "", "all conditions together, or not computed"},
    CodebookRow{"lo", "Lower end of its 95 % Wald interval", "", "",
                "all conditions together, or not computed"},
    CodebookRow{"hi", "Its upper end", "", "", "all conditions together, or not computed"},
    CodebookRow{"sd_participants", "Standard deviation of the participants on the logit scale", "", "",
                "all conditions together, or not computed"},
    CodebookRow{"log_likelihood", "Log likelihood, constants left out", "", "",
                "all conditions together, or not computed"},
    CodebookRow{"lr_chi2", "Likelihood-ratio statistic of the conditions", "", "", "a single term"},
    CodebookRow{"lr_df", "Its degrees of freedom", "", "", "a single term"},
    CodebookRow{"lr_p", "Its p", "", "", "a single term"},
    CodebookRow{"participants", "Participants in the model", "", "", kMethodRefused},
    CodebookRow{"trials", "Trials in the model", "", "", kMethodRefused},
    CodebookRow{"note", "Why there are no numbers", "", "", "there are"},
};

constexpr std::array kTimesRows{
    CodebookRow{"participant_id", kGroupOrPerson},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"against", "Condition that it is compared with", "", "", "the row is one participant"},
    CodebookRow{"n", "Correct test trials; of GROUP the participants", "", "", kMethodRefused},
    CodebookRow{"geometric_mean_s", "Geometric mean of the response times", "s", "",
                "the row is a comparison"},
    CodebookRow{"median_s", "Their median", "s", "", "the row is a comparison"},
    CodebookRow{"ratio", "Ratio of the conditions' geometric means", "", "",
                "the row is one participant, or not computed"},
    CodebookRow{"lo", "Lower end of its 95 % interval", "", "",
                "the row is one participant, or not computed"},
    CodebookRow{"hi", "Its upper end", "", "", "the row is one participant, or not computed"},
    CodebookRow{"t", "t of the paired comparison of mean logarithms", "", "",
                "the row is one participant, or not computed"},
    CodebookRow{"df", "Its degrees of freedom", "", "", "the row is one participant, or not computed"},
    CodebookRow{"p", "Two-sided p", "", "", "the row is one participant, or not computed"},
    CodebookRow{"p_holm", "p by Holm over the pairs of the task", "", "",
                "the row is one participant, or not computed"},
    CodebookRow{"note", "Why there are no numbers", "", "", "there are"},
};

constexpr std::array kExclusionsRows{
    CodebookRow{"rule", "Id of the rule"},
    CodebookRow{"of", "What the rule leaves out", "", "trial; session; participant",
                "marks of the file itself"},
    CodebookRow{"kind", "Kind of the rule, as in the protocol", "", "", "marks of the file itself"},
    CodebookRow{"value", "Its limit", "", "", "marks of the file itself"},
    CodebookRow{
        "origin", "When the rule was set", "",
        "protocol: before the data; after the data: on the command line; file: the marks of the table"},
    CodebookRow{"participant_id", kGroupOrPerson},
    CodebookRow{"trials_before", "Trials that the rules before it had left"},
    CodebookRow{"trials", "Of them left out by this rule"},
    CodebookRow{"sessions", "Sessions with such trials"},
    CodebookRow{"participants", "Participants with such trials"},
    CodebookRow{"note", "Remark", "", "", "none"},
};

constexpr std::array kThresholdRows{
    CodebookRow{"participant_id", kGroupOrPerson},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"track", "Track"},
    CodebookRow{"design", "Design of the task"},
    CodebookRow{"function", "Psychometric function", "", "gauss; logistic; weibull",
                "the guess rate is not known"},
    CodebookRow{"n", "Trials of the fit; of GROUP the participants"},
    CodebookRow{"threshold", "Level at which F is 1/2, whatever guess and lapse rate are", "", "",
                "no answer; see note"},
    CodebookRow{"lo", "Lower end of its 95 % interval", "", "", "open, or no answer"},
    CodebookRow{"hi", "Its upper end", "", "", "open, or no answer"},
    CodebookRow{"interval", "Kind of the interval", "", "profile; bootstrap; t"},
    CodebookRow{"unit", "Unit of the levels", "", "", "not known"},
    CodebookRow{"spread", "Spread s of gauss and logistic, slope b of weibull", "", "",
                "no answer, or at a limit"},
    CodebookRow{"guess", "Guess rate", "", "", "not known"},
    CodebookRow{"lapse", "Lapse rate", "", "", "no answer"},
    CodebookRow{"deviance", "Deviance of the fit", "", "", "no answer"},
    CodebookRow{"p_deviance", "p of the deviance from data sets drawn from the fit", "", "",
                "adaptive track, or no answer"},
    CodebookRow{"jnd", "Just noticeable difference", "", "", "another design, or no answer"},
    CodebookRow{"weber", "jnd over the reference", "", "", "another design, or no answer"},
    CodebookRow{"pse", "Point of subjective equality", "", "", "another design, or no answer"},
    CodebookRow{"stair_estimate", "Estimate of the staircase", "", "", "no staircase, or no estimate"},
    CodebookRow{"stair_reversals", "Reversals of the staircase", "", "", "no staircase"},
    CodebookRow{"bayes_mean", "Posterior mean of the threshold", "", "", "no Bayesian procedure"},
    CodebookRow{"bayes_sd", "Posterior standard deviation, in the scale of the levels", "", "",
                "no Bayesian procedure"},
    CodebookRow{"note",
                "What the answers say instead of numbers, or about them; hierarchical: this row is one fit "
                "of all participants, each with a threshold of their own",
                "", "", "nothing"},
};

constexpr std::array kLevelsRows{
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"track", "Track"},
    CodebookRow{"design", "Design of the task"},
    CodebookRow{"function", "Psychometric function of the fit"},
    CodebookRow{"scale", "Scale of the levels", "", "linear; log10"},
    CodebookRow{"guess", "Guess rate of the fit", "", "", "not known"},
    CodebookRow{"lapse_lo", "Least lapse rate of the fit"},
    CodebookRow{"lapse_hi", "Largest lapse rate of the fit"},
    CodebookRow{"level", "Level"},
    CodebookRow{"level_unit", "Its unit", "", "", "not known"},
    CodebookRow{"reference", "Level of the standard", "", "", "none"},
    CodebookRow{"n", "Trials at this level"},
    CodebookRow{"n_positive", "Of them right, or answered yes or more"},
};

constexpr std::array kDetectionRows{
    CodebookRow{"participant_id", kGroupOrPerson},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition"},
    CodebookRow{"track", "Track"},
    CodebookRow{"hits", "Hits", "", "", "another count, or the row is GROUP"},
    CodebookRow{"n_signal", "Trials with a signal", "", "", "the row is GROUP"},
    CodebookRow{"false_alarms", "False alarms", "", "", "another count, or the row is GROUP"},
    CodebookRow{"n_noise", "Trials without", "", "", "the row is GROUP"},
    CodebookRow{"dprime", "Sensitivity d'", "", "", kMethodRefused},
    CodebookRow{"lo", "Lower end of its 95 % interval", "", "", kMethodRefused},
    CodebookRow{"hi", "Its upper end", "", "", kMethodRefused},
    CodebookRow{"c", "Criterion", "", "", "the design has none"},
    CodebookRow{"method", "How d' was computed"},
};

constexpr std::array kPlanRows{
    CodebookRow{"test", "TASK:EFFECT, or TASK:threshold for the interval of a threshold"},
    CodebookRow{"participants", "Number of participants of each study"},
    CodebookRow{"studies", "Studies that were drawn"},
    CodebookRow{"significant", "Of them with p below 0.05, or with an interval that is narrow enough"},
    CodebookRow{"refused", "Of them without an analysis; not significant"},
    CodebookRow{"power", "significant over studies"},
    CodebookRow{"se", "Standard error of power"},
    CodebookRow{"lo", "Lower end of its 95 % interval (Wilson)"},
    CodebookRow{"hi", "Its upper end"},
    CodebookRow{"target", "Power that is wanted"},
    CodebookRow{"seed", "Seed of all studies"},
};

constexpr std::array kMethodTables{
    CodebookFile{"comparisons.csv", kComparisonsRows},
    CodebookFile{"ranks.csv", kRanksRows},
    CodebookFile{"binomial_model.csv", kModelRows},
    CodebookFile{"response_times.csv", kTimesRows},
    CodebookFile{"exclusions.csv", kExclusionsRows},
    CodebookFile{"thresholds.csv", kThresholdRows},
    CodebookFile{"levels.csv", kLevelsRows},
    CodebookFile{"sdt.csv", kDetectionRows},
    CodebookFile{"plan.csv", kPlanRows},
};

} // namespace

std::span<const CodebookFile> codebookOfMethods() {
    return kMethodTables;
}

} // namespace teleta::study
