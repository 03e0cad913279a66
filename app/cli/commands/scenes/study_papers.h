// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace CLI {
class App;
}

namespace teleta::cli {

/// Parts of `teleta study`: the report of one participant, the codebook, and a test of the trigger line.
class StudyPapers {
public:
    void declareReport(CLI::App& app);
    void declareCodebook(CLI::App& app);
    void declareTrigger(CLI::App& app);

    [[nodiscard]] core::Expected<void> writeReport() const;
    [[nodiscard]] core::Expected<void> writeCodebook() const;
    [[nodiscard]] core::Expected<void> testTrigger() const;

private:
    std::string m_study;
    std::string m_server;
    std::string m_participant;
    std::string m_reader = "experimenter";
    std::string m_out;
    std::string m_device;
    bool m_json = false;
};

} // namespace teleta::cli
