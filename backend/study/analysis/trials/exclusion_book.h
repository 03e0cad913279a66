// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/trial_tally.h"
#include "backend/study/analysis/trials/exclusion.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// What a rule left out, of one participant or of all.
struct ExclusionLine {
    std::string rule;                  ///< its id
    std::optional<ExclusionKind> kind; ///< empty: the rows of a file were marked already
    double value = 0.0;
    bool afterTheData = false;
    std::string participant; ///< empty: all participants
    std::size_t trialsBefore = 0;
    std::size_t trials = 0;
    std::size_t sessions = 0;
    std::size_t participants = 0;
    std::size_t cellsWithoutSpread = 0; ///< see ExclusionCount
};

/// Holds back the trials of participants to whom rules apply until all are there, applies the rules, and
/// keeps beside it what the results would be without them. Memory: per trial held back, and a second tally.
/// Thread: one.
class ExclusionBook {
public:
    /// rules: of the command line, for everybody, after those of each study.
    explicit ExclusionBook(std::vector<ExclusionRule> rules = {});

    /// A trial, and what the rules have to know of it beyond that.
    struct Trial {
        TalliedTrial trial;
        std::string_view session;
        std::size_t deviceFaults = 0;
        std::size_t framesMissed = 0;
        bool isScored = true;      ///< there is a right answer
        std::string_view excluded; ///< rule that has left it out already; empty: none
        std::string_view file{};   ///< it comes from; empty: a store
        long long row = 0;         ///< of the file, from 0 below its header
    };

    /// Rules of a study, in their order; none: only those of the command line.
    [[nodiscard]] bool hasRules(const std::vector<ExclusionRule>& ofStudy) const {
        return !ofStudy.empty() || !m_after.empty();
    }
    /// Holds a trial back. False: there are too many pattern names, as with TrialTally::add().
    [[nodiscard]] bool hold(const Trial& trial, const std::vector<ExclusionRule>& ofStudy);

    /// Adds what is left to the tally, which has all other trials. Call it once, after the last trial. False:
    /// both together have too many pattern names.
    [[nodiscard]] bool finish(TrialTally& tally);

    /// Rules applied, or rows were marked; after finish().
    [[nodiscard]] bool isUsed() const { return !m_lines.empty(); }
    /// Rules of the command line.
    [[nodiscard]] const std::vector<ExclusionRule>& after() const { return m_after; }
    /// A rule has left out that row; after finish().
    [[nodiscard]] bool hasLeftOut(std::string_view file, long long row) const;
    /// All trials, excluded ones too; only if isUsed().
    [[nodiscard]] const TrialTally& withoutRules() const { return m_all; }
    /// Each rule: all participants, then those who lost something.
    [[nodiscard]] const std::vector<ExclusionLine>& lines() const { return m_lines; }

private:
    struct Person {
        std::vector<ExclusionRule> rules;
        std::vector<Trial> trials; ///< texts in m_texts
    };
    [[nodiscard]] std::string_view own(std::string_view text);
    [[nodiscard]] ExclusionLine& line(const ExclusionRule& rule, bool isMarked);

    std::vector<ExclusionRule> m_after;
    std::set<std::string, std::less<>> m_texts;
    std::map<std::string_view, Person> m_people;
    std::map<std::string, std::set<long long>, std::less<>> m_leftOut; ///< rows, by file
    TrialTally m_names;                                                ///< counts the pattern names alone
    TrialTally m_all;
    std::vector<ExclusionLine> m_lines;
};

} // namespace teleta::study
