// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QRectF>
#include <QSizeF>
#include <QString>

class QPainter;

namespace teleta::base {

/// Where the data of a view come from. Every view of data that are not live says so, and every view of an arm
/// that nothing at the robot stops: by a stripe on the screen, by a badge in a picture that leaves the
/// program. Several data together are what the greatest of theirs says: that data are not of now, or not
/// real, counts for more.
enum class Provenance { live, unguarded, recorded, recordedSimulation, simulated };

/// "SIMULATED", "RECORDED", "RECORDED SIMULATION", "UNGUARDED", translated; empty for live data.
[[nodiscard]] QString provenanceText(Provenance provenance);

/// Violet for simulated data, recorded ones among them; blue-grey for recorded ones of a device; red for an
/// arm without a guard.
[[nodiscard]] QColor provenanceColour(Provenance provenance, const QPalette& palette);

/// A word in a coloured box, for states that must not be missed.
[[nodiscard]] QSizeF badgeSize(const QFont& font, const QString& text);
void paintBadge(QPainter& painter, const QRectF& rect, const QString& text, const QColor& colour);

/// Whether a painter draws what is on the screen only, and not a picture that is copied, saved or printed.
[[nodiscard]] bool paintsScreen(const QPainter& painter);

/// Labels data that are not live at the right end of a line, in the painter's font, in pictures that leave
/// the program: on the screen a stripe does it. Returns the rest of the line, up to a gap (px) before the
/// label; without a label the whole line.
QRectF paintProvenance(QPainter& painter, const QRectF& line, Provenance provenance, const QPalette& palette,
                       double gap);

} // namespace teleta::base
