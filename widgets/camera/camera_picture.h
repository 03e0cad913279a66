// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/base/controls/badge.h"

#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QPointF>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::camera {

/// The image of the camera in the soft tube with what was found in it: displacements of the pattern, outlines
/// and identities of contacts, bumps, and why a frame cannot be used. Drawn by the view and its exported
/// figure. Thread: GUI (fonts).
class CameraPicture {
    Q_DECLARE_TR_FUNCTIONS(CameraPicture)

public:
    /// Smaller displacements (pixels) are noise and have no arrow.
    static constexpr double kLeastArrow_px = 0.5;
    static constexpr double kLargestZoom = 12.0;

    pipeline::CameraSnapshot shown;
    base::Provenance provenance = base::Provenance::live;
    bool arrows = true;
    bool paused = false;
    QFont font;
    double zoom = 1.0;        ///< 1: the whole image
    QPointF centre{0.5, 0.5}; ///< of the visible part, as shares of the image
    double enlargement = 4.0; ///< of the arrows
    double bumpFade = 0.0;    ///< 1: a bump was just detected, 0: long ago
    int bumped = 0;           ///< identity of the contact that bumped

    [[nodiscard]] bool isEmpty() const { return shown.preview.isEmpty(); }
    /// Place of the image in a picture of this size.
    [[nodiscard]] QRectF imageRect(const QSizeF& size) const;
    [[nodiscard]] QPointF toPicture(const QPointF& pixel, const QSizeF& size) const;
    [[nodiscard]] QPointF toPixel(const QPointF& point, const QSizeF& size) const;
    /// Zooms about the pixel at a point.
    void zoomAt(const QPointF& point, const QSizeF& size, double factor);
    void moveBy(const QPointF& way, const QSizeF& size);
    /// Index of the contact at a point; -1: none.
    [[nodiscard]] int contactAt(const QPointF& point, const QSizeF& size) const;
    [[nodiscard]] QString wordsFor(const vision::FollowedContact& followed) const;

    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// One row per contact: kContactColumns without event, and sd_m. C locale, NA where unknown.
    [[nodiscard]] QString csv() const;

private:
    [[nodiscard]] double scale(const QSizeF& size) const;
    void paintImage(QPainter& painter, const QSizeF& size) const;
    void paintArrows(QPainter& painter, const QSizeF& size) const;
    void paintContacts(QPainter& painter, const QSizeF& size) const;
    void paintState(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
};

} // namespace teleta::camera
