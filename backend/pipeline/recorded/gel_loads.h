// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/equilibration/load_calibration.h"
#include "backend/vision/gel/gel_contacts.h"

#include <string>
#include <utility>
#include <vector>

namespace teleta::pipeline {

/// Loads of a contact on a flat gel, in N and N m, that follow from its proxies by a calibration with known
/// presses. The signals are the columns of exported contacts: normal_proxy_m2, shear_proxy_x_m, area_m2, ...
/// Thread: any.
class GelLoads {
public:
    /// What a calibration may name.
    [[nodiscard]] static std::vector<std::string> signalNames();

    /// calibration: its signals are of signalNames().
    explicit GelLoads(equilibration::LoadCalibration calibration);
    /// Error: as equilibration::readLoadCalibration(), which also refuses a signal that no contact has.
    [[nodiscard]] static core::Expected<GelLoads> read(const std::string& path);

    [[nodiscard]] const equilibration::LoadCalibration& calibration() const { return m_calibration; }
    [[nodiscard]] equilibration::LoadCalibration::Loads at(const vision::GelContactState& contact) const;

private:
    equilibration::LoadCalibration m_calibration;
    std::vector<std::size_t> m_values; ///< of gelContactValues(), a channel each
};

} // namespace teleta::pipeline
