// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace teleta::base {

/// Fusion, with check boxes and radio buttons whose edge can be seen on dark grounds too: Fusion draws it
/// darker than the ground. Thread: GUI.
class ConsoleStyle : public QProxyStyle {
    Q_OBJECT

public:
    ConsoleStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget = nullptr) const override;
};

} // namespace teleta::base
