// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::simulation {

struct JointEffect;
struct CameraEffect;

/// The type of the effects that act on this.
template <scene::ActsOn kOn>
using EffectOn = std::conditional_t<
    kOn == scene::ActsOn::taxels, TaxelEffect,
    std::conditional_t<kOn == scene::ActsOn::joints, JointEffect,
                       std::conditional_t<kOn == scene::ActsOn::camera, CameraEffect, void>>>;

// GCC suspects that the friend below was meant to be a template. It was not: each row has a maker of its own.
#pragma GCC diagnostic push
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wnon-template-friend"
#endif

/// An effect that a scene lists, and what its maker may need. Each row of the table of effects
/// (backend/scene/effects.h) that acts on taxels, joints or a camera has its maker in the effect's own
/// source; without one, the program does not link.
template <typename Spec>
struct Listed {
    const Spec& spec;
    const scene::Scene& scene;
    std::uint64_t seed = 0;
    double step_s = 0.0; ///< from one frame of the taxels to the next

    [[nodiscard]] std::string_view name() const { return Spec::kRow.name; }
    [[nodiscard]] core::RandomStream random() const { return core::RandomStream(seed, name()); }

    friend EffectOn<Spec::kRow.actsOn> makeEffect(const Listed<Spec>& listed);
};

#pragma GCC diagnostic pop

/// The effects that a valid scene lists and that act on this, in the order of the table. Each has its own
/// random stream.
template <scene::ActsOn kOn>
[[nodiscard]] std::vector<EffectOn<kOn>> makeEffects(const scene::Scene& scene, std::uint64_t seed,
                                                     double step_s = 0.0) {
    std::vector<EffectOn<kOn>> effects;
    const auto add = [&]<typename Spec>(std::type_identity<Spec>) {
        if constexpr (Spec::kRow.actsOn == kOn) {
            if (const Spec* spec = scene.listed<Spec>())
                effects.push_back(makeEffect(Listed<Spec>{*spec, scene, seed, step_s}));
        }
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (add(std::type_identity<std::variant_alternative_t<I, scene::EffectParameters>>()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<scene::EffectParameters>>());
    return effects;
}

} // namespace teleta::simulation
