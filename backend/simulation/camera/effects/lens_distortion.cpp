// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

CameraEffect makeEffect(const Listed<scene::LensDistortionSpec>& listed) {
    return {.name = listed.name(), .changeLens = [spec = listed.spec](vision::CameraParameters& camera) {
                const auto& [k1, k2, k3, k4, k5, k6] = spec.radial;
                const auto& [p1, p2] = spec.tangential;
                camera.distortion = {k1, k2, k3, k4, k5, k6, p1, p2};
            }};
}

} // namespace teleta::simulation
