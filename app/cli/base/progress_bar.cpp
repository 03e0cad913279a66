// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/progress_bar.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace teleta::cli {

namespace {

constexpr std::int64_t kInterval_ns = 200'000'000;
constexpr std::size_t kWidth = 30;

struct UnitNames {
    const char* amount;
    const char* rate;
};

UnitNames namesOf(ProgressBar::Unit unit) {
    switch (unit) {
    case ProgressBar::Unit::bytes:
        return {"MB", "MB/s"};
    case ProgressBar::Unit::trials:
        return {"trials", "trials/s"};
    case ProgressBar::Unit::runs:
        return {"runs", "runs/s"};
    case ProgressBar::Unit::frames:
        return {"frames", "frames/s"};
    default:
        return {"s", "x"};
    }
}

} // namespace

ProgressBar::ProgressBar(Unit unit, bool resultsOnTerminal)
    : m_unit(unit)
    , m_shown(!resultsOnTerminal && isatty(STDERR_FILENO) != 0)
    , m_start_ns(core::steadyNow_ns())
    , m_next_ns(m_start_ns + kInterval_ns) {
}

void ProgressBar::erase() {
    if (m_drawn)
        std::fputs("\r\x1b[K", stderr);
    m_drawn = false;
}

void ProgressBar::update(double done, double total) {
    if (!m_shown)
        return;
    const std::int64_t now_ns = core::steadyNow_ns();
    if (now_ns < m_next_ns)
        return;
    m_next_ns = now_ns + kInterval_ns;
    m_drawn = true;
    const double scale = m_unit == Unit::bytes ? 1e-6 : 1.0;
    const auto [unit, rateUnit] = namesOf(m_unit);
    const double rate = scale * done / (static_cast<double>(now_ns - m_start_ns) * 1e-9);
    if (!(total > 0.0)) {
        std::fprintf(stderr, "\r%.0f %s  %.0f %s\x1b[K", scale * done, unit, rate, rateUnit);
        return;
    }
    const double share = std::min(1.0, done / total);
    std::string bar(kWidth, ' ');
    std::fill_n(bar.begin(), static_cast<std::size_t>(share * static_cast<double>(kWidth)), '#');
    if (m_unit == Unit::share)
        std::fprintf(stderr, "\r[%s] %3.0f %%\x1b[K", bar.c_str(), 100.0 * share);
    else
        std::fprintf(stderr, "\r[%s] %3.0f %%  %.0f %s\x1b[K", bar.c_str(), 100.0 * share, rate, rateUnit);
}

} // namespace teleta::cli
