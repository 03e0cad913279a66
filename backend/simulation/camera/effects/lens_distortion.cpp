// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/lens_distortion.h"

namespace teleta::simulation {

void LensDistortion::changeLens(vision::CameraParameters& camera) {
    const auto& [k1, k2, k3, k4, k5, k6] = m_spec.radial;
    const auto& [p1, p2] = m_spec.tangential;
    camera.distortion = {k1, k2, k3, k4, k5, k6, p1, p2};
}

} // namespace teleta::simulation
