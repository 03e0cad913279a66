// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"

#include "widgets/base/console_style.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <cmath>

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

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

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

QFont bold(QFont font) {
    font.setBold(true);
    return font;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    const auto mix = [s](float x, float y) { return x + s * (y - x); };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()),
                            mix(a.alphaF(), b.alphaF()));
}

QColor translucent(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
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

void setTextColour(QWidget* widget, const QColor& colour) {
    QPalette palette = widget->palette();
    palette.setColor(QPalette::WindowText, colour);
    widget->setPalette(palette);
}

void paintFocusFrame(QPainter& painter, const QWidget& view) {
    if (!view.hasFocus())
        return;
    painter.setPen(QPen(view.palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(view.rect().adjusted(0, 0, -1, -1));
}

} // namespace teleta::base
