// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

CameraEffect makeEffect(const Listed<scene::VignettingSpec>& listed) {
    return {.name = listed.name(),
            .changeLight = [share = listed.spec.share](cv::Mat1f& light, const cv::Mat2f& /*places*/) {
                const double u0 = 0.5 * (light.cols - 1);
                const double v0 = 0.5 * (light.rows - 1);
                const double corner = u0 * u0 + v0 * v0;
                light.forEach([&](float& factor, const int* place) {
                    const double dv = place[0] - v0;
                    const double du = place[1] - u0;
                    factor *= static_cast<float>(1.0 - share * (du * du + dv * dv) / corner);
                });
            }};
}

} // namespace teleta::simulation
