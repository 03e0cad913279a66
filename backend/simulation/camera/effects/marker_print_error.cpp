// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

CameraEffect makeEffect(const Listed<scene::MarkerPrintErrorSpec>& listed) {
    return {.name = listed.name(),
            .changePrint = [spec = listed.spec, random = listed.random()](PrintedDots& dots) mutable {
                dots.misprint(spec, random);
            }};
}

} // namespace teleta::simulation
