// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/tokens.h"

#include <QColor>
#include <QFont>
#include <QPalette>

class QPainter;
class QWidget;

namespace teleta::base {

enum class ThemeChoice {
    light,
    dark,
    system, ///< follows the desktop's palette
};

/// Sets the Fusion style and the designed palette for the whole application. Thread: GUI.
void applyTheme(ThemeChoice choice);

/// Whether text on this palette is lighter than its background.
[[nodiscard]] bool isDark(const QPalette& palette);

/// A length in px; 1 em is the line height of the widget's font, 16 px with a 10 pt font at scale 1.
[[nodiscard]] int em(const QWidget* widget, double count);
/// The layout grid: half an em, 8 px at scale 1.
[[nodiscard]] int grid(const QWidget* widget, double count = 1.0);

[[nodiscard]] QFont sized(const QFont& font, double factor);
[[nodiscard]] QFont bold(QFont font);

/// Mixes two colours, component-wise in sRGB: a at share 0, b at share 1.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double share);
/// A colour with another opacity, 0..1.
[[nodiscard]] QColor translucent(QColor colour, float opacity);
/// Contrast ratio 1..21 of two opaque colours, WCAG 2.1 section 1.4.3.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);
/// Black or white, whichever reads better on the background.
[[nodiscard]] QColor readableOn(const QColor& background);

/// Sets the text colour of a label. Thread: GUI.
void setTextColour(QWidget* widget, const QColor& colour);
/// Draws a frame around a self-painted view while it has the focus. Changes the painter's pen and brush.
/// Thread: GUI.
void paintFocusFrame(QPainter& painter, const QWidget& view);

} // namespace teleta::base
