// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"

#include <QColor>
#include <QPalette>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::base {

/// Symbol of a device's state; states differ in shape as well as in colour.
/// live: green disc. stale: amber triangle. lost: red disc, crossed. reconnecting: red ring, crossed.
/// connecting: grey ring with a gap. paused: two bars. finished: square. closed: empty ring.
void paintStatusGlyph(QPainter& painter, const QRectF& square, core::DeviceState state,
                      const QPalette& palette);

[[nodiscard]] QColor statusColour(core::DeviceState state, const QPalette& palette);

/// The word for the state, translated: "live", "stale", ...
[[nodiscard]] QString statusWord(core::DeviceState state);

/// An age in a short form: "0.3 s", "12 s", "5 min", "3 h".
[[nodiscard]] QString ageText(double age_s);

} // namespace teleta::base
