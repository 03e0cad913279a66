// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <span>
#include <string_view>

namespace teleta::pattern {

/// The paper's five levels of vibration, 167, 188, 208, 229, 250 Hz: these are 2/3 to 1 of the full speed in
/// even steps. On the intensity scale of a motor that starts at a third of its full voltage, with a speed
/// in proportion to it (MotorProfile::assumed()), they are 1/2 to 1. level: 1..5, limited to that.
/// Source: TeleTA, 5.3.
[[nodiscard]] constexpr double levelIntensity(int level) {
    return 0.375 + 0.125 * (level < 1 ? 1 : level > 5 ? 5 : level);
}

/// The stimuli of the paper's user study, shapes before stiffness, constant before dynamic:
///   shape.A.static ... shape.F.dynamic: A circle, B rectangle, C triangle, D arc, E line, F point, 2 s each;
///   stiffness.A.static ... stiffness.E.dynamic: level 1 (softest) to 5; dynamic ones 2 s (A) to 0.3 s (E).
/// Names are in English. Thread: any. Source: TeleTA, 5.3, figures 9 and 10.
[[nodiscard]] std::span<const Pattern> builtInPatterns();

/// nullptr when there is none of this id.
[[nodiscard]] const Pattern* findBuiltIn(std::string_view id);

} // namespace teleta::pattern
