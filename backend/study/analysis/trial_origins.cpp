// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trial_origins.h"

namespace teleta::study {

namespace {

/// A larger trial number is a damaged row or from another program; it costs more memory.
constexpr std::size_t kMostInBits = 65'536;

} // namespace

std::optional<std::string> TrialOrigins::takeFromStore(std::string_view participant,
                                                       const std::string& store) {
    const auto [place, isNew] = m_places.try_emplace(std::string(participant), Place{store, true});
    return isNew ? std::nullopt : std::optional(place->second.name);
}

std::optional<std::string> TrialOrigins::takeFromFile(std::string_view participant, const std::string& file) {
    const auto found = m_places.find(participant);
    if (found == m_places.end())
        m_places.emplace(std::string(participant), Place{file, false});
    return found != m_places.end() && found->second.isStore ? std::optional(found->second.name)
                                                            : std::nullopt;
}

bool TrialOrigins::addTrial(const TrialName& name) {
    if (m_last == nullptr || m_last->first.first != name.participant || m_last->first.second != name.session)
        m_last = &*m_sessions.try_emplace({std::string(name.participant), std::string(name.session)}).first;
    Session& session = m_last->second;
    const bool isTest = name.phase == Phase::test;
    if (name.attempt != 1 || name.trial >= kMostInBits)
        return session.others.insert({{name.trial, name.attempt}, isTest}).second;
    std::vector<bool>& first = session.first[isTest ? 1 : 0];
    if (name.trial >= first.size())
        first.resize(name.trial + 1);
    const bool isNew = !first[name.trial];
    first[name.trial] = true;
    return isNew;
}

} // namespace teleta::study
