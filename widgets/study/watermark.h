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

/// Paints it, large and faint, across a picture; nothing for a real run.
void paintWatermark(QPainter& painter, const QRectF& rect, Mode mode, const QPalette& palette);

} // namespace teleta::study
