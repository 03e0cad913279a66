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

/// Pairs of a camera calibration with what one camera makes of them.
struct CalibratedPairs {
    std::vector<vision::CalibrationPair> pairs;
    std::vector<bool> used; ///< false: the user has excluded the pair; one a pair
    /// One a pair; empty without a camera. Of a pair that is not used, `kept` is false.
    std::vector<vision::PairResidual> residuals;
    std::optional<vision::CameraModel> camera;
    vision::CylinderSurface surface;
    int width_px = 1640;
    int height_px = 1232;
    std::optional<Eigen::Vector3d> next_m; ///< that is to be probed next

    enum class State { unknown, kept, outlier, excluded };
    [[nodiscard]] State state(std::size_t pair) const;
};

/// Residuals of a calibration on the image or on the unrolled cylinder: what the view and its exported
/// figures draw. A dot a pair and an arrow, enlarged, to where the camera projects (image) or locates
/// (cylinder) it; wrong pairs are crosses, excluded ones rings. The image has the circle of the valid radius;
/// the cylinder's dots are coloured by the error along the axis. A large ring shows what is to be probed
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
    /// Where a pair is in a picture of this size.
    [[nodiscard]] QPointF position(std::size_t pair, const QSizeF& size) const;
    /// Where the place to be probed next is; with the camera as it is designed while no other one is known.
    [[nodiscard]] std::optional<QPointF> nextPosition(const QSizeF& size) const;
    /// The pair nearest to a point, within an em.
    [[nodiscard]] std::optional<std::size_t> pairAt(const QPointF& point, const QSizeF& size) const;
    void paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const;
    /// How many times the arrows are enlarged.
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
