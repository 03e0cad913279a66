// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/tapped_bracelet.h"
#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/motors/motor_file.h"
#include "backend/motors/wearer_limits.h"
#include "backend/playback/player.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::console {

/// Which bracelet the console drives.
enum class BraceletChoice {
    none,
    simulated,
    hid,  ///< the first bracelet that is plugged in
    file, ///< that of a device file, described::openBracelet
};

/// A connected bracelet with its player. Making one and letting it go may wait for the device: off the GUI's
/// thread. Thread: player() any, see Player.
class BraceletSession {
public:
    /// Opens the bracelet and reads the profile of its motors. stop must outlive the session. choice: not
    /// none. deviceFile: that describes the bracelet. player: its limits and ranges are taken from the files
    /// of the bracelet; copies of one share what they know of the heat. Error: of the device or its file.
    [[nodiscard]] static core::Expected<std::shared_ptr<BraceletSession>>
    open(BraceletChoice choice, const std::string& deviceFile, const core::StopSwitch& stop,
         playback::PlayerConfig player = {});
    BraceletSession(std::unique_ptr<core::BraceletSource> source, const core::StopSwitch& stop,
                    playback::PlayerConfig player = {});
    ~BraceletSession();
    BraceletSession(const BraceletSession&) = delete;
    BraceletSession& operator=(const BraceletSession&) = delete;

    [[nodiscard]] const core::BraceletSource& source() const { return *m_source; }
    [[nodiscard]] playback::Player& player() { return *m_player; }
    /// Who gets copies of the frames that are written; null: nobody. Thread: any.
    void record(std::shared_ptr<core::StreamTap> tap) { m_source->setTap(std::move(tap)); }
    /// The same for somebody else who follows. Thread: any.
    void watch(std::shared_ptr<core::StreamTap> tap) { m_source->setWatcher(std::move(tap)); }
    /// As the file of this bracelet says; assumed motors without one.
    [[nodiscard]] const motors::MotorCalibration& calibration() const { return m_calibration; }
    /// Why that file could not be used.
    [[nodiscard]] const std::optional<core::Error>& calibrationError() const { return m_calibrationError; }

    /// The wearer's limits, which the player obeys.
    [[nodiscard]] const motors::WearerLimits& limits() const { return m_limits; }
    /// Why the saved limits could not be read; weak limits are used then.
    [[nodiscard]] const std::optional<core::Error>& limitsError() const { return m_limitsError; }

private:
    core::Wakeup m_wakeup; ///< nobody waits for it: the views look at 30 Hz
    std::unique_ptr<TappedBracelet> m_source;
    motors::MotorCalibration m_calibration;
    std::optional<core::Error> m_calibrationError;
    motors::WearerLimits m_limits;
    std::optional<core::Error> m_limitsError;
    std::unique_ptr<playback::Player> m_player;
};

} // namespace teleta::console
