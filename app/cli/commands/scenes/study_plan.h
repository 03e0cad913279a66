// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace teleta::cli {

/// `teleta study plan`: how many participants a test needs.
class StudyPlan {
public:
    void declare(CLI::App& app);
    [[nodiscard]] core::Expected<void> run() const;

private:
    std::string m_protocolPath;
    std::string m_participants = "6:30:2";
    std::string m_truth;
    std::string m_test;
    double m_width = 0.1;      ///< of the interval of a threshold to each side, on the scale
    std::size_t m_trials = 0;  ///< of a track; 0: the protocol says
    std::size_t m_studies = 0; ///< 0: as many as usual for the test
    std::uint64_t m_seed = 1;
    double m_target = 0.9;
    std::string m_outPath;
    bool m_json = false;
};

} // namespace teleta::cli
