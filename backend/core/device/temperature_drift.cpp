// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/temperature_drift.h"

#include <algorithm>
#include <cmath>

namespace teleta::core {

void TemperatureDrift::restart() {
    restart({});
    m_given = false;
}

void TemperatureDrift::restart(std::span<const float> atTare_degC) {
    m_atTare.assign(atTare_degC.begin(), atTare_degC.end());
    m_given = true;
    m_largest.reset();
    m_told = false;
}

void TemperatureDrift::take(std::span<const float> values_degC) {
    if (m_atTare.size() != values_degC.size()) {
        if (m_given)
            return;
        restart();
        m_atTare.assign(values_degC.begin(), values_degC.end());
        return;
    }
    m_largest.reset();
    for (std::size_t chip = 0; chip < values_degC.size(); ++chip) {
        if (!std::isfinite(values_degC[chip]))
            continue;
        if (!std::isfinite(m_atTare[chip])) {
            if (!m_given)
                m_atTare[chip] = values_degC[chip]; // the first that this chip tells
            continue;
        }
        const double change_K = static_cast<double>(values_degC[chip]) - static_cast<double>(m_atTare[chip]);
        if (!m_largest || std::abs(change_K) > std::abs(m_largest->change_K))
            m_largest = {chip, change_K};
    }
    const double most_K = m_largest ? std::abs(m_largest->change_K) : 0.0;
    m_told = most_K > (m_told ? kOver_K : kTold_K);
}

} // namespace teleta::core
