// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "widgets/chrome/time_slider.h"

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include <vector>

class QToolButton;

namespace teleta::chrome {

/// Playback controls: play and pause, single steps, a time bar with marks, speed, loop. Shows a position and
/// emits requests. Keys: Space plays or pauses, Left and Right step, Page Up and Page Down jump between
/// marks, Home and End go to the ends. Thread: GUI.
class PlaybackBar : public QWidget {
    Q_OBJECT

public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    void setPosition(const core::PlaybackPosition& position);
    /// marks: in order of time. With marks, the clock counts from the start of the recording as they do.
    void setMarks(std::vector<core::PlaybackMark> marks);

signals:
    void playRequested();
    void pauseRequested();
    void stepRequested(int frames);
    void seekRequested(double time_s);
    void speedRequested(double factor);
    void loopRequested(bool loop);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QToolButton* makeButton(const char* name);
    void restyle();
    void retranslate();
    void togglePlay();
    void goToMark(bool forward);
    [[nodiscard]] double sliderTime_s(int value) const;

    QToolButton* m_toStart = makeButton("toStart");
    QToolButton* m_back = makeButton("back");
    QToolButton* m_play = makeButton("play");
    QToolButton* m_forward = makeButton("forward");
    QToolButton* m_loop = makeButton("loop");
    TimeSlider* m_slider = new TimeSlider(Qt::Horizontal, this);
    QLabel* m_time = new QLabel(this);
    QComboBox* m_speed = new QComboBox(this);
    core::PlaybackPosition m_position;
    std::vector<core::PlaybackMark> m_marks;
    bool m_shownPaused = false;
};

} // namespace teleta::chrome
