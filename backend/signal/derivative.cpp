// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/derivative.h"

#include <algorithm>
#include <cmath>

namespace teleta::signal {

bool Derivative::follow(const Series& series, std::size_t most) {
    if (m_next < series.dropped()) {
        m_next = series.dropped();
        m_series.lift();
        m_kept = 0;
    }
    const std::uint64_t end = std::min<std::uint64_t>(series.appended(), m_next + most);
    for (; m_next < end; ++m_next) {
        const auto index = static_cast<std::size_t>(m_next - series.dropped());
        take({series.time_s(index), series.value(index)});
    }
    return m_next < series.appended();
}

void Derivative::take(const Sample& sample) {
    if (std::isnan(sample.value)) {
        m_series.lift();
        m_kept = 0;
        return;
    }
    if (m_kept > 0 && sample.time_s <= m_middle.time_s)
        return;
    if (m_kept == 2) {
        const double before_s = m_middle.time_s - m_before.time_s, after_s = sample.time_s - m_middle.time_s;
        const double slopeBefore = (m_middle.value - m_before.value) / before_s;
        const double slopeAfter = (sample.value - m_middle.value) / after_s;
        m_series.append(m_middle.time_s,
                        (slopeBefore * after_s + slopeAfter * before_s) / (before_s + after_s));
    }
    m_before = m_middle;
    m_middle = sample;
    m_kept = std::min(m_kept + 1, 2);
}

} // namespace teleta::signal
