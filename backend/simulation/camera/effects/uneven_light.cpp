// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/uneven_light.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

void UnevenLight::changeLight(cv::Mat1f& light, const cv::Mat2f& places) {
    constexpr double kDarkest = 0.1;
    light.forEach([&](float& factor, const int* place) {
        const cv::Vec2f& skin = places(place[0], place[1]);
        if (std::isnan(skin[0]))
            return;
        const double wave =
            1.0 - 0.5 * m_spec.ripple * (1.0 - std::cos(m_spec.lamps * static_cast<double>(skin[0])));
        const double fall = 1.0 - m_spec.fallPerMetre * static_cast<double>(skin[1]);
        factor *= static_cast<float>(std::max(kDarkest, wave * fall));
    });
}

} // namespace teleta::simulation
