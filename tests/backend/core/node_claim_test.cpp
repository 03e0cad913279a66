// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

using teleta::core::NodeClaim;
using teleta::test::TemporaryFolder;

namespace {

std::string makeNode(const TemporaryFolder& folder) {
    const std::string path = folder.path("node");
    std::ofstream(path) << "node";
    return path;
}

} // namespace

TEST(NodeClaim, isHeldOnceAndFreeAgainWhenItEnds) {
    const TemporaryFolder folder;
    const std::string path = makeNode(folder);
    auto first = NodeClaim::take(path);
    ASSERT_TRUE(first && *first);
    auto second = NodeClaim::take(path);
    ASSERT_TRUE(second);
    EXPECT_FALSE(*second);
    // It moves with its holder.
    NodeClaim moved = std::move(**first);
    first->reset();
    second = NodeClaim::take(path);
    EXPECT_FALSE(*second);
    { const NodeClaim last = std::move(moved); }
    second = NodeClaim::take(path);
    EXPECT_TRUE(*second);
}

TEST(NodeClaim, endsWithTheProgramThatIsKilled) {
    const TemporaryFolder folder;
    const std::string path = makeNode(folder);
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        const auto claim = NodeClaim::take(path);
        const char got = claim && *claim ? 'y' : 'n';
        (void)!write(ready[1], &got, 1);
        pause();
        _exit(0);
    }
    char got = 0;
    ASSERT_EQ(read(ready[0], &got, 1), 1);
    EXPECT_EQ(got, 'y');
    EXPECT_FALSE(*NodeClaim::take(path)) << "another program has it";
    kill(child, SIGKILL);
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    EXPECT_TRUE(*NodeClaim::take(path));
    close(ready[0]);
    close(ready[1]);
}

TEST(NodeClaim, needsANode) {
    const auto claim = NodeClaim::take("/nowhere/node");
    ASSERT_FALSE(claim);
    EXPECT_EQ(claim.error().kind, teleta::core::ErrorKind::ioFailed);
}
