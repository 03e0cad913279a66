// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/gui_clock.h"

#include "backend/core/quantile.h"

#include <algorithm>

namespace teleta::console {

namespace {

constexpr std::size_t kKeptTicks = 3600UL * 1000UL / GuiClock::kPeriod_ms;

double quantile(std::vector<float> values, double share) {
    if (values.empty())
        return 0.0;
    return static_cast<double>(core::lowerQuantileOf(values, share));
}

} // namespace

GuiClock::GuiClock(QObject* parent)
    : QObject(parent) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kPeriod_ms);
    connect(&m_timer, &QTimer::timeout, this, &GuiClock::onTimeout);
}

void GuiClock::start() {
    m_sinceTick.invalidate();
    m_timer.start();
}

void GuiClock::stop() {
    m_timer.stop();
}

GuiClock::Report GuiClock::report() const {
    return {.ticks = m_ticks,
            .work_p50_s = quantile(m_work_s, 0.5),
            .work_p99_s = quantile(m_work_s, 0.99),
            .work_max_s = quantile(m_work_s, 1.0),
            .stall_p99_s = quantile(m_stall_s, 0.99),
            .stall_max_s = quantile(m_stall_s, 1.0)};
}

void GuiClock::resetReport() {
    m_work_s.clear();
    m_stall_s.clear();
    m_ticks = 0;
    m_sinceTick.invalidate();
}

void GuiClock::onTimeout() {
    const double sincePrevious_s =
        m_sinceTick.isValid() ? static_cast<double>(m_sinceTick.nsecsElapsed()) * 1e-9 : 0.0;
    const double stall_s = std::max(0.0, sincePrevious_s - kPeriod_ms * 1e-3);
    m_sinceTick.start();
    emit tick();
    const double work_s = static_cast<double>(m_sinceTick.nsecsElapsed()) * 1e-9;

    const std::size_t slot = m_ticks % kKeptTicks;
    if (m_work_s.size() <= slot) {
        m_work_s.push_back(0.0F);
        m_stall_s.push_back(0.0F);
    }
    m_work_s[slot] = static_cast<float>(work_s);
    m_stall_s[slot] = static_cast<float>(stall_s);
    ++m_ticks;
}

} // namespace teleta::console
