// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// What a rule looks at and leaves out.
enum class ExclusionOf { trial, session, participant };

/// When something is left out of the results. `value` is the number of the rule.
enum class ExclusionKind {
    responseTimeBelow_s,   ///< trial: answered earlier than value
    responseTimeAbove_s,   ///< trial: answered later than value
    responseTimeMad,       ///< trial: |log time - median| > value * 1.4826 MAD, of participant and condition
    deviceFaults,          ///< trial: more faults than value
    framesMissedAbove,     ///< trial: more missed frames than value
    timeoutsShareAbove,    ///< session: share of test trials without an answer
    catchYesShareAbove,    ///< session: share of "yes" in catch trials
    sameAnswerShareAbove,  ///< session: share of the most frequent answer
    practiceAccuracyBelow, ///< participant: share of right answers in practice
    accuracyNotAboveChance ///< participant: p of so many right test answers by guessing > value
};

/// A rule that decides before or after the data what does not count.
struct ExclusionRule {
    std::string id; ///< what the column `excluded` has
    ExclusionKind kind = ExclusionKind::responseTimeBelow_s;
    double value = 0.0;
    bool afterTheData = false; ///< given when the data were analysed, not in the protocol

    [[nodiscard]] ExclusionOf of() const;
    friend bool operator==(const ExclusionRule&, const ExclusionRule&) = default;
};

/// Words in files: trial, session, participant; response_time_below_s, ...
[[nodiscard]] const char* toString(ExclusionOf of);
[[nodiscard]] const char* toString(ExclusionKind kind);

/// Describes [[exclude]].
void describeExclusions(core::Keys& keys, std::vector<ExclusionRule>& rules);

/// A rule as the command line has it: "response_time_below_s=0.2"; its id is the name of the rule. Error:
/// badInput. Thread: any.
[[nodiscard]] core::Expected<ExclusionRule> parseExclusion(std::string_view text);

} // namespace teleta::study
