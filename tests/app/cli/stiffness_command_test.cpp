// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/backend/stiffness/disturbed_touch.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

using nlohmann::ordered_json;
using teleta::stiffness::JointSample;
using teleta::stiffness::test::SimulatedTouch;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

std::string csvOf(const std::vector<JointSample>& log) {
    std::string text = "time_s,joint_angle_rad,joint_torque_nm\n";
    char line[128];
    for (const JointSample& sample : log) {
        std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", sample.time_s, sample.angle_rad,
                      sample.torque_Nm);
        text += line;
    }
    return text;
}

class StiffnessCommand : public testing::Test {
protected:
    ProgramResult touch(const std::string& log,
                        std::vector<std::string> options = {"--contact-distance", "0.17"}) {
        options.insert(options.begin(), {"stiffness", m_folder.write("touch.csv", log)});
        return run(options);
    }

    ordered_json json(const std::string& log,
                      std::vector<std::string> options = {"--contact-distance", "0.17"}) {
        options.push_back("--json");
        const ProgramResult result = touch(log, options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return ordered_json::parse(result.out, nullptr, false);
    }

    void expectError(const ProgramResult& result, int exitCode, const std::string& text) {
        EXPECT_EQ(result.exitCode, exitCode) << result.err;
        EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }

    /// A clean touch: link of the paper and an object in series, 0.17 m from the joint.
    std::string cleanTouch(double object_NPerM) {
        SimulatedTouch world;
        world.objectCompliance_mPerN = 1.0 / object_NPerM;
        world.torqueNoise_Nm = 0.0;
        return csvOf(world.record(1));
    }

    TemporaryFolder m_folder;
};

const std::string kHeader = "time_s,joint_angle_rad,joint_torque_nm\n";
// The paper's wood: dTheta 3.84e-4 rad, dTau 2.92e-2 Nm, P_C 0.1755 m; k_i 2469.0 and k_o 8562.9 N/m (Table
// 1, 2).
const std::string kPaperWood = kHeader + "0,0.1,0\n1,0.2,0.0205\n2,0.200384,0.0497\n";

} // namespace

TEST_F(StiffnessCommand, reproducesThePapersWoodFromTwoSamples) {
    const ordered_json answer = json(kPaperWood, {"--contact-distance", "0.1755", "--method", "two-point"});
    EXPECT_EQ(answer["method"], "two-point");
    EXPECT_EQ(answer["samples"], 2);
    EXPECT_NEAR(answer["delta_theta_rad"].get<double>(), 3.84e-4, 1e-12);
    EXPECT_NEAR(answer["delta_torque_nm"].get<double>(), 2.92e-2, 1e-12);
    EXPECT_NEAR(answer["total_stiffness_n_per_m"].get<double>(), 2469.0, 0.002 * 2469.0);
    EXPECT_NEAR(answer["object_stiffness_n_per_m"].get<double>(), 8562.9, 0.002 * 8562.9);
    EXPECT_EQ(answer["material"], "wood");
    EXPECT_EQ(answer["safe"], false);
    EXPECT_EQ(answer["level"], 4);
}

TEST_F(StiffnessCommand, jsonHasTheKeysOfTheFormatInTheirOrder) {
    const ordered_json answer = json(cleanTouch(282.0));
    std::vector<std::string> keys;
    for (const auto& [key, value] : answer.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"method",
                                              "samples",
                                              "delta_theta_rad",
                                              "delta_torque_nm",
                                              "total_stiffness_n_per_m",
                                              "total_stiffness_se",
                                              "object_stiffness_n_per_m",
                                              "object_stiffness_lower_95",
                                              "object_stiffness_upper_95",
                                              "material",
                                              "safe",
                                              "level",
                                              "reliable",
                                              "warnings",
                                              "error_budget",
                                              "effective_samples",
                                              "torque_reference_nm",
                                              "torque_drift_nm_per_s",
                                              "tangent_stiffness_n_per_m",
                                              "secant_stiffness_n_per_m",
                                              "standard_linear_solid"}));
    EXPECT_EQ(answer["reliable"], true);
    EXPECT_EQ(answer["warnings"], ordered_json::array());
    EXPECT_EQ(answer["error_budget"][0]["source"], "contact_distance");
}

TEST_F(StiffnessCommand, everyMaterialIsNamedAndHasItsLevel) {
    struct Case {
        double object_NPerM;
        const char* material;
        bool safe;
    };
    int level = 0;
    for (const Case& one :
         {Case{282.0, "sponge", true}, Case{1325.9, "rubber_sponge", true}, Case{7223.9, "rubber", false},
          Case{8562.9, "wood", false}, Case{1e5, "metal", false}}) {
        const ordered_json answer = json(cleanTouch(one.object_NPerM));
        EXPECT_EQ(answer["method"], "regression") << "is the default";
        EXPECT_NEAR(answer["object_stiffness_n_per_m"].get<double>(), one.object_NPerM,
                    1e-6 * one.object_NPerM);
        EXPECT_EQ(answer["material"], one.material);
        EXPECT_EQ(answer["safe"], one.safe);
        EXPECT_EQ(answer["level"], ++level);
    }
}

TEST_F(StiffnessCommand, noisyTouchHasAnIntervalAroundItsValue) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 8562.9;
    const ordered_json answer = json(csvOf(world.record(4)));
    const double value = answer["object_stiffness_n_per_m"];
    EXPECT_NEAR(value, 8562.9, 856.29);
    EXPECT_LT(answer["object_stiffness_lower_95"].get<double>(), value);
    EXPECT_GT(answer["object_stiffness_upper_95"].get<double>(), value);
    EXPECT_GT(answer["total_stiffness_se"].get<double>(), 0.0);
    EXPECT_NEAR(answer["samples"].get<double>(), 84.0, 4.0);
}

TEST_F(StiffnessCommand, aRigidObjectHasOnlyALowerBound) {
    const SimulatedTouch world; // rigid
    const std::string log = csvOf(world.record(4));
    const ordered_json answer = json(log);
    EXPECT_TRUE(answer["object_stiffness_n_per_m"].is_null());
    EXPECT_TRUE(answer["object_stiffness_upper_95"].is_null());
    EXPECT_GT(answer["object_stiffness_lower_95"].get<double>(), 50000.0);
    EXPECT_NEAR(answer["total_stiffness_n_per_m"].get<double>(), 3468.6, 0.03 * 3468.6);
    EXPECT_EQ(answer["material"], "metal");
    const ProgramResult table = touch(log);
    EXPECT_EQ(table.exitCode, 0);
    EXPECT_NE(table.out.find("at least"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("danger"), std::string::npos) << table.out;
}

TEST_F(StiffnessCommand, anAngleThatDoesNotChangeIsARigidBoundWithAWarning) {
    std::string log = kHeader;
    for (int i = 0; i <= 50; ++i)
        log += std::to_string(i) + ",0.5," + std::to_string(0.001 * i) + '\n';
    const ProgramResult result = touch(log, {"--contact-distance", "0.17", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    EXPECT_TRUE(answer["total_stiffness_n_per_m"].is_null());
    EXPECT_TRUE(answer["object_stiffness_n_per_m"].is_null());
    EXPECT_NEAR(answer["object_stiffness_lower_95"].get<double>(), 3468.6, 1e-6);
    EXPECT_EQ(answer["material"], "metal");
    EXPECT_NE(result.err.find("stiffer than the link"), std::string::npos) << result.err;
}

TEST_F(StiffnessCommand, twoSamplesHaveAValueButNoUncertainty) {
    const ordered_json answer = json(kPaperWood, {"--contact-distance", "0.1755", "--method", "two-point"});
    EXPECT_FALSE(answer["object_stiffness_n_per_m"].is_null());
    EXPECT_TRUE(answer["total_stiffness_se"].is_null());
    EXPECT_TRUE(answer["object_stiffness_lower_95"].is_null());
}

TEST_F(StiffnessCommand, optionsReachTheEstimator) {
    // Clean touch of 1325.9 N/m: k_i is 959.23 N/m at 0.17 m; at 0.34 m the same log means a quarter.
    const std::string log = cleanTouch(1325.9);
    const double total = json(log)["total_stiffness_n_per_m"];
    EXPECT_NEAR(total, 1.0 / (1.0 / 1325.9 + 1.0 / 3468.6), 1e-6);
    EXPECT_NEAR(json(log, {"--contact-distance", "0.34"})["total_stiffness_n_per_m"].get<double>(),
                total / 4.0, 1e-6);
    EXPECT_NEAR(
        json(log, {"--contact-distance", "0.17", "--link-stiffness", "10000"})["object_stiffness_n_per_m"]
            .get<double>(),
        1.0 / (1.0 / total - 1e-4), 1e-5);
    const ordered_json thick = json(log, {"--contact-distance", "0.17", "--link-half-thickness", "0.03"});
    EXPECT_EQ(thick, json(log)) << "the thickness cancels";
    const ordered_json narrow = json(log, {"--contact-distance", "0.17", "--window", "0.03,0.04"});
    EXPECT_NEAR(narrow["delta_torque_nm"].get<double>(), 0.01, 2e-4);
}

TEST_F(StiffnessCommand, standardErrorsOfDistanceAndLinkWidenTheInterval) {
    const std::string log = cleanTouch(1325.9);
    const auto width = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"--contact-distance", "0.17"});
        const ordered_json answer = json(log, options);
        return answer["object_stiffness_upper_95"].get<double>() -
               answer["object_stiffness_lower_95"].get<double>();
    };
    EXPECT_NEAR(width({"--contact-distance-se", "0"}), 0.0, 1e-6);
    const double usual = width({});
    EXPECT_GT(usual, 1.0);
    // 2 1.96 k_o^2 c_i 2 dP / P with k_o / k_i = 1.3823.
    EXPECT_NEAR(width({"--contact-distance-se", "0.001"}), 2 * 1.96 * 1325.9 * 1.3823 * 2 * 0.001 / 0.17,
                1.0);
    // 2 1.96 k_o^2 100 / k_ri^2, and the distance.
    EXPECT_NEAR(width({"--link-stiffness-se", "100"}),
                std::hypot(2 * 1.96 * std::pow(1325.9 / 3468.6, 2) * 100, usual), 0.5);
}

TEST_F(StiffnessCommand, theTorqueReferenceIsThatOfTheFreeMotionUnlessToldOtherwise) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 282.0;
    world.torqueReference_Nm = 0.03;
    world.freeMotion_s = 1.0;
    const std::string log = csvOf(world.record(2));
    const ordered_json fromStart = json(log);
    EXPECT_NEAR(fromStart["object_stiffness_n_per_m"].get<double>(), 282.0, 5.0);
    EXPECT_NEAR(fromStart["torque_reference_nm"].get<double>(), 0.03, 1e-4);
    EXPECT_EQ(fromStart["warnings"], ordered_json::array({"torque_offset"}));
    EXPECT_EQ(json(log, {"--contact-distance", "0.17", "--torque-reference", "start"}), fromStart);
    const ordered_json told = json(log, {"--contact-distance", "0.17", "--torque-reference", "0.03"});
    EXPECT_EQ(told["torque_reference_nm"], 0.03);
    EXPECT_EQ(told["warnings"], ordered_json::array());
}

TEST_F(StiffnessCommand, anUnreliableAnswerNamesNoMaterialAndSaysWhy) {
    using teleta::stiffness::test::Disturbance;
    const std::string log = csvOf(teleta::stiffness::test::disturbedTouch(Disturbance::standardSolid, 5).log);
    const ordered_json answer = json(log);
    EXPECT_EQ(answer["reliable"], false);
    EXPECT_TRUE(answer["material"].is_null());
    EXPECT_TRUE(answer["safe"].is_null());
    const ProgramResult table = touch(log);
    EXPECT_NE(table.out.find("cannot tell"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("how quickly the object is pressed"), std::string::npos) << table.out;
    EXPECT_EQ(table.out.find("danger"), std::string::npos) << table.out;
}

TEST_F(StiffnessCommand, columnsMayStandInAnyOrderAmongOthers) {
    const std::string log = "joint_torque_nm,note,joint_angle_rad,time_s\n0,7,0.1,0\n0.0205,7,0.2,1\n"
                            "0.0497,7,0.200384,2\n";
    const ordered_json answer = json(log, {"--contact-distance", "0.1755", "--method", "two-point"});
    EXPECT_NEAR(answer["total_stiffness_n_per_m"].get<double>(), 2469.0, 0.002 * 2469.0);
}

TEST_F(StiffnessCommand, refusesWithAReasonAndExitCodeOne) {
    const std::vector<std::string> options{"--contact-distance", "0.17", "--json"};
    expectError(touch(kHeader + "0,0,0\n1,0.1,0.01\n", options), 1, "no sample reaches the torque window");
    expectError(touch(kHeader + "0,0,0\n1,0.1,0.01\n", options), 1, "0.01 Nm");
    expectError(touch(kHeader + "0,0,0\n1,0.1,0.03\n", options), 1, "fewer than 20 independent samples");
    expectError(touch(kHeader + "0,0,0.03\n1,0.1,0.03\n", options), 1, "torque does not change");
    expectError(touch(kHeader + "0,0,0.02\n1,-0.1,0.05\n", options), 1, "turns against");
    expectError(
        touch(kHeader + "0,0,0.02\n1,0.1,0.03\n", {"--contact-distance", "0.17", "--method", "two-point"}), 1,
        "one half of the torque window");
    expectError(touch(kHeader + "0,0,0.02\n1,0.1,1e200\n", options), 1, "too large or too small");
}

TEST_F(StiffnessCommand, wrongUsageIsExitCodeTwo) {
    expectError(touch(kPaperWood, {}), 2, "--contact-distance");
    expectError(touch(kPaperWood, {"--contact-distance", "0"}), 2, "--contact-distance");
    expectError(touch(kPaperWood, {"--contact-distance", "-0.17"}), 2, "--contact-distance");
    expectError(touch(kPaperWood, {"--contact-distance", "nan"}), 2, "--contact-distance");
    const auto with = [&](const std::string& option, const std::string& value) {
        return touch(kPaperWood, {"--contact-distance", "0.17", option, value});
    };
    expectError(with("--link-stiffness", "0"), 2, "--link-stiffness");
    expectError(with("--link-half-thickness", "-1"), 2, "--link-half-thickness");
    expectError(with("--method", "guess"), 2, "--method");
    expectError(with("--window", "0.05,0.02"), 2, "--window");
    expectError(with("--window", "-0.01,0.02"), 2, "--window");
    expectError(with("--window", "0.02"), 2, "--window");
    expectError(with("--contact-distance-se", "-0.001"), 2, "--contact-distance-se");
    expectError(with("--link-stiffness-se", "nan"), 2, "--link-stiffness-se");
    expectError(with("--torque-reference", "first"), 2, "--torque-reference");
    expectError(run({"stiffness", "--contact-distance", "0.17"}), 2, "log");
}

TEST_F(StiffnessCommand, badInputIsExitCodeThreeWithItsPlace) {
    expectError(touch(kHeader + "0,0,0\n1,abc,0.03\n"), 3, "touch.csv:3:3:");
    expectError(touch(kHeader + "0,0,0\n1,0.1,nan\n"), 3, "touch.csv:3:7:");
    expectError(touch(kHeader + "0,0\n"), 3, "touch.csv:2:");
    expectError(touch("time_s,joint_angle_rad\n0,0\n"), 3, "joint_torque_nm");
    expectError(touch(kHeader), 3, "no samples");
    expectError(run({"stiffness", m_folder.path("absent.csv"), "--contact-distance", "0.17"}), 3,
                "absent.csv");
}

TEST_F(StiffnessCommand, printsATableForPeople) {
    const ProgramResult result = touch(cleanTouch(282.0));
    EXPECT_EQ(result.exitCode, 0);
    for (const char* text : {"regression", "Total stiffness", "260.8 N/m", "Object stiffness", "282 N/m",
                             "sponge", "safe", "level 1 of 5"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " in\n" << result.out;
}
