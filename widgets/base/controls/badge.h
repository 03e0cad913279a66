// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QRectF>
#include <QSizeF>
#include <QString>

class QPainter;

namespace teleta::base {

/// Where the data of a view come from. Every view of data that are not live is labelled in violet.
enum class Provenance { live, recorded, simulated, recordedSimulation };

/// "SIMULATED", "RECORDED", "RECORDED SIMULATION", translated; empty for live data.
[[nodiscard]] QString provenanceText(Provenance provenance);

/// A word in a coloured box, for states that must not be missed.
[[nodiscard]] QSizeF badgeSize(const QFont& font, const QString& text);
void paintBadge(QPainter& painter, const QRectF& rect, const QString& text, const QColor& colour);

/// Labels data that are not live at the right end of a line, in the painter's font. Returns the rest of the
/// line, up to a gap (px) before the label; for live data the whole line.
QRectF paintProvenance(QPainter& painter, const QRectF& line, Provenance provenance, const QPalette& palette,
                       double gap);

} // namespace teleta::base
