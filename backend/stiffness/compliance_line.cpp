// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/compliance_line.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace teleta::stiffness {

namespace {

/// Slope of the line in units of both spreads, and slope over correlation, which is finite even at zero
/// correlation.
struct ScaledSlope {
    double slope = 0.0;
    double slopeOverCorrelation = 1.0;
};

/// torqueNoise, angleNoise: noise over spread, scaled so that the larger is 1. Both forms are the same root
/// of the quadratic; each avoids cancellation on its side.
ScaledSlope demingSlope(double correlation, double torqueNoise, double angleNoise) {
    const double t2 = torqueNoise * torqueNoise;
    const double a2 = angleNoise * angleNoise;
    const double root = std::hypot(t2 - a2, 2.0 * torqueNoise * angleNoise * correlation);
    if (torqueNoise > angleNoise) {
        const double ratio = (t2 - a2 + root) / (2.0 * correlation * correlation * t2);
        return {ratio * correlation, ratio};
    }
    const double ratio = 2.0 * a2 / (a2 - t2 + root);
    return {ratio * correlation, ratio};
}

/// Whether a correlation is significant at 95 % (Student's t of the slope).
bool isSignificant(double correlation, double unexplained, std::size_t points) {
    if (points < 3)
        return correlation != 0.0;
    // The widest quantile, that of one degree of freedom, decides clear cases without computing the exact
    // one.
    constexpr double kWidestQuantile95 = 12.7063;
    const double degreesOfFreedom = static_cast<double>(points) - 2.0;
    const double explained = correlation * correlation * degreesOfFreedom;
    if (explained > kWidestQuantile95 * kWidestQuantile95 * unexplained)
        return true;
    const double quantile = studentQuantile95(degreesOfFreedom);
    return explained > quantile * quantile * unexplained;
}

/// Share of a point's distance from the line, in angle, that is most likely due to its torque.
double pullOf(double slope_radPerNm, const ReadingNoise& noise) {
    if (!std::isnormal(slope_radPerNm))
        return 0.0;
    if (noise.torque_Nm <= 0.0 && noise.angle_rad <= 0.0)
        return 1.0 / slope_radPerNm;
    const double fromTorque_rad = std::abs(slope_radPerNm) * noise.torque_Nm;
    const double both_rad = std::hypot(fromTorque_rad, noise.angle_rad);
    return both_rad > 0.0 ? fromTorque_rad / both_rad * (fromTorque_rad / both_rad) / slope_radPerNm : 0.0;
}

} // namespace

double studentQuantile95(double degreesOfFreedom) {
    return boost::math::quantile(boost::math::students_t(degreesOfFreedom), 0.975);
}

std::optional<ComplianceLine> fitComplianceLine(std::span<const TorqueAngle> points,
                                                const ReadingNoise& noise) {
    const std::size_t n = points.size();
    if (n < 2)
        return std::nullopt;
    double meanTorque_Nm = 0.0;
    double meanAngle_rad = 0.0;
    for (const TorqueAngle& point : points) {
        meanTorque_Nm += point.torque_Nm - points.front().torque_Nm;
        meanAngle_rad += point.angle_rad - points.front().angle_rad;
    }
    meanTorque_Nm = points.front().torque_Nm + meanTorque_Nm / static_cast<double>(n);
    meanAngle_rad = points.front().angle_rad + meanAngle_rad / static_cast<double>(n);

    double farthestTorque_Nm = 0.0;
    double farthestAngle_rad = 0.0;
    for (const TorqueAngle& point : points) {
        farthestTorque_Nm = std::max(farthestTorque_Nm, std::abs(point.torque_Nm - meanTorque_Nm));
        farthestAngle_rad = std::max(farthestAngle_rad, std::abs(point.angle_rad - meanAngle_rad));
    }
    if (farthestTorque_Nm <= 0.0)
        return std::nullopt;

    // Deviations are divided by the largest one before squaring, so that they neither overflow nor underflow.
    double torqueSquares = 0.0;
    double angleSquares = 0.0;
    double products = 0.0;
    for (const TorqueAngle& point : points) {
        const double torque = (point.torque_Nm - meanTorque_Nm) / farthestTorque_Nm;
        const double angle =
            farthestAngle_rad > 0.0 ? (point.angle_rad - meanAngle_rad) / farthestAngle_rad : 0.0;
        torqueSquares += torque * torque;
        angleSquares += angle * angle;
        products += torque * angle;
    }
    const double torqueSpread_Nm = farthestTorque_Nm * std::sqrt(torqueSquares);
    const double angleSpread_rad = farthestAngle_rad * std::sqrt(angleSquares);
    ComplianceLine line;
    line.points = n;
    line.offset_rad = meanAngle_rad;
    line.torqueSpread_Nm = torqueSpread_Nm;
    if (angleSpread_rad <= 0.0) {
        if (n > 2)
            line.slopeSe_radPerNm = 0.0;
        return line;
    }

    const double correlation =
        std::clamp(products / std::sqrt(torqueSquares) / std::sqrt(angleSquares), -1.0, 1.0);
    // Summed from the residuals: for clean data 1 - r^2 itself would be lost in rounding.
    double unexplained = 0.0;
    for (const TorqueAngle& point : points) {
        const double residual = (point.angle_rad - meanAngle_rad) / angleSpread_rad -
                                correlation * ((point.torque_Nm - meanTorque_Nm) / torqueSpread_Nm);
        unexplained += residual * residual;
    }
    line.correlated = isSignificant(correlation, unexplained, n);
    ScaledSlope scaled{correlation, 1.0};
    if (line.correlated) {
        double torqueNoise = noise.torque_Nm / torqueSpread_Nm;
        double angleNoise = noise.angle_rad / angleSpread_rad;
        if (torqueNoise <= 0.0 && angleNoise <= 0.0)
            torqueNoise = 1.0;
        const double larger = std::max(torqueNoise, angleNoise);
        scaled = demingSlope(correlation, torqueNoise / larger, angleNoise / larger);
    }

    const double scale_radPerNm = angleSpread_rad / torqueSpread_Nm;
    line.slope_radPerNm = scaled.slope * scale_radPerNm;
    line.offset_rad = meanAngle_rad - line.slope_radPerNm * meanTorque_Nm;
    line.torqueSpread_Nm = torqueSpread_Nm / std::sqrt(scaled.slopeOverCorrelation);
    line.pull_NmPerRad = pullOf(line.slope_radPerNm, noise);
    if (n > 2)
        line.slopeSe_radPerNm = scaled.slopeOverCorrelation * scale_radPerNm *
                                std::sqrt(unexplained / (static_cast<double>(n) - 2.0));
    return line;
}

} // namespace teleta::stiffness
