// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

CameraEffect makeEffect(const Listed<scene::UnevenLightSpec>& listed) {
    return {.name = listed.name(),
            .changeLight = [spec = listed.spec](cv::Mat1f& light, const cv::Mat2f& places) {
                constexpr double kDarkest = 0.1;
                light.forEach([&](float& factor, const int* place) {
                    const cv::Vec2f& skin = places(place[0], place[1]);
                    if (std::isnan(skin[0]))
                        return;
                    const double wave =
                        1.0 - 0.5 * spec.ripple * (1.0 - std::cos(spec.lamps * static_cast<double>(skin[0])));
                    const double fall = 1.0 - spec.fallPerMetre * static_cast<double>(skin[1]);
                    factor *= static_cast<float>(std::max(kDarkest, wave * fall));
                });
            }};
}

} // namespace teleta::simulation
