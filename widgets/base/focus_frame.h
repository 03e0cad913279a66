// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;
class QWidget;

namespace teleta::base {

/// Frames a view that draws itself while it has the keyboard. Changes the painter's pen and brush. Thread:
/// GUI.
void paintFocusFrame(QPainter& painter, const QWidget& view);

} // namespace teleta::base
