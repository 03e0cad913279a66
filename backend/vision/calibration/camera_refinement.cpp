// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_refinement.h"

#include "backend/vision/calibration/camera_start.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>
#include <cmath>
#include <glog/logging.h>
#include <vector>

namespace teleta::vision {

namespace {

constexpr std::array<int, 8> kFreedInOrder{0, 3, 1, 4, 6, 7, 2, 5};

std::array<double, 8> lensBlock(const RationalDistortion& k) {
    return {k.k1, k.k2, k.k3, k.k4, k.k5, k.k6, k.p1, k.p2};
}

/// A camera as parameter blocks of the solver.
struct Blocks {
    std::array<double, 4> focus{}; ///< fx, fy, cx, cy
    Eigen::Quaterniond turn;
    Eigen::Vector3d centre_m;
    std::array<double, 8> lens{};

    explicit Blocks(const CameraParameters& camera)
        : focus{camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px}
        , turn(camera.R_Camera_Sensor)
        , centre_m(camera.p_Sensor_Camera_m) {
        lens = lensBlock(camera.distortion);
    }
};

void assign(CameraParameters& camera, const double* focus, const double* turn, const double* centre_m,
            const double* lens) {
    camera.fx_px = focus[0];
    camera.fy_px = focus[1];
    camera.cx_px = focus[2];
    camera.cy_px = focus[3];
    camera.R_Camera_Sensor = Eigen::Map<const Eigen::Quaterniond>(turn).normalized().toRotationMatrix();
    camera.p_Sensor_Camera_m = Eigen::Map<const Eigen::Vector3d>(centre_m);
    camera.distortion = {lens[0], lens[1], lens[2], lens[3], lens[4], lens[5], lens[6], lens[7]};
}

/// Residual between a pixel and its projected point.
class PixelError : public ceres::SizedCostFunction<2, 4, 4, 3, 8> {
public:
    PixelError(const CalibrationPair& pair, const CameraParameters& fixed)
        : m_pair(pair)
        , m_fixed(fixed) {}

    bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
        CameraParameters camera = m_fixed;
        assign(camera, blocks[0], blocks[1], blocks[2], blocks[3]);
        const auto projection = projectFreely(camera, m_pair.p_Sensor_m);
        if (!projection)
            return false;
        Eigen::Map<Eigen::Vector2d>(residuals, 2) = projection->pixel - m_pair.pixel;
        if (jacobians == nullptr)
            return true;
        const auto& by = projection->byParameters;
        if (jacobians[0] != nullptr) {
            Eigen::Map<Eigen::Matrix<double, 2, 4, Eigen::RowMajor>> j(jacobians[0]);
            j << by.leftCols<2>(), by.middleCols<2>(3);
        }
        if (jacobians[1] != nullptr) {
            // The rotation vector of a small change d of the quaternion q is twice the vector part of d q*.
            const Eigen::Map<const Eigen::Quaterniond> q(blocks[1]);
            const Eigen::Vector3d v = q.vec();
            Eigen::Matrix<double, 3, 4> turn;
            turn << q.w(), -v.z(), v.y(), -v.x(), v.z(), q.w(), -v.x(), -v.y(), -v.y(), v.x(), q.w(), -v.z();
            Eigen::Map<Eigen::Matrix<double, 2, 4, Eigen::RowMajor>> j(jacobians[1]);
            j = 2.0 * by.middleCols<3>(5) * turn;
        }
        if (jacobians[2] != nullptr) {
            Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>> j(jacobians[2]);
            j = by.middleCols<3>(8);
        }
        if (jacobians[3] != nullptr) {
            Eigen::Map<Eigen::Matrix<double, 2, 8, Eigen::RowMajor>> j(jacobians[3]);
            j = by.rightCols<8>();
        }
        return true;
    }

private:
    CalibrationPair m_pair;
    CameraParameters m_fixed;
};

/// Violation of monotonicity of the lens model at one radius.
struct FoldError {
    double r;
    double weight;

    template <typename T>
    bool operator()(const T* k, T* residuals) const {
        using std::sqrt;
        const double s = r * r;
        const T n = 1.0 + s * (k[0] + s * (k[1] + s * k[2]));
        const T d = 1.0 + s * (k[3] + s * (k[4] + s * k[5]));
        const T nSlope = k[0] + s * (2.0 * k[1] + 3.0 * s * k[2]);
        const T dSlope = k[3] + s * (2.0 * k[4] + 3.0 * s * k[5]);
        constexpr double kLeastDenominator = 0.05;
        constexpr double kShareOfEquidistant = 0.05;
        const double least = kShareOfEquidistant / (1.0 + s);
        if (d < T(kLeastDenominator)) {
            residuals[0] = weight * (T(kLeastDenominator) - d);
            residuals[1] = T(weight);
            return true;
        }
        // Root of a positive number, so that the derivative exists without decentring, too.
        const T decentring = 6.0 * r * sqrt(k[6] * k[6] + k[7] * k[7] + 1e-16);
        const T slope = n / d + 2.0 * s * (nSlope * d - n * dSlope) / (d * d) - decentring;
        residuals[0] = T(0.0);
        residuals[1] = slope < T(least) ? T(weight) * (least - slope) : T(0.0);
        return true;
    }
};

struct PriorError {
    double noise_px;
    std::array<double, 8> usual;

    template <typename T>
    bool operator()(const T* k, T* residuals) const {
        for (int i = 0; i < 8; ++i)
            residuals[i] = noise_px / distortionPrior(i) * (k[i] - usual[static_cast<std::size_t>(i)]);
        return true;
    }
};

} // namespace

bool isFreeDistortion(int parameter, int freeDistortion) {
    const auto end = kFreedInOrder.begin() + std::clamp(freeDistortion, 0, 8);
    return std::find(kFreedInOrder.begin(), end, parameter) != end;
}

std::optional<CameraParameters> refineCamera(const CameraParameters& start,
                                             std::span<const CalibrationPair> pairs,
                                             const RefinementSettings& settings) {
    // A failed start is a valid result; the solver must not print to standard error.
    [[maybe_unused]] static const bool silenced = [] {
        FLAGS_minloglevel = google::GLOG_FATAL;
        return true;
    }();
    Blocks blocks(start);
    ceres::Problem problem;
    double* const focus = blocks.focus.data();
    double* const turn = blocks.turn.coeffs().data();
    double* const centre_m = blocks.centre_m.data();
    double* const lens = blocks.lens.data();
    std::size_t used = 0;
    for (const CalibrationPair& pair : pairs) {
        if (!projectFreely(start, pair.p_Sensor_m))
            continue;
        ceres::LossFunction* loss =
            settings.lossScale_px > 0.0 ? new ceres::TukeyLoss(settings.lossScale_px) : nullptr;
        problem.AddResidualBlock(new PixelError(pair, start), loss, focus, turn, centre_m, lens);
        ++used;
    }
    constexpr std::size_t kFewest = 6;
    if (used < kFewest)
        return std::nullopt;
    problem.SetManifold(turn, new ceres::EigenQuaternionManifold);
    std::vector<int> fixed;
    for (int i = 0; i < 8; ++i) {
        if (!isFreeDistortion(i, settings.freeDistortion))
            fixed.push_back(i);
    }
    if (fixed.size() == blocks.lens.size()) {
        problem.SetParameterBlockConstant(lens);
    } else {
        if (!fixed.empty())
            problem.SetManifold(lens, new ceres::SubsetManifold(8, fixed));
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PriorError, 8, 8>(
                                     new PriorError{settings.noise_px, lensBlock(equidistantLens())}),
                                 nullptr, lens);
        constexpr int kRadii = 40;
        for (int i = 1; settings.monotoneUpTo > 0.0 && i <= kRadii; ++i)
            problem.AddResidualBlock(new ceres::AutoDiffCostFunction<FoldError, 2, 8>(new FoldError{
                                         settings.monotoneUpTo * i / kRadii, 0.3 * start.fx_px}),
                                     nullptr, lens);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-14;
    options.gradient_tolerance = 1e-14;
    options.parameter_tolerance = 1e-13;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable())
        return std::nullopt;
    CameraParameters camera = start;
    assign(camera, focus, turn, centre_m, lens);
    const bool isCamera = camera.fx_px > 0.0 && camera.fy_px > 0.0 && camera.cameraMatrix_px().allFinite() &&
                          camera.R_Camera_Sensor.allFinite() && camera.p_Sensor_Camera_m.allFinite() &&
                          camera.distortion.isFinite();
    return isCamera ? std::optional(camera) : std::nullopt;
}

} // namespace teleta::vision
