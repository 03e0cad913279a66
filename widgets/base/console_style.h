// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace teleta::base {

/// Fusion with check boxes and radio buttons whose edges are visible on dark backgrounds too: plain Fusion
/// draws them darker than the background. Thread: GUI.
class ConsoleStyle : public QProxyStyle {
    Q_OBJECT

public:
    ConsoleStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget = nullptr) const override;
};

} // namespace teleta::base
