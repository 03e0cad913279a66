// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include <array>

/// What everything on the screen is made of: colours, distances, radii, sizes of text. The style, the
/// painters, the charts and the 3-D view read it; nothing else names a colour.
namespace teleta::base {

/// Distances in units of the layout grid, 8 px at scale 1: see grid().
inline constexpr double kHair = 0.125;   ///< 1 px: edges
inline constexpr double kStripe = 0.375; ///< 3 px: marks of provenance, of a tab, of a page
inline constexpr double kTight = 0.5;    ///< 4 px: icon to text
inline constexpr double kNear = 1.0;     ///< 8 px: what belongs together
inline constexpr double kApart = 1.5;    ///< 12 px: inside of a card
inline constexpr double kGroup = 2.0;    ///< 16 px: between groups
inline constexpr double kSection = 3.0;  ///< 24 px: between sections

/// Radii, likewise.
inline constexpr double kControlRadius = 0.5; ///< 4 px
inline constexpr double kCardRadius = 1.0;    ///< 8 px

/// Sizes of text, in em of the system font.
inline constexpr double kSmallText = 0.85;
inline constexpr double kNormalText = 1.0;
inline constexpr double kTitleText = 1.15; ///< titles of groups and cards
inline constexpr double kLargeText = 1.5;  ///< titles of pages
inline constexpr double kHugeText = 2.2;   ///< readings

/// The light and the dark palette, each designed by itself. Surfaces in three steps: Window around, Button
/// for what lies on it, Base for views and fields.
[[nodiscard]] QPalette designedPalette(bool dark);

/// Colours with a meaning. Each has a contrast of at least 4.5:1 on Window and on Base, so it can be used for
/// text. Colour is never the only sign of a state: a word and a shape go with it.
struct StatusColours {
    QColor live;
    QColor stale;
    QColor lost;
    QColor simulated; ///< violet: the data are not real
    QColor recorded;  ///< blue-grey: the data are not of now
    QColor neutral;   ///< paused, closed, connecting
    QColor stop;      ///< background of STOP, under white text
};
[[nodiscard]] const StatusColours& statusColours(const QPalette& palette);

/// Colours of the 3-D view that are not data.
struct SpaceColours {
    QColor tube;
    QColor shell;               ///< links of an arm
    QColor joint;               ///< its joints and its base
    std::array<QColor, 3> axes; ///< x, y, z
};
[[nodiscard]] const SpaceColours& spaceColours(bool dark);

/// Colours of controls, by the palette of the control. Edge and focus have a contrast of at least 3:1 on
/// Window and on Base.
struct ControlColours {
    QColor edge;    ///< of fields, boxes and buttons
    QColor faint;   ///< of what is no control: groups, tables, menus
    QColor hover;   ///< ground under the mouse
    QColor pressed; ///< ground of what is pressed or on
    QColor accent;  ///< ground of what is chosen
    QColor ring;    ///< around what has the focus
    QColor onAccent;
    QColor groove; ///< of sliders, bars and scroll bars
    QColor handle; ///< of scroll bars
};
[[nodiscard]] ControlColours controlColours(const QPalette& palette, bool enabled);

} // namespace teleta::base
