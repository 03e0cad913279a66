// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/array/keyframe_motion.h"
#include "backend/simulation/camera/carrier_arm.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/simulation/camera/gel/gel_renderer.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::simulation {

/// One ball on the gel as it truly is.
struct GelBallTruth {
    std::string name;
    bool touches = false;
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero(); ///< of the contact, on the gel's surface
    double radius_m = 0.0;                              ///< of the contact
    Eigen::Vector2d drag_m = Eigen::Vector2d::Zero();   ///< of the ball, along the gel
    double turn_rad = 0.0;
    double slipShare = 0.0; ///< share of the contact's area that slips: 1 - (c / a)^2; 1: all of it
};

/// The flat gel of a scene under its balls. One picture a call. Each ball is a GelContact:
///   a = sqrt(R depth); all slips once the ball has been dragged by friction * depth = U;
///   until then c / a = sqrt(1 - drag / U), afterwards the contact moves on with the ball.
/// These are Hertz, Cattaneo and Mindlin for a rigid ball on a half space with Poisson's number 0 (Johnson,
/// Contact Mechanics, 4.2 and 7.2). A ball that is dragged back has no memory of how it came: the skin is as
/// if it had been dragged straight to where it is. The arm moves the gel under the balls: away from them they
/// are less deep, aside they have been dragged less. Deterministic. Thread: one.
class GelStage {
public:
    /// Error: badInput when the scene is not valid or not of a gel.
    [[nodiscard]] static core::Expected<std::unique_ptr<GelStage>> make(const scene::Scene& scene,
                                                                        std::uint64_t seed);

    /// Moves on by one picture, the arm that carries the gel with this velocity asked for, and takes it.
    /// Along: away from the balls; aside: in the plane of the gel.
    void next(const TubeVelocity& asked, cv::Mat1b& picture);
    /// The same with an arm that stands.
    void next(cv::Mat1b& picture) { next({}, picture); }
    /// A picture as it is; moves nothing.
    void again(cv::Mat1b& picture);
    /// Begins anew: balls and arm are where they were at the start. Noise goes on.
    void restart();

    [[nodiscard]] double time_s() const { return static_cast<double>(m_picture) / m_rate_Hz; }
    [[nodiscard]] const CarrierArm& arm() const { return m_arm; }
    /// Of the newest picture, on the gel.
    [[nodiscard]] const std::vector<GelBallTruth>& truth() const { return m_truth; }
    /// Where each marker truly is in it, in the order of rows, and where it was printed.
    [[nodiscard]] const std::vector<Eigen::Vector2d>& places_px() const { return m_places_px; }
    [[nodiscard]] const std::vector<Eigen::Vector2d>& rest_px() const { return m_renderer.rest_px(); }

private:
    GelStage(const scene::GelWorld& world, double rate_Hz, std::uint64_t seed);
    void place();

    scene::GelWorld m_world;
    double m_rate_Hz;
    GelRenderer m_renderer;
    std::vector<KeyframeMotion> m_motions;
    CarrierArm m_arm;
    std::vector<Eigen::Vector2d> m_met_m; ///< where the arm was when each ball met the gel
    std::vector<GelBallTruth> m_truth;
    std::vector<Eigen::Vector2d> m_places_px;
    std::uint64_t m_picture = 0;
};

} // namespace teleta::simulation
