// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"

#include "widgets/base/console_style.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QStyle>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace teleta::base {

namespace {

struct PaletteColours {
    QRgb window, base, alternate, text, faintText, disabledText;
    QRgb button, light, midlight, mid, dark, shadow;
    QRgb accent, onAccent, link, visited, tipBase, tipText;
};

constexpr PaletteColours kLight{
    .window = 0xffeceef1,
    .base = 0xffffffff,
    .alternate = 0xfff4f6f8,
    .text = 0xff1b2026,
    .faintText = 0xff6a737d,
    .disabledText = 0xff8b939c,
    .button = 0xffe6e9ed,
    .light = 0xffffffff,
    .midlight = 0xffdfe3e8,
    .mid = 0xffc2c8d0,
    .dark = 0xff98a1ab,
    .shadow = 0xff5c6670,
    .accent = 0xff1a66b3,
    .onAccent = 0xffffffff,
    .link = 0xff1a66b3,
    .visited = 0xff6b4a9e,
    .tipBase = 0xfffdfdfd,
    .tipText = 0xff1b2026,
};

constexpr PaletteColours kDark{
    .window = 0xff24282d,
    .base = 0xff1b1e22,
    .alternate = 0xff21252a,
    .text = 0xffe2e6ea,
    .faintText = 0xff98a2ad,
    .disabledText = 0xff6e7781,
    .button = 0xff31363d,
    .light = 0xff4b525b,
    .midlight = 0xff3a4048,
    .mid = 0xff454c55,
    .dark = 0xff15181b,
    .shadow = 0xff0c0e10,
    .accent = 0xff2e74be,
    .onAccent = 0xffffffff,
    .link = 0xff6db3f7,
    .visited = 0xffb596e8,
    .tipBase = 0xff31363d,
    .tipText = 0xffe2e6ea,
};

QPalette paletteOf(const PaletteColours& c) {
    QPalette palette;
    const auto all = [&palette](QPalette::ColorRole role, QRgb colour) {
        palette.setColor(role, QColor(colour));
    };
    all(QPalette::Window, c.window);
    all(QPalette::WindowText, c.text);
    all(QPalette::Base, c.base);
    all(QPalette::AlternateBase, c.alternate);
    all(QPalette::Text, c.text);
    all(QPalette::PlaceholderText, c.faintText);
    all(QPalette::Button, c.button);
    all(QPalette::ButtonText, c.text);
    all(QPalette::BrightText, c.onAccent);
    all(QPalette::Light, c.light);
    all(QPalette::Midlight, c.midlight);
    all(QPalette::Mid, c.mid);
    all(QPalette::Dark, c.dark);
    all(QPalette::Shadow, c.shadow);
    all(QPalette::Highlight, c.accent);
    all(QPalette::HighlightedText, c.onAccent);
    all(QPalette::Link, c.link);
    all(QPalette::LinkVisited, c.visited);
    all(QPalette::ToolTipBase, c.tipBase);
    all(QPalette::ToolTipText, c.tipText);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, QColor(c.disabledText));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(c.mid));
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor(c.text));
    return palette;
}

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

} // namespace

QPalette designedPalette(bool dark) {
    return paletteOf(dark ? kDark : kLight);
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::WindowText)) > luminance(palette.color(QPalette::Window));
}

void applyTheme(ThemeChoice choice) {
    if (qobject_cast<ConsoleStyle*>(QApplication::style()) == nullptr)
        QApplication::setStyle(new ConsoleStyle);
    bool dark = choice == ThemeChoice::dark;
    if (choice == ThemeChoice::system) {
        QApplication::setPalette(QPalette()); // restores the desktop's palette, to inspect it
        dark = isDark(QApplication::palette());
    }
    QApplication::setPalette(designedPalette(dark));
}

const StatusColours& statusColours(const QPalette& palette) {
    static const StatusColours light{
        .live = QColor(0xff1a7337),
        .stale = QColor(0xff8a5800),
        .lost = QColor(0xffc0222b),
        .simulated = QColor(0xff7a3bb8),
        .neutral = QColor(0xff59626c),
        .stop = QColor(0xffc8102e),
    };
    static const StatusColours dark{
        .live = QColor(0xff4fc46e),
        .stale = QColor(0xfff2b632),
        .lost = QColor(0xffff7a70),
        .simulated = QColor(0xffc596f8),
        .neutral = QColor(0xffa3adb8),
        .stop = QColor(0xffd3182c),
    };
    return isDark(palette) ? dark : light;
}

int em(const QWidget* widget, double count) {
    return static_cast<int>(std::lround(QFontMetricsF(widget->font()).height() * count));
}

int grid(const QWidget* widget, double count) {
    return em(widget, 0.5 * count);
}

QFont sized(const QFont& font, double factor) {
    QFont result = font;
    if (font.pointSizeF() > 0.0)
        result.setPointSizeF(font.pointSizeF() * factor);
    else
        result.setPixelSize(std::max(1, static_cast<int>(std::lround(font.pixelSize() * factor))));
    return result;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    const auto mix = [s](float x, float y) { return x + s * (y - x); };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()),
                            mix(a.alphaF(), b.alphaF()));
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor readableOn(const QColor& background) {
    return contrast(background, Qt::white) >= contrast(background, Qt::black) ? QColor(Qt::white)
                                                                              : QColor(Qt::black);
}

} // namespace teleta::base
