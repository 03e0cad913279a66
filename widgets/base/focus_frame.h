// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;
class QWidget;

namespace teleta::base {

/// Draws a frame around a self-painted view while it has the keyboard focus. Changes the painter's pen and
/// brush. Thread: GUI.
void paintFocusFrame(QPainter& painter, const QWidget& view);

} // namespace teleta::base
