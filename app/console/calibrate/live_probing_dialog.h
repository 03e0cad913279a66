// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/live_probing.h"
#include "backend/vision/hole_grid.h"

#include <QDialog>
#include <QString>
#include <QStringList>

class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QSpinBox;

namespace teleta::console {

/// Asks with which camera, or video of one, the tube is probed, and through which holes. Window modal, opened
/// by the user. Thread: GUI.
class LiveProbingDialog : public QDialog {
    Q_OBJECT

public:
    /// cameras: numbers of those that are connected.
    LiveProbingDialog(const QString& last, const vision::HoleGrid& grid, const QStringList& cameras,
                      QWidget* parent = nullptr);

    /// A file or the number of a camera.
    [[nodiscard]] QString source() const;
    [[nodiscard]] vision::HoleGrid grid() const;

private:
    QComboBox* m_source;
    QSpinBox* m_around;
    QSpinBox* m_along;
    QDoubleSpinBox* m_first;
    QDoubleSpinBox* m_last;
    QDoubleSpinBox* m_angle;
    QPushButton* m_accept;
};

/// Opens a camera, or a video that is played at its own rate.
[[nodiscard]] LiveProbing::Opener cameraOpener(const QString& source);

} // namespace teleta::console
