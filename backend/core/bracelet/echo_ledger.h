// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::core {

/// Numbers the frames to a board and finds the lost ones from the board's echoes. (A successful write only
/// means that the kernel accepted the frame.) A frame is lost when the echo of a later one arrives first,
/// when the board refuses it, when its connection ends, or when kLongestFlight later ones were sent without
/// any echo. Thread: one.
class EchoLedger {
public:
    static constexpr std::uint64_t kLongestFlight = 256;

    /// Number of the frame that is sent now; counts on from 1 and wraps.
    [[nodiscard]] std::uint16_t send();
    /// An unexpected echo (a second one, an old one, another program's) is counted as stray.
    void echo(std::uint16_t sequence);
    /// The board did not understand the frame, which then counts as lost. An unexpected refusal is stray,
    /// too.
    void refuse(std::uint16_t sequence);
    /// Frames in flight will not be answered any more.
    void endConnection();

    [[nodiscard]] std::uint64_t sent() const { return m_sent; }
    [[nodiscard]] std::uint64_t echoed() const { return m_echoed; }
    /// Number of the newest frame that was echoed, not wrapped; 0: none.
    [[nodiscard]] std::uint64_t newestEchoed() const { return m_newestEchoed; }
    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    /// Lost frames that the board refused.
    [[nodiscard]] std::uint64_t refused() const { return m_refused; }
    [[nodiscard]] std::uint64_t stray() const { return m_stray; }
    [[nodiscard]] std::uint64_t inFlight() const { return m_sent - m_settled; }

private:
    /// Settles an answered frame and all before it, which are lost. Its number; 0: nothing waits for it.
    [[nodiscard]] std::uint64_t settle(std::uint16_t sequence);

    std::uint64_t m_sent = 0;
    std::uint64_t m_settled = 0; ///< newest frame that was answered or given up
    std::uint64_t m_echoed = 0;
    std::uint64_t m_newestEchoed = 0;
    std::uint64_t m_lost = 0;
    std::uint64_t m_refused = 0;
    std::uint64_t m_stray = 0;
};

} // namespace teleta::core
