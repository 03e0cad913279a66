// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/file_descriptor.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace teleta::cli {

/// A chain in a process of its own. It is killed with the object. Thread: one.
class ChainProcess {
public:
    /// What the chain has said so far.
    struct State {
        bool driving = false;
        std::uint64_t safeFrames = 0;
        bool recordingFailed = false;
        std::string problem; ///< why it did not drive when it was last asked; empty: it did not say
    };

    /// Starts this program once more. arguments: after `teleta certify`. recording: the file that it makes;
    /// empty: none. Error: ioFailed.
    [[nodiscard]] static core::Expected<std::unique_ptr<ChainProcess>>
    start(const std::vector<std::string>& arguments, const std::string& recording);
    ~ChainProcess();
    ChainProcess(const ChainProcess&) = delete;
    ChainProcess& operator=(const ChainProcess&) = delete;

    /// One line. Ignored by a chain that has ended.
    void say(std::string line);
    void signal(int signal) const;
    /// Reads what it has said since.
    const State& look();
    [[nodiscard]] bool ended();
    /// False: it still runs after that time.
    [[nodiscard]] bool waitForEnd(std::chrono::milliseconds longest);
    [[nodiscard]] pid_t process() const { return m_process; }
    [[nodiscard]] const std::string& recording() const { return m_recording; }

private:
    ChainProcess(pid_t process, core::FileDescriptor commands, core::FileDescriptor answers,
                 std::string recording);
    void take(std::string_view line);

    pid_t m_process;
    core::FileDescriptor m_commands;
    core::FileDescriptor m_answers;
    std::string m_recording;
    bool m_ended = false;
    std::string m_text; ///< not yet a line
    State m_state;
};

} // namespace teleta::cli
