// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzz_inputs.h"

#include "tests/backend/core/temporary_folder.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace teleta::fuzz {

const std::map<std::string, Target>& targets() {
    static const std::map<std::string, Target> kTargets{
        {"camera_json", cameraJson},
        {"camera_pairs", cameraPairs},
        {"contour_csv", contourCsv},
        {"cost_csv", costCsv},
        {"csv", csv},
        {"frame_arrays", frameArrays},
        {"frame_csv", frameCsv},
        {"frame_numpy", frameNumpy},
        {"frame_table", frameTable},
        {"frame_tekscan", frameTekscan},
        {"gain_csv", gainCsv},
        {"hid_bracelet_file", hidBraceletFile},
        {"hid_reports", hidReports},
        {"level_csv", levelCsv},
        {"mcap_file", mcapFile},
        {"mcap_message", mcapMessage},
        {"motor_profile", motorProfile},
        {"motor_recording", motorRecording},
        {"pattern_ahap", patternAhap},
        {"pattern_export", patternExport},
        {"pattern_haptic", patternHaptic},
        {"pattern_haptic_zip", patternHapticZip},
        {"pattern_hjif", patternHjif},
        {"pattern_json", patternJson},
        {"pattern_map", patternMap},
        {"pattern_recovery", patternRecovery},
        {"pattern_tact", patternTact},
        {"recording", recording},
        {"register_map", registerMap},
        {"remote_site_file", remoteSiteFile},
        {"ros_arm_file", rosArmFile},
        {"ros_array_messages", rosArrayMessages},
        {"ros_camera_messages", rosCameraMessages},
        {"ros_frames", rosFrames},
        {"ros_joint_states", rosJointStates},
        {"ros_nodes", rosNodes},
        {"ros_sensor_file", rosSensorFile},
        {"scene", scene},
        {"servo_csv", servoCsv},
        {"site_file", siteFile},
        {"site_governance", siteGovernance},
        {"site_motions", siteMotions},
        {"site_permissions", sitePermissions},
        {"site_streams", siteStreams},
        {"sound_bracelet_file", soundBraceletFile},
        {"study_protocol", studyProtocol},
        {"study_scene", studyScene},
        {"taxel_stream", taxelStream},
        {"taxels_file", taxelsFile},
        {"touch_csv", touchCsv},
        {"trial_csv", trialCsv},
        {"trial_journal", trialJournal},
        {"urdf", urdf},
        {"wts_frames", wtsFrames},
    };
    return kTargets;
}

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

std::string nameOf(const Input& input) {
    std::string name = input.target + '_' + input.path.substr(input.path.rfind('/') + 1);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

} // namespace teleta::fuzz
