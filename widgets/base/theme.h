// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

class QWidget;

namespace teleta::base {

enum class ThemeChoice {
    light,
    dark,
    system, ///< light or dark as the desktop's own palette is
};

/// Sets the Fusion style and the designed palette for the whole application.
/// Thread: GUI.
void applyTheme(ThemeChoice choice);

/// The two palettes, each designed on its own; views take every colour from here or from a data map.
[[nodiscard]] QPalette designedPalette(bool dark);
/// Whether text on this palette is lighter than its background.
[[nodiscard]] bool isDark(const QPalette& palette);

/// Colours with a meaning. Each reaches a contrast of 4.5:1 on Window and on Base, so it can carry text.
/// Never the only sign of a state: a word and a shape go with it.
struct StatusColours {
    QColor live;
    QColor stale;
    QColor lost;
    QColor simulated; ///< violet: the data is not real
    QColor neutral;   ///< paused, closed, connecting
    QColor stop;      ///< background of STOP, under white text
};
[[nodiscard]] const StatusColours& statusColours(const QPalette& palette);

/// Font-relative lengths in px: 1 em is the line height of the widget's font, 16 px with a 10 pt font at
/// scale 1.
[[nodiscard]] int em(const QWidget* widget, double count);
/// The layout grid: half an em, 8 px at scale 1.
[[nodiscard]] int grid(const QWidget* widget, double count = 1.0);

/// The four sizes of text, in em of the system font.
inline constexpr double kSmallText = 0.85;
inline constexpr double kNormalText = 1.0;
inline constexpr double kLargeText = 1.4;
inline constexpr double kHugeText = 2.2;
[[nodiscard]] QFont sized(const QFont& font, double factor);

/// a where share is 0, b where it is 1; component-wise in sRGB.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double share);
/// Contrast ratio 1..21 of two opaque colours, WCAG 2.1 section 1.4.3.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);
/// Black or white, whichever reads better on the background.
[[nodiscard]] QColor readableOn(const QColor& background);

} // namespace teleta::base
