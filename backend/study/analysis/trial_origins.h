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

/// Which trial of which session a row is.
struct TrialName {
    std::string_view participant;
    std::string_view session;
    Phase phase = Phase::test;
    std::size_t trial = 1;
    std::size_t attempt = 1;
};

/// Where the data of the participants came from, so that different people of one name are not counted as one
/// and no trial counts twice. The files of a study may be many; its store has all of a participant.
/// Memory: by participant and session, and some bits a trial. Thread: one.
class TrialOrigins {
public:
    /// The place where this participant's data were before, when these may not be added to them; otherwise
    /// the participant is of this place.
    [[nodiscard]] std::optional<std::string> takeFromStore(std::string_view participant,
                                                           const std::string& store);
    [[nodiscard]] std::optional<std::string> takeFromFile(std::string_view participant,
                                                          const std::string& file);

    /// False: it was there before.
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
