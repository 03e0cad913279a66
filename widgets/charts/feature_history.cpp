// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/feature_history.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace teleta::charts {

namespace {

constexpr double kShortestGap_s = 0.1;
constexpr double kPeriodsOfAGap = 5.0;
constexpr double kShortestJump_s = 0.25;
constexpr double kLongestJump_s = 2.0;
constexpr double kSmoothing = 0.05;

double orNaN(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

void appendNumber(std::string& text, double value) {
    if (!std::isfinite(value)) {
        text += "NA";
        return;
    }
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
}

} // namespace

FeatureHistory::FeatureHistory(std::size_t capacity)
    : m_capacity(std::max<std::size_t>(1, capacity))
    , m_time_s(m_capacity)
    , m_sourceTime_s(m_capacity)
    , m_breaks(m_capacity)
    , m_types(m_capacity) {
    for (auto& column : m_values)
        column.resize(m_capacity);
}

void FeatureHistory::clear() {
    m_first = m_size = 0;
    m_period_s = 0.0;
}

double FeatureHistory::longestStep_s() const {
    return std::max(kShortestGap_s, kPeriodsOfAGap * m_period_s);
}

double FeatureHistory::follow(const pipeline::FeatureSample& sample, Break& before) {
    before = Break::none;
    if (m_size == 0) {
        before = Break::jump;
        return 0.0;
    }
    const double newest_s = newestTime_s();
    const double step_s = sample.sourceTime_s - sourceTime_s(m_size - 1);
    if (sample.discontinuity || !(step_s >= 0.0)) {
        before = Break::jump;
        const double passed_s = static_cast<double>(sample.time_ns - m_lastSteady_ns) * 1e-9;
        return newest_s + std::clamp(passed_s, kShortestJump_s, kLongestJump_s);
    }
    if (m_period_s > 0.0 && step_s > longestStep_s())
        before = Break::missing;
    else if (step_s > 0.0)
        m_period_s = m_period_s > 0.0 ? m_period_s + kSmoothing * (step_s - m_period_s) : step_s;
    return newest_s + step_s;
}

void FeatureHistory::append(const pipeline::FeatureSample& sample) {
    Break before = Break::none;
    const double time_s = follow(sample, before);
    m_lastSteady_ns = sample.time_ns;
    if (m_size == m_capacity)
        m_first = m_first + 1 == m_capacity ? 0 : m_first + 1;
    else
        ++m_size;
    ++m_appended;

    const std::size_t s = slot(m_size - 1);
    m_time_s[s] = time_s;
    m_sourceTime_s[s] = sample.sourceTime_s;
    m_breaks[s] = before;
    m_types[s] = sample.features.type;
    const auto put = [&](Channel channel, double value) {
        m_values[static_cast<std::size_t>(channel)][s] = value;
    };
    const contact::TactileFeatures& f = sample.features;
    put(Channel::force, f.force_N);
    put(Channel::threshold, f.threshold_N);
    put(Channel::copX, orNaN(f.copX_m));
    put(Channel::copY, orNaN(f.copY_m));
    put(Channel::cocX, orNaN(f.cocX_m));
    put(Channel::cocY, orNaN(f.cocY_m));
    put(Channel::dzmpX, orNaN(f.dzmpX_m));
    put(Channel::dzmpY, orNaN(f.dzmpY_m));
    put(Channel::alphaZ, orNaN(f.alphaZ_rad));
    put(Channel::lambda1, orNaN(f.lambda1_m2));
    put(Channel::lambda2, orNaN(f.lambda2_m2));
    const bool hasRatio = f.lambda1_m2 && f.lambda2_m2 && *f.lambda2_m2 > 0.0;
    put(Channel::ratio, hasRatio ? *f.lambda1_m2 / *f.lambda2_m2 : orNaN({}));
    put(Channel::active, f.active);
}

std::size_t FeatureHistory::firstAt(double time) const {
    std::size_t low = 0;
    std::size_t high = m_size;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (time_s(middle) < time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::optional<std::size_t> FeatureHistory::nearest(double time) const {
    if (m_size == 0)
        return std::nullopt;
    std::size_t index = std::min(firstAt(time), m_size - 1);
    if (index > 0 && time - time_s(index - 1) < time_s(index) - time)
        --index;
    if (std::abs(time_s(index) - time) > longestStep_s())
        return std::nullopt;
    return index;
}

std::optional<std::size_t> FeatureHistory::nearestSource(double source) const {
    std::optional<std::size_t> best;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = m_size; i-- > 0;) {
        const double d = std::abs(sourceTime_s(i) - source);
        if (d < distance) {
            distance = d;
            best = i;
        }
        if (best && breakBefore(i) == Break::jump && distance <= longestStep_s())
            break; // an older pass over the same stretch of a recording does not count
    }
    return best;
}

std::string featuresCsv(const FeatureHistory& history, std::size_t first, std::size_t last) {
    constexpr std::array kColumns{Channel::force,   Channel::copX,    Channel::copY,  Channel::cocX,
                                  Channel::cocY,    Channel::dzmpX,   Channel::dzmpY, Channel::alphaZ,
                                  Channel::lambda1, Channel::lambda2, Channel::active};
    std::string csv =
        "time_s,contact_type,force_n,cop_x_m,cop_y_m,coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,alpha_z_rad,"
        "lambda1_m2,lambda2_m2,active\n";
    for (std::size_t i = first; i < last; ++i) {
        appendNumber(csv, history.sourceTime_s(i));
        csv += ',';
        csv += contact::toString(history.type(i));
        for (const Channel channel : kColumns) {
            csv += ',';
            appendNumber(csv, history.value(channel, i));
        }
        csv += '\n';
    }
    return csv;
}

} // namespace teleta::charts
