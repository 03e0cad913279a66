// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pattern/document/pattern_document.h"

#include <QString>

#include <vector>

class QMenu;

namespace teleta::editor {

/// Appends what can be done with the selection of a document.
void fillTimelineMenu(QMenu& menu, PatternDocument& document, double playhead_s);

/// "linear", "hold", ...; translated.
[[nodiscard]] QString easingName(pattern::Easing easing);
/// What a motor is asked at a time, with its speed: lines for a tool tip.
[[nodiscard]] QString valueText(std::size_t track, double time_s, double intensity,
                                const pattern::MotorProfile& motor);
[[nodiscard]] QString pointText(std::size_t track, const pattern::Breakpoint& point,
                                const pattern::MotorProfile& motor);
/// Title and span of an object.
[[nodiscard]] QString objectText(const pattern::PatternObject& object);

/// Numbers as a person types them in a line, with their units, separated by semicolons; empty when one of
/// them is none.
[[nodiscard]] std::vector<double> numbersIn(const QString& text);

} // namespace teleta::editor
