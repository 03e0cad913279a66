// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/gel_loads.h"

#include "backend/equilibration/load_calibration_file.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/recording/stream_columns.h"

#include <algorithm>

namespace teleta::pipeline {

namespace {

constexpr std::size_t kOfTheContact = 1; ///< before its signals its number

} // namespace

std::vector<std::string> GelLoads::signalNames() {
    std::vector<std::string> names;
    for (const recording::Column& column : recording::gelContactColumns())
        names.push_back(column.name);
    names.erase(names.begin(), names.begin() + kOfTheContact);
    return names;
}

GelLoads::GelLoads(equilibration::LoadCalibration calibration)
    : m_calibration(std::move(calibration)) {
    const std::vector<std::string> names = signalNames();
    for (const std::string& channel : m_calibration.channels)
        m_values.push_back(static_cast<std::size_t>(std::ranges::find(names, channel) - names.begin()) +
                           kOfTheContact);
}

core::Expected<GelLoads> GelLoads::read(const std::string& path) {
    return equilibration::readLoadCalibration(path, signalNames()).map([](auto calibration) {
        return GelLoads(std::move(calibration));
    });
}

equilibration::LoadCalibration::Loads GelLoads::at(const vision::GelContactState& contact) const {
    const auto values = gelContactValues(contact);
    Eigen::VectorXd signal(static_cast<Eigen::Index>(m_values.size()));
    for (std::size_t i = 0; i < m_values.size(); ++i)
        signal[static_cast<Eigen::Index>(i)] = values.at(m_values[i]);
    return m_calibration.at(signal);
}

} // namespace teleta::pipeline
