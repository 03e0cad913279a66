// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladders.h"

namespace teleta::cost {

std::vector<Ladder> allLadders() {
    return {contactFlowLadder(),    cameraCalibrationLadder(), undistortionLadder(),    gelMarkersLadder(),
            contourLadder(),        stiffnessLadder(),         tactileFeaturesLadder(), skinContactsLadder(),
            taxelGainsLadder(),     simulationStepLadder(),    sceneEffectsLadder(),    statisticsLadder(),
            psychometricFitLadder()};
}

} // namespace teleta::cost
