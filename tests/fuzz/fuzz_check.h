// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace teleta::fuzz {

/// Ends the program, in every build, when a condition does not hold.
inline void require(bool holds, std::string_view what) {
    if (holds)
        return;
    std::cerr << "broken: " << what << std::endl;
    std::abort();
}

/// The name in errors for an input without a file.
inline constexpr const char* kInput = "input";

/// Checks an error of a reader: it must say what is wrong, and in which file.
inline void requireExplained(const core::Error& error, std::string_view file = kInput) {
    require(!error.message.empty(), "an error has a message");
    require(error.where.file.starts_with(file), "an error names its file");
    require(error.where.line >= 0 && error.where.column >= 0, "an error has a place or none");
    require(error.kind == core::ErrorKind::badInput || error.kind == core::ErrorKind::refused,
            "what is wrong with an input is the input's fault");
}

} // namespace teleta::fuzz
