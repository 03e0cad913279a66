// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/base/random_stream.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <utility>

namespace teleta::simulation {

/// See scene::MarkerPrintErrorSpec.
class MarkerPrintError : public CameraEffect {
public:
    MarkerPrintError(std::string_view name, const scene::MarkerPrintErrorSpec& spec, RandomStream random)
        : CameraEffect(name)
        , m_spec(spec)
        , m_random(std::move(random)) {}

    void changePrint(PrintedDots& dots) override { dots.misprint(m_spec, m_random); }

private:
    scene::MarkerPrintErrorSpec m_spec;
    RandomStream m_random;
};

} // namespace teleta::simulation
