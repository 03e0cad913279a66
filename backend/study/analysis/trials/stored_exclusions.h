// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trials/exclusion.h"
#include "backend/study/store/study_store.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace teleta::study {

/// The trials of a participant that the rules of the protocol leave out.
class StoredExclusions {
public:
    /// Id of the rule; empty: the trial counts.
    [[nodiscard]] std::string ruleOf(const SessionRecord& session, const TrialResult& trial) const;

private:
    friend core::Expected<StoredExclusions> storedExclusions(const StudyStore& store,
                                                             const Participant& participant,
                                                             const std::vector<ExclusionRule>& after);
    using Key = std::tuple<long long, Phase, std::size_t, std::size_t>; ///< session, phase, trial, attempt
    [[nodiscard]] static Key keyOf(const SessionRecord& session, const TrialResult& trial);

    std::map<Key, std::string> m_rules;
};

/// Applies the rules of the protocol to what a participant has done so far, then those made after the data;
/// without rules nothing is read. Error: what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<StoredExclusions> storedExclusions(const StudyStore& store,
                                                                const Participant& participant,
                                                                const std::vector<ExclusionRule>& after = {});

/// A stored trial as the rules see it; the texts are those of session and task. Thread: any.
[[nodiscard]] ExcludableTrial excludableTrial(const StudyTask& task, const PlannedSession& planned,
                                              const SessionRecord& session, const TrialResult& trial);

} // namespace teleta::study
