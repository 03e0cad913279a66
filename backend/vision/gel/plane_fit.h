// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace teleta::vision {

/// A place on a flat pattern, and the pixel at which it is seen, without the distortion of the lens.
struct PlanePair {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero(); ///< right-handed with u and v
};

/// Two points of a ruler, and their distance.
struct RulerReading {
    Eigen::Vector2d from_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d to_px = Eigen::Vector2d::Zero();
    double length_m = 0.0;
};

/// Standard deviation of a pixel that a person has read off a picture, along an axis: an assumption.
inline constexpr double kReading_px = 0.5;

/// How pixels become places on a plane.
struct PlaneFit {
    /// Pixel to m: a homography, or the same scale everywhere. x points along u, y along v in the middle of
    /// the pattern, which has the place that the scale alone would give it.
    Eigen::Matrix3d homography = Eigen::Matrix3d::Identity();
    bool isScale = false;           ///< the same scale everywhere
    double scale_mPerPx = 0.0;      ///< root of the area of a pixel in the middle of the pattern
    double scaleError_mPerPx = 0.0; ///< its standard deviation
    /// Distance of a pixel from where the fit has it, of those kept; of rulers that of their lengths, and NaN
    /// of a single one.
    double rms_px = 0.0;
    std::size_t pairs = 0;
    std::size_t kept = 0; ///< with at least half of their weight
};

/// The homography of a plane by robust least squares in the picture (Huber, then Tukey), from a start by the
/// linear method with normalised coordinates. Standard deviation of the scale: of noise that is independent
/// and equal in all pairs, and of shared_px, an error along the pattern's mean radius that more pairs do not
/// make smaller. Error: refused: fewer than 6 pairs, all on one line, or no plane that the picture
/// shows once. Thread: any (pure).
[[nodiscard]] core::Expected<PlaneFit> fitHomography(std::span<const PlanePair> pairs,
                                                     double shared_px = 0.0);

/// The same with one scale for the whole picture: pixel = R place / scale + t. Error: refused: fewer than 4
/// pairs, or all on one line. Thread: any (pure).
[[nodiscard]] core::Expected<PlaneFit> fitScale(std::span<const PlanePair> pairs);

/// The scale by lengths that a person has read off a picture: least squares of their pixels, each end read
/// within kReading_px, or as far as several readings differ if that is more. Error: refused: none, a length
/// that is not above 0, ends closer than 10 px, lengths that contradict each other by more than 5 % and 2 px.
/// Thread: any (pure).
[[nodiscard]] core::Expected<PlaneFit> fitRuler(std::span<const RulerReading> readings);

} // namespace teleta::vision
