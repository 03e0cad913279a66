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

} // namespace teleta::base
