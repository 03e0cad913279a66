// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/tokens.h"

#include "widgets/base/theme.h"

namespace teleta::base {

namespace {

/// A role's colour on a light and on a dark background.
struct RoleColours {
    QPalette::ColorRole role;
    QRgb light, dark;
};

constexpr RoleColours kColours[]{
    {QPalette::Window, 0xffeceef1, 0xff24282d},      {QPalette::WindowText, 0xff1b2026, 0xffe2e6ea},
    {QPalette::Base, 0xffffffff, 0xff1b1e22},        {QPalette::AlternateBase, 0xfff4f6f8, 0xff21252a},
    {QPalette::Text, 0xff1b2026, 0xffe2e6ea},        {QPalette::PlaceholderText, 0xff6a737d, 0xff98a2ad},
    {QPalette::Button, 0xffe6e9ed, 0xff31363d},      {QPalette::ButtonText, 0xff1b2026, 0xffe2e6ea},
    {QPalette::BrightText, 0xffffffff, 0xffffffff},  {QPalette::Light, 0xffffffff, 0xff4b525b},
    {QPalette::Midlight, 0xffdfe3e8, 0xff3a4048},    {QPalette::Mid, 0xffc2c8d0, 0xff454c55},
    {QPalette::Dark, 0xff98a1ab, 0xff15181b},        {QPalette::Shadow, 0xff5c6670, 0xff0c0e10},
    {QPalette::Highlight, 0xff1a66b3, 0xff2e74be},   {QPalette::HighlightedText, 0xffffffff, 0xffffffff},
    {QPalette::Link, 0xff1a66b3, 0xff6db3f7},        {QPalette::LinkVisited, 0xff6b4a9e, 0xffb596e8},
    {QPalette::ToolTipBase, 0xfffdfdfd, 0xff31363d}, {QPalette::ToolTipText, 0xff1b2026, 0xffe2e6ea},
};
constexpr QRgb kDisabledLight = 0xff8b939c;
constexpr QRgb kDisabledDark = 0xff6e7781;

// Shares of the colour of text in that of the ground.
constexpr double kEdgeShare = 0.57;
constexpr double kFaintShare = 0.16;
constexpr double kHoverShare = 0.06;
constexpr double kGrooveShare = 0.14;
constexpr double kHandleShare = 0.5;
constexpr double kPressedShare = 0.2; ///< of the accent

} // namespace

QPalette designedPalette(bool dark) {
    QPalette palette;
    for (const auto& [role, onLight, onDark] : kColours)
        palette.setColor(role, QColor(dark ? onDark : onLight));
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, QColor(dark ? kDisabledDark : kDisabledLight));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, palette.color(QPalette::Mid));
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, palette.color(QPalette::Text));
    return palette;
}

const StatusColours& statusColours(const QPalette& palette) {
    static const StatusColours light{
        .live = QColor(0xff1a7337),
        .stale = QColor(0xff8a5800),
        .lost = QColor(0xffc0222b),
        .simulated = QColor(0xff7a3bb8),
        .recorded = QColor(0xff41607f),
        .neutral = QColor(0xff59626c),
        .stop = QColor(0xffc8102e),
    };
    static const StatusColours dark{
        .live = QColor(0xff4fc46e),
        .stale = QColor(0xfff2b632),
        .lost = QColor(0xffff7a70),
        .simulated = QColor(0xffc596f8),
        .recorded = QColor(0xff9db8d4),
        .neutral = QColor(0xffa3adb8),
        .stop = QColor(0xffd3182c),
    };
    return isDark(palette) ? dark : light;
}

const SpaceColours& spaceColours(bool dark) {
    static const SpaceColours onLight{
        .tube = QColor(0xff4c6680),
        .shell = QColor(0xffd2d7dd),
        .joint = QColor(0xff4a525c),
        .axes = {QColor(0xffb8322a), QColor(0xff2a7d3c), QColor(0xff2262b4)},
    };
    static const SpaceColours onDark{
        .tube = QColor(0xff9aaec0),
        .shell = QColor(0xffb4bac2),
        .joint = QColor(0xff5a626c),
        .axes = {QColor(0xfff07c72), QColor(0xff6cc47c), QColor(0xff74aef0)},
    };
    return dark ? onDark : onLight;
}

ControlColours controlColours(const QPalette& palette, bool enabled) {
    const QColor ground = palette.color(QPalette::Window);
    const QColor text = palette.color(QPalette::Active, QPalette::WindowText);
    const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
    const QColor ring = isDark(palette) ? palette.color(QPalette::Active, QPalette::Link) : accent;
    const auto share = [&](double of) { return mixed(ground, text, of); };
    return {.edge = share(enabled ? kEdgeShare : kFaintShare),
            .faint = share(kFaintShare),
            .hover = share(kHoverShare),
            .pressed = mixed(ground, accent, kPressedShare),
            .accent = enabled ? accent : share(kGrooveShare),
            .ring = ring,
            .onAccent = palette.color(enabled ? QPalette::Active : QPalette::Disabled,
                                      enabled ? QPalette::HighlightedText : QPalette::ButtonText),
            .groove = share(kGrooveShare),
            .handle = share(kHandleShare)};
}

} // namespace teleta::base
