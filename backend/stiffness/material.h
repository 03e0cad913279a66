// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace teleta::stiffness {

/// Class of an object by its stiffness, named after the five objects of the paper; from soft to hard.
enum class Material { sponge, rubberSponge, rubber, wood, metal };

/// Object stiffness k_o of the paper's objects (TeleTA, Table 2).
inline constexpr double kSpongeStiffness_NPerM = 282.0;
inline constexpr double kRubberSpongeStiffness_NPerM = 1325.9;
inline constexpr double kRubberStiffness_NPerM = 7223.9;
inline constexpr double kWoodStiffness_NPerM = 8562.9;

/// Position of metal on the scale. The paper's aluminium is rigid and has no k_o; ten times the stiffness of
/// the paper's link (3468.6 N/m) is used, above which more than 90 % of the compliance is that of the link.
inline constexpr double kMetalStiffness_NPerM = 34686.0;

/// Boundaries between the classes: geometric means of the neighbouring objects.
inline constexpr double kSpongeToRubberSponge_NPerM = 611.477;
inline constexpr double kRubberSpongeToRubber_NPerM = 3094.862;
inline constexpr double kRubberToWood_NPerM = 7864.956;
inline constexpr double kWoodToMetal_NPerM = 17234.058;

/// Range of stiffness of one class: lower <= k_o < upper.
struct MaterialBand {
    Material material = Material::sponge;
    double lower_NPerM = 0.0;          ///< 0 for the softest
    std::optional<double> upper_NPerM; ///< empty for the hardest
    double typical_NPerM = 0.0;        ///< k_o of the paper's object
};

/// All classes from soft to hard, without gaps. Thread: any.
[[nodiscard]] const std::array<MaterialBand, 5>& materialBands();

/// Class of an object. stiffness_NPerM: >= 0. Infinity and NaN are metal: the unknown counts as hard. Thread:
/// any (pure).
[[nodiscard]] Material classify(double stiffness_NPerM);

/// Whether a collision is harmless: true for sponge and rubber sponge, false for rubber, wood and metal
/// (TeleTA, section 2).
[[nodiscard]] bool isSafe(Material material);

/// Level 1 (softest) to 5 of the bracelet's stiffness patterns.
[[nodiscard]] int level(Material material);

/// Name in files and on the command line: "sponge", "rubber_sponge", "rubber", "wood", "metal".
[[nodiscard]] const char* toString(Material material);

} // namespace teleta::stiffness
