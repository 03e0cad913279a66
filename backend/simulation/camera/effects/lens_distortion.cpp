// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

namespace {

/// See scene::LensDistortionSpec.
class LensDistortion : public CameraEffect {
public:
    explicit LensDistortion(const Listed<scene::LensDistortionSpec>& listed)
        : CameraEffect(listed.name())
        , m_spec(listed.spec) {}

    void changeLens(vision::CameraParameters& camera) override {
        const auto& [k1, k2, k3, k4, k5, k6] = m_spec.radial;
        const auto& [p1, p2] = m_spec.tangential;
        camera.distortion = {k1, k2, k3, k4, k5, k6, p1, p2};
    }

private:
    scene::LensDistortionSpec m_spec;
};

} // namespace

std::unique_ptr<CameraEffect> makeEffect(const Listed<scene::LensDistortionSpec>& listed) {
    return std::make_unique<LensDistortion>(listed);
}

} // namespace teleta::simulation
