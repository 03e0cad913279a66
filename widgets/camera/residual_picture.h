// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QCoreApplication>
#include <QFont>
#include <QPalette>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace teleta::camera {

/// Pairs of a camera calibration, with the result of one camera for them.
struct CalibratedPairs {
    std::vector<vision::CalibrationPair> pairs;
    std::vector<bool> used; ///< false: excluded by the user; one per pair
    /// One per pair; empty without a camera. `kept` is false for unused pairs.
    std::vector<vision::PairResidual> residuals;
    std::optional<vision::CameraModel> camera;
    vision::CylinderSurface surface;
    int width_px = 1640;
    int height_px = 1232;
    std::optional<Eigen::Vector3d> next_m; ///< point to be probed next

    enum class State { unknown, kept, outlier, excluded };
    [[nodiscard]] State state(std::size_t pair) const;
};

/// Residuals of a calibration on the image or on the unrolled cylinder, as drawn by the view and its exported
/// figures. Each pair is a dot with an enlarged arrow to where the camera projects (image) or locates
/// (cylinder) it; wrong pairs are crosses, excluded ones rings. The image has the circle of the valid radius;
/// the cylinder's dots are coloured by the error along the axis. A large ring marks the point to be probed
/// next. Thread: GUI (fonts).
class ResidualPicture {
    Q_DECLARE_TR_FUNCTIONS(ResidualPicture)

public:
    enum class Surface { image, cylinder };
    Surface surface = Surface::image;
    CalibratedPairs shown;
    std::optional<std::size_t> selected;
    QFont font;

    [[nodiscard]] QString headline() const;
    /// Place of a pair in a picture of this size.
    [[nodiscard]] QPointF position(std::size_t pair, const QSizeF& size) const;
    /// Place of the point to be probed next, computed with the nominal camera until one is calibrated.
    [[nodiscard]] std::optional<QPointF> nextPosition(const QSizeF& size) const;
    /// The pair nearest to a point, within an em.
    [[nodiscard]] std::optional<std::size_t> pairAt(const QPointF& point, const QSizeF& size) const;
    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// Enlargement of the arrows.
    [[nodiscard]] double enlargement(const QSizeF& size) const;

private:
    [[nodiscard]] QRectF extent() const;
    [[nodiscard]] QRectF plotRect(const QSizeF& size) const;
    [[nodiscard]] QPointF toPlot(const QPointF& value, const QSizeF& size) const;
    [[nodiscard]] QPointF valueOf(std::size_t pair) const;
    [[nodiscard]] std::optional<QPointF> shiftOf(std::size_t pair) const;
    void paintAxes(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    void paintPairs(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    void paintNext(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    void paintScale(QPainter& painter, const QSizeF& size, const QPalette& palette, double limit_mm) const;
    [[nodiscard]] double axialLimit_mm() const;
};

} // namespace teleta::camera
