// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_menu.h"

#include <QActionGroup>
#include <QFileDialog>
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
constexpr char kModbus[] = "modbus:";

} // namespace

BraceletMenu::BraceletMenu(BraceletStation& station, ConsoleSettings& settings, QWidget* window)
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
        add(tr("Modbus: %1", "a device file").arg(QFileInfo(file).fileName()), BraceletChoice::modbus, file);
    QAction* open = menu.addAction(tr("&Modbus\u2026"), this, &BraceletMenu::askForFile);
    open->setToolTip(tr("A file that describes the registers of a motor driver"));
    add(tr("&None"), BraceletChoice::none);
}

void BraceletMenu::restore(const QString& option) {
    const QString wanted = option.isEmpty() ? m_settings.bracelet() : option;
    for (const BraceletName& known : kBracelets) {
        if (wanted == QLatin1String(known.name)) {
            m_station.choose(known.choice);
            return;
        }
    }
    if (!option.isEmpty())
        m_station.choose(BraceletChoice::modbus, option);
    else if (wanted.startsWith(QLatin1String(kModbus)))
        m_station.choose(BraceletChoice::modbus, wanted.mid(static_cast<int>(sizeof kModbus) - 1));
}

void BraceletMenu::choose(BraceletChoice choice, const QString& deviceFile) {
    if (choice == BraceletChoice::modbus) {
        m_settings.addDeviceFile(deviceFile);
        m_settings.setBracelet(QLatin1String(kModbus) + deviceFile);
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
    auto* dialog =
        new QFileDialog(m_window, tr("Open a Modbus motor driver"), QString(), tr("Devices (*.toml)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& path) { choose(BraceletChoice::modbus, path); });
    dialog->open();
}

} // namespace teleta::console
