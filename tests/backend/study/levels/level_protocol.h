// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <string>

namespace teleta::study {

/// A protocol with one task that has levels. task: its keys besides id and condition; settings: further keys
/// of the protocol.
inline std::string levelProtocolText(const std::string& task, std::size_t practice = 1, std::size_t test = 1,
                                     double stimulus_s = 0.5) {
    return "name = \"levels\"\nstimulus_s = " + std::to_string(stimulus_s) +
           "\nresponse_limit_s = 5.0\nresponse_window = \"from_end\"\norder = \"full_random\"\n"
           "[practice]\nrepetitions = " +
           std::to_string(practice) + "\n[test]\nrepetitions = " + std::to_string(test) +
           "\n[masking_noise]\ncolour = \"none\"\n[[task]]\nid = \"detect\"\ncondition = [{ id = \"rest\" "
           "}]\n" +
           task;
}

inline const std::string kStimulus = "stimulus = { file = \"burst.json\", vary = \"intensity\" }\n";
inline const std::string kLogLevels =
    "level = { scale = \"log10\", lowest = 0.01, highest = 1.0, reference = 0.0 }\n";
inline const std::string kTwoTracks =
    "track = [{ id = \"t1\", tactors = [1] }, { id = \"t2\", tactors = [2] }]\n";

inline Protocol levelProtocol(const std::string& task, std::size_t practice = 1, std::size_t test = 1,
                              double stimulus_s = 0.5) {
    return parseProtocol(levelProtocolText(task, practice, test, stimulus_s), "levels.toml").value();
}

} // namespace teleta::study
