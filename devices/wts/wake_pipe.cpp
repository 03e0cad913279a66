// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wake_pipe.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace teleta::wts {

WakePipe::WakePipe() {
    if (::pipe2(m_ends, O_CLOEXEC | O_NONBLOCK) != 0)
        m_ends[0] = m_ends[1] = -1;
}

WakePipe::~WakePipe() {
    for (const int end : m_ends) {
        if (end >= 0)
            ::close(end);
    }
}

void WakePipe::wake() {
    const char byte = 1;
    // A full pipe is readable already.
    [[maybe_unused]] const ssize_t written = ::write(m_ends[1], &byte, 1);
}

void WakePipe::clear() {
    char bytes[64];
    while (::read(m_ends[0], bytes, sizeof bytes) > 0) {
    }
}

void WakePipe::waitUntil(std::int64_t deadline_ns) const {
    pollfd polled{m_ends[0], POLLIN, 0};
    int ready = -1;
    do {
        const std::int64_t left_ns = std::max<std::int64_t>(0, deadline_ns - core::steadyNow_ns());
        const timespec left{static_cast<time_t>(left_ns / 1'000'000'000), left_ns % 1'000'000'000};
        ready = ::ppoll(&polled, 1, &left, nullptr);
    } while (ready < 0 && errno == EINTR);
}

} // namespace teleta::wts
