// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/camera_probing.h"

#include <QWidget>

class QProgressBar;
class QPushButton;

namespace teleta::console {

/// How far a probing is, and a button that ends it; shown while one runs. Thread: GUI.
class ProbingStrip : public QWidget {
    Q_OBJECT

public:
    explicit ProbingStrip(CameraProbing& probing, QWidget* parent = nullptr);

    [[nodiscard]] QProgressBar* progress() const { return m_progress; }
    [[nodiscard]] QPushButton* stopButton() const { return m_stop; }
    void retranslate();

private:
    CameraProbing& m_probing;
    int m_pairs = 0;
    QProgressBar* m_progress;
    QPushButton* m_stop;
};

} // namespace teleta::console
