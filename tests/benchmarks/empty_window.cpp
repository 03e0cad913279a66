// SPDX-License-Identifier: GPL-3.0-or-later
// What window_benchmark.py compares the console with: the least that a program with a window does. It prints
// what the console prints with --measure: the time until its window is shown.
#include "app/console/process_times.h"

#include <QApplication>
#include <QMainWindow>
#include <QTimer>

#include <cstdio>

namespace {

class EmptyWindow : public QMainWindow {
    bool event(QEvent* event) override {
        if (event->type() == QEvent::Paint)
            QTimer::singleShot(0, this, [] {
                std::printf("{\"first_window_s\": %.3f, \"first_window_processor_s\": %.3f}\n",
                            teleta::console::processAge_s(), teleta::console::processorTime_s());
                QApplication::quit();
            });
        return QMainWindow::event(event);
    }
};

} // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    EmptyWindow window;
    window.resize(1344, 840);
    window.show();
    return QApplication::exec();
}
