// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strips.h"

#include <numbers>

namespace teleta::charts {

namespace {

constexpr Display kMillimetres{.scale = 1e3};
constexpr Display kMillimetresOfRoot{.scale = 1e3, .root = true};
constexpr Display kDegrees{.scale = 180.0 / std::numbers::pi};

constexpr std::size_t column(Channel channel) {
    return static_cast<std::size_t>(channel);
}

std::array<StripDefinition, kStrips> makeDefinitions() {
    return {{
        {.strip = Strip::force,
         .curves = {{.column = column(Channel::force), .display = {}, .colour = 1},
                    {.column = column(Channel::threshold), .display = {}, .colour = 0, .dashed = true}},
         .minimumSpan = 1.0,
         .fromZero = true},
        {.strip = Strip::positionX,
         .curves = {{.column = column(Channel::copX), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::cocX), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 2.0},
        {.strip = Strip::positionY,
         .curves = {{.column = column(Channel::copY), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::cocY), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 2.0},
        {.strip = Strip::dzmp,
         .curves = {{.column = column(Channel::dzmpX), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::dzmpY), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 1.0},
        {.strip = Strip::orientation,
         .curves = {{.column = column(Channel::alphaZ),
                     .display = kDegrees,
                     .colour = 1,
                     .period = std::numbers::pi}},
         .fixedLow = -90.0,
         .fixedHigh = 90.0,
         .fixedStep = 45.0},
        {.strip = Strip::spread,
         .curves = {{.column = column(Channel::lambda1), .display = kMillimetresOfRoot, .colour = 1},
                    {.column = column(Channel::lambda2), .display = kMillimetresOfRoot, .colour = 2}},
         .minimumSpan = 2.0,
         .fromZero = true,
         .shownAtFirst = false},
        {.strip = Strip::ratio,
         .curves = {{.column = column(Channel::ratio), .display = {}, .colour = 1}},
         .minimumSpan = 2.0,
         .fromZero = true,
         .shownAtFirst = false},
        {.strip = Strip::active,
         .curves = {{.column = column(Channel::active), .display = {}, .colour = 1, .whole = true}},
         .minimumSpan = 5.0,
         .fromZero = true,
         .shownAtFirst = false},
    }};
}

} // namespace

const StripDefinition& definitionOf(Strip strip) {
    static const std::array<StripDefinition, kStrips> definitions = makeDefinitions();
    return definitions[static_cast<std::size_t>(strip)];
}

QString StripTexts::title(Strip strip) {
    switch (strip) {
    case Strip::force:
        return tr("Force");
    case Strip::positionX:
        return tr("Position x");
    case Strip::positionY:
        return tr("Position y");
    case Strip::dzmp:
        return tr("DZMP", "deviation of the zero moment point: centre of pressure minus centre of contact");
    case Strip::orientation:
        return tr("Orientation");
    case Strip::spread:
        return tr("Spread", "standard deviations of the touched area along its principal axes");
    case Strip::ratio:
        return tr("Edge ratio", "ratio of the eigenvalues of the touched area");
    case Strip::active:
        return tr("Active taxels");
    }
    return {};
}

QString StripTexts::unit(Strip strip, const QString& loadUnit) {
    switch (strip) {
    case Strip::force:
        return loadUnit;
    case Strip::positionX:
    case Strip::positionY:
    case Strip::dzmp:
    case Strip::spread:
        return QStringLiteral("mm");
    case Strip::orientation:
        return QStringLiteral("\u00b0");
    case Strip::ratio:
    case Strip::active:
        break;
    }
    return {};
}

QString StripTexts::name(Channel channel) {
    switch (channel) {
    case Channel::force:
        return tr("force");
    case Channel::threshold:
        return tr("threshold", "of one taxel");
    case Channel::copX:
    case Channel::copY:
        return tr("CoP", "centre of pressure");
    case Channel::cocX:
    case Channel::cocY:
        return tr("CoC", "centre of contact");
    case Channel::dzmpX:
        return QStringLiteral("x");
    case Channel::dzmpY:
        return QStringLiteral("y");
    case Channel::alphaZ:
        return QStringLiteral("\u03b1");
    case Channel::lambda1:
        return QStringLiteral("\u221a\u03bb\u2081");
    case Channel::lambda2:
        return QStringLiteral("\u221a\u03bb\u2082");
    case Channel::ratio:
        return QStringLiteral("\u03bb\u2081/\u03bb\u2082");
    case Channel::active:
        return tr("active");
    }
    return {};
}

QString StripTexts::key(Strip strip) {
    constexpr std::array<const char*, kStrips> kKeys{"force",       "position_x", "position_y", "dzmp",
                                                     "orientation", "spread",     "edge_ratio", "active"};
    return QString::fromLatin1(kKeys[static_cast<std::size_t>(strip)]);
}

} // namespace teleta::charts
