// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace teleta::stiffness {

/// What an object feels like, after the five objects of the paper, from soft to hard.
enum class Material { sponge, rubberSponge, rubber, wood, metal };

/// Object stiffness k_o of the paper's objects (TeleTA, Table 2).
inline constexpr double kSpongeStiffness_NPerM = 282.0;
inline constexpr double kRubberSpongeStiffness_NPerM = 1325.9;
inline constexpr double kRubberStiffness_NPerM = 7223.9;
inline constexpr double kWoodStiffness_NPerM = 8562.9;

/// The paper's aluminium is rigid and has no k_o. Its place on the scale is ten times the stiffness of the
/// paper's link (3468.6 N/m): from there on nine tenths of what yields is the link.
inline constexpr double kMetalStiffness_NPerM = 34686.0;

/// Borders between the classes: geometric means of the neighbours.
inline constexpr double kSpongeToRubberSponge_NPerM = 611.477;
inline constexpr double kRubberSpongeToRubber_NPerM = 3094.862;
inline constexpr double kRubberToWood_NPerM = 7864.956;
inline constexpr double kWoodToMetal_NPerM = 17234.058;

/// The part of the stiffness scale that belongs to one class: lower <= k_o < upper.
struct MaterialBand {
    Material material = Material::sponge;
    double lower_NPerM = 0.0;          ///< 0 for the softest
    std::optional<double> upper_NPerM; ///< empty for the hardest
    double typical_NPerM = 0.0;        ///< k_o of the paper's object
};

/// All bands from soft to hard, without gaps. Thread: any.
[[nodiscard]] const std::array<MaterialBand, 5>& materialBands();

/// Class of an object. stiffness_NPerM: >= 0; infinite is metal. NaN is metal too: the unknown is taken as
/// hard.
[[nodiscard]] Material classify(double stiffness_NPerM);

/// Sponge and rubber sponge do the arm no harm; rubber, wood and metal are a danger (TeleTA, section 2).
[[nodiscard]] bool isSafe(Material material);

/// Level 1..5 of the bracelet's stiffness patterns.
[[nodiscard]] int level(Material material);

/// Value in files and on the command line: "sponge", "rubber_sponge", "rubber", "wood", "metal".
[[nodiscard]] const char* toString(Material material);
[[nodiscard]] std::optional<Material> materialFromString(std::string_view text);

} // namespace teleta::stiffness
