// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/contact_force.h"
#include "backend/contact/tactile_features.h"
#include "backend/contour/point.h"
#include "backend/contour/shape_recogniser.h"
#include "backend/stiffness/refusal.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::pipeline {

/// Where the skin felt the strongest contact at a time.
struct SkinContact {
    std::int64_t time_ns = 0;
    double sourceTime_s = 0.0;
    bool touching = false; ///< false: the skin felt nothing, x, y and force say nothing
    double x_m = 0.0;      ///< frame {s} of the skin's sheet
    double y_m = 0.0;
    double force_N = 0.0;
    contact::ContactType type = contact::ContactType::none; ///< of the whole frame
    double xSe_m = 0.0; ///< standard errors of the place, setPlaceErrors()
    double ySe_m = 0.0;
};

/// One touch of the remote arm, from the first torque above the noise to the estimate.
struct TouchRecord {
    std::uint64_t number = 0;  ///< from 1
    std::int64_t start_ns = 0; ///< first sample above the noise floor
    std::int64_t ready_ns = 0; ///< when this record was made, by the sample that completed it
    /// When that sample came from another computer, which read it; 0: it was read by this one.
    std::int64_t arrived_ns = 0;
    double start_s = 0.0; ///< start_ns and ready_ns in the arm's own time
    double ready_s = 0.0;
    std::size_t joint = 0;  ///< whose torque and angle were evaluated
    std::size_t joints = 0; ///< of the arm
    double torque_Nm = 0.0; ///< of that joint when the record was made, without its reference

    bool located = false; ///< the skin felt the contact; else the point and what rests on it is missing
    double contactDistance_m = 0.0; ///< P_C, from the elbow along the forearm
    double contactDistanceSe_m = 0.0;
    double side_rad = 0.0;
    Eigen::Vector3d p_Base_Contact_m = Eigen::Vector3d::Zero();
    contact::ContactType contactType = contact::ContactType::none; ///< as the skin felt it last

    std::optional<arm::ContactForce> force;
    std::optional<stiffness::TouchStiffness> stiffness;
    std::optional<stiffness::Refusal> refusal; ///< why there is no stiffness, when the contact was located
};

/// What the touches so far tell of the object's shape, in the x-y plane of the arm's base.
struct ExploredContour {
    static constexpr std::size_t kLeastPoints = 3; ///< with fewer there is no recognition
    /// Of fewer touches in one place, a larger object may lie beside them.
    static constexpr std::size_t kLeastOfAPoint = 8;

    std::uint64_t revision = 0;           ///< grows with each change; 0: nothing was explored
    std::vector<contour::Point> points_m; ///< in the order in which they were touched
    std::vector<contour::Point> curve_m;  ///< interpolating spline, sampled; empty with fewer than two points
    double height_m = 0.0;                ///< mean z of the contact points in the base
    std::optional<contour::Recognition> recognition;
};

} // namespace teleta::pipeline
