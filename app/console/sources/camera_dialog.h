// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/source_request.h"
#include "app/console/sources/camera_source_field.h"

#include <QDialog>

class QCheckBox;
class QLineEdit;
class QPushButton;

namespace teleta::console {

/// Asks for a camera in the soft tube, or a video of one, and for its calibration. Window modal, opened by
/// the user, never by a device. Thread: GUI.
class CameraDialog : public QDialog {
    Q_OBJECT

public:
    /// last: what was opened the last time.
    explicit CameraDialog(const CameraRequest& last, QWidget* parent = nullptr,
                          const CameraSourceField::Lister& cameras = camera::listCameras);

    [[nodiscard]] CameraRequest request() const;

private:
    void check();
    void chooseModel();

    CameraSourceField* m_source;
    QLineEdit* m_model;
    QCheckBox* m_loop;
    QPushButton* m_accept;
};

} // namespace teleta::console
