// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/calibration/camera_file.h"
#include "tests/app/cli/gel_video.h"
#include "tests/app/cli/program_run.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

std::vector<std::string> commands() {
    std::istringstream help(run({"--help"}).out);
    std::vector<std::string> names;
    bool listed = false;
    for (std::string line; std::getline(help, line);) {
        if (line == "Commands:" || line == "Subcommands:")
            listed = true;
        else if (listed && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
}

/// The lines behind "Example:", as somebody copies them.
std::string exampleOf(const std::string& command) {
    const std::string help = run({command, "--help"}).out;
    const std::size_t start = help.find("Example:\n");
    return start == std::string::npos ? std::string() : help.substr(start + 9);
}

/// What the example of track needs and no command writes: a video of a press, and the camera's file.
void writeVideo(const TemporaryFolder& folder) {
    auto tube = teleta::simulation::SimulatedTube::make(teleta::test::cameraScene(), 1);
    ASSERT_TRUE(tube);
    const teleta::vision::CalibrationSummary none;
    ASSERT_TRUE(teleta::vision::writeCamera({.camera = (*tube)->camera(), .summary = none},
                                            folder.path("camera.json")));
    cv::Mat1b frame;
    (*tube)->untouched(frame);
    cv::VideoWriter video(folder.path("press.avi"), cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 10.0,
                          frame.size(), false);
    ASSERT_TRUE(video.isOpened());
    for (const double depth_m : {0.0, 0.0008, 0.0015}) {
        (*tube)->pressed({{.centre = {1.0, 0.04}, .ballRadius_m = 0.01, .depth_m = depth_m}}, frame);
        video.write(frame);
    }
}

} // namespace

class Examples : public testing::TestWithParam<std::string> {};

TEST_P(Examples, workAsTheyAreCopiedIntoAShellInAnEmptyFolder) {
    const std::string example = exampleOf(GetParam());
    ASSERT_NE(example.find("teleta " + GetParam()), std::string::npos) << example;
    const TemporaryFolder folder;
    if (GetParam() == "track")
        writeVideo(folder);
    if (GetParam() == "markers") {
        ASSERT_TRUE(teleta::test::writeGelVideo(folder.path("press.avi"), 12));
        folder.write("gel.toml", teleta::test::kGelFile);
    }
    const auto runScript = [&folder](const std::string& commands) {
        const std::string script = folder.write("example.sh", "set -euo pipefail\n" + commands);
        return std::system(("cd '" + folder.path("") +
                            "' && PATH=\"$(dirname '" TELETA_PROGRAM "'):$PATH\" bash '" + script +
                            "' >out 2>err")
                               .c_str());
    };
    int status = runScript(example);
    // Times that a busy machine spoils are refused, which says nothing about the example: they are allowed.
    if (readAll(folder.path("err")).find("the machine was too busy") != std::string::npos)
        status = runScript("teleta() { command teleta \"$@\" --largest-spread 1000; }\n" + example);
    EXPECT_EQ(status, 0) << example << readAll(folder.path("err"));
}

INSTANTIATE_TEST_SUITE_P(Commands, Examples, testing::ValuesIn(commands()),
                         [](const auto& test) { return test.param; });

TEST(ExampleList, hasEachCommand) {
    EXPECT_GE(commands().size(), 15U);
}
