// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/vignetting.h"

namespace teleta::simulation {

void Vignetting::changeLight(cv::Mat1f& light, const cv::Mat2f& /*places*/) {
    const double u0 = 0.5 * (light.cols - 1);
    const double v0 = 0.5 * (light.rows - 1);
    const double corner = u0 * u0 + v0 * v0;
    light.forEach([&](float& factor, const int* place) {
        const double dv = place[0] - v0;
        const double du = place[1] - u0;
        factor *= static_cast<float>(1.0 - m_spec.share * (du * du + dv * dv) / corner);
    });
}

} // namespace teleta::simulation
