// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/array/keyframe_motion.h"
#include "backend/simulation/base/timed_effects.h"
#include "backend/simulation/camera/carrier_arm.h"
#include "backend/simulation/camera/effects/camera_effect.h"
#include "backend/simulation/camera/probing_plan.h"
#include "backend/simulation/camera/skin_renderer.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::simulation {

/// One finger as it truly is at the end of the newest frame's exposure.
struct FingerTruth {
    std::string name;
    bool touches = false;
    SkinPress press;                                             ///< in the sensor's frame
    Eigen::Vector3d p_Sensor_Centre_m = Eigen::Vector3d::Zero(); ///< of the contact, on the skin at rest
    double contactRadius_m = 0.0;
    SkinPlace inBase; ///< angle about the tube's axis as it was at the start, and z
};

/// The soft tube of a scene, its camera, the fingers that touch it and the arm that carries it. One frame a
/// call. Deterministic: same scene, same seed, same commands, same frames. Thread: one.
class SimulatedTube {
public:
    /// Error: badInput when the scene is not valid or its camera is none.
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedTube>> make(const scene::Scene& scene,
                                                                             std::uint64_t seed);

    /// Moves on by one frame, the arm with this velocity asked for, and takes the image.
    void next(const TubeVelocity& asked, cv::Mat1b& frame);
    /// Begins the scene anew: fingers and arm are where they were at the start. Noise goes on.
    void restart();
    /// An image of the tube with nothing touching it; moves nothing.
    void untouched(cv::Mat1b& frame);
    /// An image under these presses; moves nothing.
    void pressed(const std::vector<SkinPress>& presses, cv::Mat1b& frame);

    [[nodiscard]] double time_s() const { return static_cast<double>(m_frame) / m_rate_Hz; }
    [[nodiscard]] double rate_Hz() const { return m_rate_Hz; }
    /// The camera as it truly is, exact.
    [[nodiscard]] const vision::CylinderCamera& camera() const { return m_renderer->camera(); }
    [[nodiscard]] const std::vector<FingerTruth>& truth() const { return m_truth; }
    [[nodiscard]] const CarrierArm& arm() const { return m_arm; }
    /// Of the person with the stick, whose truth is the last one; empty in a scene without.
    [[nodiscard]] const std::optional<ProbingPlan>& probing() const { return m_probing; }
    [[nodiscard]] const SkinRenderer& renderer() const { return *m_renderer; }
    [[nodiscard]] const std::vector<EffectTime>& effectTimes() const { return m_effects.times(); }

private:
    SimulatedTube(const scene::Scene& scene, std::uint64_t seed);
    /// A finger against the tube as it is now; without drag.
    [[nodiscard]] FingerTruth fingerAt(std::size_t finger, double time_s) const;
    void drag(FingerTruth& now, const FingerTruth& before) const;
    /// moments[i]: the presses at the i-th moment of the exposure.
    void expose(const std::vector<std::vector<SkinPress>>& moments, cv::Mat1b& frame);
    /// The image as the sensor gives it.
    void finish(cv::Mat1b& frame);

    scene::CameraWorld m_world;
    double m_rate_Hz;
    std::optional<ProbingPlan> m_probing;
    std::vector<KeyframeMotion> m_motions;
    TimedEffects<CameraEffect> m_effects;
    bool m_changesRows = false;          ///< any of them
    std::vector<double> m_before_s{0.0}; ///< when, before the end of the exposure, the moments of a frame are
    std::unique_ptr<SkinRenderer> m_renderer;
    CarrierArm m_arm;
    std::vector<FingerTruth> m_truth;
    std::uint64_t m_frame = 0;
    cv::Mat1f m_image, m_part, m_sum, m_rows;
    std::vector<cv::Rect> m_drawn; ///< parts of m_image that are not at rest
};

} // namespace teleta::simulation
