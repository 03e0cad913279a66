// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <span>
#include <string_view>

namespace teleta::pattern {

/// Intensity of the paper's five levels of vibration. Their speeds 167, 188, 208, 229 and 250 Hz are 2/3 to 1
/// of the full speed in even steps. A motor that starts at a third of its full voltage and whose speed is
/// proportional to the voltage (MotorProfile::assumedCoinMotor()) reaches them at intensities of 1/2 to 1.
/// level: clamped to 1..5. Source: TeleTA, 5.3.
[[nodiscard]] constexpr double levelIntensity(int level) {
    return 0.375 + 0.125 * (level < 1 ? 1 : level > 5 ? 5 : level);
}

/// The stimuli of the paper's user study, shapes before stiffness, constant before dynamic ones:
///   shape.A.static ... shape.F.dynamic: A circle, B rectangle, C triangle, D arc, E line, F point, 2 s each;
///   stiffness.A.static ... stiffness.E.dynamic: level 1 (softest) to 5; dynamic ones 2 s (A) to 0.3 s (E).
/// Names are in English. Thread: any. Source: TeleTA, 5.3, figures 9 and 10.
[[nodiscard]] std::span<const Pattern> builtInPatterns();

/// Id of unknownStiffness().
inline constexpr std::string_view kUnknownStiffnessId = "stiffness.unknown";

/// Three short swells of all tactors, 0.9 s: a touch whose stiffness is not reliable. No stimulus of the
/// study, so that builtInPatterns() is without it. Thread: any.
[[nodiscard]] const Pattern& unknownStiffness();

/// The built-in pattern with this id, that for an unknown stiffness too, or nullptr. Thread: any.
[[nodiscard]] const Pattern* findBuiltIn(std::string_view id);

} // namespace teleta::pattern
