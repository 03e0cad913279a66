// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"
#include "widgets/base/controls/badge.h"

#include <QColor>
#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <cstddef>

class QPainter;

namespace teleta::camera {

/// The picture of a flat gel with the displacements of its markers, the outlines of contacts with their
/// numbers, and how much of each contact slips. Drawn by the view and its exported figure. Thread: GUI
/// (fonts).
class GelPicture {
    Q_DECLARE_TR_FUNCTIONS(GelPicture)

public:
    /// Displacements below so many standard deviations of a marker's place have no arrow.
    static constexpr double kLeastArrow = 3.0;

    pipeline::GelSnapshot shown;
    base::Provenance provenance = base::Provenance::live;
    bool arrows = true;
    bool paused = false;
    QFont font;
    double enlargement = 4.0; ///< of the arrows

    [[nodiscard]] bool isEmpty() const { return shown.image.isEmpty(); }
    /// Place of the image in a picture of this size.
    [[nodiscard]] QRectF imageRect(const QSizeF& size) const;
    [[nodiscard]] QPointF toPicture(const QPointF& pixel, const QSizeF& size) const;
    /// Index of the contact at a point; -1: none.
    [[nodiscard]] int contactAt(const QPointF& point, const QSizeF& size) const;
    [[nodiscard]] static QString wordsFor(const vision::GelContactState& contact);
    /// What is known of a contact, line by line: wordsFor(), and its loads.
    [[nodiscard]] static QString wordsFor(const pipeline::GelSnapshot& snapshot, std::size_t contact);
    /// "1.25 ± 0.05 N" of each load of a contact, with its name; what is beyond the presses is marked. Empty
    /// without a calibration.
    [[nodiscard]] static QStringList loadTexts(const pipeline::GelSnapshot& snapshot, std::size_t contact);
    /// "slip 0.42", or that the index is not known.
    [[nodiscard]] static QString slipText(const vision::GelContactState& contact);
    /// Of a slip index; over the picture, as on a dark ground.
    [[nodiscard]] static QColor slipColour(const vision::GelContactState& contact, bool onDark = true);

    /// The displacement that the legend's arrow stands for, and how long it is on the screen.
    struct Legend {
        double length_m = 0.0;
        double length_px = 0.0;
    };
    [[nodiscard]] Legend legend(const QSizeF& size) const;

    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// One row per marker: vision::kMarkerColumns. C locale, NA where unknown.
    [[nodiscard]] QString csv() const;

private:
    [[nodiscard]] double scale(const QSizeF& size) const;
    [[nodiscard]] QPolygonF outlineOf(const vision::GelContactState& contact, const QSizeF& size) const;
    void paintImage(QPainter& painter, const QSizeF& size) const;
    void paintArrows(QPainter& painter, const QSizeF& size) const;
    void paintContacts(QPainter& painter, const QSizeF& size) const;
    void paintLegend(QPainter& painter, const QSizeF& size) const;
    void paintState(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
};

} // namespace teleta::camera
