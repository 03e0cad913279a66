// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/skin_sample.h"

namespace teleta::vision {

std::optional<SkinSample> skinSample(const CylinderCamera& camera, const Eigen::Vector2d& pixel) {
    const auto hit = camera.locate_m(pixel);
    if (!hit)
        return std::nullopt;
    const auto projection = camera.camera().projectWithDerivatives(*hit);
    if (!projection)
        return std::nullopt;
    const double radius_m = camera.surface().radius_m;
    const Eigen::Vector3d outward(hit->x() / radius_m, hit->y() / radius_m, 0.0);
    const Eigen::Vector3d around(-outward.y(), outward.x(), 0.0);
    Eigen::Matrix2d byDisplacement;
    byDisplacement << projection->byPoint * around, projection->byPoint * -outward;
    Eigen::Matrix2d bySurface;
    bySurface << projection->byPoint * around, projection->byPoint * Eigen::Vector3d::UnitZ();
    constexpr double kLeastDeterminant_px2PerM2 = 1.0;
    if (!(std::abs(byDisplacement.determinant()) > kLeastDeterminant_px2PerM2) ||
        !(std::abs(bySurface.determinant()) > kLeastDeterminant_px2PerM2))
        return std::nullopt;
    return SkinSample{.p_Sensor_m = *hit,
                      .metresPerPixel = byDisplacement.inverse(),
                      .surfacePerPixel = bySurface.inverse()};
}

} // namespace teleta::vision
