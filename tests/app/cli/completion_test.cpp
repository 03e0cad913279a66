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

using Words = std::vector<std::string>;

/// What a shell prints for a script in which the program of this build is teleta.
Words printed(const std::string& shell, const std::string& script) {
    const std::string line =
        "PATH=\"$(dirname '" TELETA_PROGRAM "'):$PATH\" " + shell + " -c '" + script + "' 2>&1";
    const std::unique_ptr<FILE, PipeCloser> pipe(popen(line.c_str(), "r"));
    Words found;
    char buffer[512];
    while (pipe != nullptr && std::fgets(buffer, sizeof buffer, pipe.get()) != nullptr) {
        std::string text(buffer);
        text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
        if (!text.empty())
            found.push_back(text);
    }
    return found;
}

std::string quoted(const Words& words) {
    std::string line;
    for (const std::string& word : words)
        line += '"' + word + "\" ";
    return line;
}

/// What the two shells offer for the last of these words: the same.
Words offered(const Words& words) {
    const Words byBash =
        printed("bash --norc", "source \"" TELETA_SOURCE_DIR "/packaging/completion/teleta\"; COMP_WORDS=(" +
                                   quoted(words) + "); COMP_CWORD=" + std::to_string(words.size() - 1) +
                                   "; _teleta; printf \"%s\\n\" \"${COMPREPLY[@]}\"");
    // Its own compadd works only while somebody types.
    const Words byZsh = printed(
        "zsh -f", "fpath=(\"" TELETA_SOURCE_DIR "/packaging/completion\" $fpath); autoload -U _teleta; "
                  "compadd() { print -l -- \"${(@P)2}\" }; _files() { }; words=(" +
                      quoted(words) + "); CURRENT=" + std::to_string(words.size()) + "; _teleta");
    EXPECT_EQ(byBash, byZsh);
    return byBash;
}

} // namespace

TEST(Completion, offersTheCommandsThatBeginSo) {
    EXPECT_EQ(offered({"teleta", "sti"}), Words{"stiffness"});
    EXPECT_EQ(offered({"teleta", "pattern", "con"}), Words{"convert"});
    EXPECT_EQ(offered({"teleta", "study", "re"}), (Words{"rehearse", "resume", "report"}));
}

TEST(Completion, offersTheOptionsOfTheCommandAndTheValuesOfAnOption) {
    EXPECT_EQ(offered({"teleta", "stiffness", "log.csv", "--link-h"}), Words{"--link-half-thickness"});
    EXPECT_EQ(offered({"teleta", "stiffness", "--method", ""}), (Words{"two-point", "regression"}));
}

TEST(Completion, offersScenesPatternsAndLaddersByName) {
    EXPECT_EQ(offered({"teleta", "simulate", "servo-bent-bar-"}), Words{"servo-bent-bar-baseline"});
    EXPECT_EQ(offered({"teleta", "pattern", "show", "shape.A.s"}), Words{"shape.A.static"});
    EXPECT_EQ(offered({"teleta", "tradeoff", "contour", "stif"}), Words{"stiffness"});
}

TEST(Completion, offersTheStreamsOfTheRecordingThatIsNamed) {
    const teleta::test::TemporaryFolder folder;
    ASSERT_EQ(
        teleta::test::run({"simulate", "teleta-touch", "--duration", "0.2", "--out", folder.path("run")})
            .exitCode,
        0);
    const std::string recording = folder.path("run/recording.teleta");
    EXPECT_EQ(offered({"teleta", "replay", recording, "--stream", "fra"}), Words{"frames"});
    EXPECT_EQ(offered({"teleta", "replay", "missing.teleta", "--stream", ""}), Words{});
}

TEST(Completion, offersShortAndLongOptions) {
    const Words all = offered({"teleta", "simulate", "-"});
    for (const char* name : {"-o", "--out", "-s", "--seed", "-d", "--duration", "-j", "--json"})
        EXPECT_NE(std::find(all.begin(), all.end(), name), all.end()) << name;
}

TEST(Completion, leavesFileNamesToTheShell) {
    EXPECT_EQ(offered({"teleta", "features", "fra"}), Words{});
}
