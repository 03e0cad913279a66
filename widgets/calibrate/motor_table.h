// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/motors/motor_file.h"

#include <QTableWidget>

#include <cstddef>

namespace teleta::calibrate {

/// The motors of a bracelet with their values and standard errors; assumed values are grey and marked by a
/// word. Thread: GUI.
class MotorTable : public QTableWidget {
    Q_OBJECT
public:
    explicit MotorTable(QWidget* parent = nullptr);

    void setCalibration(const motors::MotorCalibration& calibration);
    [[nodiscard]] std::size_t selectedMotor() const;
    void selectMotor(std::size_t motor);

signals:
    void motorSelected(std::size_t motor);

private:
    void fill();
    void retranslate();

    motors::MotorCalibration m_calibration;
};

} // namespace teleta::calibrate
