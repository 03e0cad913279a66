// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/feature_history.h"

#include "backend/recording/stream_columns.h"
#include "widgets/base/numbers/quantity_text.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

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
                                               static_cast<double>(f.active),
                                               f.shear ? f.shear->x_N : orNaN({}),
                                               f.shear ? f.shear->y_N : orNaN({}),
                                               f.shear ? f.shear->momentZ_Nm : orNaN({}),
                                               f.shear ? f.shear->friction : orNaN({})};
    SampleHistory::append({sample.time_ns, sample.sourceTime_s, sample.discontinuity}, values);
    m_types[slot(size() - 1)] = f.type;
}

QString featuresCsv(const FeatureHistory& history, std::size_t first, std::size_t last,
                    const QString& loadUnit, bool vectors) {
    // In the order of recording::featureColumns(), after the type.
    constexpr std::array kColumns{Channel::force,   Channel::copX,    Channel::copY,    Channel::cocX,
                                  Channel::cocY,    Channel::dzmpX,   Channel::dzmpY,   Channel::alphaZ,
                                  Channel::lambda1, Channel::lambda2, Channel::active,  Channel::shearX,
                                  Channel::shearY,  Channel::momentZ, Channel::friction};
    QString csv = QStringLiteral("time_s");
    const std::vector<recording::Column> columns = recording::featureColumns(loadUnit.toStdString(), vectors);
    for (const recording::Column& column : columns)
        csv += QLatin1Char(',') + QString::fromStdString(column.name);
    csv += QLatin1Char('\n');
    const auto shown = std::span(kColumns).first(columns.size() - 1);
    for (std::size_t i = first; i < last; ++i) {
        csv += base::csvNumber(history.sourceTime_s(i)) + QLatin1Char(',') +
               QLatin1String(contact::toString(history.type(i)));
        for (const Channel channel : shown)
            csv += QLatin1Char(',') + base::csvNumber(history.value(channel, i));
        csv += QLatin1Char('\n');
    }
    return csv;
}

} // namespace teleta::charts
