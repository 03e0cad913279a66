// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/wake_pipe.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace teleta::link {

int pollUntil(std::span<pollfd> polled, std::int64_t deadline_ns) {
    int ready = -1;
    do {
        const std::int64_t left_ns = std::max<std::int64_t>(0, deadline_ns - core::steadyNow_ns());
        const timespec left{static_cast<time_t>(left_ns / 1'000'000'000), left_ns % 1'000'000'000};
        ready = ::ppoll(polled.data(), polled.size(), &left, nullptr);
    } while (ready < 0 && errno == EINTR);
    return ready;
}

WakePipe::WakePipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    m_read = core::FileDescriptor(ends[0]);
    m_write = core::FileDescriptor(ends[1]);
}

void WakePipe::wake() {
    const char byte = 1;
    // A full pipe is readable already.
    [[maybe_unused]] const ssize_t written = ::write(m_write.get(), &byte, 1);
}

void WakePipe::clear() {
    char bytes[64];
    while (::read(m_read.get(), bytes, sizeof bytes) > 0) {
    }
}

void WakePipe::waitUntil(std::int64_t deadline_ns) const {
    pollfd polled{m_read.get(), POLLIN, 0};
    pollUntil({&polled, 1}, deadline_ns);
}

} // namespace teleta::link
