// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/felt_trials.h"

#include <algorithm>
#include <optional>

namespace teleta::motors {

FeltTrials::FeltTrials(const StaircaseRules& rules)
    : m_rules(rules) {
    replay();
}

bool FeltTrials::isCatch() const {
    const int every = m_rules.catchEvery;
    return every > 0 && static_cast<int>(m_trials.size()) % every == every / 2;
}

double FeltTrials::drive() const {
    return isCatch() ? 0.0 : m_drive;
}

bool FeltTrials::done() const {
    return m_reversals >= m_rules.reversals || m_presented >= m_rules.mostTrials;
}

void FeltTrials::answer(bool yes) {
    if (done())
        return;
    m_trials.push_back({drive(), yes, isCatch()});
    replay();
}

bool FeltTrials::undo() {
    if (m_trials.empty())
        return false;
    m_trials.pop_back();
    replay();
    return true;
}

double FeltTrials::progress() const {
    return std::max(static_cast<double>(m_reversals) / m_rules.reversals,
                    static_cast<double>(m_presented) / m_rules.mostTrials);
}

/// Recomputes the state from the first answer, so that an undone one leaves no trace.
void FeltTrials::replay() {
    m_drive = m_rules.first;
    m_step = m_rules.firstStep;
    m_reversals = m_presented = 0;
    std::optional<bool> before;
    for (const FeltTrial& trial : m_trials) {
        if (trial.isCatch)
            continue;
        ++m_presented;
        if (before && *before != trial.yes) {
            ++m_reversals;
            m_step = std::max(0.5 * m_step, m_rules.smallestStep);
        }
        before = trial.yes;
        m_drive = std::clamp(m_drive + (trial.yes ? -m_step : m_step), m_rules.lowest, m_rules.highest);
    }
}

} // namespace teleta::motors
