// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/material.h"

#include <cmath>

namespace teleta::stiffness {

const std::array<MaterialBand, 5>& materialBands() {
    static const std::array<MaterialBand, 5> bands{{
        {Material::sponge, 0.0, kSpongeToRubberSponge_NPerM, kSpongeStiffness_NPerM},
        {Material::rubberSponge, kSpongeToRubberSponge_NPerM, kRubberSpongeToRubber_NPerM,
         kRubberSpongeStiffness_NPerM},
        {Material::rubber, kRubberSpongeToRubber_NPerM, kRubberToWood_NPerM, kRubberStiffness_NPerM},
        {Material::wood, kRubberToWood_NPerM, kWoodToMetal_NPerM, kWoodStiffness_NPerM},
        {Material::metal, kWoodToMetal_NPerM, std::nullopt, kMetalStiffness_NPerM},
    }};
    return bands;
}

Material classify(double stiffness_NPerM) {
    for (const MaterialBand& band : materialBands())
        if (band.upper_NPerM && std::isless(stiffness_NPerM, *band.upper_NPerM))
            return band.material;
    return Material::metal;
}

bool isSafe(Material material) {
    return material == Material::sponge || material == Material::rubberSponge;
}

int level(Material material) {
    return static_cast<int>(material) + 1;
}

const char* toString(Material material) {
    switch (material) {
    case Material::sponge:
        return "sponge";
    case Material::rubberSponge:
        return "rubber_sponge";
    case Material::rubber:
        return "rubber";
    case Material::wood:
        return "wood";
    case Material::metal:
        return "metal";
    }
    return "";
}

} // namespace teleta::stiffness
