// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"
#include "backend/core/device/device.h"
#include "widgets/base/controls/badge.h"

#include <QCoreApplication>
#include <QFont>
#include <QImage>
#include <QPalette>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <QStringList>

class QPainter;

namespace teleta::camera {

/// The picture of a camera that is only looked at, under a line with its name and its numbers. A picture that
/// is too old is dimmed and says so. Drawn by the view; the exported figure is the picture alone. Thread: GUI
/// (fonts).
class ScenePicture {
    Q_DECLARE_TR_FUNCTIONS(ScenePicture)

public:
    core::ColourImage image;
    QString name;
    core::DeviceState state = core::DeviceState::connecting;
    QStringList numbers; ///< the last one counts most: where there is no room, the first ones go
    QString problem;     ///< why the picture is not of now; empty: it is
    QString reason;      ///< what is behind the problem; may be empty
    base::Provenance provenance = base::Provenance::live;
    QFont font;

    [[nodiscard]] bool isEmpty() const { return image.isEmpty(); }
    /// It shares the pixels, which stay as long as it is used.
    [[nodiscard]] QImage shared() const;
    /// Height of the line above the picture.
    [[nodiscard]] static double captionHeight(const QFont& font);
    /// Place of the picture in a view of this size: as large as possible, in its own shape.
    [[nodiscard]] QRectF imageRect(const QSizeF& size) const;

    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// The picture fills everything, with a badge when it is not live.
    void paintAlone(QPainter& painter, const QSizeF& size, const QPalette& palette) const;

private:
    void paintCaption(QPainter& painter, const QRectF& line, const QPalette& palette) const;
    void paintProblem(QPainter& painter, const QRectF& room, const QPalette& palette) const;
};

} // namespace teleta::camera
