// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

CameraEffect makeEffect(const Listed<scene::MotionBlurSpec>& listed) {
    CameraEffect effect{.name = listed.name()};
    for (int moment = 0; moment < listed.spec.samples; ++moment)
        effect.before_s.push_back(listed.spec.exposure_s * (listed.spec.samples - 1 - moment) /
                                  (listed.spec.samples - 1));
    return effect;
}

} // namespace teleta::simulation
