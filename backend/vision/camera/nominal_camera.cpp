// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/nominal_camera.h"

#include <algorithm>
#include <numbers>

namespace teleta::vision {

namespace {

constexpr double kHalfField_rad = 80.0 / 180.0 * std::numbers::pi;
constexpr double kBehind_m = 0.020;

} // namespace

CylinderCamera nominalCamera(int width_px, int height_px, const CylinderSurface& surface) {
    CameraParameters camera;
    camera.width_px = std::max(1, width_px);
    camera.height_px = std::max(1, height_px);
    camera.fx_px = camera.fy_px = 0.5 * camera.width_px / kHalfField_rad;
    camera.cx_px = 0.5 * (camera.width_px - 1);
    camera.cy_px = 0.5 * (camera.height_px - 1);
    // Padé approximant of atan(r) / r.
    camera.distortion = {735.0 / 945.0, 64.0 / 945.0, 0.0, 1050.0 / 945.0, 225.0 / 945.0, 0.0, 0.0, 0.0};
    camera.p_Sensor_Camera_m = {0.0, 0.0, -kBehind_m};
    camera.mirrored = true;
    return {CameraModel::create(camera).value(), surface};
}

} // namespace teleta::vision
