// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/study_scene.h"

#include <gtest/gtest.h>

namespace teleta::study {

namespace {

constexpr const char* kScene = R"(name = "n"
description = "d"
duration_s = 100.0
rate_Hz = 200.0
[study]
protocol = "paper"
participants = 2
)";

core::Expected<StudyScene> read(const std::string& more) {
    return parseStudyScene(kScene + more, "scene.toml");
}

} // namespace

TEST(StudyScene, hasTheEffectsThatItListsAndNoOthers) {
    const auto plain = read("");
    ASSERT_TRUE(plain) << core::describe(plain.error());
    EXPECT_EQ(plain->participants, 2U);
    EXPECT_EQ(plain->protocol.testTrials(), 110U);
    EXPECT_TRUE(plain->effects.empty());
    const StudyTask& shape = plain->protocol.tasks[0];
    const SimulatedParticipant perfect = plain->participantFor(shape, "static");
    EXPECT_FALSE(perfect.matrix);
    EXPECT_EQ(perfect.lapses, 0.0);
    EXPECT_EQ(perfect.medianResponse_s, plain->protocol.stimulus_s);
    EXPECT_EQ(perfect.logSpread, 0.0);

    const auto whole = read(R"(
[[effects]]
name = "lapses"
why = "w"
probability = 0.1
[[effects]]
name = "confusion"
why = "w"
matrix = "paper"
[[effects]]
name = "reaction_time"
why = "w"
median_s = 2.5
log_spread = 0.3
[[effects]]
name = "motor_lag"
why = "w"
rise_s = 0.05
fall_s = 0.07
[[effects]]
name = "dead_zone"
why = "w"
start_share = 0.33
[[effects]]
name = "dropped_frames"
why = "lost"
share = 0.01
)");
    ASSERT_TRUE(whole) << core::describe(whole.error());
    ASSERT_EQ(whole->effects.size(), 6U);
    EXPECT_EQ(whole->effects[0].name, "lapses");
    EXPECT_EQ(whole->effects[5].why, "lost");
    const SimulatedParticipant person = whole->participantFor(shape, "static");
    EXPECT_EQ(person.matrix, paperMatrix("shape", "static"));
    EXPECT_EQ(person.lapses, 0.1);
    EXPECT_EQ(person.medianResponse_s, 2.5);
    EXPECT_EQ(person.logSpread, 0.3);
    EXPECT_EQ(whole->motorLag->fall_s, 0.07);
    EXPECT_EQ(whole->deadZone, 0.33);
    EXPECT_EQ(whole->droppedFrames, 0.01);
}

TEST(StudyScene, withoutAnEffectItIsTheSceneThatDoesNotListIt) {
    const std::string lapses = "[[effects]]\nname = \"lapses\"\nwhy = \"w\"\nprobability = 0.1\n";
    const std::string frames = "[[effects]]\nname = \"dropped_frames\"\nwhy = \"w\"\nshare = 0.01\n";
    const StudyScene both = read(lapses + frames).value();
    const StudyScene one = both.without("lapses");
    EXPECT_FALSE(one.lapses);
    EXPECT_EQ(one.droppedFrames, 0.01);
    ASSERT_EQ(one.effects.size(), 1U);
    EXPECT_EQ(one.effects[0].name, "dropped_frames");
    const StudyScene none = one.without("dropped_frames").without("confusion");
    EXPECT_FALSE(none.droppedFrames);
    EXPECT_TRUE(none.effects.empty());
    EXPECT_EQ(both.without("of no study").effects.size(), 2U);
}

TEST(StudyScene, saysWhereItIsWrong) {
    const auto place = [](const std::string& more) {
        const auto scene = read(more);
        return scene ? std::string("none") : core::describe(scene.error());
    };
    const std::string lapses = "[[effects]]\nname = \"lapses\"\nwhy = \"w\"\n";
    EXPECT_NE(place(lapses + "probability = 1.5\n").find("scene.toml:11:"), std::string::npos);
    EXPECT_NE(place(lapses).find("scene.toml:8:"), std::string::npos) << place(lapses);
    EXPECT_NE(place(lapses + "probability = 0.1\n" + lapses + "probability = 0.1\n").find("scene.toml:13:"),
              std::string::npos);
    EXPECT_NE(place("[[effects]]\nname = \"drift\"\nwhy = \"w\"\n").find("scene.toml:9:"), std::string::npos);
    EXPECT_NE(place("[[effects]]\nname = \"lapses\"\nwhy = \"w\"\nprobability = 0.1\nodd = 1\n")
                  .find("scene.toml:12:"),
              std::string::npos);
}

TEST(StudyScene, isToldFromOtherScenesByItsTable) {
    EXPECT_TRUE(isStudyScene(kScene));
    EXPECT_FALSE(isStudyScene("name = \"x\"\n[sensor]\nrows = 2\n"));
    EXPECT_FALSE(isStudyScene("[study"));
}

} // namespace teleta::study
