// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_start.h"

#include "backend/core/quantile.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace teleta::vision {

namespace {

/// Similarity that moves the centroid of vectors to the origin and scales their mean distance to the root of
/// their dimension.
template <int Dimension>
struct Normalisation {
    Eigen::Matrix<double, Dimension, 1> centre;
    double scale = 1.0;

    template <typename Get>
    Normalisation(std::span<const CalibrationPair> pairs, Get get)
        : centre(Eigen::Matrix<double, Dimension, 1>::Zero()) {
        const auto count = static_cast<double>(pairs.size());
        for (const CalibrationPair& pair : pairs)
            centre += get(pair) / count;
        double distance = 0.0;
        for (const CalibrationPair& pair : pairs)
            distance += (get(pair) - centre).norm() / count;
        if (distance > 0.0)
            scale = std::sqrt(static_cast<double>(Dimension)) / distance;
    }

    [[nodiscard]] Eigen::Matrix<double, Dimension, 1>
    operator()(const Eigen::Matrix<double, Dimension, 1>& vector) const {
        return scale * (vector - centre);
    }
    [[nodiscard]] Eigen::Matrix<double, Dimension + 1, Dimension + 1> matrix() const {
        Eigen::Matrix<double, Dimension + 1, Dimension + 1> result;
        result.setIdentity();
        result.template topLeftCorner<Dimension, Dimension>() *= scale;
        result.template topRightCorner<Dimension, 1>() = -scale * centre;
        return result;
    }
};

/// M = K R with an upper triangular K with positive diagonal, for det M > 0.
void decompose(const Eigen::Matrix3d& m, Eigen::Matrix3d& k, Eigen::Matrix3d& r) {
    // From the last row upwards: that of K R is proportional to that of R.
    r.row(2) = m.row(2).normalized();
    k.setZero();
    k(2, 2) = m.row(2).norm();
    k(1, 2) = m.row(1).dot(r.row(2));
    const Eigen::RowVector3d second = m.row(1) - k(1, 2) * r.row(2);
    k(1, 1) = second.norm();
    r.row(1) = second / k(1, 1);
    k(0, 2) = m.row(0).dot(r.row(2));
    k(0, 1) = m.row(0).dot(r.row(1));
    const Eigen::RowVector3d first = m.row(0) - k(0, 2) * r.row(2) - k(0, 1) * r.row(1);
    k(0, 0) = first.norm();
    r.row(0) = first / k(0, 0);
}

/// The nearest rotation to a matrix near one, by Newton's iteration for the polar decomposition.
Eigen::Matrix3d orthonormal(Eigen::Matrix3d r) {
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i)
        r = 0.5 * (r + Eigen::Matrix3d(r.inverse().transpose()));
    return r;
}

/// Eigenvector of the least eigenvalue of a symmetric matrix; condition: ratio of the second least eigenvalue
/// to the largest.
template <int Size>
Eigen::Matrix<double, Size, 1> leastEigenvector(const Eigen::Matrix<double, Size, Size>& squares,
                                                double* condition = nullptr) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(squares);
    if (condition != nullptr)
        *condition = solver.eigenvalues()[1] / solver.eigenvalues()[squares.rows() - 1];
    return solver.eigenvectors().col(0);
}

/// Two rows of an affine map from points to directions around the middle of the image, up to scale.
using Alignment = Eigen::Matrix<double, 2, 4>;

class AlignmentSearch {
    using Row = Eigen::Matrix<double, 8, 1>;

public:
    AlignmentSearch(std::span<const CalibrationPair> pairs, const Eigen::Vector2d& middle_px)
        : m_toUnits(pairs, [](const CalibrationPair& pair) { return pair.p_Sensor_m; }) {
        for (const CalibrationPair& pair : pairs) {
            const Eigen::Vector2d m = pair.pixel - middle_px;
            const Eigen::Vector3d p = m_toUnits(pair.p_Sensor_m);
            const Eigen::RowVector4d point(p.x(), p.y(), p.z(), 1.0);
            m_pixels.push_back(m);
            m_points.emplace_back(point);
            const double distance = std::max(m.norm(), std::numeric_limits<double>::min());
            Row& row = m_rows.emplace_back();
            row << -m.y() / distance * point.transpose(), m.x() / distance * point.transpose();
        }
    }

    /// Least squares over the pairs with these indices.
    [[nodiscard]] Alignment fit(std::span<const Eigen::Index> which) const {
        Eigen::Matrix<double, 8, 8> squares = Eigen::Matrix<double, 8, 8>::Zero();
        for (const Eigen::Index i : which) {
            const Row& row = m_rows[static_cast<std::size_t>(i)];
            squares += row * row.transpose();
        }
        const Row v = leastEigenvector<8>(squares);
        Alignment alignment;
        alignment << v.head<4>().transpose(), v.tail<4>().transpose();
        double sign = 0.0;
        for (const Eigen::Index i : which)
            sign += std::copysign(1.0, m_pixels[static_cast<std::size_t>(i)].dot(direction(alignment, i)));
        return sign < 0.0 ? Alignment(-alignment) : alignment;
    }

    /// Distance of a pixel from the half line on which its point is projected.
    [[nodiscard]] double distance_px(const Alignment& alignment, Eigen::Index i) const {
        const Eigen::Vector2d d = direction(alignment, i);
        const Eigen::Vector2d& m = m_pixels[static_cast<std::size_t>(i)];
        const double length = d.norm();
        if (!(length > 0.0) || d.dot(m) < 0.0)
            return m.norm();
        return std::abs(d.x() * m.y() - d.y() * m.x()) / length;
    }

    [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(m_rows.size()); }
    [[nodiscard]] const Normalisation<3>& toUnits() const { return m_toUnits; }

private:
    [[nodiscard]] Eigen::Vector2d direction(const Alignment& alignment, Eigen::Index i) const {
        return alignment * m_points[static_cast<std::size_t>(i)].transpose();
    }

    Normalisation<3> m_toUnits;
    std::vector<Row> m_rows;
    std::vector<Eigen::Vector2d> m_pixels;
    std::vector<Eigen::RowVector4d> m_points;
};

/// The alignment with the most support, refined on the supporting pairs, and these pairs.
std::optional<Alignment> consensus(const AlignmentSearch& search, double tolerance_px,
                                   std::vector<Eigen::Index>& supporters) {
    constexpr int kMostSamples = 1000;
    constexpr int kFewestSamples = 100;
    constexpr std::size_t kSampleSize = 7;
    std::mt19937_64 engine(1);
    std::vector<Eigen::Index> order(static_cast<std::size_t>(search.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<Eigen::Index>(i);
    std::size_t agreeing = 0; // with the newest alignment
    const auto support = [&](const Alignment& alignment, std::vector<Eigen::Index>* which) {
        double sum = 0.0;
        agreeing = 0;
        for (Eigen::Index i = 0; i < search.size(); ++i) {
            const double share = search.distance_px(alignment, i) / tolerance_px;
            if (share < 1.0) {
                sum += 1.0 - share * share;
                ++agreeing;
                if (which != nullptr)
                    which->push_back(i);
            }
        }
        return sum;
    };
    std::optional<Alignment> best;
    double bestSupport = 0.0;
    // After so many samples one without a wrong pair has been missed with a probability of 1e-9.
    const auto enough = [&] {
        const double right = static_cast<double>(agreeing) / static_cast<double>(search.size());
        const double missed = std::log1p(-std::min(std::pow(right, kSampleSize), 0.99));
        return std::clamp(std::log(1e-9) / std::min(missed, -1e-300), static_cast<double>(kFewestSamples),
                          static_cast<double>(kMostSamples));
    };
    double samples = kMostSamples;
    for (int sample = 0; sample < samples; ++sample) {
        for (std::size_t i = 0; i < kSampleSize; ++i)
            std::swap(order[i], order[i + engine() % (order.size() - i)]);
        const Alignment alignment = search.fit(std::span(order).first(kSampleSize));
        const double found = support(alignment, nullptr);
        if (found > bestSupport) {
            best = alignment;
            bestSupport = found;
            samples = enough();
        }
    }
    constexpr int kRefinements = 5;
    for (int i = 0; best && i < kRefinements; ++i) {
        std::vector<Eigen::Index> which;
        (void)support(*best, &which);
        if (which.size() < kSampleSize)
            return std::nullopt;
        best = search.fit(which);
    }
    if (best)
        (void)support(*best, &supporters);
    return best;
}

struct Candidate {
    CameraParameters camera;
    double error_px = std::numeric_limits<double>::infinity();
};

/// Depth and focal length that best fit the distances from the middle of the image for one kind of lens.
Candidate searchDepth(std::span<const CalibrationPair> pairs, const std::vector<Eigen::Index>& which,
                      const Eigen::Matrix3d& r, const Eigen::Vector2d& shift, bool equidistant,
                      const Eigen::Vector2d& middle_px) {
    std::vector<Eigen::Vector3d> turned;
    std::vector<double> distances_px;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Eigen::Index i : which) {
        const CalibrationPair& pair = pairs[static_cast<std::size_t>(i)];
        Eigen::Vector3d p = r * pair.p_Sensor_m;
        p.head<2>() += shift;
        turned.push_back(p);
        distances_px.push_back((pair.pixel - middle_px).norm());
        lowest = std::min(lowest, p.z());
        highest = std::max(highest, p.z());
    }
    Candidate best;
    const double extent = highest - lowest;
    if (!(extent > 0.0))
        return best;
    constexpr int kDepths = 80;
    std::vector<double> focal(turned.size());
    std::vector<double> errors(turned.size());
    for (int step = 0; step < kDepths; ++step) {
        // The nearest point is assumed at 1/30 to 30 times the extent of the points.
        const double shift_z = extent * std::pow(30.0, 2.0 * step / (kDepths - 1.0) - 1.0) - lowest;
        std::vector<double> seen(turned.size());
        for (std::size_t i = 0; i < turned.size(); ++i) {
            const double across = turned[i].head<2>().norm();
            const double along = turned[i].z() + shift_z;
            seen[i] = equidistant ? std::atan2(across, along) : across / along;
            focal[i] = distances_px[i] / std::max(seen[i], 1e-12);
        }
        const double f = core::upperMedianOf(focal);
        for (std::size_t i = 0; i < turned.size(); ++i)
            errors[i] = std::abs(distances_px[i] - f * seen[i]);
        const double error_px = core::upperMedianOf(errors);
        if (error_px < best.error_px) {
            best.error_px = error_px;
            best.camera.fx_px = f;
            best.camera.fy_px = f;
            best.camera.R_Camera_Sensor = r;
            best.camera.p_Sensor_Camera_m = -r.transpose() * Eigen::Vector3d(shift.x(), shift.y(), shift_z);
        }
    }
    best.camera.cx_px = middle_px.x();
    best.camera.cy_px = middle_px.y();
    if (equidistant)
        best.camera.distortion = equidistantLens();
    return best;
}

} // namespace

RationalDistortion equidistantLens() {
    // atan(r)/r = 1/(1 + 1 s/(3 + 4 s/(5 + 9 s/(7 + ... 36 s/13)))), s = r^2, multiplied out.
    return {50.0 / 39.0, 283.0 / 715.0, 256.0 / 15015.0, 21.0 / 13.0, 105.0 / 143.0, 35.0 / 429.0, 0.0, 0.0};
}

std::optional<CameraParameters> directLinearCamera(std::span<const CalibrationPair> pairs) {
    constexpr std::size_t kFewest = 6;
    if (pairs.size() < kFewest)
        return std::nullopt;
    const Normalisation<2> pixels(pairs, [](const CalibrationPair& pair) { return pair.pixel; });
    const Normalisation<3> points(pairs, [](const CalibrationPair& pair) { return pair.p_Sensor_m; });
    Eigen::Matrix<double, 12, 12> squares = Eigen::Matrix<double, 12, 12>::Zero();
    for (const CalibrationPair& pair : pairs) {
        const Eigen::Vector2d u = pixels(pair.pixel);
        const Eigen::Vector3d p = points(pair.p_Sensor_m);
        Eigen::Matrix<double, 2, 12> equations = Eigen::Matrix<double, 2, 12>::Zero();
        for (int i = 0; i < 2; ++i) {
            equations.row(i).segment<4>(4 * i) << p.x(), p.y(), p.z(), 1.0;
            equations.row(i).tail<4>() << -u[i] * p.x(), -u[i] * p.y(), -u[i] * p.z(), -u[i];
        }
        squares += equations.transpose() * equations;
    }
    double condition = 0.0;
    const Eigen::Matrix<double, 12, 1> v = leastEigenvector<12>(squares, &condition);
    constexpr double kRankTolerance = 1e-14;
    if (!(condition > kRankTolerance))
        return std::nullopt;
    Eigen::Matrix<double, 3, 4> p;
    p << v.segment<4>(0).transpose(), v.segment<4>(4).transpose(), v.segment<4>(8).transpose();
    p = Eigen::Matrix<double, 3, 4>(Eigen::Matrix3d(pixels.matrix().inverse()) * p * points.matrix());

    double inFront = 0.0;
    for (const CalibrationPair& pair : pairs)
        inFront += std::copysign(1.0, p.row(2).head<3>().dot(pair.p_Sensor_m) + p(2, 3));
    if (inFront < 0.0)
        p = -p;
    CameraParameters camera;
    Eigen::Matrix3d m = p.leftCols<3>();
    camera.p_Sensor_Camera_m = -m.inverse() * p.col(3);
    camera.mirrored = m.determinant() < 0.0;
    if (camera.mirrored)
        m.col(1) = -m.col(1);
    Eigen::Matrix3d k;
    decompose(m, k, camera.R_Camera_Sensor);
    k /= k(2, 2);
    camera.R_Camera_Sensor = orthonormal(camera.R_Camera_Sensor);
    camera.fx_px = k(0, 0);
    camera.fy_px = k(1, 1);
    camera.skew_px = k(0, 1);
    camera.cx_px = k(0, 2);
    camera.cy_px = k(1, 2);
    if (!k.allFinite() || !camera.R_Camera_Sensor.allFinite() || !camera.p_Sensor_Camera_m.allFinite())
        return std::nullopt;
    return camera;
}

std::vector<CameraParameters> alignedCameras(std::span<const CalibrationPair> pairs, int width_px,
                                             int height_px) {
    constexpr std::size_t kFewest = 8;
    if (pairs.size() < kFewest)
        return {};
    const Eigen::Vector2d middle_px(0.5 * (width_px - 1), 0.5 * (height_px - 1));
    const AlignmentSearch search(pairs, middle_px);
    // The principal point may be this far from the middle, which moves the pixels off their half lines.
    const double tolerance_px = 0.015 * std::max(width_px, height_px);
    std::vector<Eigen::Index> supporters;
    const std::optional<Alignment> alignment = consensus(search, tolerance_px, supporters);
    if (!alignment || supporters.size() < kFewest)
        return {};

    // Undo the normalisation and the unknown scale of each row.
    Alignment rows;
    rows.leftCols<3>() = alignment->leftCols<3>() * search.toUnits().scale;
    rows.col(3) = alignment->col(3) - rows.leftCols<3>() * search.toUnits().centre;
    for (int i = 0; i < 2; ++i)
        rows.row(i) /= rows.row(i).head<3>().norm();
    if (!rows.allFinite())
        return {};

    std::vector<Candidate> candidates;
    for (const bool mirrored : {false, true}) {
        std::vector<CalibrationPair> flipped(pairs.begin(), pairs.end());
        Alignment turned = rows;
        if (mirrored) {
            for (CalibrationPair& pair : flipped)
                pair.p_Sensor_m.y() = -pair.p_Sensor_m.y();
            turned.col(1) = -turned.col(1);
        }
        Eigen::Matrix3d r;
        r.topRows<2>() = turned.leftCols<3>();
        r.row(2) = r.row(0).cross(r.row(1));
        r = orthonormal(r);
        for (const bool equidistant : {false, true}) {
            Candidate candidate = searchDepth(flipped, supporters, r, turned.col(3), equidistant, middle_px);
            if (!std::isfinite(candidate.error_px))
                continue;
            candidate.camera.mirrored = mirrored;
            if (mirrored)
                candidate.camera.p_Sensor_Camera_m.y() = -candidate.camera.p_Sensor_Camera_m.y();
            candidates.push_back(candidate);
        }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.error_px < b.error_px; });
    std::vector<CameraParameters> cameras;
    // With the wrong handedness the error is about a hundred pixels.
    constexpr double kHopeless = 5.0;
    for (const Candidate& candidate : candidates) {
        if (candidate.error_px <= kHopeless * candidates.front().error_px)
            cameras.push_back(candidate.camera);
    }
    return cameras;
}

} // namespace teleta::vision
