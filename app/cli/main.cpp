// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program_part.h"
#include "backend/core/part_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <unistd.h>

// The program loads no library of its own, so that it is quick to start: what it does is in one of two
// modules.

namespace {

/// The commands of teleta_everyday; everyday_commands.h has the same.
constexpr std::array<std::string_view, 5> kEveryday{"features", "contacts", "gains", "stiffness", "contour"};

constexpr std::string_view kVersion = "teleta " TELETA_VERSION "\n";

bool printedVersion() {
    return write(STDOUT_FILENO, kVersion.data(), kVersion.size()) == static_cast<ssize_t>(kVersion.size());
}

} // namespace

int main(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    // Where it cannot be written, the whole program says why.
    if (argc == 2 && first == "--version" && printedVersion())
        return 0;
    const bool everyday = std::ranges::find(kEveryday, first) != kEveryday.end();
    std::string reason;
    const void* const found =
        teleta::core::findPart(everyday ? "teleta_everyday" : "teleta_commands", reason);
    if (found == nullptr) {
        std::fprintf(
            stderr,
            "teleta: a part of the program cannot be loaded: %s; expected a complete installation of "
            "the program\n",
            reason.c_str());
        return 1;
    }
    return static_cast<const teleta::cli::ProgramPart*>(found)->run(argc, argv);
}
