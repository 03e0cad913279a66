// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/level_trial_store.h"

#include "backend/core/failure.h"
#include "backend/study/analysis/trials/stored_exclusions.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace teleta::study {

namespace {

struct LevelStoreText {
    Q_DECLARE_TR_FUNCTIONS(LevelSourceText)
};

} // namespace

LevelTaskFacts levelTaskFacts(const Protocol& protocol, const StudyTask& task) {
    LevelTaskFacts facts;
    facts.design = task.design;
    facts.intervals = task.patterns.size(); // the answers
    facts.unit = unitOf(task.levels.vary);
    facts.procedure = nameOf(task.levels.procedure);
    facts.scale = task.levels.range.scale;
    facts.range = task.levels.range;
    facts.settings = procedureOf(task.design, task.levels, protocol.test.repetitions,
                                 protocol.order == OrderMethod::blockedRandom);
    return facts;
}

core::Expected<void> addLevelTrials(const StudyStore& store, ModeFilter& modes, LevelTrials& trials,
                                    const std::vector<ExclusionRule>& after) {
    const StudyHead& head = store.head();
    if (modes.wanted && *modes.wanted != head.mode)
        return {};
    if (!modes.wanted && modes.seen && *modes.seen != head.mode)
        return core::failed(core::ErrorKind::refused,
                            LevelStoreText::tr("these are data of different modes: %1 and %2")
                                .arg(toString(*modes.seen), toString(head.mode)),
                            LevelStoreText::tr("one mode, or the choice of one"), {store.folder()});
    modes.seen = head.mode;
    if (std::ranges::all_of(head.protocol.tasks,
                            [](const StudyTask& task) { return task.design == Design::identification; }))
        return {};
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    for (const Participant& participant : participants) {
        const std::vector<PlannedSession> plan =
            planSessions(head.protocol, head.seed, participant.enrolment);
        TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
        TELETA_TRY(const StoredExclusions exclusions, storedExclusions(store, participant, after));
        for (const SessionRecord& session : sessions) {
            const PlannedSession& planned = plan.at(session.planIndex);
            const StudyTask& task = head.protocol.tasks[planned.task];
            if (task.design == Design::identification)
                continue;
            TELETA_TRY(const std::vector<StoredTrial> stored, store.trials(session));
            const std::string& condition = task.conditions[planned.condition];
            const double reference = task.referenceOf(condition);
            LevelTaskFacts& facts = trials.factsOf(std::string_view(task.id));
            facts = levelTaskFacts(head.protocol, task);
            for (const StoredTrial& one : stored) {
                const TrialResult& result = one.result;
                if (!result.isComplete() || result.planned.phase != Phase::test || !result.planned.level)
                    continue;
                std::optional<LevelTrial> trial = levelTrialOf(task.design, *result.planned.level, reference,
                                                               result.planned.stimulus, result.response);
                if (!trial)
                    continue;
                trial->isExcluded = !exclusions.ruleOf(session, result).empty();
                trial->run = facts.procedure == "constant" ? 1 : result.planned.repetition;
                LevelTrials::Track& track =
                    trials.trackOf({task.id, condition, result.planned.track, participant.id});
                track.reference = reference;
                track.trials.push_back(*trial);
            }
        }
    }
    return {};
}

} // namespace teleta::study
