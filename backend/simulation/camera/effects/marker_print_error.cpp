// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

namespace {

/// See scene::MarkerPrintErrorSpec.
class MarkerPrintError : public CameraEffect {
public:
    explicit MarkerPrintError(const Listed<scene::MarkerPrintErrorSpec>& listed)
        : CameraEffect(listed.name())
        , m_spec(listed.spec)
        , m_random(listed.random()) {}

    void changePrint(PrintedDots& dots) override { dots.misprint(m_spec, m_random); }

private:
    scene::MarkerPrintErrorSpec m_spec;
    core::RandomStream m_random;
};

} // namespace

std::unique_ptr<CameraEffect> makeEffect(const Listed<scene::MarkerPrintErrorSpec>& listed) {
    return std::make_unique<MarkerPrintError>(listed);
}

} // namespace teleta::simulation
