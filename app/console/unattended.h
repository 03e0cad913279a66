// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console_options.h"

#include <QElapsedTimer>
#include <QObject>

namespace teleta::console {

class MainWindow;

/// Runs without a person: takes a picture of the window after a while (--screenshot), or measures what it
/// took to show the window and how busy the event loop and the processor are (--measure), and ends the
/// program with an exit code: 0 done, 1 the picture could not be written, 3 a source could not be opened.
/// Thread: GUI.
class Unattended : public QObject {
    Q_OBJECT

public:
    Unattended(const ConsoleOptions& options, MainWindow& window);

    void start();

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void takePicture();
    void printMeasurement();

    ConsoleOptions m_options;
    MainWindow& m_window;
    QElapsedTimer m_measured;
    double m_processorBefore_s = 0.0;
    double m_firstWindow_s = 0.0; ///< since the process began
    double m_firstWindowProcessor_s = 0.0;
};

} // namespace teleta::console
