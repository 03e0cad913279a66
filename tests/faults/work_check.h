// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Runs file_work and looks at what it left. Thread: one.
namespace teleta::test {

inline constexpr const char* kWorks[]{"recording", "study", "output"};

struct WorkResult {
    int exitCode = 0; ///< minus the signal that ended it
    std::string errors;
};

/// environment: of faulty_files.cpp, without FAULTY_ROOT, which is the folder.
[[nodiscard]] WorkResult runWork(const std::string& work, const std::string& folder,
                                 const std::vector<std::pair<std::string, std::string>>& environment);

/// How many of the steps of a work were said to last.
[[nodiscard]] int acksIn(const std::string& folder);

/// What is wrong with the files of a work after so many steps that were said to last: something is missing,
/// or is neither old nor new. Empty: nothing.
[[nodiscard]] std::string wrongWith(const std::string& work, const std::string& folder, int acks);

} // namespace teleta::test
