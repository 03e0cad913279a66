// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/effect_factory.h"

#include "backend/simulation/effects/crosstalk.h"
#include "backend/simulation/effects/dead_taxels.h"
#include "backend/simulation/effects/drift.h"
#include "backend/simulation/effects/gain_spread.h"
#include "backend/simulation/effects/hysteresis.h"
#include "backend/simulation/effects/latency.h"
#include "backend/simulation/effects/noise.h"
#include "backend/simulation/effects/nonlinear_response.h"
#include "backend/simulation/effects/quantization.h"
#include "backend/simulation/effects/saturation.h"

namespace teleta::simulation {

namespace {

/// Makes the effects that the scene lists of one kind.
template <typename Spec, typename Make>
void addListed(const scene::Scene& scene, std::vector<std::unique_ptr<Effect>>& effects, const Make& make) {
    for (const scene::Effect& listed : scene.effects) {
        if (const auto* spec = std::get_if<Spec>(&listed.parameters))
            effects.push_back(make(nameOf(listed), *spec));
    }
}

} // namespace

std::vector<std::unique_ptr<Effect>> makeEffects(const scene::Scene& scene, double frameRate_Hz,
                                                 std::uint64_t seed) {
    using Name = std::string_view;
    const core::ArrayLayout& layout = scene.taxels();
    const double fullScale_N = scene.fullScale_N();
    std::vector<std::unique_ptr<Effect>> effects;
    addListed<scene::CrosstalkSpec>(scene, effects, [&](Name name, const scene::CrosstalkSpec& spec) {
        return std::make_unique<Crosstalk>(name, spec, layout);
    });
    addListed<scene::HysteresisSpec>(scene, effects, [&](Name name, const scene::HysteresisSpec& spec) {
        return std::make_unique<Hysteresis>(name, spec, layout);
    });
    addListed<scene::NonlinearResponseSpec>(
        scene, effects, [&](Name name, const scene::NonlinearResponseSpec& spec) {
            return std::make_unique<NonlinearResponse>(name, spec, fullScale_N);
        });
    addListed<scene::GainSpreadSpec>(scene, effects, [&](Name name, const scene::GainSpreadSpec& spec) {
        return std::make_unique<GainSpread>(name,
                                            gainFactors(spec, layout.taxels(), RandomStream(seed, name)));
    });
    addListed<scene::DriftSpec>(scene, effects, [&](Name name, const scene::DriftSpec& spec) {
        return std::make_unique<Drift>(name, spec, layout, 1.0 / frameRate_Hz, RandomStream(seed, name));
    });
    addListed<scene::NoiseSpec>(scene, effects, [&](Name name, const scene::NoiseSpec& spec) {
        return std::make_unique<Noise>(name, spec, RandomStream(seed, name));
    });
    addListed<scene::SaturationSpec>(scene, effects, [&](Name name, const scene::SaturationSpec&) {
        return std::make_unique<Saturation>(name, fullScale_N);
    });
    addListed<scene::QuantizationSpec>(scene, effects, [&](Name name, const scene::QuantizationSpec& spec) {
        return std::make_unique<Quantization>(name, spec);
    });
    addListed<scene::DeadTaxelsSpec>(scene, effects, [&](Name name, const scene::DeadTaxelsSpec& spec) {
        return std::make_unique<DeadTaxels>(name, spec, layout, RandomStream(seed, name));
    });
    addListed<scene::LatencySpec>(scene, effects, [&](Name name, const scene::LatencySpec& spec) {
        return std::make_unique<Latency>(name, spec, layout, 1.0 / frameRate_Hz);
    });
    return effects;
}

} // namespace teleta::simulation
