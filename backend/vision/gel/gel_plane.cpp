// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_plane.h"

#include "backend/core/failure.h"
#include "backend/vision/gel/marker_layout.h"

#include <QCoreApplication>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace teleta::vision {

namespace {

struct PlaneText {
    Q_DECLARE_TR_FUNCTIONS(GelPlane)
};

constexpr double kMmPerM = 1000.0;

tl::expected<CameraModel, CameraModel::Refusal> lensOf(const MarkerGelFile::Lens& lens, int width_px,
                                                       int height_px) {
    CameraParameters camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px = lens.fx_px;
    camera.fy_px = lens.fy_px;
    camera.cx_px = lens.cx_px;
    camera.cy_px = lens.cy_px;
    camera.distortion.k1 = lens.k1;
    camera.distortion.k2 = lens.k2;
    camera.distortion.k3 = lens.k3;
    camera.distortion.p1 = lens.p1;
    camera.distortion.p2 = lens.p2;
    return CameraModel::create(camera);
}

} // namespace

core::Expected<GelPlane> GelPlane::make(const MarkerGelFile& gel, int width_px, int height_px,
                                        std::span<const Eigen::Vector2d> markers_px) {
    GelPlane plane;
    const std::array<Eigen::Vector2d, 4> corners{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(width_px, 0.0),
                                                 Eigen::Vector2d(0.0, height_px),
                                                 Eigen::Vector2d(width_px, height_px)};
    if (gel.lens) {
        const auto lens = lensOf(*gel.lens, width_px, height_px);
        if (!lens || !std::ranges::all_of(corners, [&](const Eigen::Vector2d& corner) {
                return lens->undistort(corner).has_value();
            }))
            return core::refused(PlaneText::tr("The lens in the file folds within the picture."),
                                 PlaneText::tr("a lens that shows each place once"));
        plane.m_lens = *lens;
    }
    if (gel.plane.homography.size() == 9) {
        for (Eigen::Index i = 0; i < 9; ++i)
            plane.m_homography(i / 3, i % 3) = gel.plane.homography[static_cast<std::size_t>(i)];
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (const Eigen::Vector2d& corner : corners) {
            const double depth = plane.m_homography.row(2) * plane.undistorted(corner).homogeneous();
            least = std::min(least, depth);
            most = std::max(most, depth);
        }
        if (!(least > 0.0 || most < 0.0))
            return core::refused(PlaneText::tr("The homography sends pixels of the picture to infinity."),
                                 PlaneText::tr("a matrix that maps the picture onto a plane"));
        return plane;
    }
    double scale_m = gel.plane.mmPerPx.value_or(1.0) / kMmPerM;
    if (gel.plane.pitch_mm) {
        std::vector<Eigen::Vector2d> straight_px;
        for (const Eigen::Vector2d& marker : markers_px)
            straight_px.push_back(plane.undistorted(marker));
        scale_m = *gel.plane.pitch_mm / nearestDistance_px(straight_px) / kMmPerM;
    }
    plane.m_homography(0, 0) = scale_m;
    plane.m_homography(1, 1) = scale_m;
    return plane;
}

Eigen::Vector2d GelPlane::undistorted(const Eigen::Vector2d& pixel) const {
    if (!m_lens)
        return pixel;
    const auto point = m_lens->undistort(pixel);
    if (!point)
        return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    const CameraParameters& camera = m_lens->parameters();
    return {camera.fx_px * point->x() + camera.cx_px, camera.fy_px * point->y() + camera.cy_px};
}

Eigen::Vector2d GelPlane::surface_m(const Eigen::Vector2d& pixel) const {
    return (m_homography * undistorted(pixel).homogeneous()).hnormalized();
}

double GelPlane::scale_m(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d alongU =
        surface_m(pixel + Eigen::Vector2d(0.5, 0.0)) - surface_m(pixel - Eigen::Vector2d(0.5, 0.0));
    const Eigen::Vector2d alongV =
        surface_m(pixel + Eigen::Vector2d(0.0, 0.5)) - surface_m(pixel - Eigen::Vector2d(0.0, 0.5));
    return std::sqrt(std::abs(alongU.x() * alongV.y() - alongU.y() * alongV.x()));
}

} // namespace teleta::vision
