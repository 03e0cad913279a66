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

/// Asks with which camera, or video of one, the tube is probed, and through which holes. Window modal, opened
/// by the user. Thread: GUI.
class LiveProbingDialog : public QDialog {
    Q_OBJECT

public:
    /// last: the camera or video of the last time.
    LiveProbingDialog(const QString& last, const vision::HoleGrid& grid, QWidget* parent = nullptr,
                      const CameraSourceField::Lister& cameras = camera::listCameras);

    /// A file or the number of a camera.
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

/// A camera that is asked for the image that is to be calibrated, or a video that is played at its own rate.
[[nodiscard]] camera::CameraConfig probingCamera(const QString& source,
                                                 const vision::CalibrationSettings& settings);
[[nodiscard]] LiveProbing::Opener cameraOpener(const QString& source,
                                               const vision::CalibrationSettings& settings);

} // namespace teleta::console
