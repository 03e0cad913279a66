// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_plane.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace teleta::vision {

namespace {

struct PlaneText {
    Q_DECLARE_TR_FUNCTIONS(GelPlane)
};

constexpr double kMmPerM = 1000.0;
constexpr int kMostSteps = 30;
constexpr double kClosest = 1e-12; ///< on the plane at unit distance

RationalDistortion distortionOf(const MarkerGelFile::Lens& lens) {
    RationalDistortion distortion;
    distortion.k1 = lens.k1;
    distortion.k2 = lens.k2;
    distortion.k3 = lens.k3;
    distortion.p1 = lens.p1;
    distortion.p2 = lens.p2;
    return distortion;
}

Eigen::Vector2d onUnitPlane(const MarkerGelFile::Lens& lens, const Eigen::Vector2d& pixel) {
    return {(pixel.x() - lens.cx_px) / lens.fx_px, (pixel.y() - lens.cy_px) / lens.fy_px};
}

/// Newton's method, started at the distorted place.
Eigen::Vector2d withoutLens(const MarkerGelFile::Lens& lens, const Eigen::Vector2d& pixel) {
    const RationalDistortion distortion = distortionOf(lens);
    const Eigen::Vector2d seen = onUnitPlane(lens, pixel);
    Eigen::Vector2d point = seen;
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::Vector2d off = distortion.apply(point) - seen;
        if (off.squaredNorm() < kClosest * kClosest)
            break;
        point -= distortion.slope(point).inverse() * off;
    }
    return {lens.fx_px * point.x() + lens.cx_px, lens.fy_px * point.y() + lens.cy_px};
}

} // namespace

Eigen::Vector2d GelPlane::undistorted(const MarkerGelFile& gel, const Eigen::Vector2d& pixel) {
    return gel.lens ? withoutLens(*gel.lens, pixel) : pixel;
}

core::Expected<GelPlane> GelPlane::make(const MarkerGelFile& gel, int width_px, int height_px,
                                        double pitch_px) {
    GelPlane plane;
    plane.m_lens = gel.lens;
    const std::array<Eigen::Vector2d, 4> corners{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(width_px, 0.0),
                                                 Eigen::Vector2d(0.0, height_px),
                                                 Eigen::Vector2d(width_px, height_px)};
    if (gel.lens) {
        // The undistorted corner may lie further out than the seen one.
        constexpr double kFarther = 4.0;
        double seen = 0.0;
        for (const Eigen::Vector2d& corner : corners)
            seen = std::max(seen, onUnitPlane(*gel.lens, corner).norm());
        const RationalDistortion distortion = distortionOf(*gel.lens);
        const double open = monotoneRadius(distortion, kFarther * seen);
        if (!(open > 0.0) || distortion.radial(open) < seen)
            return core::refused(PlaneText::tr("The lens in the file folds within the picture."),
                                 PlaneText::tr("a lens that shows each place once"));
    }
    if (gel.plane.homography.size() == 9) {
        for (Eigen::Index i = 0; i < 9; ++i)
            plane.m_homography(i / 3, i % 3) = gel.plane.homography[static_cast<std::size_t>(i)];
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (const Eigen::Vector2d& corner : corners) {
            const double depth = plane.m_homography.row(2) * undistorted(gel, corner).homogeneous();
            least = std::min(least, depth);
            most = std::max(most, depth);
        }
        if (!(least > 0.0 || most < 0.0))
            return core::refused(PlaneText::tr("The homography sends pixels of the picture to infinity."),
                                 PlaneText::tr("a matrix that maps the picture onto a plane"));
        return plane;
    }
    const double scale_m =
        (gel.plane.pitch_mm ? *gel.plane.pitch_mm / pitch_px : gel.plane.mmPerPx.value_or(1.0)) / kMmPerM;
    plane.m_homography(0, 0) = scale_m;
    plane.m_homography(1, 1) = scale_m;
    return plane;
}

Eigen::Vector2d GelPlane::surface_m(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d straight = m_lens ? withoutLens(*m_lens, pixel) : pixel;
    return (m_homography * straight.homogeneous()).hnormalized();
}

double GelPlane::scale_m(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d alongU =
        surface_m(pixel + Eigen::Vector2d(0.5, 0.0)) - surface_m(pixel - Eigen::Vector2d(0.5, 0.0));
    const Eigen::Vector2d alongV =
        surface_m(pixel + Eigen::Vector2d(0.0, 0.5)) - surface_m(pixel - Eigen::Vector2d(0.0, 0.5));
    return std::sqrt(std::abs(alongU.x() * alongV.y() - alongU.y() * alongV.x()));
}

} // namespace teleta::vision
