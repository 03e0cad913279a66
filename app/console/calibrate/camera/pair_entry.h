// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace teleta::console {

/// Fields for typing in a pair of a pixel and a probed point. Enter in any of them adds it. Thread: GUI.
class PairEntry : public QWidget {
    Q_OBJECT

public:
    explicit PairEntry(QWidget* parent = nullptr);

    void retranslate();

signals:
    void entered(const teleta::vision::CalibrationPair& pair);

private:
    void add();

    QLabel* m_pixelLabel;
    QLabel* m_pointLabel;
    std::array<QDoubleSpinBox*, 5> m_fields{}; ///< u, v in px; x, y, z in mm
    QPushButton* m_add;
};

} // namespace teleta::console
