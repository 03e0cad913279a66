// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <QPalette>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::studyview {

/// "PILOT", "SIMULATED", translated; empty for a real run.
[[nodiscard]] QString modeMark(study::Mode mode);
[[nodiscard]] QColor modeColour(study::Mode mode, const QPalette& palette);

/// Paints it, large and faint, across a picture; nothing for a real run.
void paintWatermark(QPainter& painter, const QRectF& rect, study::Mode mode, const QPalette& palette);

} // namespace teleta::studyview
