// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_refinement.h"

#include "backend/vision/calibration/camera_start.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace teleta::vision {

namespace {

constexpr std::array<int, 8> kFreedInOrder{0, 3, 1, 4, 6, 7, 2, 5};

/// fx, fy, cx, cy; a small rotation vector in the camera frame; centre of the camera; k1..k6, p1, p2.
constexpr int kUnknowns = 18;
constexpr int kFirstOfTurn = 4;
constexpr int kFirstOfCentre = 7;
constexpr int kFirstOfLens = 10;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Lens = std::array<double, 8>;

Lens lensOf(const RationalDistortion& k) {
    return {k.k1, k.k2, k.k3, k.k4, k.k5, k.k6, k.p1, k.p2};
}

CameraParameters moved(const CameraParameters& camera, const Unknowns& by) {
    CameraParameters result = camera;
    result.fx_px += by[0];
    result.fy_px += by[1];
    result.cx_px += by[2];
    result.cy_px += by[3];
    const Eigen::Vector3d turn = by.segment<3>(kFirstOfTurn);
    const double angle_rad = turn.norm();
    if (angle_rad > 0.0) {
        const Eigen::Quaterniond small(Eigen::AngleAxisd(angle_rad, turn / angle_rad));
        result.R_Camera_Sensor =
            (small * Eigen::Quaterniond(camera.R_Camera_Sensor)).normalized().toRotationMatrix();
    }
    result.p_Sensor_Camera_m += by.segment<3>(kFirstOfCentre);
    Lens lens = lensOf(camera.distortion);
    for (std::size_t i = 0; i < lens.size(); ++i)
        lens[i] += by[kFirstOfLens + static_cast<Eigen::Index>(i)];
    result.distortion = {lens[0], lens[1], lens[2], lens[3], lens[4], lens[5], lens[6], lens[7]};
    return result;
}

/// Half the sum of squares at a camera, and its derivatives.
struct Squares {
    double cost = 0.0;
    Unknowns gradient = Unknowns::Zero();
    /// Approximate second derivatives; only the entries (row, column) with row >= column.
    Eigen::Matrix<double, kUnknowns, kUnknowns> normal = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();

    /// Adds two residuals with a weight, and their derivatives.
    void add(double weight, const Eigen::Vector2d& residual, const Unknowns& first, const Unknowns& second) {
        for (int column = 0; column < kUnknowns; ++column) {
            const double a = weight * first[column];
            const double b = weight * second[column];
            gradient[column] += a * residual.x() + b * residual.y();
            double* entries = &normal(0, column);
            for (int row = column / 2 * 2; row < kUnknowns; ++row)
                entries[row] += a * first[row] + b * second[row];
        }
    }
};

class CameraFit {
public:
    CameraFit(const CameraParameters& start, std::span<const CalibrationPair> pairs,
              const RefinementSettings& settings)
        : m_settings(settings)
        , m_lossScale2(settings.lossScale_px * settings.lossScale_px)
        , m_foldWeight(0.3 * start.fx_px) {
        for (const CalibrationPair& pair : pairs) {
            if (projectFreely(start, pair.p_Sensor_m))
                m_pairs.push_back(pair);
        }
        for (int i = 0; i < 8; ++i)
            m_free[static_cast<std::size_t>(i)] = isFreeDistortion(i, settings.freeDistortion);
        m_isLensFree = std::ranges::find(m_free, true) != m_free.end();
    }

    [[nodiscard]] std::size_t used() const { return m_pairs.size(); }

    /// Half the sum of squares; with derivatives when asked for. False: a point is not in front of the camera
    /// or where the lens model has no value.
    template <bool kDerivatives>
    [[nodiscard]] bool evaluate(const CameraParameters& camera, Squares& squares) const {
        squares.cost = 0.0;
        if constexpr (kDerivatives) {
            squares.gradient.setZero();
            squares.normal.setZero();
        }
        const Eigen::Matrix3d linear = camera.linearPart();
        for (const CalibrationPair& pair : m_pairs) {
            if (!addPair<kDerivatives>(camera, linear, pair, squares))
                return false;
        }
        if (m_isLensFree) {
            addPrior<kDerivatives>(camera, squares);
            constexpr int kRadii = 40;
            for (int i = 1; m_settings.monotoneUpTo > 0.0 && i <= kRadii; ++i)
                addFold<kDerivatives>(camera, m_settings.monotoneUpTo * i / kRadii, squares);
        }
        if constexpr (kDerivatives) {
            for (int i = 0; i < 8; ++i) {
                if (!m_free[static_cast<std::size_t>(i)])
                    fix(kFirstOfLens + i, squares);
            }
        }
        return std::isfinite(squares.cost);
    }

private:
    static void fix(int unknown, Squares& squares) {
        squares.gradient[unknown] = 0.0;
        squares.normal.row(unknown).setZero();
        squares.normal.col(unknown).setZero();
        squares.normal(unknown, unknown) = 1.0;
    }

    /// See projectFreely().
    template <bool kDerivatives>
    [[nodiscard]] bool addPair(const CameraParameters& camera, const Eigen::Matrix3d& linear,
                               const CalibrationPair& pair, Squares& squares) const {
        const Eigen::Vector3d p = linear * (pair.p_Sensor_m - camera.p_Sensor_Camera_m);
        if (!(p.z() > 0.0))
            return false;
        const RationalDistortion& lens = camera.distortion;
        const double inverse = 1.0 / p.z();
        const Eigen::Vector2d point = p.head<2>() * inverse;
        if (!(lens.denominator(point.squaredNorm()) > 0.0))
            return false;
        const Eigen::Vector2d distorted = lens.apply(point);
        const Eigen::Vector2d residual(camera.fx_px * distorted.x() + camera.skew_px * distorted.y() +
                                           camera.cx_px - pair.pixel.x(),
                                       camera.fy_px * distorted.y() + camera.cy_px - pair.pixel.y());
        const double size2 = residual.squaredNorm();
        // Tukey's biweight rho(s) of s = |r|^2, with rho'(0) = 1.
        double weight = 1.0;
        if (m_lossScale2 > 0.0) {
            const double rest = std::max(0.0, 1.0 - size2 / m_lossScale2);
            squares.cost += m_lossScale2 / 6.0 * (1.0 - rest * rest * rest);
            weight = rest * rest;
        } else {
            squares.cost += 0.5 * size2;
        }
        if constexpr (kDerivatives) {
            if (weight == 0.0)
                return true;
            const Eigen::Matrix2d slope = lens.slope(point);
            const Eigen::Matrix<double, 2, 8> byLens = lens.byParameters(point);
            Unknowns u = Unknowns::Zero();
            Unknowns v = Unknowns::Zero();
            u[0] = distorted.x();
            v[1] = distorted.y();
            u[2] = v[3] = 1.0;
            const auto fill = [&](Unknowns& to, const Eigen::RowVector2d& byPoint) {
                const Eigen::Vector3d byCamera(byPoint.x() * inverse, byPoint.y() * inverse,
                                               -byPoint.dot(point) * inverse);
                to.segment<3>(kFirstOfTurn) = p.cross(byCamera);
                to.segment<3>(kFirstOfCentre) = -linear.transpose() * byCamera;
            };
            fill(u, camera.fx_px * slope.row(0) + camera.skew_px * slope.row(1));
            fill(v, camera.fy_px * slope.row(1));
            u.tail<8>() = (camera.fx_px * byLens.row(0) + camera.skew_px * byLens.row(1)).transpose();
            v.tail<8>() = camera.fy_px * byLens.row(1).transpose();
            squares.add(weight, residual, u, v);
        }
        return true;
    }

    template <bool kDerivatives>
    void addPrior(const CameraParameters& camera, Squares& squares) const {
        const Lens lens = lensOf(camera.distortion);
        const Lens usual = lensOf(equidistantLens());
        for (int i = 0; i < 8; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double weight = m_settings.noise_px / distortionPrior(i);
            const double residual = weight * (lens[k] - usual[k]);
            squares.cost += 0.5 * residual * residual;
            if constexpr (kDerivatives) {
                squares.gradient[kFirstOfLens + i] += weight * residual;
                squares.normal(kFirstOfLens + i, kFirstOfLens + i) += weight * weight;
            }
        }
    }

    /// Adds the violation of monotonicity of the lens model at one radius.
    template <bool kDerivatives>
    void addFold(const CameraParameters& camera, double r, Squares& squares) const {
        constexpr double kLeastDenominator = 0.05;
        constexpr double kShareOfEquidistant = 0.05;
        const RationalDistortion& k = camera.distortion;
        const double s = r * r;
        const double n = k.numerator(s);
        const double d = k.denominator(s);
        Eigen::Vector2d residual = Eigen::Vector2d::Zero();
        Unknowns first = Unknowns::Zero();
        Unknowns second = Unknowns::Zero();
        if (d < kLeastDenominator) {
            residual = m_foldWeight * Eigen::Vector2d(kLeastDenominator - d, 1.0);
            for (int i = 0; i < 3; ++i)
                first[kFirstOfLens + 3 + i] = -m_foldWeight * std::pow(s, i + 1);
        } else {
            const double nSlope = k.k1 + s * (2.0 * k.k2 + 3.0 * s * k.k3);
            const double dSlope = k.k4 + s * (2.0 * k.k5 + 3.0 * s * k.k6);
            // Root of a positive number, so that the derivative exists without decentring, too.
            const double root = std::sqrt(k.p1 * k.p1 + k.p2 * k.p2 + 1e-16);
            const double slope = n / d + 2.0 * s * (nSlope * d - n * dSlope) / (d * d) - 6.0 * r * root;
            const double least = kShareOfEquidistant / (1.0 + s);
            if (!(slope < least))
                return;
            residual.y() = m_foldWeight * (least - slope);
            double power = 1.0;
            for (int i = 0; i < 3; ++i) {
                // Derivatives by k_i of n: s^i, of n': i s^(i - 1); of d and d' the same.
                const double bySlope = (i + 1.0) * power;
                power *= s;
                second[kFirstOfLens + i] =
                    -m_foldWeight * (power * (1.0 / d - 2.0 * s * dSlope / (d * d)) + bySlope * 2.0 * s / d);
                second[kFirstOfLens + 3 + i] =
                    -m_foldWeight * (power * (-n - 2.0 * s * nSlope + 4.0 * s * n * dSlope / d) / (d * d) -
                                     bySlope * 2.0 * s * n / (d * d));
            }
            second[kFirstOfLens + 6] = m_foldWeight * 6.0 * r * k.p1 / root;
            second[kFirstOfLens + 7] = m_foldWeight * 6.0 * r * k.p2 / root;
        }
        squares.cost += 0.5 * residual.squaredNorm();
        if constexpr (kDerivatives)
            squares.add(1.0, residual, first, second);
    }

    RefinementSettings m_settings;
    double m_lossScale2;
    double m_foldWeight;
    std::vector<CalibrationPair> m_pairs;
    std::array<bool, 8> m_free{};
    bool m_isLensFree = false;
};

/// The step of Levenberg and Marquardt: (N + diag(N) / trust) step = -gradient. decrease: of the cost, as the
/// approximation says. Empty when rounding leaves no positive definite matrix.
std::optional<Unknowns> stepOf(const Squares& squares, double trust, double& decrease) {
    const Unknowns scale = squares.normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Eigen::Matrix<double, kUnknowns, kUnknowns> damped =
        scale.asDiagonal() * squares.normal * scale.asDiagonal();
    damped.diagonal().array() += 1.0 / trust;
    const Eigen::LLT<Eigen::Ref<Eigen::Matrix<double, kUnknowns, kUnknowns>>> solver(damped);
    if (solver.info() != Eigen::Success)
        return std::nullopt;
    const Unknowns step = scale.cwiseProduct(solver.solve(-scale.cwiseProduct(squares.gradient)));
    if (!step.allFinite())
        return std::nullopt;
    decrease =
        -step.dot(squares.gradient + 0.5 * (squares.normal.selfadjointView<Eigen::Lower>() * step).eval());
    return step;
}

} // namespace

bool isFreeDistortion(int parameter, int freeDistortion) {
    const auto end = kFreedInOrder.begin() + std::clamp(freeDistortion, 0, 8);
    return std::find(kFreedInOrder.begin(), end, parameter) != end;
}

std::optional<CameraParameters> refineCamera(const CameraParameters& start,
                                             std::span<const CalibrationPair> pairs,
                                             const RefinementSettings& settings) {
    constexpr std::size_t kFewest = 6;
    constexpr double kTrustOfStart = 1e4;
    constexpr double kTrustNear = 1e8;
    constexpr double kSmallestTrust = 1e-32;
    constexpr double kLargestTrust = 1e14;
    constexpr double kSmallestGradient = 1e-14;
    constexpr double kSmallestStep = 1e-13;
    constexpr double kLeastShare = 1e-3; ///< of the expected decrease
    const CameraFit fit(start, pairs, settings);
    if (fit.used() < kFewest)
        return std::nullopt;
    CameraParameters camera = start;
    Squares squares;
    Squares trial;
    if (!fit.evaluate<true>(camera, squares))
        return std::nullopt;
    double trust = settings.isNear ? kTrustNear : kTrustOfStart;
    double shrink = 2.0;
    for (int i = 0; i < settings.mostSteps && trust > kSmallestTrust; ++i) {
        if (squares.gradient.cwiseAbs().maxCoeff() <= kSmallestGradient)
            break;
        double expected = 0.0;
        const std::optional<Unknowns> step = stepOf(squares, trust, expected);
        if (step && step->norm() <= kSmallestStep * (camera.fx_px + camera.fy_px))
            break;
        const CameraParameters next = step ? moved(camera, *step) : camera;
        const bool isUsable = step && expected > 0.0 && fit.evaluate<false>(next, trial);
        const double decrease = isUsable ? squares.cost - trial.cost : -1.0;
        const bool settled = isUsable && std::abs(decrease) <= settings.tolerance * squares.cost;
        if (decrease > kLeastShare * expected) {
            camera = next;
            if (settled)
                break;
            trust = std::min(kLargestTrust,
                             trust / std::max(0.1, 1.0 - std::pow(2.0 * decrease / expected - 1.0, 3)));
            shrink = 2.0;
            if (!fit.evaluate<true>(camera, squares))
                return std::nullopt;
        } else {
            if (settled)
                break;
            trust /= shrink;
            shrink *= 2.0;
        }
    }
    const bool isCamera = camera.fx_px > 0.0 && camera.fy_px > 0.0 && camera.cameraMatrix_px().allFinite() &&
                          camera.R_Camera_Sensor.allFinite() && camera.p_Sensor_Camera_m.allFinite() &&
                          camera.distortion.isFinite();
    return isCamera ? std::optional(camera) : std::nullopt;
}

} // namespace teleta::vision
