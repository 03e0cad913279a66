// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/main_window.h"

#include <QTest>

#include <memory>

namespace teleta::test {

/// The window as a whole, on a real display. Thread: GUI.
class WindowBench {
protected:
    /// fresh: with the default settings, of which nothing is remembered.
    void openWindow(const console::ConsoleOptions& options = {}, bool fresh = true) {
        m_window.reset();
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<console::ConsoleSettings>(fresh);
        m_window = std::make_unique<console::MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->openRequested(options);
    }

    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<console::ConsoleSettings> m_settings;
    std::unique_ptr<console::MainWindow> m_window;
};

} // namespace teleta::test
