// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/core/error.h"
#include "backend/equilibration/load_calibration.h"
#include "backend/recording/recording_types.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// Columns of recorded loads: NAME and NAME_se of each, then extrapolated, 0 or 1. names: of
/// equilibration::kLoadColumns. Thread: any (pure).
[[nodiscard]] std::vector<recording::Column> loadColumns(const std::vector<std::string>& names);

/// Loads of a whole frame of an array, in N and N m, that follow from its signals by a calibration with known
/// presses. The signals are columns of what a recording of the array is exported as:
///   t0, t1, ..., of vectors t0_x, t0_y, ...: what the taxels read, as it came
///   force_ut, shear_x_ut, cop_x_m, ...: what was computed of the frame
/// so that a table for "teleta loads fit" can be made of a recording. Where the array has a tare, it takes
/// the place of the rest that the calibration has of its taxels:  signal = read - tare + rest.
/// Thread: one.
class FrameLoads {
public:
    /// What a calibration may name. Places without a taxel have no signal.
    [[nodiscard]] static std::vector<std::string> signalsOf(const core::TaxelLayout& layout,
                                                            const std::string& loadUnit);

    /// calibration: its signals are of signalsOf().
    FrameLoads(equilibration::LoadCalibration calibration, const core::TaxelLayout& layout,
               const std::string& loadUnit);

    /// Reads a calibration for an array. Error: as equilibration::readLoadCalibration(), which also refuses a
    /// signal that the array does not have. Thread: any.
    [[nodiscard]] static core::Expected<FrameLoads>
    read(const std::string& path, const core::TaxelLayout& layout, const std::string& loadUnit);

    [[nodiscard]] const equilibration::LoadCalibration& calibration() const { return m_calibration; }
    [[nodiscard]] const std::vector<std::string>& names() const { return m_calibration.loads; }
    [[nodiscard]] std::vector<recording::Column> columns() const { return loadColumns(names()); }

    /// raw: layout.values() numbers as they came. tare: as many, or none. features: as featureColumns() has
    /// them. NaN: a signal of it is not defined in this frame.
    [[nodiscard]] equilibration::LoadCalibration::Loads
    at(std::span<const float> raw, std::span<const float> tare, std::span<const double> features);

private:
    struct Signal {
        bool isFeature = false;
        std::size_t index = 0;
    };

    equilibration::LoadCalibration m_calibration;
    std::vector<Signal> m_signals; ///< of the channels
    Eigen::VectorXd m_values;
};

/// As loadColumns() has them.
[[nodiscard]] std::vector<double> loadValues(const equilibration::LoadCalibration::Loads& loads);

/// The newest loads of an array, for views.
struct LoadReading {
    std::int64_t time_ns = 0;       ///< of the frame; 0: there was none
    std::vector<std::string> names; ///< of equilibration::kLoadColumns
    equilibration::LoadCalibration::Loads at;
};

} // namespace teleta::pipeline
