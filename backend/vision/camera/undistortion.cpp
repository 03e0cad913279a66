// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/undistortion.h"

#include <algorithm>
#include <cmath>

namespace teleta::vision {

std::optional<Eigen::Vector2d> undistortByIteration(const CameraParameters& camera,
                                                    const Eigen::Vector2d& pixel, int iterations) {
    const RationalDistortion& lens = camera.distortion;
    Eigen::Vector2d target;
    target.y() = (pixel.y() - camera.cy_px) / camera.fy_px;
    target.x() = (pixel.x() - camera.cx_px - camera.skew_px * target.y()) / camera.fx_px;
    Eigen::Vector2d point = target;
    for (int i = 0; i < iterations; ++i) {
        const double s = point.squaredNorm();
        const Eigen::Vector2d decentring(
            2.0 * lens.p1 * point.x() * point.y() + lens.p2 * (s + 2.0 * point.x() * point.x()),
            lens.p1 * (s + 2.0 * point.y() * point.y()) + 2.0 * lens.p2 * point.x() * point.y());
        point = (target - decentring) * (lens.denominator(s) / lens.numerator(s));
    }
    if (!std::isfinite(point.x()) || !std::isfinite(point.y()))
        return std::nullopt;
    return point;
}

DirectionTable::DirectionTable(const CameraModel& camera, int step_px)
    : m_step_px(std::max(1, step_px))
    , m_columns(static_cast<int>(std::ceil((camera.parameters().width_px - 1) / m_step_px)) + 1)
    , m_rows(static_cast<int>(std::ceil((camera.parameters().height_px - 1) / m_step_px)) + 1) {
    m_direction.reserve(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column) {
            const auto point = camera.undistort({column * m_step_px, row * m_step_px});
            m_direction.push_back(point ? Eigen::Vector3d(point->x(), point->y(), 1.0).normalized()
                                        : Eigen::Vector3d(Eigen::Vector3d::Zero()));
        }
}

std::optional<Eigen::Vector3d> DirectionTable::direction(const Eigen::Vector2d& pixel) const {
    const double x = pixel.x() / m_step_px;
    const double y = pixel.y() / m_step_px;
    if (!(x >= 0.0 && y >= 0.0 && x <= m_columns - 1 && y <= m_rows - 1))
        return std::nullopt;
    const int column = std::min(static_cast<int>(x), std::max(0, m_columns - 2));
    const int row = std::min(static_cast<int>(y), std::max(0, m_rows - 2));
    const double u = x - column;
    const double v = y - row;
    const auto node = [&](int right, int down) -> const Eigen::Vector3d& {
        return m_direction[static_cast<std::size_t>(std::min(row + down, m_rows - 1)) *
                               static_cast<std::size_t>(m_columns) +
                           static_cast<std::size_t>(std::min(column + right, m_columns - 1))];
    };
    for (const int right : {0, 1})
        for (const int down : {0, 1})
            if (node(right, down).isZero(0.0))
                return std::nullopt;
    const Eigen::Vector3d sum =
        (1.0 - v) * ((1.0 - u) * node(0, 0) + u * node(1, 0)) + v * ((1.0 - u) * node(0, 1) + u * node(1, 1));
    return Eigen::Vector3d(sum.normalized());
}

} // namespace teleta::vision
