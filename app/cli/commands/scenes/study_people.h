// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace CLI {
class App;
}

namespace teleta::cli {

/// The parts of `teleta study` that are about people: who takes part, who is behind a pseudonym, and who is
/// deleted. Thread: one.
class StudyPeople {
public:
    void declareList(CLI::App& app);
    void declareEnrol(CLI::App& app);
    void declareDelete(CLI::App& app);

    [[nodiscard]] core::Expected<void> list() const;
    [[nodiscard]] core::Expected<void> enrol() const;
    [[nodiscard]] core::Expected<void> remove() const;

private:
    void declareCommon(CLI::App& app);
    void declareKey(CLI::App& app, const char* about);

    std::string m_folder;
    std::string m_server;
    std::string m_participant;
    std::string m_keyPath;
    std::string m_name;
    std::string m_note;
    std::string m_reason;
    bool m_yes = false;
    bool m_json = false;
};

} // namespace teleta::cli
