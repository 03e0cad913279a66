// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/peer/uhid_device.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace teleta::peer {

/// A bracelet's board as its firmware would be, made from devices/bracelet/README.md only: a HID device of
/// the kernel by /dev/uhid. It turns its motors off by itself after the time-out of the last frame. Thread:
/// any.
class UhidBoard {
public:
    using Bytes = std::vector<std::uint8_t>;
    struct Frame {
        Bytes bytes;
        std::int64_t time_ns = 0;
    };
    struct State {
        std::vector<Frame> frames;
        std::array<int, 6> motors{};
        int timeouts = 0;               ///< times that it turned its motors off by itself
        std::int64_t timedOutAt_ns = 0; ///< last time
        bool opened = false;            ///< a program has the device open
        int openings = 0;               ///< times that a first program opened it
        int closings = 0;               ///< times that its last program let it go
        int closedWhileTurning = 0;     ///< of these, with the motors on
        int drains = 0;                 ///< times that it took all that the kernel had for it
    };

    /// Throws std::system_error when there is no /dev/uhid. productId: of vendor 0x1209.
    explicit UhidBoard(std::string serial, std::uint16_t productId = 0x0001);
    ~UhidBoard();
    UhidBoard(const UhidBoard&) = delete;
    UhidBoard& operator=(const UhidBoard&) = delete;

    void plugIn();
    void unplug();
    /// False: the board hangs and takes nothing from the kernel.
    void setAwake(bool awake);

    [[nodiscard]] State state() const;
    void forgetFrames();
    /// The same when all that was written before has arrived; false when it does not within 30 s.
    [[nodiscard]] bool forgetWhatWasWritten();
    /// Waits until a condition on the state holds; false when it does not come to hold within 30 s.
    template <typename Condition>
    [[nodiscard]] bool waitFor(const Condition& condition) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::seconds(30), [&] { return condition(m_state); });
    }

private:
    void run(const std::stop_token& stop);
    void serve();
    void takeFrame(const std::uint8_t* bytes, std::size_t size);
    void answer(const Frame& frame, bool timedOut);
    /// Nothing comes from a board that is unplugged: the kernel refuses it.
    template <typename Send>
    void whilePluggedIn(const Send& send);
    void answerFeature(std::uint32_t request, std::uint8_t report);
    void checkTimeout();

    std::string m_serial;
    std::uint16_t m_productId;
    UhidDevice m_device;
    std::array<int, 2> m_wake{-1, -1};
    std::atomic<bool> m_awake{true};
    std::mutex m_plugMutex;
    bool m_pluggedIn = false; ///< guarded by m_plugMutex

    mutable std::mutex m_mutex; ///< of what follows
    std::condition_variable m_changed;
    State m_state;
    std::int64_t m_timeoutAt_ns = 0;
    bool m_timedOut = false;

    std::jthread m_thread;
};

[[nodiscard]] inline bool turns(const UhidBoard::State& state) {
    return state.motors != std::array<int, 6>{};
}

} // namespace teleta::peer
