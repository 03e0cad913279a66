// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/frame_loads.h"

#include "backend/equilibration/load_calibration_file.h"
#include "backend/recording/stream_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::pipeline {

namespace {

constexpr std::array<const char*, 3> kAxes{"_x", "_y", "_z"};

/// The name of a number that the array reads, as its frames are exported.
std::string nameOfValue(const core::TaxelLayout& layout, std::size_t value) {
    const auto components = static_cast<std::size_t>(layout.components());
    const std::string taxel = "t" + std::to_string(value / components);
    return layout.isVector() ? taxel + kAxes[value % components] : taxel;
}

std::string unitOf(const std::string& load) {
    return load.ends_with("_nm") ? "Nm" : "N";
}

} // namespace

std::vector<std::string> FrameLoads::signalsOf(const core::TaxelLayout& layout, const std::string& loadUnit) {
    std::vector<std::string> names;
    for (const recording::Column& column : recording::featureColumns(loadUnit, layout.isVector()))
        if (column.name != "contact_type") // a word in exported files
            names.push_back(column.name);
    const auto components = static_cast<std::size_t>(layout.components());
    for (std::size_t value = 0; value < layout.values(); ++value)
        if (!layout.isAbsent(value / components))
            names.push_back(nameOfValue(layout, value));
    return names;
}

FrameLoads::FrameLoads(equilibration::LoadCalibration calibration, const core::TaxelLayout& layout,
                       const std::string& loadUnit)
    : m_calibration(std::move(calibration))
    , m_values(static_cast<Eigen::Index>(m_calibration.channels.size())) {
    const std::vector<recording::Column> features = recording::featureColumns(loadUnit, layout.isVector());
    for (const std::string& channel : m_calibration.channels) {
        const auto feature = std::ranges::find(features, channel, &recording::Column::name);
        Signal signal{feature != features.end(), static_cast<std::size_t>(feature - features.begin())};
        for (std::size_t value = 0; !signal.isFeature && value < layout.values(); ++value)
            if (nameOfValue(layout, value) == channel)
                signal.index = value;
        m_signals.push_back(signal);
    }
}

core::Expected<FrameLoads> FrameLoads::read(const std::string& path, const core::TaxelLayout& layout,
                                            const std::string& loadUnit) {
    TELETA_TRY(auto calibration, equilibration::readLoadCalibration(path, signalsOf(layout, loadUnit)));
    return FrameLoads(std::move(calibration), layout, loadUnit);
}

std::vector<recording::Column> loadColumns(const std::vector<std::string>& names) {
    std::vector<recording::Column> columns;
    for (const std::string& load : names) {
        columns.push_back({load, unitOf(load)});
        columns.push_back({load + "_se", unitOf(load)});
    }
    columns.push_back({"extrapolated", ""});
    return columns;
}

equilibration::LoadCalibration::Loads FrameLoads::at(std::span<const float> raw, std::span<const float> tare,
                                                     std::span<const double> features) {
    for (std::size_t i = 0; i < m_signals.size(); ++i) {
        const auto [isFeature, index] = m_signals[i];
        const auto channel = static_cast<Eigen::Index>(i);
        if (isFeature)
            m_values[channel] = features[index];
        else if (tare.size() == raw.size())
            m_values[channel] = static_cast<double>(raw[index]) - static_cast<double>(tare[index]) +
                                m_calibration.rest[channel];
        else
            m_values[channel] = static_cast<double>(raw[index]);
    }
    return m_calibration.at(m_values);
}

std::vector<double> loadValues(const equilibration::LoadCalibration::Loads& loads) {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < loads.loads.size(); ++i) {
        values.push_back(loads.loads[i]);
        values.push_back(loads.errors[i]);
    }
    values.push_back(loads.extrapolated ? 1.0 : 0.0);
    return values;
}

} // namespace teleta::pipeline
