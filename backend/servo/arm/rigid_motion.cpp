// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/rigid_motion.h"

#include <cmath>

namespace teleta::servo {

namespace {

/// Below this angle the closed forms lose digits and the series are used.
constexpr double kSeriesAngle_rad = 0.25;

/// (t - sin t)/t^3.
double sineDefect(double t) {
    if (t < kSeriesAngle_rad) {
        const double t2 = t * t;
        return (1.0 - t2 / 20.0 * (1.0 - t2 / 42.0 * (1.0 - t2 / 72.0 * (1.0 - t2 / 110.0)))) / 6.0;
    }
    return (t - std::sin(t)) / (t * t * t);
}

/// (1 - (t/2) cot(t/2))/t^2, with cot(t/2) = w/n of the rotation's quaternion.
double cotangentDefect(double t, double w, double n) {
    if (t < kSeriesAngle_rad) {
        const double t2 = t * t;
        return 1.0 / 12.0 +
               t2 * (1.0 / 720.0 + t2 * (1.0 / 30240.0 + t2 * (1.0 / 1209600.0 + t2 * (1.0 / 47900160.0))));
    }
    return (1.0 - 0.5 * t * w / n) / (t * t);
}

struct HalfAngle {
    Eigen::Vector3d axisTimesSine;
    double sine;
    double cosine; ///< >= 0
};

HalfAngle halfAngleOf(const Eigen::Matrix3d& R) {
    Eigen::Quaterniond q(R);
    q.normalize();
    if (q.w() < 0.0)
        q.coeffs() = -q.coeffs();
    Eigen::Vector3d v = q.vec();
    // A half turn up to rounding: both signs of the axis describe it, and the sign of w has no meaning.
    if (q.w() < 1e-15) {
        Eigen::Index first = 0;
        while (first < 2 && std::abs(v[first]) < 1e-15)
            ++first;
        if (v[first] < 0.0)
            v = -v;
    }
    return {v, v.norm(), q.w()};
}

Eigen::Vector3d rotationVector(const HalfAngle& half) {
    if (half.sine < 1e-12)
        return 2.0 * half.axisTimesSine;
    return (2.0 * std::atan2(half.sine, half.cosine) / half.sine) * half.axisTimesSine;
}

} // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
    Eigen::Matrix3d matrix;
    matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return matrix;
}

Eigen::Isometry3d expSE3(const Twist& xi) {
    const Eigen::Vector3d v = xi.head<3>();
    const Eigen::Vector3d w = xi.tail<3>();
    const double t = w.norm();
    const double half = std::sin(0.5 * t);
    const double a = t > 0.0 ? std::sin(t) / t : 1.0;
    const double b = t > 0.0 ? 2.0 * (half / t) * (half / t) : 0.5;
    const double c = sineDefect(t);
    const Eigen::Matrix3d W = skew(w);
    const Eigen::Matrix3d W2 = W * W;
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() += a * W + b * W2;
    const Eigen::Vector3d wv = w.cross(v);
    X.translation() = v + b * wv + c * w.cross(wv);
    return X;
}

Eigen::Vector3d logSO3(const Eigen::Matrix3d& R) {
    return rotationVector(halfAngleOf(R));
}

Twist logSE3(const Eigen::Isometry3d& X) {
    const HalfAngle half = halfAngleOf(X.linear());
    const Eigen::Vector3d w = rotationVector(half);
    const double d = cotangentDefect(w.norm(), half.cosine, half.sine);
    const Eigen::Vector3d p = X.translation();
    const Eigen::Vector3d wp = w.cross(p);
    Twist xi;
    xi << p - 0.5 * wp + d * w.cross(wp), w;
    return xi;
}

Twist twistTo(const Eigen::Isometry3d& X_A_B, const Twist& twist_B) {
    const Eigen::Vector3d w = X_A_B.linear() * twist_B.tail<3>();
    Twist twist_A;
    twist_A << X_A_B.linear() * twist_B.head<3>() + X_A_B.translation().cross(w), w;
    return twist_A;
}

Twist poseDifference(const Eigen::Isometry3d& X_A_From, const Eigen::Isometry3d& X_A_To) {
    return logSE3(X_A_From.inverse(Eigen::Isometry) * X_A_To);
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& X_Base_Sensor, const Twist& increment_Base) {
    Eigen::Isometry3d X = expSE3(increment_Base) * X_Base_Sensor;
    X.linear() = orthonormal(X.linear());
    return X;
}

Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& R) {
    return Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

} // namespace teleta::servo
