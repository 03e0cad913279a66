// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pattern/document/pattern_document.h"

#include <QString>

#include <array>
#include <vector>

class QMenu;

namespace teleta::pattern {

/// Appends the actions for the selection of a document.
void fillTimelineMenu(QMenu& menu, PatternDocument& document, double playhead_s);

inline constexpr std::array kEasings{Easing::linear, Easing::hold, Easing::easeIn, Easing::easeOut,
                                     Easing::easeInOut};
/// "linear", "hold", ...; translated.
[[nodiscard]] QString easingName(Easing easing);
/// Tool tip with the commanded intensity of a motor at a time, and its speed.
[[nodiscard]] QString valueText(std::size_t track, double time_s, double intensity,
                                const MotorProfile& motor);
[[nodiscard]] QString pointText(std::size_t track, const Breakpoint& point, const MotorProfile& motor);
/// Title and span of an object.
[[nodiscard]] QString objectText(const PatternObject& object);

/// Parses numbers typed with their units and separated by semicolons; empty when one is not a number.
[[nodiscard]] std::vector<double> numbersIn(const QString& text);

} // namespace teleta::pattern
