// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/fuzz_targets.h"

#include <map>
#include <string>
#include <vector>

namespace teleta::fuzz {

using Target = bool (*)(Bytes);

/// All of them by the names that they have in CMakeLists.txt.
[[nodiscard]] const std::map<std::string, Target>& targets();

/// A kept file for one of them.
struct Input {
    std::string target;
    std::string path;
};

/// kind: "seed" or "regression", as in TELETA_FUZZ_INPUTS.
[[nodiscard]] std::vector<Input> inputs(const std::string& kind);

/// For a test of this input.
[[nodiscard]] std::string nameOf(const Input& input);

} // namespace teleta::fuzz
