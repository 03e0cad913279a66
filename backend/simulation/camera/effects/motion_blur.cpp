// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

namespace {

/// See scene::MotionBlurSpec.
class MotionBlur : public CameraEffect {
public:
    explicit MotionBlur(const Listed<scene::MotionBlurSpec>& listed)
        : CameraEffect(listed.name())
        , m_spec(listed.spec) {}

    [[nodiscard]] int moments() const override { return m_spec.samples; }
    [[nodiscard]] double before_s(int moment) const override {
        return m_spec.exposure_s * (m_spec.samples - 1 - moment) / (m_spec.samples - 1);
    }

private:
    scene::MotionBlurSpec m_spec;
};

} // namespace

std::unique_ptr<CameraEffect> makeEffect(const Listed<scene::MotionBlurSpec>& listed) {
    return std::make_unique<MotionBlur>(listed);
}

} // namespace teleta::simulation
