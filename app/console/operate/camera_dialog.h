// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/source_request.h"

#include <QDialog>
#include <QStringList>

#include <functional>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;

namespace teleta::console {

/// Asks for a camera in the soft tube, or a video of one, and for its calibration. Window modal, opened by
/// the user, never by a device. Thread: GUI.
class CameraDialog : public QDialog {
    Q_OBJECT

public:
    /// last: what was opened the last time. cameras: numbers of those that are connected.
    CameraDialog(const CameraRequest& last, const QStringList& cameras, QWidget* parent = nullptr);

    [[nodiscard]] CameraRequest request() const;
    /// Numbers of the connected cameras, in order.
    [[nodiscard]] static QStringList connectedCameras();

private:
    void check();
    void choose(const QString& title, const QString& filter, const std::function<void(const QString&)>& take);

    QComboBox* m_source;
    QLineEdit* m_model;
    QCheckBox* m_loop;
    QPushButton* m_accept;
};

} // namespace teleta::console
