// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct PipeCloser {
    void operator()(FILE* pipe) const { pclose(pipe); }
};

/// What bash offers for the last of these words, with the program of this build as teleta.
std::vector<std::string> offered(const std::vector<std::string>& words) {
    std::string line =
        "bash --norc -c 'PATH=\"$(dirname \"" TELETA_PROGRAM "\"):$PATH\"; source \"" TELETA_SOURCE_DIR
        "/packaging/completion/teleta\"; COMP_WORDS=(";
    for (const std::string& word : words)
        line += '"' + word + "\" ";
    line += "); COMP_CWORD=" + std::to_string(words.size() - 1) +
            "; _teleta 2>/dev/null; printf \"%s\\n\" \"${COMPREPLY[@]}\"'";
    const std::unique_ptr<FILE, PipeCloser> pipe(popen(line.c_str(), "r"));
    std::vector<std::string> found;
    char buffer[512];
    while (pipe != nullptr && std::fgets(buffer, sizeof buffer, pipe.get()) != nullptr) {
        std::string text(buffer);
        text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
        if (!text.empty())
            found.push_back(text);
    }
    return found;
}

using Words = std::vector<std::string>;

} // namespace

TEST(Completion, offersTheCommandsThatBeginSo) {
    EXPECT_EQ(offered({"teleta", "sti"}), Words{"stiffness"});
    EXPECT_EQ(offered({"teleta", "pattern", "con"}), Words{"convert"});
    EXPECT_EQ(offered({"teleta", "study", "re"}), (Words{"rehearse", "resume"}));
}

TEST(Completion, offersTheOptionsOfTheCommandAndTheValuesOfAnOption) {
    EXPECT_EQ(offered({"teleta", "stiffness", "log.csv", "--con"}), Words{"--contact-distance"});
    EXPECT_EQ(offered({"teleta", "stiffness", "--method", ""}), (Words{"two-point", "regression"}));
}

TEST(Completion, offersScenesPatternsAndLaddersByName) {
    EXPECT_EQ(offered({"teleta", "simulate", "servo-bent-bar-"}), Words{"servo-bent-bar-baseline"});
    EXPECT_EQ(offered({"teleta", "pattern", "show", "shape.A.s"}), Words{"shape.A.static"});
    EXPECT_EQ(offered({"teleta", "tradeoff", "contour", "stif"}), Words{"stiffness"});
}

TEST(Completion, leavesFileNamesToTheShell) {
    EXPECT_EQ(offered({"teleta", "features", "fra"}), Words{});
}
