// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace teleta::console {

/// Input fields of a calibration: image size, radius and length of the tactile cylinder, and the scaling of
/// the pairs' points to its surface. Thread: GUI.
class TubeFields : public QWidget {
    Q_OBJECT

public:
    explicit TubeFields(QWidget* parent = nullptr);

    /// Emits nothing.
    void setSettings(const vision::CalibrationSettings& settings);
    void setHoleFactor(double factor);
    void retranslate();

signals:
    /// The user has changed a value.
    void changed(const teleta::vision::CalibrationSettings& settings);
    void holeFactorChanged(double factor);

private:
    void tell();

    vision::CalibrationSettings m_settings;
    QLabel *m_imageLabel, *m_radiusLabel, *m_lengthLabel, *m_holeLabel;
    QSpinBox *m_width, *m_height;
    QDoubleSpinBox *m_radius, *m_length, *m_holeFactor;
};

} // namespace teleta::console
