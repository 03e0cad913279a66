// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace teleta::console {

/// What a calibration has to know beforehand: size of the image, radius and length of the tactile cylinder,
/// and where the pairs' points are. Thread: GUI.
class TubeFields : public QWidget {
    Q_OBJECT

public:
    explicit TubeFields(QWidget* parent = nullptr);

    /// Shows them; tells nobody.
    void setSettings(const vision::CalibrationSettings& settings);
    void setHoleFactor(double factor);
    [[nodiscard]] QSpinBox* width() const { return m_width; }
    [[nodiscard]] QSpinBox* height() const { return m_height; }
    [[nodiscard]] QDoubleSpinBox* radius() const { return m_radius; }
    [[nodiscard]] QDoubleSpinBox* length() const { return m_length; }
    [[nodiscard]] QDoubleSpinBox* holeFactor() const { return m_holeFactor; }
    void retranslate();

signals:
    /// By a person.
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
