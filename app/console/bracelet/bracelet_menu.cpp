// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_menu.h"

#include "app/console/bracelet/latency_dialog.h"
#include "widgets/base/file_dialog.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>

#include <array>

namespace teleta::console {

namespace {

struct BraceletName {
    BraceletChoice choice;
    const char* name;
};
constexpr std::array kBracelets{
    BraceletName{BraceletChoice::simulated, "simulated"}, BraceletName{BraceletChoice::hid, "hid"},
    BraceletName{BraceletChoice::hid, "usb"}, BraceletName{BraceletChoice::none, "none"}};
/// Before the path of a device file; the first programs, which knew Modbus files only, wrote the other one.
constexpr std::array<QLatin1String, 2> kFilePrefixes{QLatin1String("file:"), QLatin1String("modbus:")};

} // namespace

BraceletMenu::BraceletMenu(BraceletService& station, ConsoleSettings& settings, QWidget* window)
    : QObject(window)
    , m_station(station)
    , m_settings(settings)
    , m_window(window) {
}

void BraceletMenu::fill(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& text, BraceletChoice choice, const QString& file = {}) {
        QAction* action = menu.addAction(text);
        // Not from within the menu, which is built anew.
        connect(
            action, &QAction::triggered, this, [this, choice, file] { choose(choice, file); },
            Qt::QueuedConnection);
        action->setCheckable(true);
        action->setChecked(m_station.choice() == choice && m_station.deviceFile() == file);
        action->setToolTip(file);
        group->addAction(action);
    };
    add(tr("&Simulated"), BraceletChoice::simulated);
    add(tr("&USB"), BraceletChoice::hid);
    for (const QString& file : m_settings.deviceFiles())
        add(tr("File: %1", "a device file").arg(QFileInfo(file).fileName()), BraceletChoice::file, file);
    QAction* open = menu.addAction(tr("&Device file\u2026"), this, &BraceletMenu::askForFile);
    open->setToolTip(
        tr("A file that describes the registers of a Modbus motor driver, the ids of a USB bracelet, or the "
           "outputs of a sound card"));
    add(tr("&None"), BraceletChoice::none);
    menu.addSeparator();
    QAction* latency = menu.addAction(tr("Measure its &latency\u2026"), this, &BraceletMenu::openLatency);
    latency->setToolTip(tr("From a frame to the movement of a tactor, for a bracelet on a sound card"));
    const auto update = [this, latency] { latency->setEnabled(m_station.isOnSoundCard()); };
    connect(&menu, &QMenu::aboutToShow, latency, update);
    update();
}

void BraceletMenu::openLatency() {
    LatencyDialog* dialog = m_latency;
    if (dialog == nullptr || !dialog->isVisible()) {
        delete dialog;
        dialog = new LatencyDialog(m_station, m_window);
        m_latency = dialog;
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void BraceletMenu::restore(const QString& option) {
    const QString wanted = option.isEmpty() ? m_settings.bracelet() : option;
    for (const BraceletName& known : kBracelets) {
        if (wanted == QLatin1String(known.name)) {
            m_station.choose(known.choice);
            return;
        }
    }
    if (!option.isEmpty()) {
        m_station.choose(BraceletChoice::file, option);
        return;
    }
    for (const QLatin1String& prefix : kFilePrefixes) {
        if (wanted.startsWith(prefix)) {
            m_station.choose(BraceletChoice::file, wanted.mid(prefix.size()));
            return;
        }
    }
}

void BraceletMenu::choose(BraceletChoice choice, const QString& deviceFile) {
    if (choice == BraceletChoice::file) {
        m_settings.addDeviceFile(deviceFile);
        m_settings.setBracelet(kFilePrefixes.front() + deviceFile);
    } else {
        for (const BraceletName& known : kBracelets) {
            if (known.choice == choice) {
                m_settings.setBracelet(QLatin1String(known.name));
                break;
            }
        }
    }
    m_station.choose(choice, deviceFile);
}

void BraceletMenu::askForFile() {
    base::askToOpen(m_window,
                    {.title = tr("Open the file of a bracelet"), .filters = {tr("Devices (*.toml)")}},
                    [this](const QString& path) { choose(BraceletChoice::file, path); });
}

} // namespace teleta::console
