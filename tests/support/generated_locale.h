// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/backend/core/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace teleta::test {

/// A locale that need not be installed: compiled from the sources of the C library into a temporary folder.
class GeneratedLocale {
public:
    /// language: "de_DE", "tr_TR".
    explicit GeneratedLocale(const std::string& language)
        : m_name(language + ".UTF-8") {
        const std::string command = "localedef -i " + language + " -f UTF-8 --no-archive '" +
                                    m_folder.path(m_name) + "' > /dev/null 2>&1";
        // It may warn although it has created the locale.
        (void)!std::system(command.c_str());
    }

    /// False where the sources are missing (package locales).
    [[nodiscard]] bool exists() const {
        return std::filesystem::exists(m_folder.path(m_name + "/LC_NUMERIC"));
    }
    [[nodiscard]] const std::string& name() const { return m_name; }
    /// For the variable LOCPATH.
    [[nodiscard]] std::string path() const { return m_folder.path("."); }

private:
    TemporaryFolder m_folder;
    std::string m_name;
};

} // namespace teleta::test
