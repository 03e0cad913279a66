// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strips.h"

#include <QCoreApplication>

#include <numbers>

namespace teleta::charts {

namespace {

constexpr Display kMillimetres{.scale = 1e3};
constexpr Display kMillimetresOfRoot{.scale = 1e3, .root = true};
constexpr Display kDegrees{.scale = 180.0 / std::numbers::pi};

/// By channel.
constexpr std::array<StripText, kChannels> kNames{{
    {QT_TRANSLATE_NOOP("StripTexts", "force")},
    QT_TRANSLATE_NOOP3("StripTexts", "threshold", "of one taxel"),
    QT_TRANSLATE_NOOP3("StripTexts", "CoP", "centre of pressure"),
    QT_TRANSLATE_NOOP3("StripTexts", "CoP", "centre of pressure"),
    QT_TRANSLATE_NOOP3("StripTexts", "CoC", "centre of contact"),
    QT_TRANSLATE_NOOP3("StripTexts", "CoC", "centre of contact"),
    {"x"},
    {"y"},
    {"\u03b1"},
    {"\u221a\u03bb\u2081"},
    {"\u221a\u03bb\u2082"},
    {"\u03bb\u2081/\u03bb\u2082"},
    {QT_TRANSLATE_NOOP("StripTexts", "active")},
    {"x"},
    {"y"},
    {QT_TRANSLATE_NOOP("StripTexts", "moment")},
    {QT_TRANSLATE_NOOP("StripTexts", "shear / load")},
}};

QString translated(const StripText& text) {
    return QCoreApplication::translate("StripTexts", text.text, text.comment);
}

constexpr std::size_t column(Channel channel) {
    return static_cast<std::size_t>(channel);
}

std::array<StripDefinition, kStrips> makeDefinitions() {
    return {{
        {.strip = Strip::force,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Force")},
         .curves = {{.column = column(Channel::force), .display = {}, .colour = 1},
                    {.column = column(Channel::threshold), .display = {}, .colour = 0, .dashed = true}},
         .minimumSpan = 1.0,
         .fromZero = true},
        {.strip = Strip::positionX,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Position x")},
         .unit = "mm",
         .curves = {{.column = column(Channel::copX), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::cocX), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 2.0},
        {.strip = Strip::positionY,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Position y")},
         .unit = "mm",
         .curves = {{.column = column(Channel::copY), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::cocY), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 2.0},
        {.strip = Strip::dzmp,
         .title = QT_TRANSLATE_NOOP3(
             "StripTexts", "DZMP",
             "deviation of the zero moment point: centre of pressure minus centre of contact"),
         .unit = "mm",
         .curves = {{.column = column(Channel::dzmpX), .display = kMillimetres, .colour = 1},
                    {.column = column(Channel::dzmpY), .display = kMillimetres, .colour = 2}},
         .minimumSpan = 1.0},
        {.strip = Strip::orientation,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Orientation")},
         .unit = "\u00b0",
         .curves = {{.column = column(Channel::alphaZ),
                     .display = kDegrees,
                     .colour = 1,
                     .period = std::numbers::pi}},
         .fixedLow = -90.0,
         .fixedHigh = 90.0,
         .fixedStep = 45.0},
        {.strip = Strip::spread,
         .title = QT_TRANSLATE_NOOP3("StripTexts", "Spread",
                                     "standard deviations of the touched area along its principal axes"),
         .unit = "mm",
         .curves = {{.column = column(Channel::lambda1), .display = kMillimetresOfRoot, .colour = 1},
                    {.column = column(Channel::lambda2), .display = kMillimetresOfRoot, .colour = 2}},
         .minimumSpan = 2.0,
         .fromZero = true,
         .shownAtFirst = false},
        {.strip = Strip::ratio,
         .title =
             QT_TRANSLATE_NOOP3("StripTexts", "Edge ratio", "ratio of the eigenvalues of the touched area"),
         .curves = {{.column = column(Channel::ratio), .display = {}, .colour = 1}},
         .minimumSpan = 2.0,
         .fromZero = true,
         .shownAtFirst = false},
        {.strip = Strip::active,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Active taxels")},
         .curves = {{.column = column(Channel::active), .display = {}, .colour = 1, .whole = true}},
         .minimumSpan = 5.0,
         .fromZero = true,
         .shownAtFirst = false},
        {.strip = Strip::shear,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Shear")},
         .curves = {{.column = column(Channel::shearX), .display = {}, .colour = 1},
                    {.column = column(Channel::shearY), .display = {}, .colour = 2}},
         .minimumSpan = 0.1,
         .fromZero = true,
         .ofVectors = true},
        {.strip = Strip::friction,
         .title = {QT_TRANSLATE_NOOP("StripTexts", "Friction")},
         .curves = {{.column = column(Channel::friction), .display = {}, .colour = 1}},
         .minimumSpan = 0.5,
         .fromZero = true,
         .shownAtFirst = false,
         .ofVectors = true},
    }};
}

} // namespace

const StripDefinition& definitionOf(Strip strip) {
    static const std::array<StripDefinition, kStrips> definitions = makeDefinitions();
    return definitions[static_cast<std::size_t>(strip)];
}

QString titleOf(Strip strip) {
    return translated(definitionOf(strip).title);
}

QString nameOf(Channel channel) {
    return translated(kNames[static_cast<std::size_t>(channel)]);
}

} // namespace teleta::charts
