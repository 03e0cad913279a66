// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_session.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/playback/player_types.h"

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::console {

/// Opens and closes bracelets on threads of their own. A device has one owner at a time: one that is being
/// closed, or is not wanted any more, is gone before the next one is opened. Thread: GUI; no call waits but
/// the destructor, for a device that is being opened or closed.
class BraceletOpener {
public:
    using Opened = core::Expected<std::shared_ptr<BraceletSession>>;

    /// player: of every bracelet, but for its limits and ranges.
    BraceletOpener(const core::StopSwitch& stop, playback::PlayerConfig player);

    /// Begins to open a bracelet in place of any that is being opened; none: opens nothing.
    void open(BraceletChoice choice, const std::string& deviceFile);
    /// Ends a session that nobody else holds; it waits for the device's last frame.
    void close(BraceletChoice choice, std::shared_ptr<BraceletSession> session);
    /// The bracelet that was asked for last, once: when it is open, or why it could not be opened.
    [[nodiscard]] std::optional<Opened> take();

private:
    /// The destructors of both wait for their threads.
    struct Closing {
        BraceletChoice choice = BraceletChoice::none;
        std::future<void> done;
    };
    struct Opening {
        BraceletChoice choice = BraceletChoice::none;
        std::uint64_t number = 0;
        std::future<Opened> result;
    };
    template <typename Ending>
    static std::vector<Ending> takeRivals(std::vector<Ending>& endings, BraceletChoice choice);

    const core::StopSwitch& m_stop;
    playback::PlayerConfig m_player;
    std::vector<Opening> m_openings;
    std::vector<Closing> m_closings;
    std::uint64_t m_newest = 0; ///< number of the newest choice
};

} // namespace teleta::console
