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

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

} // namespace

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
