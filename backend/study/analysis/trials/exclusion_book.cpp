// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/exclusion_book.h"

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

/// Number of answers to choose from, by task.
std::map<std::string, std::size_t> answersOf(const TrialTally& tally) {
    std::map<std::string, std::set<std::size_t>> letters;
    for (const auto& [key, cell] : tally.cells()) {
        std::set<std::size_t>& own = letters[key.task];
        for (const auto& [answer, count] : cell.counts) {
            own.insert(answer.first);
            if (answer.second != TrialTally::kNone)
                own.insert(answer.second);
        }
    }
    std::map<std::string, std::size_t> counts;
    for (auto& [task, own] : letters) {
        std::size_t told = 0;
        if (const TrialTally::Alternatives* known = tally.alternatives(task)) {
            own.insert(known->patterns.begin(), known->patterns.end());
            told = known->count;
        }
        counts[task] = std::max(own.size(), told);
    }
    return counts;
}

} // namespace

ExclusionBook::ExclusionBook(std::vector<ExclusionRule> rules)
    : m_after(std::move(rules)) {
}

std::string_view ExclusionBook::own(std::string_view text) {
    const auto found = m_texts.find(text);
    return found != m_texts.end() ? *found : *m_texts.emplace(text).first;
}

bool ExclusionBook::hold(const Trial& trial, const std::vector<ExclusionRule>& ofStudy) {
    Person& person = m_people[own(trial.trial.participant)];
    if (person.trials.empty()) {
        person.rules = ofStudy;
        person.rules.insert(person.rules.end(), m_after.begin(), m_after.end());
    }
    Trial held = trial;
    TalliedTrial& texts = held.trial;
    for (std::string_view* text : {&texts.participant, &texts.task, &texts.condition, &texts.stimulus,
                                   &texts.response, &held.session, &held.excluded, &held.file})
        *text = own(*text);
    person.trials.push_back(held);
    m_names.expectPattern({}, texts.stimulus);
    if (!texts.response.empty())
        m_names.expectPattern({}, texts.response);
    return m_names.names().size() <= TrialTally::kMostNames;
}

bool ExclusionBook::hasLeftOut(std::string_view file, long long row) const {
    const auto found = m_leftOut.find(file);
    return found != m_leftOut.end() && found->second.contains(row);
}

ExclusionLine& ExclusionBook::line(const ExclusionRule& rule, bool isMarked) {
    const auto found = std::ranges::find_if(m_lines, [&](const ExclusionLine& one) {
        return one.participant.empty() && one.rule == rule.id && one.afterTheData == rule.afterTheData &&
               one.kind.has_value() != isMarked &&
               (isMarked || (one.kind == rule.kind && one.value == rule.value));
    });
    if (found != m_lines.end())
        return *found;
    ExclusionLine line;
    line.rule = rule.id;
    if (!isMarked)
        line.kind = rule.kind;
    line.value = rule.value;
    line.afterTheData = rule.afterTheData;
    m_lines.push_back(line);
    return m_lines.back();
}

bool ExclusionBook::finish(TrialTally& tally) {
    if (m_people.empty())
        return true;
    m_all.add(tally);
    for (const auto& [id, person] : m_people) {
        for (const Trial& held : person.trials)
            (void)m_all.add(held.trial);
    }
    if (m_all.names().size() > TrialTally::kMostNames)
        return false;
    const std::map<std::string, std::size_t> answers = answersOf(m_all);
    std::vector<ExclusionLine> own;
    for (const auto& [id, person] : m_people) {
        std::vector<ExcludableTrial> left;
        std::vector<const Trial*> origin;
        std::map<std::string_view, std::size_t> marked;
        for (const Trial& held : person.trials) {
            if (!held.excluded.empty()) {
                ++marked[held.excluded];
                continue;
            }
            const TalliedTrial& trial = held.trial;
            const auto choices = static_cast<double>(answers.at(std::string(trial.task)));
            left.push_back({trial.task, trial.condition, held.session, trial.phase, trial.stimulus,
                            trial.response, trial.responseTime_s, held.deviceFaults, held.framesMissed,
                            held.isScored ? 1.0 / choices : 0.0});
            origin.push_back(&held);
        }
        const auto note = [&](const ExclusionRule& rule, bool isMarked, const ExclusionCount& count) {
            ExclusionLine& all = line(rule, isMarked);
            const auto add = [&](ExclusionLine& sum) {
                sum.trialsBefore += count.trialsBefore;
                sum.trials += count.trials;
                sum.sessions += count.sessions;
                sum.participants += count.participant ? 1 : 0;
                sum.cellsWithoutSpread += count.cellsWithoutSpread;
            };
            add(all);
            if (count.trials == 0 && count.cellsWithoutSpread == 0)
                return;
            ExclusionLine& mine = own.emplace_back();
            mine.rule = all.rule;
            mine.kind = all.kind;
            mine.value = all.value;
            mine.afterTheData = all.afterTheData;
            mine.participant = std::string(id);
            add(mine);
        };
        for (const auto& [rule, trials] : marked) {
            ExclusionRule named;
            named.id = std::string(rule);
            note(named, true, {person.trials.size(), trials, 0, false, 0});
        }
        const Exclusions exclusions = applyExclusions(person.rules, left);
        for (std::size_t i = 0; i < person.rules.size(); ++i)
            note(person.rules[i], false, exclusions.counts[i]);
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (!exclusions.rule[i])
                (void)tally.add(origin[i]->trial);
            else if (!origin[i]->file.empty())
                m_leftOut[std::string(origin[i]->file)].insert(origin[i]->row);
        }
    }
    m_lines.insert(m_lines.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    m_people.clear();
    return true;
}

} // namespace teleta::study
