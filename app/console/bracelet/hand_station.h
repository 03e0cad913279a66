// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/wakeup.h"
#include "devices/mouse3d/mouse3d.h"
#include "widgets/chrome/device_strip.h"
#include "widgets/touch/jog/jog_panel.h"

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace teleta::console {

/// The 3D mouse of the console: looks for one all the time, on its own thread, and tells what the hand on it
/// wants. Thread: GUI; no call waits but the destructor, 50 ms at most.
class HandStation {
    Q_DECLARE_TR_FUNCTIONS(HandStation)

public:
    /// opener: by default the first mouse that is plugged in.
    explicit HandStation(mouse3d::Mouse3dConfig config = {},
                         mouse3d::HidInputOpener opener = mouse3d::openFirstMouse);
    HandStation(const HandStation&) = delete;
    HandStation& operator=(const HandStation&) = delete;

    /// Empty while no mouse is connected.
    [[nodiscard]] std::optional<touch::HandMotion> motion() const;
    /// One line on its state.
    [[nodiscard]] QString text() const;
    /// For the status bar; empty as long as none was ever there.
    [[nodiscard]] std::optional<chrome::DeviceReading> reading() const;

private:
    core::Wakeup m_wakeup; ///< nobody waits for it: the views look at 30 Hz
    mouse3d::Mouse3d m_mouse;
};

} // namespace teleta::console
