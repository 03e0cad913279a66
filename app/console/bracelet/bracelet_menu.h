// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/bracelet/bracelet_service.h"

#include <QObject>
#include <QPointer>
#include <QString>

class QMenu;
class QWidget;

namespace teleta::console {

class LatencyDialog;

/// Chooses the bracelet: from the menu, the settings or the command line; opens what there is to do with it.
/// Thread: GUI.
class BraceletMenu : public QObject {
    Q_OBJECT

public:
    BraceletMenu(BraceletService& station, ConsoleSettings& settings, QWidget* window);

    void fill(QMenu& menu);
    /// The one of the command line ("simulated", "usb", "none" or a device file), or the one of the last
    /// time.
    void restore(const QString& option);

private:
    void choose(BraceletChoice choice, const QString& deviceFile = {});
    void askForFile();
    void openLatency();

    BraceletService& m_station;
    ConsoleSettings& m_settings;
    QWidget* m_window;
    QPointer<LatencyDialog> m_latency;
};

} // namespace teleta::console
