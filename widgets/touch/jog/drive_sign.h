// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"

#include <QWidget>

#include <optional>

namespace teleta::touch {

/// What moves the arm, by shape, colour and word: stopped a red octagon, held two grey bars, program a green
/// triangle, jog four arrows in the accent colour. Thread: GUI.
class DriveSign : public QWidget {
    Q_OBJECT
public:
    explicit DriveSign(QWidget* parent = nullptr);

    /// Empty: no arm.
    void setDrive(std::optional<core::ArmDrive> drive);
    [[nodiscard]] QString text() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<core::ArmDrive> m_drive;
};

} // namespace teleta::touch
