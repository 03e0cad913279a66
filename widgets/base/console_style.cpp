// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/console_style.h"

#include "widgets/base/theme.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace teleta::base {

namespace {

constexpr double kEdgeOfText = 0.65; ///< as much of the colour of text: a contrast over 3 in both themes

} // namespace

ConsoleStyle::ConsoleStyle()
    : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {
}

void ConsoleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isBox = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
    if (!isBox && element != PE_IndicatorRadioButton)
        return;
    const bool isFocused =
        option->state.testFlag(State_HasFocus) && option->state.testFlag(State_KeyboardFocusChange);
    const QColor edge = isFocused ? option->palette.color(QPalette::Highlight)
                                  : mixed(option->palette.color(QPalette::Base),
                                          option->palette.color(QPalette::Text), kEdgeOfText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(edge, 1.0));
    painter->setBrush(Qt::NoBrush);
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (isBox)
        painter->drawRoundedRect(box, 1.5, 1.5);
    else
        painter->drawEllipse(box);
    painter->restore();
}

} // namespace teleta::base
