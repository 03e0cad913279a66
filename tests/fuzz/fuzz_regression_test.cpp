// SPDX-License-Identifier: GPL-3.0-or-later
// Replays inputs that fuzzing has found, and its seeds, through the same functions in every test run. A
// broken contract ends the program (fuzz_targets.h).
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/fuzz_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

using teleta::fuzz::Bytes;

namespace {

using Target = bool (*)(Bytes);

const std::map<std::string, Target> kTargets{
    {"camera_json", teleta::fuzz::cameraJson},
    {"camera_pairs", teleta::fuzz::cameraPairs},
    {"contour_csv", teleta::fuzz::contourCsv},
    {"cost_csv", teleta::fuzz::costCsv},
    {"csv", teleta::fuzz::csv},
    {"frame_csv", teleta::fuzz::frameCsv},
    {"frame_numpy", teleta::fuzz::frameNumpy},
    {"frame_table", teleta::fuzz::frameTable},
    {"frame_tekscan", teleta::fuzz::frameTekscan},
    {"gain_csv", teleta::fuzz::gainCsv},
    {"hid_bracelet_file", teleta::fuzz::hidBraceletFile},
    {"hid_reports", teleta::fuzz::hidReports},
    {"level_csv", teleta::fuzz::levelCsv},
    {"mcap_file", teleta::fuzz::mcapFile},
    {"mcap_message", teleta::fuzz::mcapMessage},
    {"motor_profile", teleta::fuzz::motorProfile},
    {"motor_recording", teleta::fuzz::motorRecording},
    {"pattern_ahap", teleta::fuzz::patternAhap},
    {"pattern_export", teleta::fuzz::patternExport},
    {"pattern_haptic", teleta::fuzz::patternHaptic},
    {"pattern_haptic_zip", teleta::fuzz::patternHapticZip},
    {"pattern_hjif", teleta::fuzz::patternHjif},
    {"pattern_json", teleta::fuzz::patternJson},
    {"pattern_map", teleta::fuzz::patternMap},
    {"pattern_recovery", teleta::fuzz::patternRecovery},
    {"pattern_tact", teleta::fuzz::patternTact},
    {"recording", teleta::fuzz::recording},
    {"register_map", teleta::fuzz::registerMap},
    {"ros_arm_file", teleta::fuzz::rosArmFile},
    {"ros_joint_states", teleta::fuzz::rosJointStates},
    {"scene", teleta::fuzz::scene},
    {"servo_csv", teleta::fuzz::servoCsv},
    {"site_governance", teleta::fuzz::siteGovernance},
    {"site_permissions", teleta::fuzz::sitePermissions},
    {"study_protocol", teleta::fuzz::studyProtocol},
    {"study_scene", teleta::fuzz::studyScene},
    {"touch_csv", teleta::fuzz::touchCsv},
    {"trial_csv", teleta::fuzz::trialCsv},
    {"trial_journal", teleta::fuzz::trialJournal},
    {"urdf", teleta::fuzz::urdf},
    {"wts_frames", teleta::fuzz::wtsFrames},
};

struct Input {
    std::string target;
    std::string path;
};

std::vector<Input> inputs(const std::string& kind) {
    std::vector<Input> found;
    std::istringstream lines(teleta::test::readAll(TELETA_FUZZ_INPUTS));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string first;
        Input input;
        std::getline(fields, first, '\t');
        std::getline(fields, input.target, '\t');
        std::getline(fields, input.path);
        if (first == kind)
            found.push_back(input);
    }
    return found;
}

bool isAccepted(const Input& input) {
    const std::string bytes = teleta::test::readAll(input.path);
    return kTargets.at(input.target)({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

std::string nameOf(const testing::TestParamInfo<Input>& info) {
    std::string name = info.param.target + '_' + info.param.path.substr(info.param.path.rfind('/') + 1);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

class Seed : public testing::TestWithParam<Input> {};
class Regression : public testing::TestWithParam<Input> {};

} // namespace

TEST_P(Seed, isAcceptedSoThatFuzzingBeginsBehindTheFirstCheck) {
    EXPECT_TRUE(isAccepted(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Fuzzing, Seed, testing::ValuesIn(inputs("seed")), nameOf);

TEST_P(Regression, keepsTheContractOfItsParser) {
    (void)isAccepted(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Fuzzing, Regression, testing::ValuesIn(inputs("regression")), nameOf);

TEST(EveryParser, hasASeed) {
    const std::vector<Input> seeds = inputs("seed");
    for (const auto& [name, target] : kTargets)
        EXPECT_TRUE(std::any_of(seeds.begin(), seeds.end(), [&](const Input& seed) {
            return seed.target == name;
        })) << name;
}

TEST(EveryParser, refusesNothingAtAllAndNoise) {
    std::string noise;
    for (unsigned k = 0; k < 300; ++k)
        noise += static_cast<char>((k * 2654435761U) >> 24U);
    for (const auto& [name, target] : kTargets) {
        for (const std::string& bytes : {std::string(), std::string(1, '\0'), noise}) {
            const bool accepted = target({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
            EXPECT_FALSE(accepted) << name << ", " << bytes.size() << " bytes";
        }
    }
}
