// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/link_delay.h"

#include <cmath>

namespace teleta::simulation {

std::optional<double> LinkDelay::next_s(double sentAt_s) {
    const bool lost = m_random.uniform() < m_spec.lossShare;
    const double jitter_s = -m_spec.jitter_s * std::log1p(-m_random.uniform());
    const bool isOut = sentAt_s >= m_spec.outageAt_s && sentAt_s < m_spec.outageAt_s + m_spec.outage_s;
    return lost || isOut ? std::nullopt : std::optional(m_spec.delay_s + jitter_s);
}

} // namespace teleta::simulation
