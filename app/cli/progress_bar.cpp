// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress_bar.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace teleta::cli {

namespace {

constexpr std::int64_t kInterval_ns = 200'000'000;
constexpr std::size_t kWidth = 30;

} // namespace

ProgressBar::ProgressBar(std::uint64_t totalBytes, bool resultsOnTerminal)
    : m_totalBytes(totalBytes)
    , m_shown(!resultsOnTerminal && isatty(STDERR_FILENO) != 0)
    , m_start_ns(core::steadyNow_ns())
    , m_next_ns(m_start_ns + kInterval_ns) {
}

ProgressBar::~ProgressBar() {
    if (m_drawn)
        std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::update(std::uint64_t doneBytes) {
    if (!m_shown)
        return;
    const std::int64_t now_ns = core::steadyNow_ns();
    if (now_ns < m_next_ns)
        return;
    m_next_ns = now_ns + kInterval_ns;
    m_drawn = true;
    const double done_MB = static_cast<double>(doneBytes) * 1e-6;
    const double rate_MBps = done_MB / (static_cast<double>(now_ns - m_start_ns) * 1e-9);
    if (m_totalBytes == 0) {
        std::fprintf(stderr, "\r%.0f MB  %.0f MB/s\x1b[K", done_MB, rate_MBps);
        return;
    }
    const double share = std::min(1.0, static_cast<double>(doneBytes) / static_cast<double>(m_totalBytes));
    std::string bar(kWidth, ' ');
    std::fill_n(bar.begin(), static_cast<std::size_t>(share * static_cast<double>(kWidth)), '#');
    std::fprintf(stderr, "\r[%s] %3.0f %%  %.0f MB/s\x1b[K", bar.c_str(), 100.0 * share, rate_MBps);
}

} // namespace teleta::cli
