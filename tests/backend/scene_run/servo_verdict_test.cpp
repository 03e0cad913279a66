// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace teleta::scene_run {
namespace {

/// The verdict of a shipped scene with these parts of its file replaced.
RunVerdict verdictOf(const std::string& name, double duration_s,
                     const std::vector<std::pair<std::string, std::string>>& replacements = {},
                     const std::string& added = {}) {
    const std::string path = TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml";
    std::string text = test::readAll(path) + added;
    for (const auto& [from, to] : replacements) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        if (at != std::string::npos)
            text.replace(at, from.size(), to);
    }
    const auto scene = scene::parseScene(text, path);
    EXPECT_TRUE(scene) << describe(scene.error());
    RunOptions options;
    options.duration_s = duration_s;
    const auto summary = runScene(scene.value(), options);
    EXPECT_TRUE(summary) << describe(summary.error());
    EXPECT_EQ(summary->toJson()["verdict"]["result"],
              summary->verdict->completed ? "completed" : "not_completed");
    return summary->verdict.value();
}

using servo::NotCompleted;

void expectNotCompleted(const RunVerdict& verdict, NotCompleted reason, const std::string& phase) {
    EXPECT_FALSE(verdict.completed);
    EXPECT_EQ(verdict.reason, reason) << toString(verdict.reason);
    EXPECT_STREQ(servo::toString(verdict.phase), phase.c_str());
}

} // namespace

TEST(ServoVerdict, isCompletedWhereTheLastingTaskIsAtWork) {
    for (const auto& [scene, phase] : {std::pair("servo-point", "point_following"),
                                       {"servo-roll", "roll"},
                                       {"servo-comanipulation", "comanipulation"},
                                       {"servo-bent-bar", "explore"}}) {
        const RunVerdict verdict = verdictOf(scene, 6.0);
        EXPECT_TRUE(verdict.completed) << scene << ' ' << toString(verdict.reason);
        EXPECT_STREQ(servo::toString(verdict.phase), phase);
    }
}

TEST(ServoVerdict, saysThatTheObjectIsOutOfReachOfTheRun) {
    expectNotCompleted(verdictOf("servo-bent-bar", 3.0, {{"gap_m = 0.004", "gap_m = 3.0"}}),
                       NotCompleted::neverInContact, "free_motion");
}

// Readings of 0.2 N out of noise look like a contact, so the array stops in the air.
TEST(ServoVerdict, isNotDeceivedByNoiseThatLooksLikeContact) {
    expectNotCompleted(
        verdictOf("servo-bent-bar", 10.0, {}, "\n[[effects]]\nname = \"noise\"\nwhy = \"-\"\nsd_N = 0.06\n"),
        NotCompleted::neverInContact, "align");
}

TEST(ServoVerdict, saysThatTheArrayDoesNotAlign) {
    expectNotCompleted(verdictOf("servo-bent-bar", 10.0, {},
                                 "\n[[effects]]\nname = \"latency\"\nwhy = \"-\"\ndelay_s = 0.15\n"),
                       NotCompleted::notAligned, "edge_control");
    expectNotCompleted(verdictOf("servo-bent-bar", 10.0, {{"radius_m = 0.003", "radius_m = 0.0015"}}),
                       NotCompleted::notAligned, "edge_control");
}

// The bar ends 30 mm after the start; the array slides off it and searches in vain.
TEST(ServoVerdict, saysThatTheContactWasLost) {
    const RunVerdict verdict = verdictOf("servo-straight-bar", 60.0, {{"ahead_m = 0.25", "ahead_m = 0.03"}});
    EXPECT_FALSE(verdict.completed);
    EXPECT_EQ(verdict.reason, NotCompleted::lost) << toString(verdict.reason);
}

// At 50 mm/s the arm is stretched before 30 s are over.
TEST(ServoVerdict, saysWhichLimitStallsAnArmThatReachesForNothing) {
    const RunVerdict verdict = verdictOf(
        "servo-bent-bar", 30.0,
        {{"gap_m = 0.004", "gap_m = 3.0"}, {"approach_m_per_s = 0.006", "approach_m_per_s = 0.05"}});
    expectNotCompleted(verdict, NotCompleted::stalled, "free_motion");
    EXPECT_TRUE(verdict.limit);
}

TEST(ServoVerdict, isExpectedWhereTheSceneSaysSo) {
    const std::string reach = "gap_m = 3.0";
    EXPECT_FALSE(verdictOf("servo-bent-bar", 0.5, {{"gap_m = 0.004", reach}}).expected);
    EXPECT_TRUE(verdictOf("servo-bent-bar", 0.5,
                          {{"gap_m = 0.004", reach}, {"[task]\n", "[task]\nexpect = \"not_completed\"\n"}})
                    .expected);
}

} // namespace teleta::scene_run
