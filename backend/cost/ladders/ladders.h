// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/ladder.h"

#include <QCoreApplication>

#include <vector>

namespace teleta::cost {

/// The texts of all ladders.
struct LadderText {
    Q_DECLARE_TR_FUNCTIONS(CostLadder)
};

/// Contacts in frames of the camera in the soft tube: all rungs of vision::contactLadder(). Frames are
/// rendered, the contacts are where the ball was put.
[[nodiscard]] Ladder contactFlowLadder();

/// Camera from pairs, every tenth wrong: all of vision::kCalibrationMethods. Cameras are drawn, pixels are
/// projected by a formula of the ladder's own.
[[nodiscard]] Ladder cameraCalibrationLadder();

/// Direction in which a pixel looks: fixed iterations, Newton, tables.
[[nodiscard]] Ladder undistortionLadder();

/// Motion of the markers of a flat gel that a ball drags: dark spots, their centres, and markers that are
/// followed, with places at rest from one picture or several. Pictures are drawn from where the markers are.
[[nodiscard]] Ladder gelMarkersLadder();

/// Stiffness of an object from the log of a touch: two points or all samples of the window, 2..1000 samples.
/// Touches are computed from the object's stiffness in closed form, with the noise of the paper's joint.
[[nodiscard]] Ladder stiffnessLadder();

/// Curve through contact points: approximating or interpolating, 8..360 noisy points of a circle, a rectangle
/// and a bent profile. Errors are the distances of points of the true outline from the curve.
[[nodiscard]] Ladder contourLadder();

/// Place of a ball that presses on an array, also over its border: centroid of the active taxels, centre of
/// pressure, summit of a paraboloid. Loads come from the foundation model.
[[nodiscard]] Ladder tactileFeaturesLadder();

/// Contacts on the skin of a whole body, 40 patches of 10 x 25 taxels: how summits are told apart, and the
/// centroid or the summit of each contact. Loads come from the foundation model.
[[nodiscard]] Ladder skinContactsLadder();

/// Gains of an array's taxels from a press whose readings are lost now and then, and spark: ratio of the
/// means, robust fit, 50..1000 frames. Readings are written from the taxels' responses.
[[nodiscard]] Ladder taxelGainsLadder();

/// An arm that touches rubber: implicit steps of 0.1..10 ms, explicit ones where they are stable, against a
/// solution with steps of 2 us. How taxels are coupled is an effect of its own: see sceneEffectsLadder().
[[nodiscard]] Ladder simulationStepLadder();

/// Frames of the scene "tactile-indenter" with all its effects, without each one, and with none. Error when
/// made: notFound where the program has no scenes.
[[nodiscard]] Ladder sceneEffectsLadder();

/// Interval of the information transfer of a study of simulated participants with a known matrix: normal
/// approximation with corrections of the bias, jackknife over participants, bootstrap with 100..100 000
/// resamples.
[[nodiscard]] Ladder statisticsLadder();

/// Interval of a threshold from the answers of simulated observers: the best point of the grid, one start or
/// several, each with the normal approximation, the profile of the likelihood, and the bootstrap.
[[nodiscard]] Ladder psychometricFitLadder();

/// All ladders in the order of their list.
[[nodiscard]] std::vector<Ladder> allLadders();

} // namespace teleta::cost
