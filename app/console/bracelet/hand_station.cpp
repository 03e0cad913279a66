// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/hand_station.h"

#include <utility>

namespace teleta::console {

namespace {

/// Of the mouse; the first one is its dead man.
constexpr unsigned kClutchButton = 1;

} // namespace

HandStation::HandStation(mouse3d::Mouse3dConfig config, mouse3d::HidInputOpener opener)
    : m_mouse(std::move(config), std::move(opener)) {
    m_mouse.start(m_wakeup);
}

std::optional<touch::HandMotion> HandStation::motion() const {
    if (m_mouse.status().state != core::DeviceState::live)
        return std::nullopt;
    // Of one reading: a hand that is held at rest while its cap is deflected would lead the tip back.
    const mouse3d::Mouse3dReading reading = m_mouse.reading();
    const mouse3d::SixAxes motion = reading.deadManHeld ? reading.axes : mouse3d::SixAxes{};
    return touch::HandMotion{motion.translation, reading.deadManHeld,
                             ((reading.buttons >> kClutchButton) & 1U) != 0};
}

QString HandStation::text() const {
    const core::DeviceStatus status = m_mouse.status();
    if (status.state != core::DeviceState::live)
        return m_mouse.name().empty() ? tr("3D mouse: none is plugged in.")
                                      : tr("3D mouse: %1").arg(QString::fromStdString(status.message));
    const QString name = QString::fromStdString(m_mouse.name());
    return m_mouse.reading().deadManHeld
               ? tr("3D mouse %1: moves the tip.").arg(name)
               : tr("3D mouse %1: hold its first button to move the tip.").arg(name);
}

std::optional<chrome::DeviceReading> HandStation::reading() const {
    if (m_mouse.name().empty())
        return std::nullopt;
    const core::DeviceStatus status = m_mouse.status();
    chrome::DeviceReading reading;
    reading.name = tr("3D mouse");
    reading.state = status.state;
    reading.rate_Hz = status.rate_Hz;
    reading.lost = status.framesLost;
    reading.details = status.message.empty() ? QString::fromStdString(m_mouse.name())
                                             : QString::fromStdString(status.message);
    return reading;
}

} // namespace teleta::console
