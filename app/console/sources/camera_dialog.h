// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/camera_source_field.h"
#include "app/sources/source_request.h"

#include <QDialog>

class QCheckBox;
class QLineEdit;
class QPushButton;

namespace teleta::console {

/// Asks for a camera in the soft tube, or a video of one, and for its calibration; without one the camera is
/// only looked at. Window modal, opened by the user, never by a device. Thread: GUI.
class CameraDialog : public QDialog {
    Q_OBJECT

public:
    /// last: what was opened the last time.
    explicit CameraDialog(const app::CameraRequest& last, QWidget* parent = nullptr,
                          const CameraSourceField::Lister& cameras = camera::listCameras);

    [[nodiscard]] app::CameraRequest request() const;
    /// What is to be opened: a scene camera where no calibration is named.
    [[nodiscard]] app::SourceRequest sourceRequest() const;

private:
    void check();
    void chooseModel();

    CameraSourceField* m_source;
    QLineEdit* m_model;
    QCheckBox* m_loop;
    QPushButton* m_accept;
};

} // namespace teleta::console
