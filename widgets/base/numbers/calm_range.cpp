// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/calm_range.h"

#include <algorithm>
#include <cmath>

namespace teleta::base {

double niceStep(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0})
        if (value <= factor * decade * (1.0 + 1e-9))
            return factor * decade;
    return 10.0 * decade;
}

CalmRange::CalmRange(double minimumSpan, double memory_s)
    : m_minimumSpan(minimumSpan)
    , m_memory_s(memory_s) {
    reset();
}

void CalmRange::reset() {
    m_empty = true;
    m_low = m_high = 0.0;
    m_shownLow = 0.0;
    m_shownHigh = m_minimumSpan;
}

CalmRange::Ends CalmRange::rounded() const {
    constexpr double kSteps = 5.0;
    double low = m_low;
    double high = m_high;
    if (high - low < m_minimumSpan) {
        // One-sided data keep zero at one end; others are centred.
        const double centre = 0.5 * (low + high);
        if (low >= 0.0 && low < m_minimumSpan)
            low = 0.0, high = std::max(high, m_minimumSpan);
        else
            low = centre - 0.5 * m_minimumSpan, high = centre + 0.5 * m_minimumSpan;
    }
    const double step = niceStep((high - low) / kSteps);
    constexpr double kSlack = 1e-9; // an extreme on a round number stays there
    return {std::floor(low / step + kSlack) * step, std::ceil(high / step - kSlack) * step};
}

bool CalmRange::update(double low, double high, double time_s) {
    constexpr double kLongestStep_s = 1.0;
    constexpr double kClearlyLess = 0.8;
    const bool first = m_empty;
    if (first) {
        m_low = low;
        m_high = high;
        m_empty = false;
    } else {
        const double elapsed_s = std::clamp(time_s - m_time_s, 0.0, kLongestStep_s);
        const double share = -std::expm1(-elapsed_s / m_memory_s);
        m_low = std::min(low, m_low + share * (low - m_low));
        m_high = std::max(high, m_high + share * (high - m_high));
    }
    m_time_s = time_s;

    const Ends ends = rounded();
    const bool outside = m_low < m_shownLow || m_high > m_shownHigh;
    const bool clearlyLess = ends.high - ends.low < kClearlyLess * (m_shownHigh - m_shownLow);
    const bool tooNarrow = m_shownHigh - m_shownLow < m_minimumSpan * (1.0 - 1e-9);
    if (!first && !outside && !clearlyLess && !tooNarrow)
        return false;
    const bool changed = ends.low != m_shownLow || ends.high != m_shownHigh;
    m_shownLow = ends.low;
    m_shownHigh = ends.high;
    return changed;
}

} // namespace teleta::base
