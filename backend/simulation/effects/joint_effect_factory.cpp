// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/joint_effect_factory.h"

#include "backend/simulation/effects/encoder_quantization.h"
#include "backend/simulation/effects/gear_ripple.h"
#include "backend/simulation/effects/gravity_error.h"
#include "backend/simulation/effects/torque_noise.h"

namespace teleta::simulation {

namespace {

/// Makes the effect that the scene lists of one kind.
template <typename Spec, typename Make>
void addListed(const scene::Scene& scene, std::vector<std::unique_ptr<JointEffect>>& effects,
               const Make& make) {
    for (const scene::Effect& listed : scene.effects) {
        if (const auto* spec = std::get_if<Spec>(&listed.parameters))
            effects.push_back(make(nameOf(listed), *spec));
    }
}

} // namespace

std::vector<std::unique_ptr<JointEffect>> makeJointEffects(const scene::Scene& scene, std::uint64_t seed) {
    using Name = std::string_view;
    std::vector<std::unique_ptr<JointEffect>> effects;
    addListed<scene::GravityErrorSpec>(scene, effects, [&](Name name, const scene::GravityErrorSpec& spec) {
        return std::make_unique<GravityError>(name, spec, scene.arm().body);
    });
    addListed<scene::GearRippleSpec>(scene, effects, [](Name name, const scene::GearRippleSpec& spec) {
        return std::make_unique<GearRipple>(name, spec);
    });
    addListed<scene::TorqueNoiseSpec>(scene, effects, [&](Name name, const scene::TorqueNoiseSpec& spec) {
        return std::make_unique<TorqueNoise>(name, spec, RandomStream(seed, name));
    });
    addListed<scene::EncoderQuantizationSpec>(scene, effects,
                                              [](Name name, const scene::EncoderQuantizationSpec& spec) {
                                                  return std::make_unique<EncoderQuantization>(name, spec);
                                              });
    return effects;
}

} // namespace teleta::simulation
