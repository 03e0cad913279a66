// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_map.h"

#include "backend/sweep/sweep_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::sweep {

namespace {

using figure::svgNumber;

constexpr double kMapLeft = 86.0;
constexpr double kMapTop = 24.0;
constexpr double kMapBottom = 48.0;
constexpr double kMapRight = 6.0;
/// A value is written into its field where it has so much room, px.
constexpr double kRoomForText = 34.0;
constexpr double kLetterWidth = 6.5;

struct MapColour {
    double red, green, blue;
};

/// Stops of viridis, which is equally even for people who see fewer colours.
constexpr std::array<MapColour, 6> kViridis{
    {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};

MapColour colourAt(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double rest = place - static_cast<double>(below);
    const MapColour& a = kViridis[below];
    const MapColour& b = kViridis[below + 1];
    return {std::lerp(a.red, b.red, rest), std::lerp(a.green, b.green, rest),
            std::lerp(a.blue, b.blue, rest)};
}

QString hexOf(const MapColour& colour) {
    return QStringLiteral("#%1%2%3")
        .arg(std::lround(colour.red), 2, 16, QLatin1Char('0'))
        .arg(std::lround(colour.green), 2, 16, QLatin1Char('0'))
        .arg(std::lround(colour.blue), 2, 16, QLatin1Char('0'));
}

bool isDark(const MapColour& colour) {
    return 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue < 140.0;
}

/// Every how many values one is labelled.
std::size_t labelStep(double size, std::size_t values, double room) {
    const double each = size / static_cast<double>(values);
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(room / each)));
}

} // namespace

QString shortNumber(double value) {
    // Rounded first: 20000 rather than 2e+04.
    return QString::number(QString::number(value, 'g', 3).toDouble(), 'g', 6);
}

void drawMap(figure::SvgCanvas& canvas, const MapBox& box, const SweepAxis& x, const SweepAxis& y,
             const ValueRange& range, const QString& heading,
             const std::function<std::optional<double>(std::size_t column, std::size_t row)>& at) {
    const double left = box.left + kMapLeft;
    const double top = box.top + kMapTop;
    const double width = box.width - kMapLeft - kMapRight;
    const double height = box.height - kMapTop - kMapBottom;
    const double fieldWidth = width / static_cast<double>(x.values.size());
    const double fieldHeight = height / static_cast<double>(y.values.size());
    canvas.text(box.left + 24.0, box.top + 15.0, heading, QStringLiteral("ink small bold"));
    for (std::size_t row = 0; row < y.values.size(); ++row) {
        const double fieldTop = top + height - static_cast<double>(row + 1) * fieldHeight;
        for (std::size_t column = 0; column < x.values.size(); ++column) {
            const double fieldLeft = left + static_cast<double>(column) * fieldWidth;
            const std::optional<double> value = at(column, row);
            if (!value) {
                canvas.rectangle(fieldLeft, fieldTop, fieldWidth, fieldHeight,
                                 QStringLiteral("class=\"hollow soft\""));
                canvas.line(fieldLeft, fieldTop + fieldHeight, fieldLeft + fieldWidth, fieldTop,
                            QStringLiteral("soft"));
                continue;
            }
            const MapColour colour = colourAt(range.share(*value));
            canvas.rectangle(fieldLeft, fieldTop, fieldWidth, fieldHeight,
                             QStringLiteral("style=\"fill:%1;stroke:none\"").arg(hexOf(colour)));
            if (fieldWidth >= kRoomForText && fieldHeight >= 14.0)
                canvas.text(fieldLeft + 0.5 * fieldWidth, fieldTop + 0.5 * fieldHeight + 4.0,
                            shortNumber(*value), QStringLiteral("small middle"),
                            isDark(colour) ? QStringLiteral("style=\"fill:#ffffff\"")
                                           : QStringLiteral("style=\"fill:#1b1b1f\""));
        }
    }
    qsizetype longest = 0;
    for (std::size_t column = 0; column < x.values.size(); ++column)
        longest = std::max(longest, valueText(x, column).size());
    const std::size_t everyColumn =
        labelStep(width, x.values.size(), kLetterWidth * static_cast<double>(longest) + 6.0);
    for (std::size_t column = 0; column < x.values.size(); column += everyColumn)
        canvas.text(left + (static_cast<double>(column) + 0.5) * fieldWidth, top + height + 16.0,
                    valueText(x, column), QStringLiteral("soft small middle"));
    const std::size_t everyRow = labelStep(height, y.values.size(), 14.0);
    for (std::size_t row = 0; row < y.values.size(); row += everyRow)
        canvas.text(left - 6.0, top + height - (static_cast<double>(row) + 0.5) * fieldHeight + 4.0,
                    valueText(y, row), QStringLiteral("soft small end"));
    canvas.text(left + 0.5 * width, top + height + 36.0, axisTitle(x), QStringLiteral("ink small middle"));
    const double middle = top + 0.5 * height;
    canvas.text(
        box.left + 14.0, middle, axisTitle(y), QStringLiteral("ink small middle"),
        QStringLiteral("transform=\"rotate(-90 %1 %2)\"").arg(svgNumber(box.left + 14.0), svgNumber(middle)));
}

void drawMapLegend(figure::SvgCanvas& canvas, double left, double top, double width,
                   const ValueRange& range) {
    constexpr int kPieces = 60;
    constexpr double kHeight = 10.0;
    for (int i = 0; i < kPieces; ++i)
        canvas.rectangle(
            left + width * i / kPieces, top, width / kPieces + 0.5, kHeight,
            QStringLiteral("style=\"fill:%1;stroke:none\"").arg(hexOf(colourAt((i + 0.5) / kPieces))));
    canvas.text(left, top + kHeight + 14.0, shortNumber(range.low), QStringLiteral("soft small"));
    canvas.text(left + width, top + kHeight + 14.0, shortNumber(range.high),
                QStringLiteral("soft small end"));
}

} // namespace teleta::sweep
