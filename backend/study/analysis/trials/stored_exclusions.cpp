// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/stored_exclusions.h"

namespace teleta::study {

StoredExclusions::Key StoredExclusions::keyOf(const SessionRecord& session, const TrialResult& trial) {
    return {session.key, trial.planned.phase, trial.planned.trial, trial.planned.attempt};
}

std::string StoredExclusions::ruleOf(const SessionRecord& session, const TrialResult& trial) const {
    const auto found = m_rules.find(keyOf(session, trial));
    return found == m_rules.end() ? std::string() : found->second;
}

ExcludableTrial excludableTrial(const StudyTask& task, const PlannedSession& planned,
                                const SessionRecord& session, const TrialResult& trial) {
    ExcludableTrial known;
    known.task = task.id;
    known.condition = task.conditions[planned.condition];
    known.session = session.id;
    known.phase = trial.planned.phase;
    known.stimulus = task.patterns.at(trial.planned.stimulus).letter;
    if (trial.response)
        known.response = task.patterns.at(*trial.response).letter;
    known.responseTime_s = trial.responseTime_s;
    known.deviceFaults = trial.deviceFaults;
    known.framesMissed = trial.framesMissed.value_or(0);
    // A comparison has no right answer. The patterns of other designs are their answers.
    if (task.design != Design::compare)
        known.chance = 1.0 / static_cast<double>(task.patterns.size());
    return known;
}

core::Expected<StoredExclusions> storedExclusions(const StudyStore& store, const Participant& participant,
                                                  const std::vector<ExclusionRule>& after) {
    StoredExclusions exclusions;
    const StudyHead& head = store.head();
    std::vector<ExclusionRule> rules = head.protocol.exclusions;
    rules.insert(rules.end(), after.begin(), after.end());
    if (rules.empty())
        return exclusions;
    const std::vector<PlannedSession> plan = planSessions(head.protocol, head.seed, participant.enrolment);
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    std::vector<ExcludableTrial> trials;
    std::vector<StoredExclusions::Key> keys;
    for (const SessionRecord& session : sessions) {
        const PlannedSession& planned = plan.at(session.planIndex);
        TELETA_TRY(const std::vector<StoredTrial> stored, store.trials(session));
        for (const StoredTrial& one : stored) {
            if (!one.result.isComplete())
                continue;
            trials.push_back(
                excludableTrial(head.protocol.tasks[planned.task], planned, session, one.result));
            keys.push_back(StoredExclusions::keyOf(session, one.result));
        }
    }
    const Exclusions applied = applyExclusions(rules, trials);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (applied.rule[i])
            exclusions.m_rules[keys[i]] = rules[*applied.rule[i]].id;
    }
    return exclusions;
}

} // namespace teleta::study
