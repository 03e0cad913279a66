// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace teleta::study {

/// Right answers of 5 by eight participants, patterns P1 to P6: static, then dynamic.
inline constexpr std::array<std::string_view, 8> kDataSetA{"552555443555", "242141533232", "443221542142",
                                                           "443351554443", "432242542352", "442423543552",
                                                           "554534554545", "543332453544"};

/// The same as trials of a study; a wrong answer is the next pattern.
inline TrialTally dataSetATally() {
    TrialTally tally;
    for (std::size_t person = 0; person < kDataSetA.size(); ++person) {
        const std::string id = std::string("s0").append(std::to_string(person + 1));
        for (std::size_t cell = 0; cell < 12; ++cell) {
            const std::string stimulus = std::string("P").append(std::to_string(cell % 6 + 1));
            const std::string other = std::string("P").append(std::to_string((cell + 1) % 6 + 1));
            const int correct = kDataSetA[person][cell] - '0';
            for (int trial = 0; trial < 5; ++trial)
                (void)tally.add({id, "shape", cell < 6 ? "static" : "dynamic", Phase::test, stimulus,
                                 trial < correct ? stimulus : other, std::nullopt});
        }
    }
    return tally;
}

/// The results of this study.
inline TaskResults dataSetA() {
    return studyResults(dataSetATally()).at(0);
}

} // namespace teleta::study
