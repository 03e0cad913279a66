// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladders.h"

namespace teleta::cost {

std::vector<Ladder> allLadders() {
    return {contactFlowLadder(),  cameraCalibrationLadder(), undistortionLadder(), contourLadder(),
            stiffnessLadder(),    tactileFeaturesLadder(),   taxelGainsLadder(),   simulationStepLadder(),
            sceneEffectsLadder(), statisticsLadder()};
}

} // namespace teleta::cost
