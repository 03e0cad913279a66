// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/feature_history.h"

#include "backend/core/data/column_unit.h"
#include "widgets/base/numbers/quantity_text.h"

#include <array>
#include <limits>

namespace teleta::charts {

namespace {

double orNaN(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

} // namespace

FeatureHistory::FeatureHistory(std::size_t capacity)
    : SampleHistory(kChannels, capacity)
    , m_types(this->capacity()) {
}

void FeatureHistory::append(const pipeline::FeatureSample& sample) {
    const contact::TactileFeatures& f = sample.features;
    const bool hasRatio = f.lambda1_m2 && f.lambda2_m2 && *f.lambda2_m2 > 0.0;
    // In the order of Channel.
    const std::array<double, kChannels> values{f.force_N,
                                               f.threshold_N,
                                               orNaN(f.copX_m),
                                               orNaN(f.copY_m),
                                               orNaN(f.cocX_m),
                                               orNaN(f.cocY_m),
                                               orNaN(f.dzmpX_m),
                                               orNaN(f.dzmpY_m),
                                               orNaN(f.alphaZ_rad),
                                               orNaN(f.lambda1_m2),
                                               orNaN(f.lambda2_m2),
                                               hasRatio ? *f.lambda1_m2 / *f.lambda2_m2 : orNaN({}),
                                               static_cast<double>(f.active)};
    SampleHistory::append({sample.time_ns, sample.sourceTime_s, sample.discontinuity}, values);
    m_types[slot(size() - 1)] = f.type;
}

QString featuresCsv(const FeatureHistory& history, std::size_t first, std::size_t last,
                    const QString& loadUnit) {
    constexpr std::array kColumns{Channel::force,   Channel::copX,    Channel::copY,  Channel::cocX,
                                  Channel::cocY,    Channel::dzmpX,   Channel::dzmpY, Channel::alphaZ,
                                  Channel::lambda1, Channel::lambda2, Channel::active};
    auto csv =
        QStringLiteral("time_s,contact_type,force_%1,cop_x_m,cop_y_m,coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,"
                       "alpha_z_rad,lambda1_m2,lambda2_m2,active\n")
            .arg(QString::fromStdString(core::columnUnit(loadUnit.toStdString())));
    for (std::size_t i = first; i < last; ++i) {
        csv += base::csvNumber(history.sourceTime_s(i)) + QLatin1Char(',') +
               QLatin1String(contact::toString(history.type(i)));
        for (const Channel channel : kColumns)
            csv += QLatin1Char(',') + base::csvNumber(history.value(channel, i));
        csv += QLatin1Char('\n');
    }
    return csv;
}

} // namespace teleta::charts
