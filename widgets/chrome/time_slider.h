// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"

#include <QSlider>

#include <vector>

namespace teleta::chrome {

/// The time bar of a playback: a click goes there; marks are flags with their texts as tool tips. The owner
/// handles the keys. Thread: GUI.
class TimeSlider : public QSlider {
    Q_OBJECT

public:
    using QSlider::QSlider;

    void setDuration(double duration_s);
    void setMarks(std::vector<core::PlaybackMark> marks);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Range of the middle of the handle, in px from the left.
    struct Run {
        double first_px = 0.0;
        double length_px = 0.0;
    };
    [[nodiscard]] Run run() const;
    [[nodiscard]] int valueAt(double x_px) const;
    /// Place of a visible mark, in px from the left.
    [[nodiscard]] double x_px(const core::PlaybackMark& mark) const;
    [[nodiscard]] bool isShown(const core::PlaybackMark& mark) const;

    double m_duration_s = 0.0;
    std::vector<core::PlaybackMark> m_marks;
};

} // namespace teleta::chrome
