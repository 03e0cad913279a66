// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::study {

/// Identifies the trial of a row.
struct TrialName {
    std::string_view participant;
    std::string_view session;
    Phase phase = Phase::test;
    std::size_t trial = 1;
    std::size_t attempt = 1;
};

/// Records where participants' data came from, so that different people with the same name are not merged and
/// no trial counts twice. A study may have many files; a store has all data of a participant. Memory: per
/// participant and session, and a few bits per trial. Thread: one.
class TrialOrigins {
public:
    /// Assigns the participant to this place. Returns the earlier place if data of both must not be combined.
    [[nodiscard]] std::optional<std::string> takeFromStore(std::string_view participant,
                                                           const std::string& store);
    [[nodiscard]] std::optional<std::string> takeFromFile(std::string_view participant,
                                                          const std::string& file);

    /// False: it was added before.
    [[nodiscard]] bool addTrial(const TrialName& name);

private:
    struct Place {
        std::string name;
        bool isStore = false;
    };
    struct Session {
        /// First attempts by trial, of practice and test.
        std::array<std::vector<bool>, 2> first;
        std::set<std::pair<std::pair<std::size_t, std::size_t>, bool>> others;
    };
    using SessionKey = std::pair<std::string, std::string>;

    std::map<std::string, Place, std::less<>> m_places;
    std::map<SessionKey, Session> m_sessions;
    std::pair<const SessionKey, Session>* m_last = nullptr; ///< rows of a file come session by session
};

} // namespace teleta::study
