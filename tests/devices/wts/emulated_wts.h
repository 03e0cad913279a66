// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/wts/wts_codec.h"
#include "devices/wts/wts_decoder.h"
#include "tests/devices/wts/wts_messages.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace teleta::wts::test {

/// What the sensor is and how it behaves.
struct EmulatedWtsBehaviour {
    unsigned columns = 14;
    unsigned rows = 6;
    unsigned cellWidth_10um = 340;
    unsigned cellHeight_10um = 340;
    int matrixParams = 10;                ///< bytes of the matrix info that are sent
    int deafTo = 0;                       ///< so many requests get no answer
    std::map<Command, unsigned> status{}; ///< answers other than success
    Bytes beforeAnswer{};                 ///< comes before each answer
    bool flood = false;                   ///< sends frames without being asked
};

/// A tactile sensor as seen through its link: a pseudo-terminal, whose path is a link in a folder of its own
/// as udev makes one, or a TCP port of this machine. Answers requests on a thread of its own; sends the
/// frames, and the rubbish, that the test tells it to. Thread: any.
class EmulatedWts {
public:
    enum class Link { pty, tcp };

    using Behaviour = EmulatedWtsBehaviour;

    explicit EmulatedWts(Link link, Behaviour behaviour = {});
    ~EmulatedWts();
    EmulatedWts(const EmulatedWts&) = delete;
    EmulatedWts& operator=(const EmulatedWts&) = delete;

    /// For parseWtsAddress.
    [[nodiscard]] std::string address() const;

    void plug();
    void unplug();
    void change(const std::function<void(Behaviour&)>& change);

    /// Waits until the link took all bytes; false when it is unplugged.
    bool send(const Bytes& bytes);

    /// A client asked for frames and did not ask to stop.
    [[nodiscard]] bool streaming() const;
    [[nodiscard]] int requests(Command command) const;
    /// Parameters of the newest request of this kind.
    [[nodiscard]] Bytes params(Command command) const;
    /// Waits until there were so many requests of this kind.
    [[nodiscard]] bool waitForRequests(Command command, int count);

private:
    void serve(const std::stop_token& stop, int descriptor);
    void serveConnections(const std::stop_token& stop, int listener);
    void obey(const Message& message, int descriptor);
    bool write(const Bytes& bytes, int descriptor);
    void setConnected(int descriptor);

    Link m_link;
    std::filesystem::path m_folder;
    int m_port = 0;
    int m_listener = -1;
    int m_slave = -1; ///< kept open: without it the master would see a hang-up between two clients
    int m_master = -1;

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    Behaviour m_behaviour;                  ///< guarded by m_mutex
    std::map<std::uint8_t, int> m_requests; ///< guarded by m_mutex
    std::map<std::uint8_t, Bytes> m_params; ///< guarded by m_mutex
    bool m_streaming = false;               ///< guarded by m_mutex
    int m_connected = -1;                   ///< guarded by m_mutex
    std::mutex m_writing;                   ///< messages do not mix; taken before m_mutex
    std::atomic<bool> m_ending{false};
    std::jthread m_thread;
};

} // namespace teleta::wts::test
