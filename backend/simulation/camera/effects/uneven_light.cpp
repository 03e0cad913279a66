// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

/// See scene::UnevenLightSpec.
class UnevenLight : public CameraEffect {
public:
    explicit UnevenLight(const Listed<scene::UnevenLightSpec>& listed)
        : CameraEffect(listed.name())
        , m_spec(listed.spec) {}

    void changeLight(cv::Mat1f& light, const cv::Mat2f& places) override {
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

private:
    scene::UnevenLightSpec m_spec;
};

} // namespace

std::unique_ptr<CameraEffect> makeEffect(const Listed<scene::UnevenLightSpec>& listed) {
    return std::make_unique<UnevenLight>(listed);
}

} // namespace teleta::simulation
