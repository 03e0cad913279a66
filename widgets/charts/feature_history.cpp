// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/feature_history.h"

#include "backend/core/number_text.h"

#include <array>
#include <cmath>
#include <limits>

namespace teleta::charts {

namespace {

double orNaN(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

void appendNumber(std::string& text, double value) {
    if (!std::isfinite(value)) {
        text += "NA";
        return;
    }
    text += core::NumberText(value).view();
}

} // namespace

FeatureHistory::FeatureHistory(std::size_t capacity)
    : SampleHistory(kChannels, capacity)
    , m_types(this->capacity()) {
}

void FeatureHistory::append(const pipeline::FeatureSample& sample) {
    std::array<double, kChannels> values{};
    const auto put = [&](Channel channel, double value) {
        values[static_cast<std::size_t>(channel)] = value;
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
    SampleHistory::append({sample.time_ns, sample.sourceTime_s, sample.discontinuity}, values);
    m_types[slot(size() - 1)] = f.type;
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
