// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/camera_probing.h"

#include <QWidget>

class QProgressBar;
class QPushButton;

namespace teleta::console {

/// Progress of a probing with a button that stops it; visible while one runs. Thread: GUI.
class ProbingStrip : public QWidget {
    Q_OBJECT

public:
    explicit ProbingStrip(CameraProbing& probing, QWidget* parent = nullptr);

    void retranslate();

private:
    CameraProbing& m_probing;
    int m_pairs = 0;
    QProgressBar* m_progress;
    QPushButton* m_stop;
};

} // namespace teleta::console
