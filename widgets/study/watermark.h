// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <QPalette>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::study {

/// "PILOT", "SIMULATED", translated; empty for a real run.
[[nodiscard]] QString modeMark(Mode mode);
[[nodiscard]] QColor modeColour(Mode mode, const QPalette& palette);

/// Marks a picture that is of no real run: on the screen by a stripe along its top, in one that leaves the
/// program by the word, large and faint, across it.
void paintWatermark(QPainter& painter, const QRectF& rect, Mode mode, const QPalette& palette);

} // namespace teleta::study
