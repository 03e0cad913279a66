// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/live_probing.h"
#include "app/console/sources/camera_source_field.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/camera/hole_grid.h"
#include "devices/camera/camera_config.h"

#include <QDialog>
#include <QString>

class QDoubleSpinBox;
class QPushButton;
class QSpinBox;

namespace teleta::console {

/// Asks for the camera, or the video of one, and for the holes through which the tube is probed. Window
/// modal, opened by the user. Thread: GUI.
class LiveProbingDialog : public QDialog {
    Q_OBJECT

public:
    /// last: the previous camera or video.
    LiveProbingDialog(const QString& last, const vision::HoleGrid& grid, QWidget* parent = nullptr,
                      const CameraSourceField::Lister& cameras = camera::listCameras);

    /// File name, or number of a camera.
    [[nodiscard]] QString source() const;
    [[nodiscard]] vision::HoleGrid grid() const;

private:
    CameraSourceField* m_source;
    QSpinBox* m_around;
    QSpinBox* m_along;
    QDoubleSpinBox* m_first;
    QDoubleSpinBox* m_last;
    QDoubleSpinBox* m_angle;
    QPushButton* m_accept;
};

/// Opens a camera with the image size to be calibrated, or a video at its own frame rate.
[[nodiscard]] camera::CameraConfig probingCamera(const QString& source,
                                                 const vision::CalibrationSettings& settings);
[[nodiscard]] LiveProbing::Opener cameraOpener(const QString& source,
                                               const vision::CalibrationSettings& settings);

} // namespace teleta::console
