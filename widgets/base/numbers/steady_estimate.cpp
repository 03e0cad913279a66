// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/steady_estimate.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"

#include <algorithm>
#include <cmath>

namespace teleta::base {

namespace {

constexpr int kMostDecimals = 9;

/// Decimals of two significant digits after rounding: 0.0996 is 0.10.
int decimalsOf(double error) {
    const double magnitude = std::floor(std::log10(error));
    const bool roundsUp = std::round(error / std::pow(10.0, magnitude - 1.0)) >= 100.0;
    return std::clamp(1 - static_cast<int>(magnitude) - (roundsUp ? 1 : 0), 0, kMostDecimals);
}

void steady(std::optional<double>& shown, double value, double step) {
    if (!shown || std::abs(value - *shown) >= step)
        shown = std::round(value / step) * step;
}

} // namespace

void SteadyEstimate::update(double value, double error) {
    if (!std::isfinite(value)) {
        m_value.reset();
        m_error.reset();
        return;
    }
    if (!std::isfinite(error) || !(error > 0.0)) {
        m_error.reset();
        m_value = value;
        return;
    }
    const double step = std::pow(10.0, -decimalsOf(error));
    if (!m_error || std::abs(error - *m_error) >= step) {
        if (!m_error || decimalsOf(error) != m_decimals)
            m_value.reset();
        m_decimals = decimalsOf(error);
        m_error = std::round(error / step) * step;
    }
    steady(m_value, value, std::pow(10.0, -m_decimals));
}

QString SteadyEstimate::text() const {
    if (!m_value || !m_error)
        return threeDigits(m_value);
    return fixedDigits(*m_value, m_decimals).rightJustified(kNumberWidth, kFigureSpace) +
           QStringLiteral(" \u00b1 ") + fixedDigits(*m_error, m_decimals);
}

} // namespace teleta::base
