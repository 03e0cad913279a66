// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace teleta::console {

/// A pair of a pixel and a probed point that is typed in. Enter in any field adds it. Thread: GUI.
class PairEntry : public QWidget {
    Q_OBJECT

public:
    explicit PairEntry(QWidget* parent = nullptr);

    /// u, v in px; x, y, z in mm.
    [[nodiscard]] QDoubleSpinBox* field(std::size_t index) const { return m_fields[index]; }
    [[nodiscard]] QPushButton* addButton() const { return m_add; }
    void retranslate();

signals:
    void entered(const teleta::vision::CalibrationPair& pair);

private:
    void add();

    QLabel* m_pixelLabel;
    QLabel* m_pointLabel;
    std::array<QDoubleSpinBox*, 5> m_fields{};
    QPushButton* m_add;
};

} // namespace teleta::console
